"""Readings as the hand's own drawings are: each by how many times what the hand is usually off it is."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.checking.judging.scatter import Scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.judging.yardstick import Yardstick
from graphic_tmm.checking.records import Judged
from graphic_tmm.drawn import DrawnScene


class CountedReading(NamedTuple):
    """A reading that counts: how many times what the hand is off, in this drawing and in each of the hand's.

    ``by``: of what that is known, the own errors of its step or its figure.
    """

    judged: Judged
    times: float
    step: Step | None
    hand: Reals
    by: StepScatter | Scatter


def counted_readings(
    made: DrawnScene, judged: Sequence[Judged], by: Yardstick
) -> list[CountedReading]:
    """Return the readings that count: not rates, which say what their lengths do, nor what is given."""
    work, found = made.mechanism, []
    steps: Mapping[tuple[str, str], Step] = steps_of(work)
    places = {} if work is None else {name: k for k, name in enumerate(work.names)}
    for one in judged:
        taken = one.taken
        step = steps.get((taken.plan, taken.segment))
        if not math.isfinite(one.times) or (step is not None and step.it.kind is Number):
            continue
        own = None if step is None else by.steps.get((step.it, places.get(taken.position, -1)))
        source: StepScatter | Scatter = by.spread[taken.at]
        if own is not None and one.own is not None:
            source = own
        hand = by.covariances.hand(source, lambda: _hand(source, _sense(one)))  # noqa: B023
        if hand.size:
            times = one.times * (_sense(one) if one.found < 0.0 else 1.0)
            found.append(CountedReading(one, times, step, hand, source))
    return found


def _hand(by: StepScatter | Scatter, sense: float) -> Reals:
    """Return how many times what it is usually off each of the hand's drawings is; none if all are alike."""
    row = by.drawn
    if isinstance(by, Scatter):
        row = sense * row / (by.rms or 1.0)
    return row if row.size and float(np.ptp(row)) > 0.0 else np.empty(0)


def _sense(one: Judged) -> float:
    """Return the sign of what is due: an excess is one of the magnitude, whether a sign was read or not."""
    return 1.0 if one.taken.pointed else math.copysign(1.0, one.due)
