"""What a task gives of a pair of gears, and what it asks, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet
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


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its pair of gears, the module in mm."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield Given("z_1", order.z1)
    yield Given("z_2", order.z2)
    yield Given("m", order.m, SIZE)
    yield Given("x_1", order.x1)
    yield Given("x_2", order.x2)
    if order.delta_y is not None:
        yield Given("Δy", order.delta_y)
    yield Given("α", order.alpha, "°")
    yield Given("h_a^*", order.ha)
    yield Given("c^*", order.c)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the dimensions, the meshing, the contact ratio, the sliding."""
    _ = speaking(language)
    yield from (_(one) for one in (_DIMENSIONS, _MESHING, _CONTACT, _SLIDING))


_DIMENSIONS = said("The dimensions of the gear pair are calculated.")
_MESHING = said(
    "The meshing is drawn: the line of action with its working part, the construction of the "
    "flanks, three teeth of each wheel, the active flanks."
)
_CONTACT = said("The contact ratio is found from the drawing and by the formula.")
_SLIDING = said("The diagram of specific sliding is drawn.")


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    wanted={"gears": asks},
)
