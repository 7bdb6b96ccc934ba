"""How true a place of a plate is by the locus, and by tracing paper: the third pin from the first pivot."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.loci.record import LOCI_PLAN, TRACING
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.language.said import said
from graphic_tmm.project import Project

WORDS = {
    "locus": said("place of the plate by its locus"),
    "tracing": said("place of the plate by tracing paper"),
}
"""What is told of by name, in English."""


def _quantities(project: Project) -> Iterator[Quantity]:
    made = LOCI_PLAN.on(project)
    for name, mark in zip(WORDS, (made.arm, TRACING.on(project)), strict=True):
        value = Value(mark, made.mu)
        yield Quantity(name, "m", (value,), 1, due=(value,), places=(LOCI,))


ACCURACY = Accuracy(quantities=_quantities, places=(LOCI,), compared=tuple(WORDS), words=WORDS)
