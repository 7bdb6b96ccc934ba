"""How accurate centrodes are: the coordinates of the instantaneous centres."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN
from graphic_tmm.chapters.centrodes.task import CENTRODES
from graphic_tmm.project import Project

NAMES = {"x_P": "x_P", "y_P": "y_P", "xi_P": "ξ_P", "eta_P": "η_P"}


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield the coordinates of the first link's centres, on what it rolls and in itself."""
    made = CENTRODES_PLAN.on(project)[0]
    marks = [mark for side in made.sides for mark in (side.x, side.y)]
    for name, mark in zip(NAMES, marks, strict=True):
        value = Value(mark, made.mu)
        yield Quantity(name, "m", (value,), made.count, due=(value,))


ACCURACY = Accuracy(quantities=_quantities, places=(CENTRODES,), words=NAMES)
