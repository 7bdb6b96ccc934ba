"""The symbols of a note: what its letters stand for, as the chapters say that have drawn something."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import folded
from graphic_tmm.note.document import (
    Block,
    Document,
    Heading,
    Runs,
    Symbol,
    Table,
    symbols,
    text,
)
from graphic_tmm.scene.captions import Named

SYMBOLS, MEANING = said("Symbols"), said("Meaning")
SYMBOL, UNIT = said("Symbol"), said("Unit")
SHARES = (0.1, 0.31, 0.09)
"""What the columns take of a page's width, twice."""
_STEM = re.compile(r"[^\W\d_]+")


def symbol_list(made: DrawnScene, blocks: Sequence[Block], language: str) -> Iterator[Block]:
    """Yield the list of symbols: those of the chapters whose letters stand in the note."""
    _ = speaking(language)
    whole = Document("", language, tuple(blocks))
    stems = {stem for one in symbols(whole) for stem in _STEM.findall(one.markup)}
    rows: dict[str, tuple[Runs, ...]] = {}
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            for letter, meaning, of in Named.of(chapter).symbols:
                stem = _STEM.match(letter)
                if stem and stem[0] in stems:
                    told = (Symbol(symbol(letter, language)),)
                    cells = text(_(meaning)), text(unit(of, language) or "—")
                    rows.setdefault(letter, (told, *cells))
    if rows:
        yield Heading(1, text(_(SYMBOLS)), numbered=False)
        heads = text(_(SYMBOL)), text(_(MEANING)), text(_(UNIT))
        table = Table("table-symbols", text(_(SYMBOLS)), heads, tuple(rows.values()), "clc", SHARES)
        yield folded(table, 2)
