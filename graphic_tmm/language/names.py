"""What marks and views are called, as plain text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.language.symbols import symbol

if TYPE_CHECKING:
    from graphic_tmm.board.record import Mark


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def spoken(mark: Mark, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))


def flywheel_title(view: str, constant: str, language: str) -> str:
    """Return what a graph of the flywheel is called; that of the moment by which of the moments varies."""
    varying = view == "moment" and constant == "driving"
    return CAPTIONS[language]["moment driving" if varying else view]


def view_name(view: str, language: str, point: str = "") -> str:
    """Return what a view is called, as plain text; figures and polygons of forces by their group.

    ``point``: of which the diagrams are.
    """
    words = CAPTIONS[language]
    kind, _, name = view.partition(" ")
    keys = {
        "group": ("group of forces", "link of forces"),
        "forces": ("polygon of group", "polygon of link"),
    }
    if kind in keys and name:
        name, _, tried = name.partition(" ")
        title = words[keys[kind][0 if "-" in name else 1]].format(name=name)
        return title + (words["pass"].format(number=tried) if tried else "")
    title = words.get(f"diagram {view}", words.get(view, view))
    return plain(title.replace("{point}", point)).strip()
