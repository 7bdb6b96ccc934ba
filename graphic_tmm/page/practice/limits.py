"""The limits of the hand at every step that is practised, in each manner of reading, of 400 drawings."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.checking.cells import Cell
from graphic_tmm.checking.check import TRIALS
from graphic_tmm.checking.judging import equivalents, step_scatter
from graphic_tmm.checking.judging.own_errors import Run, run_log
from graphic_tmm.checking.judging.scatter import Limits, Scatter, limited, limited_figure
from graphic_tmm.checking.judging.step_scatter import StepScatter, scatters_of
from graphic_tmm.checking.judging.taken_marks import Reader, reader
from graphic_tmm.page.practice.tasks import PoseRow
from graphic_tmm.scene.records import Scene

HAND = "student"
"""By whose drawings a student is judged, here as in a check."""
DIGITS = 5
"""Significant digits of a limit: more than 400 drawings tell of it."""
MARGIN = 1.5 * 10.0 ** (1 - DIGITS)
"""By so much a limit is raised, as a share: more than it, and the size that it is a multiple of, is rounded."""
Named = Mapping[Mark, tuple[str, str, str, str]]
"""What a check reads of marks, see `tasks.readable`."""


def drawings(row: PoseRow, marks: Collection[Mark], scene: Scene) -> dict[Mark, Any]:
    """Return marks as the hand draws them, (trial, position), at all positions of a row."""
    by = reader(scene, HANDS[HAND]._replace(trials=TRIALS, seed=scene.seed), "screen")
    found = execute(row.log, row.given, marks, hand=by.hand)
    wide = (TRIALS, len(row.names))
    return {mark: np.broadcast_to(found[mark], wide) for mark in marks}


def own_limits(
    row: PoseRow, read: Collection[Mark], drawn: Mapping[Mark, Any], by: Reader
) -> dict[tuple[Mark, int], StepScatter]:
    """Return how large the hand's own errors are where these marks are read, by mark and position."""
    found = {mark: _there(row, mark) for mark in read}

    def run(taken: Mapping[Mark, Any]) -> Run:
        return run_log(row.log, row.given, taken, {}, partial(_exact, row))

    return scatters_of(row.log, run, found, drawn, by, Limits())


