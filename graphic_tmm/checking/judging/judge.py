"""Verdicts: how far a reading is from its due, measured by how far the hand's own drawings are.

A reading is doubtful where the hand is farther off in a small share of its drawings only, wrong where none
of them comes near. Where earlier readings enter a figure, they are taken as they were found: a slip is
blamed once, and what it carries on is said to follow from it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Number
from graphic_tmm.checking.cells import due_figure, half_of, taken_figure
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.equivalents import pair
from graphic_tmm.checking.judging.own_errors import apart
from graphic_tmm.checking.judging.scatter import Scatter, times_off
from graphic_tmm.checking.judging.slips import counted
from graphic_tmm.checking.judging.taken_marks import GIVEN, step_name
from graphic_tmm.checking.judging.yardstick import Yardstick
from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Judged, Taken
from graphic_tmm.drawn import DrawnScene

LEAST = 1e-9
"""A deviation below this share of the plan is none: numbers of the machine agree to some 1e-12 of it,
rulers divide to 1e-5."""
CARRIED = 1.0 / 3.0
"""A deviation follows from an earlier reading that brings at least this share of it: the rest is the hand's
own. With 0.1 or 0.2 one of 2000 readings is said to follow from another one, with 0.5 four, 0.8 thirteen."""


class _Off(NamedTuple):
    """A reading against its due, in mm or in its unit: the deviation with its sign, what rounding may carry."""

    found: float
    due: float
    signed: float
    grain: float
    times: float

    @property
    def counted(self) -> float:
        return counted(self.signed, self.grain)


class _Own(NamedTuple):
    """A reading against what earlier readings make of it: how far by which scatter, the step, its error."""

    scatter: Scatter
    counted: float
    step: Step | None
    error: float
    times: float = math.nan


def judge(made: DrawnScene, readings: Sequence[Taken], by: Yardstick) -> tuple[Judged, ...]:
    """Return every reading with its verdict; a row with mm, a quantity and a place is as many readings.

    ``made``: drawn by the exact hand.
    """
    rows = [part for taken in readings for part in taken.parts()]
    drawing = Comparison(made, rows, by)
    order = sorted(range(len(rows)), key=lambda k: _rank(drawing, rows[k]))
    found: dict[int, Judged] = {}
    verdicts: dict[Taken, str] = {}
    for k in order:
        found[k] = _judged(drawing, rows[k], verdicts)
        verdicts[rows[k]] = found[k].verdict
    return tuple(found[k] for k in range(len(rows)))


def _rank(drawing: Comparison, taken: Taken) -> tuple[float, bool]:
    """Return the place of a reading among the others: earlier steps first, mm before their quantity."""
    step = drawing.step(taken)
    return (math.inf if step is None else step.it.slot, not taken.in_mm)


def _judged(drawing: Comparison, taken: Taken, verdicts: Mapping[Taken, str]) -> Judged:
    seen, off = drawing.by.spread[taken.at], _off(drawing, taken)
    own = _own(drawing, taken)
    total = FINE if _none(drawing, taken, off, off.signed) else seen.verdict(off.counted, off.times)
    verdict, quantile = total, seen.quantile(off.counted)
    scatter, counted_off = seen, off.counted
    blamed, error, follows = drawing.step(taken), None, None
    if own is not None:
        still = _none(drawing, taken, off, own.error)
        mine = FINE if still else own.scatter.verdict(own.counted)
        if _strict(drawing, taken, verdicts) or _milder(mine, total):
            error = None if _rate(drawing, taken) else own.error
            verdict, blamed = mine, own.step
            quantile = own.scatter.quantile(0.0 if still else own.counted)
            scatter, counted_off = own.scatter, own.counted
            follows = _follows(drawing, taken, off) if mine == FINE != total else None
        else:  # it is as it should be, and an earlier reading, which is off, was not drawn with
            own = None
    return Judged(
        taken=taken,
        found=off.found,
        due=off.due,
        deviation=off.signed,
        percent=_percent(drawing, taken, off),
        quantile=quantile,
        verdict=verdict,
        unit="mm" if taken.in_mm else drawing.due[taken.key].unit,
        step=step_name(drawing.made.mechanism, blamed) if verdict != FINE else "",
        own=error,
        follows=follows,
        times=_times(seen, off) if own is None else own.times,
        doubt=scatter.doubt(counted_off) if verdict == DOUBTFUL else float(verdict == WRONG),
    )


def _times(seen: Scatter, off: _Off) -> float:
    """Return how many times what the hand is usually off a deviation is, with its sign."""
    usual = seen.rms
    return math.copysign(off.counted, off.signed) / usual if usual > 0.0 else math.nan


def _off(drawing: Comparison, taken: Taken) -> _Off:
    reader = drawing.by.reader
    if taken.pointed:
        spot, goal = taken.spot, drawing.spots[taken.key]
        grain = reader.lost(taken.last)
        return _Off(abs(spot), abs(goal), abs(spot - goal), grain, 0.0)
    cell = drawing.due[taken.key]
    found, goal = taken_figure(taken, cell), due_figure(cell, taken)
    grain = half_of(taken, cell)
    mu = 1.0 if taken.mm is not None else drawing.scale(taken)
    if mu > 0.0:
        grain = mu * reader.unblurred(grain / mu)
    elif drawing.is_given(taken):
        grain += GIVEN * abs(goal)
    signed = float(apart(found, goal, taken.signed or cell.direction))
    times = 0.0 if cell.direction else float(times_off(found, goal))  # near 0 it means nothing
    return _Off(found, goal, signed, grain, times)


def _own(drawing: Comparison, taken: Taken) -> _Own | None:
    """Return a reading against what the earlier ones make of it; None where that cannot be told."""
    if _other_sense(drawing, taken):
        return None
    if (length := drawing.length_of(taken)) is not None:
        return _agreed(drawing, taken, length)
    step = drawing.step(taken)
    steps = None if step is None else drawing.by.steps.get((step.it, drawing.place(taken)))
    errors = drawing.errors(taken)
    if not errors or steps is None:
        return None
    if taken.pointed:
        lost = drawing.by.reader.lost(taken.last, drawing.share)
        errors = tuple((one, error, lost) for one, error, _ in errors)
    times, by, error = steps.worst(errors, drawing.share if taken.pointed else 1.0)
    own = _Own(steps.scatter, times, by, error, math.copysign(times, error))
    return _mildest(drawing, taken, own) if taken.pointed else own


def _mildest(drawing: Comparison, taken: Taken, own: _Own) -> _Own:
    """Return the mildest of what a point is off by the log's construction and by others that are as right."""
    verdict = own.scatter.verdict(own.counted)
    if verdict == FINE:
        return own
    limits = pair(drawing.by.limits)
    grain = drawing.by.reader.lost(taken.last, drawing.share)
    for way in drawing.otherwise(taken):
        times, error = max(
            ((counted(one.error, grain) / one.size, one.error) for one in way),
            default=(math.inf, 0.0),
        )
        if not _milder(verdict, limits.verdict(times)):
            own, verdict = _Own(limits, times, own.step, error, times), limits.verdict(times)
    return own


