"""The table of readings weighed: what would be if it had been written down otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.evidence import Board, Readings, of_variations
from graphic_tmm.checking.mutations.hypotheses import Hypothesis, of_table
from graphic_tmm.checking.mutations.tables import Table, copied, variations
from graphic_tmm.checking.records import Taken

FAR = 3.0, 0.01
"""Two readings are told apart if they should differ by so many deviations, and by such a share."""


def of_written(
    readings: Readings, base: Board, due: Mapping[tuple[Key, bool], Any] | None = None
) -> Iterator[Hypothesis]:
    """Yield the hypotheses of a table that was written down otherwise, on a board.

    ``due``: what tables say by the board, (1,), where that is not as it should be.
    """
    drawing = readings.drawing
    names = drawing.made.mechanism.names if drawing.made.mechanism is not None else ()
    table = Table(drawing.rows, names or tuple(dict.fromkeys(t.position for t in drawing.rows)))

    def off(k: int) -> complex:
        taken = drawing.rows[k]
        return taken.spot - drawing.spots.get(taken.key, taken.spot)

    def apart(k: int, j: int) -> bool:
        one, other = drawing.rows[k], drawing.rows[j]
        if one.pointed:
            return abs(drawing.spots[one.key] - drawing.spots[other.key]) > 1.0
        here, there = (_due(drawing, taken) for taken in (one, other))
        scatters, share = FAR
        return abs(here - there) > scatters * drawing.by.spread[one.at].rms + share * abs(here)

    scales = {
        one.symbol: one.value for board in drawing.made.boards for one in board.scales.values()
    }
    varied = variations(table, drawing.scale, off, scales, apart)
    some = [table.same(), *varied, *copied(table, apart)]
    yield from of_table(some, of_variations(readings, base, some, due or {}))


def _due(drawing: Comparison, taken: Taken) -> float:
    cell = drawing.due[taken.key]
    return float((cell.mm if taken.mm is not None else cell.value) or 0.0)
