"""What people call kinematic diagrams, their table and its columns; why they are begun as they are."""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.task import DIAGRAMS
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "diagrams": said("Diagrams"),
    "diagrams of": said("Kinematic diagrams of {point}"),
    "diagram S": said("Displacement diagram of {point}"),
    "diagram V": said("Velocity diagram of {point}"),
    "diagram a": said("Acceleration diagram of {point}"),
    "view diagram S": said("Displacement diagram"),
    "view diagram V": said("Velocity diagram"),
    "view diagram a": said("Acceleration diagram"),
    "view base": said("Base of the diagrams"),
    "diagrams-calculation": said("Time of a turn, places on the base"),
    "table diagrams": said("Diagrams and plans"),
    "V_plan": said("V_{pl}"),
    "a_plan": said("a_{pl}"),
    "V_difference": said("Δ_{V}"),
    "a_difference": said("Δ_{a}"),
}


def called(view: str, speech: Speech, point: str) -> str:
    """Return what a diagram of a point is called, as plain text; "" for another view."""
    caption = CAPTIONS.get(view, "")
    return plain(speech(caption, point=point)).strip() if "{point}" in caption else ""


SYMBOLS = (
    ("L", said("length of the base"), "mm"),
    ("H", said("pole distance"), "mm"),
    ("μ_t", said("scale factor of time"), "s/mm"),
    ("μ_S", said("scale factor of displacements"), "m/mm"),
    ("μ_V", said("scale factor of velocities on the diagram"), "(m/s)/mm"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(DIAGRAMS,),
    sources=("artobolevsky",),
    symbols=SYMBOLS,
)


TRAVEL = said("The displacement is counted from the zero position, along the guide.")
END_OF_INTEGRAL = said(
    "After a turn the point is back, so the integral of its velocity ends at 0; what is left is the error "
    "of the drawing."
)
MEAN_READ = said(
    "The mean derivative over an interval stands over its middle, from where the smooth curve goes on."
)
