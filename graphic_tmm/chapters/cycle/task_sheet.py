"""What a task asks of a cycle of moments, and the moments that it gives."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.task import ASKED, CYCLE
from graphic_tmm.chapters.flywheel.task_sheet import given_of, of_order
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.readers.task_sheet import Given, Listed, TaskSheet, given_figure, given_speed
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of a cycle: the speed of its shaft, its turns, its flywheel."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield given_speed("1", order.speed)
    yield Given("n_t", float(order.turns))
    yield from given_of(order.flywheel)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the diagrams, the flywheel, its rim."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield speaking(language)(_PARTS, n=order.positions)
    yield from of_order(order.flywheel, language)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the moments point by point, a table each: they add up."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    opposes = order.flywheel.constant == "driving"
    for k, one in enumerate(order.moments):
        title = _(_RESISTING if opposes else _DRIVING) if k == 0 else ""
        heads = ("φ, °", *(given_figure(angle, language) for angle, _ in one.points))
        row = (
            f"M, {unit('N·m', language)}",
            *(given_figure(size, language) for _, size in one.points),
        )
        yield Listed(f"moment-{k + 1}", title, heads, (row,))


_PARTS = said("The cycle is divided into {n} part.", "The cycle is divided into {n} parts.")
_RESISTING = said("Resisting moments over the cycle (several add up), straight between the points")
_DRIVING = said("Driving moments over the cycle (several add up), straight between the points")


TASK_SHEET = TaskSheet(
    given=given,
    listed=listed,
    wanted={CYCLE: asks},
)
