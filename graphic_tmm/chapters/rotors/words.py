"""What people call the views and the results of a rotor; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.rotors.task import ROTOR
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter rotors": said("Balance of a rotor"),
    "rotor": said("Balance of a rotor"),
    "given rotor": said("Given data: rotor"),
    "rotor-end": said("Rotor along its axis"),
    "rotor-side": said("Rotor from the side"),
    "rotor-moments": said("Polygon of m·r·z about plane I"),
    "rotor-forces": said("Polygon of m·r"),
    "rotor-bearing-moments": said("Polygon of m·r·z about bearing A"),
    "rotor-bearing-forces": said("Polygon of m·r with bearing B"),
    "rotor-moments table": said("Moments about plane I"),
    "rotor-bearing-moments table": said("Moments about bearing A"),
    "rotor-bearing-forces table": said("Reactions of the bearings"),
    "table rotor": said("Unbalances and counterweights"),
    "rotor bearings": said("Reactions of the bearings without counterweights"),
    **{f"rotor_D_{name}": f"D_{{{name}}}" for name in ("k", "I", "II", "A", "B")},
    **{f"rotor_alpha_{name}": f"α_{{{name}}}" for name in ("k", "I", "II", "A", "B")},
    **{f"rotor_m_{name}": f"m_{{{name}}}" for name in ("k", "I", "II")},
    **{f"rotor_r_{name}": f"r_{{{name}}}" for name in ("k", "I", "II")},
    **{f"rotor_R_{name}": f"R_{{{name}}}" for name in "AB"},
}

SYMBOLS = (
    ("D", said("unbalance, m·r"), "kg·m"),
    ("M", said("moment of an unbalance, m·r·z"), "kg·m²"),
    ("z", said("distance from the first plane"), "m"),
)
"""Its letters in a note: what they stand for, their units."""

WORDS = Named(
    captions=CAPTIONS, plans=(ROTOR,), sources=("artobolevsky",), symbols=SYMBOLS,
)  # fmt: skip

AXIS = said("The rotor is drawn from the side: this is its axis.")
STATION = said("Masses, planes and bearings stand at their places along the axis.")
MASS = said("Seen along the axis the mass stands at its angle and radius.")
DIRECTION = said("The force of inertia points outward, along the radius of its mass.")
LAID_OFF = said("The vectors are laid off one behind the other, in any order.")
CLOSES = said(
    "What is balanced closes its polygon: the side from the last vertex to the first is what is missing."
)
AT_REST = said("At rest a rotor is balanced where the vectors m·r close their polygon.")
ANGLE = said("The counterweight stands where the side that was missing points.")
TOTAL = said("What remains of all vectors goes from the first vertex to the last.")
POINTS = said("It points as the side that was measured does.")
