"""What people call plans, tables and views of kinematics."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.names import EXTREMES, PLANS
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter kinematics": said("Kinematics of the mechanism"),
    "positions": said("Plan of positions"),
    "extremes": said("Extreme positions"),
    "velocities": said("Velocity plan"),
    "accelerations": said("Acceleration plan"),
    "table positions": said("Positions from the plans"),
    "table velocities": said("Velocities from the plans"),
    "table accelerations": said("Accelerations from the plans"),
    "positions in a turn": said("Positions"),
}

SYMBOLS = (
    ("l_{AB}", said("length of a link"), "m"),
    ("n_1", said("turns a minute of the crank"), "rpm"),
    ("φ", said("angle of the crank"), "°"),
    ("ω", said("angular velocity"), "1/s"),
    ("ε", said("angular acceleration"), "1/s²"),
    ("v", said("velocity of a point"), "m/s"),
    ("a", said("acceleration of a point"), "m/s²"),
    ("μ_l", said("scale factor of lengths"), "m/mm"),
    ("μ_v", said("scale factor of velocities"), "(m/s)/mm"),
    ("μ_a", said("scale factor of accelerations"), "(m/s²)/mm"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(EXTREMES, *PLANS),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
