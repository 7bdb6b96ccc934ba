"""What a task says of a pair of gears besides its numbers: the kind of meshing."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears import CHAPTER
from graphic_tmm.chapters.gears.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import Given, TaskSheet, given_by_keys, given_speed
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its gears; both addenda, the speed as it was written."""
    order = ASKED.of(scene)
    if order is None:
        return
    for row in given_by_keys(CHAPTER, scene):
        if row.symbol == "c^*" and isinstance(order.ha, tuple):
            yield from (Given(f"h_{{a{i}}}^*", value) for i, value in enumerate(order.ha, 1))
        yield given_speed("1", order.speed) if row.symbol == "ω_1" and order.speed else row


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell the kind of meshing: of a ring or rack, helical, by the shifts of both wheels."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    if order.internal or order.racked:
        yield _(_RING if order.internal else _RACK)
    if order.beta:
        yield _(_HELICAL)
    if order.distance is not None or order.x_sum is not None:
        yield _(_WANTED)
        return
    x1, x2 = order.x1 or 0.0, order.x2 or 0.0
    both = x1 + x2
    if x1 == x2 == 0.0:
        kind = _NONE
    elif order.internal or order.racked:
        return
    else:
        kind = _EQUAL if abs(both) < ROUNDING else _POSITIVE if both > 0.0 else _NEGATIVE
    yield _(kind)


ROUNDING = 1e-9
"""Shifts that together are less than this are opposite."""
_RING = said("Wheel 1 runs inside a ring.")
_RACK = said("Wheel 1 drives a rack.")
_HELICAL = said("The teeth are helical; module, angle and shifts are given across them.")
_WANTED = said("The shift that is not given is to be found.")
_NONE = said("The gears are cut without shift.")
_EQUAL = said("The meshing has equal and opposite shifts.")
_POSITIVE = said("The meshing has unequal shifts, their sum is positive.")
_NEGATIVE = said("The meshing has unequal shifts, their sum is negative.")


TASK_SHEET = TaskSheet(stated=stated, given=given)
