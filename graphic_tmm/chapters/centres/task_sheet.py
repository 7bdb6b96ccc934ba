"""What a task asks of instantaneous centres."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.centres.task import ASKED, CENTRES
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_POSITIONS = said(
    "All instantaneous centres are found in position {listed} by the theorem of Aronhold and Kennedy.",
    "All instantaneous centres are found in positions {listed} by the theorem of Aronhold and Kennedy.",
)
_EVERYWHERE = said(
    "All instantaneous centres are found in all positions by the theorem of Aronhold and Kennedy."
)
_POLYGON = said("The polygon of links shows in which order they are found.")
_RATES = said(
    "Angular velocities of links and velocities of points are found by the centres and compared with the plan."
)


def assignments(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the centres in their positions, and for what is found by them."""
    order, _ = ASKED.of(scene), speaking(language)
    if order is None or order.positions == ("all",):
        yield _(_EVERYWHERE)
    else:
        yield _(_POSITIONS, n=len(order.positions), listed=", ".join(order.positions))
    yield from (_(_POLYGON), _(_RATES))


TASK_SHEET = TaskSheet(given=lambda scene: (), wanted={CENTRES: assignments})