def _agreed(drawing: Comparison, taken: Taken, length: Taken) -> _Own | None:
    """Return a quantity against the length beside it times μ, mm: it has no more slips than a calculation."""
    step, mu, hand = drawing.step(taken), drawing.scale(taken), drawing.by.reader.hand
    if not mu > 0.0:
        return None
    assert length.mm is not None
    cell = drawing.due[taken.key]
    found = taken_figure(taken, cell)
    error = abs(found) / mu - abs(length.mm)
    ruler = drawing.by.reader.half
    digits = drawing.by.reader.rounding(length.mm)
    grain = half_of(taken, cell) / mu + length.last.mm + ruler + digits
    most = drawing.by.limits.wrong * max(hand.reading, ruler)
    return _Own(Scatter(np.empty(0), 0.0, most), counted(error, grain), step, error)


def _strict(drawing: Comparison, taken: Taken, verdicts: Mapping[Taken, str]) -> bool:
    """Whether only what earlier readings make of a reading counts.

    Always of a point; of what is calculated, or measured between points that were read, if they are right.
    """
    if taken.pointed:
        return True
    sources = list(drawing.sources(taken))
    measured = drawing.length_of(taken) is None and not (
        _rate(drawing, taken) or drawing.calculated(taken)
    )
    if measured and not (sources and all(one.pointed for one in sources)):
        return False
    return all(verdicts.get(one) == FINE for one in sources)


def _other_sense(drawing: Comparison, taken: Taken) -> bool:
    """Whether a figure has the other sense than is due: lengths are read without one, so they do not tell it.

    Of what is no larger than a hand is off by it the sign is chance; a rate may have it by an earlier reading.
    """
    if taken.pointed or not (taken.signed or _rate(drawing, taken)):
        return False
    cell = drawing.due[taken.key]
    found, due = taken_figure(taken, cell), due_figure(cell, taken)
    if _rate(drawing, taken) and drawing.sense(taken) * found > 0.0:
        return False  # so it is by what was read before it
    if taken.signed and due < -drawing.by.spread[taken.at].doubtful:
        return found > 0.0
    return found < 0.0 < due and _rate(drawing, taken)


def _rate(drawing: Comparison, taken: Taken) -> bool:
    step = drawing.step(taken)
    return step is not None and step.it.kind is Number


def _follows(drawing: Comparison, taken: Taken, off: _Off) -> Taken | None:
    """Return the earlier reading that brings the most of a deviation."""
    sources = drawing.sources(taken)
    carried = [(drawing.carried(taken, one), -k) for k, one in enumerate(sources)]
    most, k = max(carried, default=(0.0, 0))
    mm = 1.0 if taken.in_mm or _rate(drawing, taken) else drawing.scale(taken)
    return sources[-k] if most * mm >= CARRIED * abs(off.signed) else None


def _none(drawing: Comparison, taken: Taken, off: _Off, error: float) -> bool:
    """Whether an error is nothing but the rounding of the machine."""
    whole = drawing.whole.get((taken.plan, taken.position), 0.0) if taken.in_mm else 0.0
    return abs(error) <= LEAST * max(whole, abs(off.due))


def _percent(drawing: Comparison, taken: Taken, off: _Off) -> float:
    """Return a deviation in % of the longest vector of its plan; NaN where nothing is drawn of it."""
    whole = drawing.whole.get((taken.plan, taken.position), 0.0)
    mu = 1.0 if taken.in_mm else drawing.scale(taken)
    return 100.0 * abs(off.signed) / mu / whole if whole and mu else math.nan


def _milder(one: str, other: str) -> bool:
    """Whether the first verdict is not more severe than the second."""
    return VERDICTS.index(one) <= VERDICTS.index(other)
