"""How specimens are asked for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene

_CHARACTERS = said("Letters and figures are drawn on their auxiliary grid, in the standard sizes.")
_SYMBOLS = said("Lines and the symbols of links and pairs are drawn as the standards have them.")


def _characters(scene: Scene, language: str) -> Iterator[str]:
    yield speaking(language)(_CHARACTERS)


def _symbols(scene: Scene, language: str) -> Iterator[str]:
    yield speaking(language)(_SYMBOLS)


TASK_SHEET = TaskSheet(wanted={"lettering": _characters, "symbols": _symbols})
