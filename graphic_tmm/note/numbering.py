"""The numbers of a note: its sections, figures and the parts of these, tables, in order."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Beside, Document, Heading, Picture, Table

LETTERS = said("abcdefghi")
"""The parts of a figure."""


class Numbered(NamedTuple):
    """The numbers of a note: headings by their place among the blocks, figures and tables by id.

    ``wholes``: the id of the figure that a part of one belongs to, by that of the part.
    """

    headings: Mapping[int, str]
    figures: Mapping[str, str]
    tables: Mapping[str, int]
    wholes: Mapping[str, str]


def numbered(document: Document) -> Numbered:
    """Return the numbers of sections, figures and tables, in order."""
    headings: dict[int, str] = {}
    counts: list[int] = []
    for k, block in enumerate(document.blocks):
        if isinstance(block, Heading) and block.numbered:
            counts = [*counts[: block.level], *[0] * (block.level - len(counts))]
            counts[block.level - 1] += 1
            headings[k] = ".".join(map(str, counts))
    figures: dict[str, str] = {}
    tables: dict[str, int] = {}
    wholes: dict[str, str] = {}
    count = 0
    for block in document.blocks:
        if isinstance(block, Picture | Beside):
            count += 1
            figures[block.id] = str(count)
        if isinstance(block, Beside):
            for k, part in enumerate(block.parts):
                figures[part.id] = f"{count}, {letter_of(k, document.language)}"
                wholes[part.id] = block.id
        elif isinstance(block, Table) and block.ruled:
            tables[block.id] = len(tables) + 1
    return Numbered(headings, figures, tables, wholes)


def letter_of(k: int, language: str) -> str:
    """Return the letter of a part of a figure, by its number from 0."""
    return speaking(language)(LETTERS)[k]
