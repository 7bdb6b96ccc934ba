"""The limits of the hand at every step that is practised, as a check draws them: 400 drawings, as arrays."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from functools import partial
from typing import Any

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.checking.cells import Cell
from graphic_tmm.checking.check import TRIALS
from graphic_tmm.checking.judging.own_errors import Run, run_log
from graphic_tmm.checking.judging.scatter import Limits, Scatter, limited_figure
from graphic_tmm.checking.judging.step_scatter import StepScatter, scatters_of
from graphic_tmm.checking.judging.taken_marks import Reader, reader
from graphic_tmm.page.practice.tasks import Row
from graphic_tmm.scene.records import Scene

HAND = "student"
"""By whose drawings a student is judged, here as in a check."""
DIGITS = 5
"""Significant digits of a limit: more than 400 drawings tell of it."""
MARGIN = 1.5 * 10.0 ** (1 - DIGITS)
"""By so much a limit is raised, as a share: more than it, and the size that it is a multiple of, is rounded."""
Named = Mapping[Mark, tuple[str, str, str, str]]
"""What a check reads of marks, see `tasks.readable`."""


def drawings(row: Row, marks: Collection[Mark], scene: Scene) -> dict[Mark, Any]:
    """Return marks as the hand draws them, (trial, position), at all positions of a row."""
    by = reader(scene, HANDS[HAND]._replace(trials=TRIALS, seed=scene.seed), "screen")
    found = execute(row.log, row.given, marks, hand=by.hand)
    wide = (TRIALS, len(row.names))
    return {mark: np.broadcast_to(found[mark], wide) for mark in marks}


def own_limits(
    row: Row, read: Collection[Mark], drawn: Mapping[Mark, Any], by: Reader
) -> dict[tuple[Mark, int], StepScatter]:
    """Return how large the hand's own errors are where these marks are read, by mark and position."""
    found = {mark: _there(row, mark) for mark in read}

    def run(taken: Mapping[Mark, Any]) -> Run:
        return run_log(row.log, row.given, taken, {}, partial(_exact, row))

    return scatters_of(row.log, run, found, drawn, by, Limits())


def total_limits(
    row: Row, plan: str, named: Named, drawn: Mapping[Mark, Any], by: Reader
) -> dict[tuple[Mark, int], Scatter]:
    """Return how far the hand's figures are off what is due, by mark and position."""
    found = {}
    for mark, (kind, _, name, unit) in named.items():
        if kind == "point" or mark.view != plan:
            continue
        due = np.broadcast_to(_exact(row, mark), (1, len(row.names)))[0]
        in_mm = mark.kind is Length
        for place in row.places[plan]:
            figure = abs(float(due[place])) if in_mm else float(due[place])
            if not np.isfinite(figure):
                continue
            cell = Cell(figure, None, unit) if in_mm else Cell(None, figure, unit)
            rows = drawn[mark][:, place]
            rows = np.abs(rows) if in_mm else rows
            key = (plan, name, row.names[place])
            rows = rows[np.isfinite(rows)]
            found[mark, place] = limited_figure(rows, key, cell, by, Limits(), in_mm)
    return found


def told(found: Iterable[float]) -> list[float]:
    """Return sizes as the page has them; what has none is -1."""
    return [float(f"{x:.{DIGITS}g}") if np.isfinite(x) else -1 for x in found]


def bounds(found: Iterable[float]) -> list[float]:
    """Return limits as the page has them, none lower than it is: a reading may stand on one of them."""
    return told(x * (1.0 + MARGIN) for x in found)


def _there(row: Row, mark: Mark) -> Any:
    """Return where a mark is read: the numbers of it in the positions of its plan, NaN in the others."""
    due = _exact(row, mark)
    found = np.full((1, len(row.names)), np.nan, due.dtype)
    at = list(row.places[mark.view])
    found[:, at] = np.broadcast_to(due, found.shape)[:, at]
    return found


def _exact(row: Row, mark: Mark) -> Any:
    return row.reading[mark]
