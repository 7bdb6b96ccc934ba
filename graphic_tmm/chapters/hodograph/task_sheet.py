"""What a task asks of hodographs and analogues."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.hodograph.task import ASKED, HODOGRAPH
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_VELOCITIES = said(
    "The velocities of {points} in all positions are carried to one pole and joined by their hodograph."
)
_BOTH = said(
    "The velocities and the accelerations of {points} in all positions are carried each to one pole and joined "
    "by their hodographs."
)
_TANGENTS = said(
    "The tangents of the hodograph of velocities are compared with the plans of accelerations."
)
_ANALOGUES = said("The analogues dS/dφ and d²S/dφ² of {points} are read off the plans.")


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the hodographs, for what they are held against, for the analogues."""
    order, _ = ASKED.of(scene), speaking(language)
    if order is None:
        return
    points = ", ".join(order.points)
    yield _(_BOTH if order.accelerations else _VELOCITIES, points=points)
    if scene.row.accelerations:
        yield _(_TANGENTS)
    if order.analogues:
        yield _(_ANALOGUES, points=points)


TASK_SHEET = TaskSheet(wanted={HODOGRAPH: asks})
