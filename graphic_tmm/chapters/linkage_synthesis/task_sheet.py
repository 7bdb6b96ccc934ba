"""What a task gives for its synthesis: with a mechanism it stands in the table of that."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.linkage_synthesis.task import ASKED
from graphic_tmm.readers.given_task import given_by_task
from graphic_tmm.readers.task_sheet import Given, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what the task of a scene gives, if it has no mechanism."""
    if ASKED.of(scene) is not None and scene.mechanism is None:
        yield from given_by_task(scene)


TASK_SHEET = TaskSheet(given=given)
