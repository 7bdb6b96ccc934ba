"""How a note ends: what follows from the results, what its letters stand for, the literature."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import in_columns
from graphic_tmm.note.document import (
    Block,
    Document,
    Heading,
    Item,
    Listed,
    Number,
    Paragraph,
    Runs,
    Source,
    Symbol,
    Table,
    lettered,
    paragraph,
    symbols,
    text,
)
from graphic_tmm.note.section_chapter import page_of
from graphic_tmm.readers.exactness import deviations
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.readers.text import result_name
from graphic_tmm.scene.captions import Named, captions

CONCLUSIONS = said("Conclusions")
EXACTNESS = said("Largest errors of the drawing against the same without error of the ruler")
PLAN, ERROR = said("Plan or result"), said("Error, %")


def conclusions(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield what follows from the results, and what the author concludes; nothing where nothing does."""
    found: list[Runs] = []
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            found += page_of(drawn, chapter, language).concludes()
    words = captions(language)
    for drawn in made.boards:
        found += [
            lettered(_sentence(told, words)) for told in warnings(drawn, language, remedies=False)
        ]
    found = list({plain(repr(one)): one for one in reversed(found)}.values())[::-1]
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
        yield in_columns(Table("table-exactness", title, heads, tuple(rows), "lc"), language, 2)


def _sentence(told: str, words: Mapping[str, str]) -> str:
    """Return a warning as a sentence; a key of several words, that would be a letter, as it is called."""
    key, colon, rest = told.partition(": ")
    if colon and "_" in key:
        told = f"{words.get(key, key)}: {rest}"
    return f"{told[:1].upper()}{told[1:].rstrip('.')}."


SYMBOLS, MEANING = said("Symbols"), said("Meaning")
SYMBOL, UNIT = said("Symbol"), said("Unit")
RPM = "rpm"
"""The unit of what is given in turns a minute only: its letter, n, stands for other things too."""
_STEM = re.compile(r"[^\W\d_]+")
_LINK = re.compile(r"\^.*|\d")
"""What tells of which link a quantity is, and of which part: P_{i1}, P_b^{Zh}."""


def symbol_list(made: DrawnScene, blocks: Sequence[Block], language: str) -> Iterator[Block]:
    """Yield the list of symbols: those of the chapters whose letters stand in the note."""
    _ = speaking(language)
    whole = Document("", language, tuple(blocks))
    letters = {plain(one.markup) for one in symbols(whole)}
    rows: dict[str, tuple[Runs, ...]] = {}
    for drawn in made.boards:
        in_turns = any(row.unit == RPM for row in given_rows(made.scene, drawn.board))
        for chapter in drawn.project.chapters:
            for letter, meaning, of in Named.of(chapter).symbols:
                called = symbol(letter, language)
                if (of != RPM or in_turns) and _stands(plain(called), letters):
                    cells = text(_(meaning)), text(unit(of, language) or "—")
                    rows.setdefault(f"{letter} {meaning}", ((Symbol(called),), *cells))
    if rows:
        yield Heading(1, text(_(SYMBOLS)), numbered=False)
        heads = text(_(SYMBOL)), text(_(MEANING)), text(_(UNIT))
        table = Table("table-symbols", text(_(SYMBOLS)), heads, tuple(rows.values()), "clc")
        yield in_columns(table, language, 2)


def _stands(letter: str, letters: Collection[str]) -> bool:
    """Whether a letter is among others: its index is a quantity's own, or stands for any point or link.

    >>> _stands("l_AB", {"l_OS1"}), _stands("P_i1", {"P_b"}), _stands("P_i1", {"P_i3"})
    (True, False, True)
    """
    stem, _, index = letter.partition("_")
    if not index or index[0].isdigit():
        return any(stem in _STEM.findall(one) for one in letters)
    if index[0].isupper() and stem != "μ":
        return any(one.startswith(f"{stem}_") and one[len(stem) + 1].isupper() for one in letters)
    return _LINK.sub("", letter) in {_LINK.sub("", one) for one in letters}


LITERATURE = said("Literature")
BOOKS: dict[str, str] = {
    "artobolevsky": said(
        "Artobolevsky I. I. Theory of Mechanisms and Machines. 4th ed. Moscow: Nauka, 1988 (in Russian)."
    ),
    "popov": said(
        "Popov S. A., Timofeev G. A. Course Projects in the Theory of Mechanisms and the Mechanics of "
        "Machines. Moscow: Vysshaya Shkola, 1999 (in Russian)."
    ),
    "assur": said(
        "Assur L. V. An Investigation of Plane Linkages with Lower Pairs by their Structure and "
        "Classification. Moscow: Academy of Sciences, 1952 (in Russian)."
    ),
    "contour": said("GOST 13755-2015. Cylindrical involute gears. Basic rack."),
    "geometry": said("GOST 16532-70. Cylindrical involute gears of external meshing. Geometry."),
    "scales": said("GOST 2.302-68. Unified system of design documents. Scales."),
    "lines": said("GOST 2.303-68. Unified system of design documents. Lines."),
    "letters": said("GOST 2.304-81. Unified system of design documents. Letters."),
    "iso scales": said("ISO 5455. Technical drawings. Scales."),
    "iso lines": said("ISO 128-2. Technical product documentation. Basic conventions for lines."),
    "iso letters": said("ISO 3098-1. Technical product documentation. Lettering."),
}
"""By the names under which chapters name them."""
ESKD, ISO = ("scales", "lines", "letters"), ("iso scales", "iso lines", "iso letters")
"""What every sheet is drawn by: a Russian one, another."""


def literature(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the literature: the author's list, else in the order in which chapters call for it."""
    told = made.scene.author.literature or _called_for(made, language)
    yield Heading(1, text(speaking(language)(LITERATURE)), numbered=False)
    yield Listed(tuple(Item(str(k), (paragraph(one),)) for k, one in enumerate(told, 1)))


def _called_for(made: DrawnScene, language: str) -> list[str]:
    """Return the books that the chapters of a note follow, and the standards of every sheet."""
    chapters = sorted(
        {one.number: one for drawn in made.boards for one in drawn.project.chapters}.values(),
        key=lambda one: one.number,
    )
    named = dict.fromkeys(key for one in chapters for key in Named.of(one).sources)
    keys = (*named, *(ESKD if code_of(language) == "ru" else ISO))
    return [speaking(language)(BOOKS[key]) for key in keys]
