"""What a task asks of Klein's and Ritterhaus's constructions."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.klein.task import ASKED, BOTH, KLEIN, RITTERHAUS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_WAYS = {
    BOTH: said(
        "Velocities and accelerations of the slider-crank are found by Klein's construction and by "
        "Ritterhaus's, and compared with the plans."
    ),
    KLEIN: said(
        "Velocities and accelerations of the slider-crank are found by Klein's construction, and compared "
        "with the plans."
    ),
    RITTERHAUS: said(
        "Velocities and accelerations of the slider-crank are found by Ritterhaus's construction, and compared "
        "with the plans."
    ),
}
_PLACES = said("This is drawn in positions {places}.")
_POINTS = said("Points of the rod: {points}.")


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the constructions, where they are drawn, and for points of the rod."""
    order, _ = ASKED.of(scene), speaking(language)
    if order is None:
        return
    yield _(_WAYS[order.construction])
    if order.positions != ("all",):
        yield _(_PLACES, places=", ".join(order.positions))
    if order.points:
        yield _(_POINTS, points=", ".join(order.points))


TASK_SHEET = TaskSheet(wanted={KLEIN: asks})
