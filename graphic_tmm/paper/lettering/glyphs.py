"""Letters as strokes: the project's own hand, drawn on the grid of ГОСТ 2.304 type B.

A glyph is drawn with a round pen; the tables give the path of the *middle* of the pen in units of
the pen's width (h/10), from the left and lower edge of the letter's grid: a capital reaches from 0
to 9, a small letter from 0 to 6, a tail ends at -3; with the pen that makes 10, 7 and 3 units.

A line of a table is ``character width path``, or ``character = other`` where two look alike. The
width is the clear one, pen included (6 for most capitals, so that their paths reach from 0 to 5).
``|`` lifts the pen between strokes; the notation of a stroke is told in glyphs_notation.py.
"""

from __future__ import annotations

from functools import cache, lru_cache
from typing import NamedTuple

from graphic_tmm.paper.lettering.cyrillic import CAPITALS, SMALL
from graphic_tmm.paper.lettering.greek import GREEK
from graphic_tmm.paper.lettering.latin import DIGITS, LATIN
from graphic_tmm.paper.lettering.notation import Stroke, parse
from graphic_tmm.paper.lettering.signs import MATHEMATICS, PUNCTUATION

BLANKS = {" ": 2.0, "\u00a0": 2.0, "\u202f": 0.0, "\u2009": 0.0}
"""Widths of blanks: with a gap of 2 on both sides they part words by 6 and thousands by 4 units."""


class Glyph(NamedTuple):
    """A letter: its clear width (units, pen included) and the strokes of the pen's middle."""

    width: float
    strokes: tuple[Stroke, ...]


@cache
def _table() -> dict[str, str]:
    """Every drawn character with the rest of its line; a line is parsed when it is needed."""
    lines = "\n".join((CAPITALS, SMALL, LATIN, DIGITS, GREEK, PUNCTUATION, MATHEMATICS))
    table: dict[str, str] = {}
    for line in lines.splitlines():
        if line:
            character, rest = line.split(None, 1)
            if character in table:
                raise ValueError(f"{character!r} stands twice in the tables of glyphs")
            table[character] = rest
    return table


@cache
def characters() -> frozenset[str]:
    """Return all characters that have a glyph, blanks included."""
    return frozenset(_table()) | frozenset(BLANKS)


@lru_cache(maxsize=1024)
def glyph(character: str) -> Glyph:
    """Return the upright glyph of a character; KeyError where there is none.

    Returns
    -------
    Glyph
        Its left edge of ink is x = 0 and its base line, the lower edge of the ink, y = 0 (units).
    """
    if character in BLANKS:
        return Glyph(BLANKS[character], ())
    width, path = _table()[character].split(None, 1)
    if width == "=":
        return glyph(path)
    return Glyph(float(width), tuple(_on_base_line(parse(part)) for part in path.split("|")))


def _on_base_line(stroke: Stroke) -> Stroke:
    return tuple((x + 0.5, y + 0.5, bulge) for x, y, bulge in stroke)
