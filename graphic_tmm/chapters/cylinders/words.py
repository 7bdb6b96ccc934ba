"""What people call the views and the results of an engine's inertia; why its steps are done."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cylinders.task import CYLINDERS
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

STAR, SHAFT = "cylinders-star", "cylinders-shaft"
ALONE, DIRECT, REVERSE = "", "-direct", "-reverse"
"""Vectors of cylinders in line; of banks the direct ones and their mirror images."""
KINDS = ("F1", "M1", "F2", "M2")
"""Forces and moments of the first order and of the second."""
ROMAN = {"1": "I", "2": "II"}


def view_of(kind: str, way: str = ALONE) -> str:
    """Return what the view of a polygon is called by code."""
    return f"{CYLINDERS}-{kind}{way}"


def _letters() -> Iterator[tuple[str, str]]:
    for kind in KINDS:
        index = ROMAN[kind[1]]
        yield f"cylinders_{kind}", f"{kind[0]}_{{{index}}}"
        yield f"cylinders_{kind}_least", f"{kind[0]}_{{{index}min}}"
        yield f"cylinders_{kind}_at", f"φ_{{{kind[0]}{index}}}"


CAPTIONS: dict[str, str] = {
    "chapter cylinders": said("Inertia of an engine with several cylinders"),
    CYLINDERS: said("Inertia of the cylinders"),
    "given cylinders": said("Given data: cylinders"),
    STAR: said("Cranks along the shaft"),
    SHAFT: said("Crankshaft from the side"),
    view_of("F1"): said("Forces of the first order"),
    view_of("M1"): said("Moments of the first order"),
    view_of("F2"): said("Forces of the second order"),
    view_of("M2"): said("Moments of the second order"),
    view_of("F1", DIRECT): said("Forces of the first order, direct"),
    view_of("M1", DIRECT): said("Moments of the first order, direct"),
    view_of("F2", DIRECT): said("Forces of the second order, direct"),
    view_of("M2", DIRECT): said("Moments of the second order, direct"),
    view_of("F1", REVERSE): said("Forces of the first order, reverse"),
    view_of("M1", REVERSE): said("Moments of the first order, reverse"),
    view_of("F2", REVERSE): said("Forces of the second order, reverse"),
    view_of("M2", REVERSE): said("Moments of the second order, reverse"),
    "cylinders rest": said("What remains"),
    "table cylinders": said("Cylinders"),
    "cylinders remains": said("What remains of forces and moments"),
    **dict(_letters()),
}

SYMBOLS = (
    ("λ", said("ratio of crank to rod"), ""),
    ("θ", said("angle of a crank from the engine's axis"), "°"),
    ("ψ", said("angle of a cylinder from the engine's axis"), "°"),
    ("F_I", said("force of inertia of the first order"), "N"),
    ("F_II", said("force of inertia of the second order"), "N"),
)
"""Its letters in a note: what they stand for, their units."""

WORDS = Named(
    captions=CAPTIONS, plans=(CYLINDERS,), sources=("artobolevsky",), symbols=SYMBOLS
)  # fmt: skip

PIN = said("Seen along the shaft the crank stands at its angle.")
STATION = said("From the side the pin stands at its place along the shaft.")
LINE = said("This is the axis of the shaft.")
