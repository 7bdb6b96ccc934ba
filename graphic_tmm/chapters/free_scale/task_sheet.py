"""What a task asks of a plan to a free scale."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.free_scale.task import ASKED, FREE_SCALE
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_BY_LINK = said(
    "Velocities are drawn once more in one position, to a free scale, by link {link} as the driving one; the "
    "scale is found by the crank pin."
)
_BY_A_LEG = said(
    "Velocities are drawn once more in one position, to a free scale, by a leg of the plate as the driving "
    "link; the scale is found by the crank pin."
)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the plan."""
    order, _ = ASKED.of(scene), speaking(language)
    if order is not None:
        yield _(_BY_A_LEG) if order.link is None else _(_BY_LINK, link=order.link)


TASK_SHEET = TaskSheet(wanted={FREE_SCALE: asks})
