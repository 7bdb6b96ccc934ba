"""The conclusions: what follows from the results, chapter by chapter, what could not be drawn, the author's."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import folded
from graphic_tmm.note.chapter import Noted
from graphic_tmm.note.document import (
    Block,
    Heading,
    Item,
    Listed,
    Number,
    Paragraph,
    Runs,
    Source,
    Table,
    lettered,
    paragraph,
    text,
)
from graphic_tmm.readers.exactness import deviations
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.text import result_name
from graphic_tmm.scene.captions import captions

CONCLUSIONS = said("Conclusions")
EXACTNESS = said("Largest errors of the drawing against the same without error of the ruler")
SHARES = (0.38, 0.12)
"""What the columns take of a page's width, twice."""
PLAN, ERROR = said("Plan or result"), said("Error, %")


def conclusions(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield what follows from the results, and what the author concludes; nothing where nothing does."""
    found: list[Runs] = []
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            found += Noted.of(chapter).concludes(drawn, language)
    for drawn in made.boards:
        found += [text(_sentence(told)) for told in warnings(drawn, language, remedies=False)]
    own = made.scene.author.conclusions
    if found or own:
        yield Heading(1, text(speaking(language)(CONCLUSIONS)), numbered=False)
    if found:
        yield Listed(tuple(Item("", (Paragraph(one),)) for one in found))
        yield from _exactness(made, language)
    yield from map(paragraph, own)


def _exactness(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield a table of how far what was drawn with a ruler is off the same drawing without error."""
    words, rows = captions(language), list[tuple[Runs, ...]]()
    for drawn in made.boards:
        for one in deviations(drawn):
            name = words.get(one.plan, one.plan) if one.plan else result_name(one.segment, language)
            told = f"{one.percent:.1g}" if one.percent < 0.1 else f"{one.percent:.2f}"
            source = Source("deviation", drawn.board, f"{one.plan}/{one.segment}", one.place)
            digits = told.replace(".", decimal_sign(language))
            rows.append((lettered(name), (Number(digits, "", source, one.percent),)))
    if rows:
        heads = text(speaking(language)(PLAN)), text(speaking(language)(ERROR))
        title = text(speaking(language)(EXACTNESS))
        yield folded(Table("table-exactness", title, heads, tuple(rows), "lc", SHARES), 2)


def _sentence(told: str) -> str:
    return f"{told[:1].upper()}{told[1:].rstrip('.')}."
