"""What people call an engine's views and forces; why its forces are resolved as they are."""

from __future__ import annotations

from graphic_tmm.chapters.engine.task import ENGINE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "engine": said("Forces of the crank mechanism"),
    "engine-148": said("Transfer of forces in the crank mechanism"),
    "harmonics": said("Rotating vectors of the inertia force"),
    "engine-calculation": said("Checks of the triangles by the formulas"),
    "engine-masses": said("Sum of the masses that go to and fro"),
    "engine-works": said("Works of T and P over a turn"),
    "engine beta": "β",
    "work_T": said("A_{T}, work of T over a turn"),
    "work_P": said("A_{P}, work of P over a turn"),
    "work_apart": said("difference of the works"),
    "table engine": said("Forces in the crank mechanism"),
    "m_to_and_fro": said("m, to and fro"),
    "m_rod_at_crank": said("m of the rod at the crank"),
    "m_rod_at_slider": said("m of the rod at the crosshead"),
    "J_rod_lumped": said("J of two masses"),
    "J_rod_excess": said("J of two masses − J of the rod"),
    "engine P": said("P"),
    "engine P_in": said("P_{in}"),
    "engine P′": said("P′"),
    "engine N": said("N"),
    "engine Q": said("Q"),
    "engine T": said("T"),
    "engine K": said("K"),
    "engine M": said("M"),
    "engine a_B_series": said("a_{B}, series"),
    "engine P_in_series": said("P_{in,ser}"),
    "engine P_in1": said("P_{in1}"),
    "engine P_in2": said("P_{in2}"),
    "engine NOB": said("N·OB"),
    "engine a_B": said("a_{B}"),
    "view engine P": said("Forces on the piston: P, P_{in} and P′ = P + P_{in}"),
    "view engine N": said("Pressure N on the guide"),
    "view engine Q": said("Force Q along the rod"),
    "view engine T": said("Tangential force T"),
    "view engine K": said("Radial force K"),
    "view engine M": said("Turning moment M"),
}

SYMBOLS = (
    ("P", said("force on the piston"), "N"),
    ("N", said("force on the guide"), "N"),
    ("Q", said("force along the rod"), "N"),
    ("T", said("tangential force at the crank pin"), "N"),
    ("K", said("radial force at the crank pin"), "N"),
    ("M", said("turning moment"), "N·m"),
    ("β", said("angle of the rod with the guide"), "°"),
    ("λ", said("ratio of crank and rod"), ""),
    ("p_{max}", said("highest pressure of the diagram"), "Pa"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(ENGINE,),
    rank=26,
    sources=("artobolevsky",),
    symbols=SYMBOLS,
)


P_LINE = said("P′ acts on the crosshead along the cylinder.")
N_LINE = said(
    "Without friction the guide can only press square to itself: this is the direction of N."
)
Q_LINE = said(
    "The rod is hinged at both ends and without load between them: it takes a force only along itself."
)
P_RESOLVED = said(
    "P′ is resolved into Q along the rod and N square to the guide: the triangle closes here."
)
FORCE_READ = said("The side of the triangle, times the scale factor, is the force.")
Q_CARRIED = said(
    "A force may be carried along its line: Q acts on the crank pin as it acts at the crosshead."
)
T_LINE = said("T, square to the crank, is the part of Q that turns it.")
K_LINE = said("K, along the crank, only stretches or presses it.")
Q_RESOLVED = said(
    "Q is resolved into T square to the crank and K along it: the triangle closes here."
)
DISTANCE = said(
    "N on the guide and the equal force on the bearing of the shaft are this far apart."
)
TOGETHER = said(
    "The force along the cylinder is that of the gas and that of the inertia, with their signs."
)
AXIS = said("The inertia force acts along the cylinder: on this line the vectors are projected.")
ONCE = said("The vector of the first order turns with the crank.")
PROJECTED = said("The projection of the turning vector changes as the cosine of its angle.")
BOTH_ORDERS = said("Both orders together are the inertia force, but for what is smaller than λ².")

PISTON = said(
    "The piston stands on its rod, which carries the force of the gas to the crosshead; how long it is drawn "
    "does not matter, for a force may be carried along its line."
)
COVER = said("The cover stands still, off the piston at its dead centre.")
GAS = said("The gas presses on the piston: P is the difference of both sides.")
COVER_LOAD = said(
    "The gas presses on the cover as much as on the piston: −P acts on the cylinder, and both close in a frame "
    "of one piece."
)
BY_PARALLELS = said(
    "The parts of a force are the sides of the parallelogram whose diagonal it is: they are cut off by "
    "parallels through its end."
)
TWO_ADDED = said(
    "Two equal and opposite forces in one point change nothing: Q and −Q are added at the bearing. −Q with Q "
    "on the crank pin is a couple, Q is left."
)
ALONG_CYLINDER = said(
    "What is left at the bearing is resolved: along the cylinder it is P′, as the rod makes the angle β with "
    "the guide."
)
ACROSS_CYLINDER = said(
    "Across the cylinder it is equal to the pressure on the guide and against it, hence −N: with N it is a "
    "couple."
)
ARM_OF_Q = said(
    "The arm of a couple is the distance between the lines of its forces, here R·sin(φ + β)."
)
