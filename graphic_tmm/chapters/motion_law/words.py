"""What people call the graphs of a law of motion, its table and results; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.motion_law.task import MOTION_LAW
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "motion_law": said("Law of motion"),
    "motion-moment": said("Reduced moment of all forces"),
    "motion-work": said("Work of all forces"),
    "motion-energy": said("Kinetic energy"),
    "motion-mass": said("Energy–mass diagram"),
    "motion-speed": said("Angular velocity of the crank"),
    "motion-acceleration": said("Angular acceleration of the crank"),
    "motion-slowness": said("Inverse of the angular velocity"),
    "motion-time": said("Time"),
    "motion-loads": said("Reduced moment of the loads"),
    "motion-loads-work": said("Work of the loads"),
    "motion-calculation": said("Calculations of the motion"),
    "table motion_law": said("Law of motion, by positions"),
    "motion_angle": said("φ at the end of the motion"),
    "motion_time": said("t at the end of the motion"),
    "motion_energy": said("T_0, first energy"),
    "motion_start": said("ω_0, first speed"),
    "motion_turns": said("turns of the run-up, to 0.1 % a turn"),
    "motion_delta": said("δ of the steady cycle"),
    "motion_flywheel": said("J_{F}"),
    "motion_step": said("ω by the crossing drawn"),
    "motion_error": said("error of ω by the number of positions"),
    "motion_speed": said("ω at the end of the base"),
}

MOMENTS = said("The constant moment on the crank comes to those of the loads.")
INERTIAS = said("What turns with the crank comes to the reduced moment of inertia of the links.")
MASS_POINT = said(
    "The point of a position has its reduced moment of inertia as abscissa and its kinetic energy as ordinate."
)
SAME_PLACE = said("After whole turns the links stand as at the beginning, and have the same J.")
RAY = said("The ray from the true origin to the point of a position slopes as ω² does.")
NORMAL = said("The normal in the middle of the chord goes down to the base.")
SUBNORMAL = said("From the foot of the middle to that of the normal: the subnormal of the graph.")

NOT_STEADY = said(
    "there is no steady cycle: the motor is too weak for the loads, they drive it ever faster, or what turns "
    "is too light for so few positions; give a stronger motor, more J, or more positions"
)
NOT_NEEDED = said(
    "no flywheel is needed: without one the cycle is even enough already; leave delta out, or make it smaller"
)
NONE_DOES = said("no flywheel makes the cycle so even; make delta larger, or give more positions")
"""Why there is no motion, and what to do."""

SYMBOLS = (
    ("T", said("kinetic energy"), "J"),
    ("ψ", said("angle of a ray of the energy–mass diagram"), ""),
    ("ω", said("angular velocity of the crank"), "1/s"),
    ("ε", said("angular acceleration of the crank"), "1/s²"),
    ("t", said("time"), "s"),
)
"""Its letters in a note: what they stand for, their units."""

WORDS = Named(
    captions=CAPTIONS, plans=(MOTION_LAW,), sources=("artobolevsky", "popov"), symbols=SYMBOLS
)
