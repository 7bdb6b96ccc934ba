"""What a task asks of kinematic diagrams, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.diagrams.task import ASKED, DIAGRAMS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the diagrams, as they are found one from another."""
    order = ASKED.of(scene)
    if order is None:
        return
    found = _VELOCITY if order.integral == "drawn" else _ALONE
    says = _DISPLACEMENT if order.start == "displacement" else found
    yield speaking(language)(says, point=order.point)


_DISPLACEMENT = said(
    "Kinematic diagrams of point {point} are drawn: of its displacement, and by graphical "
    "differentiation of its velocity and acceleration."
)
_VELOCITY = said(
    "Kinematic diagrams of point {point} are drawn: of its velocity, taken from the plans, by "
    "graphical integration of its displacement, by graphical differentiation of its acceleration."
)
_ALONE = said(
    "Kinematic diagrams of point {point} are drawn: of its velocity, taken from the plans, and by "
    "graphical differentiation of its acceleration."
)


TASK_SHEET = TaskSheet(
    wanted={DIAGRAMS: asks},
)
