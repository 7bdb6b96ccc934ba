"""What people call an engine's plan, its diagrams, columns and results."""

from __future__ import annotations

from graphic_tmm.chapters.engine.names import ENGINE
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
