"""What marks are called, as plain text."""

from __future__ import annotations

from typing import Protocol

from graphic_tmm.language.symbols import symbol


class HasName(Protocol):
    """What bears a name, as the marks of a log do."""

    @property
    def name(self) -> str:
        """The name."""


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def spoken(mark: HasName, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))
