"""Specimens: the lettering of ГОСТ 2.304, lines of ГОСТ 2.303, symbols of links and pairs of ГОСТ 2.770.

They are not a chapter of the theory but of the craft: what a sheet is drawn with, laid out so that it can
be looked at. Lettering stands on an auxiliary grid whose step is the width of a stroke; the height of
capitals is the size. The package has an own stroke lettering on that grid (`graphic_tmm.paper.lettering`):
every character is a few strokes and arcs, so it is drawn by a pen as everything else. A specimen shows each
character at its place between the lines of its row, sizes, and the mark-up of indices. Symbols
(`graphic_tmm.paper.symbols`) are those that kinematic schemes and plans of positions use.

Draws: places ``lettering`` and ``symbols``, on any sheet; they need a scene for its language only and have
no board. Builds on no chapter.

Sources: ГОСТ 2.303 (линии), ГОСТ 2.304 (шрифты чертёжные), ГОСТ 2.770 (условные обозначения в схемах,
элементы кинематики).
"""

from __future__ import annotations

from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_CHARACTERS = said("Letters and figures are drawn on their auxiliary grid, in the standard sizes.")
_SYMBOLS = said("Lines and the symbols of links and pairs are drawn as the standards have them.")

CHAPTER = Chapter(
    name="lettering",
    number=11,
    board="",
    places=(Place("lettering", asks=(_CHARACTERS,)), Place("symbols", asks=(_SYMBOLS,))),
)
