"""What a task says of a pair of gears besides its numbers: the kind of meshing."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell the kind of meshing, by the shifts of both wheels."""
    order = ASKED.of(scene)
    if order is None:
        return
    both = order.x1 + order.x2
    if order.x1 == order.x2 == 0.0:
        kind = _NONE
    else:
        kind = _EQUAL if abs(both) < ROUNDING else _POSITIVE if both > 0.0 else _NEGATIVE
    yield speaking(language)(kind)


ROUNDING = 1e-9
"""Shifts that together are less than this are opposite."""
_NONE = said("The gears are cut without shift.")
_EQUAL = said("The meshing has equal and opposite shifts.")
_POSITIVE = said("The meshing has unequal shifts, their sum is positive.")
_NEGATIVE = said("The meshing has unequal shifts, their sum is negative.")


TASK_SHEET = TaskSheet(stated=stated)
