"""What a task asks of accelerations by substitution."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.substitution.task import ASKED, SUBSTITUTION
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_ONCE_MORE = said(
    "Accelerations of the group of class IV are drawn once more in one position, by substitution: ε of one "
    "plate is taken as 0 first."
)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for both plans."""
    if ASKED.of(scene) is not None:
        yield speaking(language)(_ONCE_MORE)


TASK_SHEET = TaskSheet(wanted={SUBSTITUTION: asks})
