"""The intervals of a diagram found by chords, in a note: how each is called, a table of their middles."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from graphic_tmm.board.charts import Chart
from graphic_tmm.chapters.diagrams.beside import Middle
from graphic_tmm.chapters.diagrams.note_words import MIDDLES
from graphic_tmm.chapters.diagrams.plan import Kinematic
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.document import Runs, Symbol, Table, text
from graphic_tmm.note.steps import Told
from graphic_tmm.scene.captions import captions

ACROSS = 12
"""How many intervals stand in one table beside one another."""
LEAD, WIDEST = 0.12, 0.1
"""Shares of the text's width: of each head of a row, and of a column at most."""


def intervals(drawn: Drawn, made: Kinematic) -> dict[int, str]:
    """Return what the intervals that can be drawn are called, by the position at which they begin."""
    names, count = drawn.names, made.base.intervals
    after = [*names[1:count], str(count)]
    return {k: f"{names[k]}–{after[k]}" for k in range(count) if k not in drawn.undrawn}


def middles_table(
    told: Told, chart: Chart, middle: Middle, intervals: Mapping[int, str], digits: int
) -> Iterator[Table]:
    """Yield the middles of intervals: mm, and what they stand for, to some decimals."""
    language = told.language
    names, title, row = captions(language), speaking(language)(MIDDLES), list(intervals)
    letter = (Symbol(symbol(chart.symbol, language)),)
    for start in range(0, len(row), ACROSS):
        part = row[start : start + ACROSS]
        heads = (text(names["value"]), text(names["unit"]), *(text(intervals[k]) for k in part))
        rows = []
        for mark, of, places in ((middle.ordinate, "mm", 1), (middle.value, chart.unit, digits)):
            cells: list[Runs] = []
            for k in part:
                one = told._replace(place=k).number(mark)
                written = one._replace(text=fixed(one.value, places, language))
                cells.append((written,) if math.isfinite(one.value) else text("—"))
            rows.append((letter, text(unit(of, language)), *cells))
        again = f" ({names['continued']})" if start else ""
        id, align = f"table-middles-{chart.symbol}-{start}", "lc" + "c" * len(part)
        wide = (LEAD, LEAD, *[min((1.0 - 2 * LEAD) / len(part), WIDEST)] * len(part))
        yield Table(id, text(title + again), heads, tuple(rows), align, wide)
