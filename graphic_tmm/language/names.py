"""What marks are called, as plain text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.language.symbols import symbol

if TYPE_CHECKING:
    from graphic_tmm.board.record import Mark


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def spoken(mark: Mark, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))
