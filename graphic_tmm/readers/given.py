"""The table of what a scene gives, as the sheet of a task lists it: letters, values, units; of all chapters."""

from __future__ import annotations

import math

from graphic_tmm.captions import captions
from graphic_tmm.chapter import MECHANISM, Given, chapters
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import HEIGHTS, Heights
from graphic_tmm.paper.lettering.indices import markup
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.scene.records import Scene

NAME = "table-given"
TALL = 12
"""More rows than these stand side by side."""
DIGITS = 6
"""Significant figures of what is given: more than tasks have; what follows from them has one less."""


def given_rows(scene: Scene) -> tuple[Given, ...]:
    """Return what a scene gives for its mechanism, chapter by chapter; nothing twice."""
    found = (row for one in chapters(MECHANISM) for row in one.given(scene))
    return tuple(dict.fromkeys(found))


def given_table(scene: Scene, heights: Heights = HEIGHTS["A1"]) -> Drawing:
    """Return the table of what is given; its rows stand side by side where there are many."""
    language, size = scene.language, heights.number
    words = captions(language)
    rows = [_cells(row, language) for row in given_rows(scene)]
    beside = max(1, math.ceil(len(rows) / TALL))
    tall = math.ceil(len(rows) / beside)
    padded = [*rows, *[("", "", "")] * (tall * beside - len(rows))]
    lines = [[cell for row in padded[k::tall] for cell in row] for k in range(tall)]
    heads = [words["letter"], words["figure"], words["unit"]] * beside
    return breakable(
        NAME,
        words["given"],
        heads,
        lines,
        again=words["continued"],
        size=size,
        title_size=heights.title,
        align=["left", "centre", "centre"] * beside,
    )


def _cells(row: Given, language: str) -> tuple[str, str, str]:
    told = row.value if isinstance(row.value, str) else _figure(row.value, language)
    word = captions(language).get(row.symbol) or markup(symbol(row.symbol, language))
    return word, escape(told), unit(row.unit, language) or "—"


def _figure(value: float, language: str) -> str:
    whole = math.isclose(value, float(f"{value:.{DIGITS}g}"), rel_tol=1e-9)
    return number(value, language, DIGITS if whole else DIGITS - 1)
