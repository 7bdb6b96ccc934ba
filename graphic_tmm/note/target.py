"""A format as pandoc is asked for it, and the elements of pandoc's tree that formats have of their own."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, NamedTuple

from graphic_tmm.language.said import said
from graphic_tmm.note.document import Figure, Picture, ReadyPicture, Table

NONE: list[Any] = ["", [], []]
"""An element without id, classes and attributes."""

Tree = dict[str, Any]


class ContentsEntry(NamedTuple):
    """A heading in the contents: its level, its id, what it says."""

    level: int
    id: str
    text: str


Outline = tuple[ContentsEntry, ...]

CONTENTS = said("Contents")
"""The heading of the outline."""


class Target(NamedTuple):
    """A format as pandoc is asked for it: its name there, options, and what it has of its own.

    ``picture``: the inline that shows a figure, ``contents`` and ``break_page``: blocks; ``styled``: a
    paragraph of the title page, ``tabled``: a table as it stands,
    ``part``: a heading without a number. ``captioned``: a figure and its caption
    are one; ``figure``: what they are instead. ``styled_rows``: parts beside one another and their caption are
    paragraphs of the styles of a figure. ``linked``: places in it have names. ``word``: a word of plain text,
    with what pandoc does not escape. ``headed``: the first cell of a row is its head.
    ``continued``: what stands above the heads of a table (its id, "Table 3, continued") on the pages that it
    goes on over. ``whole``: the lines of one formula, which no page parts.
    ``piece``: a piece of a formula among words, which no line parts; None where a formula is one.
    ``measured``: it is told how wide columns are.
    """

    name: str
    picture: Callable[[Picture | ReadyPicture], Tree]
    contents: Callable[[Outline], list[Tree]]
    break_page: Callable[[], list[Tree]]
    options: tuple[str, ...] = ()
    styled: Callable[[Tree, str], list[Tree]] = lambda block, style: styled(block, style)
    tabled: Callable[[Tree, Table], list[Tree]] = lambda made, table: [made]
    part: Callable[[Tree], list[Tree]] = lambda heading: [heading]
    captioned: bool = True
    linked: bool = True
    headed: bool = False
    figure: Callable[[Figure, Tree], list[Tree]] | None = None
    styled_rows: bool = False
    word: Callable[[str], list[Tree]] = lambda word: one_string(word)
    continued: Callable[[str, str], Tree] | None = None
    piece: Callable[[Tree], list[Tree]] | None = None
    measured: bool = False
    whole: Callable[[list[Tree]], list[Tree]] = lambda lines: lines


def of(kind: str, content: object) -> Tree:
    """Return an element of the tree."""
    return {"t": kind, "c": content}


def styled(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of a style; how it is set is of no account but on pages."""
    return [block] if style in (RAGGED, LEADING) else [classed(block, style)]


RAGGED, LEADING = "ragged", "leading"
"""How a paragraph is set whose lines are not spread; one that stays with what follows it."""


def classed(block: Tree, style: str, id: str = "") -> Tree:
    """Return a block as one of a class, which is a style to a word processor."""
    return of("Div", [[id, [style], [["custom-style", style]]], [block]])


def one_string(word: str) -> list[Tree]:
    """Return a word as it is."""
    return [of("Str", word)]


def as_words(text: str, word: Callable[[str], list[Tree]] = one_string) -> list[Tree]:
    """Return plain text as words and spaces; lines that are broken stay so."""
    found: list[Tree] = []
    for k, line in enumerate(text.split("\n")):
        if k:
            found.append({"t": "LineBreak"})
        for j, one in enumerate(line.split(" ")):
            if j:
                found.append({"t": "Space"})
            found += word(one) if one else []
    return found


def escaped(form: str, strange: re.Pattern[str]) -> Callable[[str], list[Tree]]:
    """Return how words are written in a format with a backslash before what would mean something there."""

    def word(text: str) -> list[Tree]:
        found: list[Tree] = []
        done = 0
        for match in strange.finditer(text):
            found += [of("Str", text[done : match.start()])] if match.start() > done else []
            found.append(raw(form, f"\\{match[0]}"))
            done = match.end()
        return [*found, of("Str", text[done:])] if done < len(text) else found

    return word


def raw(form: str, text: str, *, block: bool = False) -> Tree:
    """Return what a format takes as it is written."""
    return of("RawBlock" if block else "RawInline", [form, text])
