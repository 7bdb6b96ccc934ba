"""How wide the columns of a table are: as wide as their words need, so that none is broken."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.language.units import unit
from graphic_tmm.note.document import Formula, Number, Once, Runs, Symbol, Table, Text
from graphic_tmm.note.widths import SIGN, pieces, width

PAGE = 165.0
"""The width of the text on a page, mm."""
EM = 3.53
"""The size of letters in a table, mm: 10 pt."""
LETTER = 0.5 * EM
"""What a letter of a formula takes, as `widths.width` counts them."""
WHITE = 1.8
"""White and lines of a cell, mm."""
MATH = 1.2
"""How much larger than words a letter may stand: LibreOffice sets 12 pt where 10 are told."""
REF = 8
"""Letters of a reference to a figure or a table."""
_WIDTHS = {
    0.28: "ijlt.,:;!|/'·\N{NO-BREAK SPACE} ",
    0.4: 'frsIJ()[]-°"',
    0.46: "acez",
    0.51: "0123456789",
    0.58: "−+=×",
    0.79: "m",
    1.02: "MW№%—…",
}
"""What letters take of their size at the most."""
_EM = {letter: share for share, letters in _WIDTHS.items() for letter in letters}
WIDE = frozenset({"ZHE", "EM", "SHA", "SHCHA", "YERU", "YU", "EF"})
"""What Unicode calls letters that are wider than others of their alphabet."""
LOWER, UPPER = (0.54, 0.78), (0.73, 1.02)
"""What other letters take, and wide ones."""


class ColumnWidth(NamedTuple):
    """What a column needs, mm: for its longest word, for its longest cell on one line."""

    word: float
    whole: float


def fits(table: Table, language: str) -> bool:
    """Whether the words of a table stand beside one another on a page."""
    columns = _columns(table, language)
    return sum(one.word + WHITE for one in columns) <= PAGE


def shares(table: Table, language: str) -> tuple[float, ...]:
    """Return what each column takes of the page's width; less than all of it if no cell needs more."""
    columns = _columns(table, language)
    room = PAGE - WHITE * len(columns)
    words, wholes = (sum(one[k] for one in columns) for k in (0, 1))
    if wholes <= room:
        given = [one.whole for one in columns]
    elif words < room:
        spare = (room - words) / (wholes - words)
        given = [one.word + spare * (one.whole - one.word) for one in columns]
    else:
        given = [one.word * room / words for one in columns]
    return tuple((one + WHITE) / PAGE for one in given)


def _columns(table: Table, language: str) -> list[ColumnWidth]:
    rows = [row for row in (table.heads, *table.rows) if row]
    return [_needed([row[k] for row in rows], language) for k in range(len(table.align))]


def _needed(cells: Sequence[Runs], language: str) -> ColumnWidth:
    pieces = [list(_pieces(cell, language)) for cell in cells]
    return ColumnWidth(
        max((max(some, default=0.0) for some in pieces), default=0.0),
        max((sum(some) for some in pieces), default=0.0),
    )


def _pieces(cell: Runs, language: str) -> Iterator[float]:
    """Yield how wide what stays on one line is, mm: words with the space behind them, sides of formulas."""
    for run in cell:
        if isinstance(run, Text):
            yield from (word_width(word) for word in _words(run.text))
        elif isinstance(run, Number):
            told = unit(run.unit, language)
            yield word_width(f"{run.text} {told}" if told else run.text)
        elif isinstance(run, Once):
            yield from _pieces(run.runs, language)
        elif isinstance(run, Symbol):
            yield width(run) * LETTER * MATH
        elif isinstance(run, Formula):
            for piece in pieces(run):
                yield sum(width(side) + SIGN for side in piece.sides) * LETTER
        else:
            yield REF * LETTER


def _words(told: str) -> list[str]:
    """Return words, each with the space behind it."""
    return re.findall(r"\S+\s?", told)


def word_width(word: str) -> float:
    """Return how wide a word is in a table at the most, mm."""
    return sum(_EM.get(letter) or _share(letter) for letter in word) * EM


def _share(letter: str) -> float:
    wide = unicodedata.name(letter, "").rpartition(" ")[2] in WIDE
    return (UPPER if letter.isupper() else LOWER)[wide]