def total_limits(
    row: PoseRow, plan: str, named: Named, drawn: Mapping[Mark, Any], by: Reader
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


def sizes_for_page(found: Iterable[float]) -> list[float]:
    """Return sizes as the page has them; what has none is -1."""
    return [float(f"{x:.{DIGITS}g}") if np.isfinite(x) else -1 for x in found]


def bounds(found: Iterable[float]) -> list[float]:
    """Return limits as the page has them, none lower than it is: a reading may stand on one of them."""
    return sizes_for_page(x * (1.0 + MARGIN) for x in found)


def _there(row: PoseRow, mark: Mark) -> Any:
    """Return where a mark is read: the numbers of it in the positions of its plan, NaN in the others."""
    due = _exact(row, mark)
    found = np.full((1, len(row.names)), np.nan, due.dtype)
    at = list(row.places[mark.view])
    found[:, at] = np.broadcast_to(due, found.shape)[:, at]
    return found


def _exact(row: PoseRow, mark: Mark) -> Any:
    return row.reading[mark]


MANNERS = {"plan": "screen", "points": "photo"}
"""What is read of a plan, and how points are: all of it, on a screen; points alone, off a photograph."""


def reader_of(scene: Scene) -> dict[str, Any]:
    """Return who reads a drawing, and how a judgement is made."""
    by = reader(scene, HANDS[HAND], "screen")
    both = equivalents.pair(Limits())
    return {
        "half": by.half,
        "reading": by.hand.reading,
        "swing": by.hand.swing,
        "compass": by.hand.compass,
        "prick": by.hand.prick,
        "digits": by.hand.digits,
        "wrong": Limits().wrong,
        "pair": {"doubtful": both.doubtful, "wrong": both.wrong},
        "sine": equivalents.LEAST_SINE,
        "shares": list(step_scatter.SHARES),
        "few": step_scatter.FEW,
        "most": step_scatter.MOST,
        "sure": step_scatter.SURE,
    }


def manner(
    scene: Scene,
    row: PoseRow,
    named: Named,
    name: str,
    plans: Sequence[str],
    crossed: Collection[Mark] = (),
) -> dict[str, Any]:
    """Return the limits of the hand, read in one manner; ``plans``: as the page counts them.

    ``own``: of a plan read alone; ``with``: by the numbers of those before it whose points are read too;
    ``placed``: of points that other lines lead to (``crossed``) how far off one stands where it is due.
    """
    hand = HANDS[HAND]._replace(trials=TRIALS, seed=scene.seed)
    by = reader(scene, hand, MANNERS[name])
    whole = name == "plan"
    read = [m for m, (kind, *_) in named.items() if whole or kind == "point"]
    own: dict[str, Any] = {}
    beside: dict[str, Any] = {}
    total: dict[str, Any] = {}
    placed: dict[str, list[float]] = {}
    for one in row.own or (row,):
        drawn = drawings(one, read, scene)
        for plan, others in _together(list(one.places), whole=whole):
            found = own_limits(one, [m for m in read if m.view in (plan, *others)], drawn, by)
            key = " ".join(str(plans.index(other)) for other in others)
            to = beside.setdefault(key, {}) if others else own
            for mark in (m for m in read if m.view == plan):
                rows = [found.get((mark, at)) for at in one.places[plan]]
                _append(to, str(mark.slot), _own(rows, pointed=named[mark][0] == "point"))
        for mark in (m for m in read if m in crossed):
            near = _placed(one, mark, named[mark][2], drawn[mark], by)
            placed[str(mark.slot)] = [*placed.get(str(mark.slot), []), *near]
        for plan in one.places if whole else ():
            spread = total_limits(one, plan, named, drawn, by)
            for mark in (m for m in read if m.view == plan and named[m][0] != "point"):
                figures = [spread.get((mark, at)) for at in one.places[plan]]
                _append(total, str(mark.slot), _total(figures))
    return {"pointing": by.pointing, "own": own, "with": beside, "total": total, "placed": placed}


def _placed(row: PoseRow, mark: Mark, name: str, drawn: Any, by: Reader) -> list[float]:
    """Return from where on the place of a point is doubtful, position by position."""
    due = np.broadcast_to(_exact(row, mark), (1, len(row.names)))[0]
    found = []
    for place in row.places[mark.view]:
        spots = drawn[:, place]
        key = (mark.view, name, row.names[place])
        read = by.pointed(spots[np.isfinite(spots)][:, None], "|".join(key))[:, 0]
        found.append(limited(np.sort(np.abs(read - due[place])), Limits()).doubtful)
    return bounds(found)


def _together(plans: Sequence[str], *, whole: bool) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield each plan with those before it that are read too; alone where all of it is read."""
    for k, plan in enumerate(plans):
        for count in range(1 if whole else k + 1):
            yield from ((plan, others) for others in combinations(plans[:k], count))


def _own(limits: Iterable[StepScatter | None], *, pointed: bool) -> dict[str, list[Any]]:
    """Return limits of a step's own errors, position by position."""
    rows = list(limits)
    found: dict[str, list[Any]] = {
        "b": [sizes_for_page(one.sizes) if one else [] for one in rows],
        "d": bounds(one.scatter.doubtful if one else math.nan for one in rows),
        "w": bounds(one.scatter.wrong if one else math.nan for one in rows),
    }
    if pointed:
        found["s"] = [sizes_for_page(one.sharp) if one else [] for one in rows]
        found["m"] = sizes_for_page([one.most if one else math.nan for one in rows])
    return found


def _total(limits: Iterable[Scatter | None]) -> dict[str, list[Any]]:
    """Return limits of the deviations of a figure, position by position."""
    rows = list(limits)
    return {
        "d": bounds(one.doubtful if one else math.nan for one in rows),
        "w": bounds(one.wrong if one else math.nan for one in rows),
        "t": bounds(one.times if one else math.nan for one in rows),
    }


def _append(to: dict[str, Any], slot: str, more: dict[str, list[Any]]) -> None:
    """Append columns to those of a mark."""
    there = to.setdefault(slot, {key: [] for key in more})
    for key, column in more.items():
        there[key] += column
