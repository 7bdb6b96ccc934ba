"""What a task gives and asks of centrodes."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.centrodes.task import ASKED, CENTRODES
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

DRAW = said(
    "Draw the fixed and the moving centrode of link {listed} through its instantaneous centres.",
    "Draw the fixed and the moving centrode of each of the links {listed} through its instantaneous centres.",
)
TOUCH = said(
    "Draw their common tangent where they touch, and compare their arcs between neighbouring positions."
)


def _wanted(scene: Scene, language: str) -> Iterator[str]:
    order, _ = ASKED.of(scene), speaking(language)
    if order is None:
        return
    yield _(DRAW, n=len(order.links), listed=", ".join(map(str, order.links)))
    yield _(TOUCH)


TASK_SHEET = TaskSheet(given=lambda scene: (), wanted={CENTRODES: _wanted})
