"""What a task asks of the structure, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.structure import PARTS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def tables(scene: Scene, language: str) -> Iterator[str]:
    """Ask for links, pairs, mobility, groups."""
    yield speaking(language)(_TABLES)


def parts(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the groups by themselves."""
    yield speaking(language)(_PARTS)


_TABLES = said(
    "The structure is analysed: links and pairs, mobility, Assur groups, formula of structure, "
    "class of the mechanism."
)
_PARTS = said("The driving link and each Assur group are drawn by themselves.")


TASK_SHEET = TaskSheet(
    wanted={"structure": tables, PARTS: parts},
)
