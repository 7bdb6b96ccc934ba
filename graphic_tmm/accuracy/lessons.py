"""What the runs of a scene teach: slopes, the best number of positions, the Pareto front."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.axes import dividing
from graphic_tmm.accuracy.fit import Slope, slope
from graphic_tmm.accuracy.measure import Run
from graphic_tmm.accuracy.pareto import front

ASIDE = ("trials", "slip", "ruler")
"""The axes on which it is not the setting that changes, but who draws."""
SMOOTH = 12
"""From so many positions on errors follow their power of N."""
FLAT = 1.25
"""Errors that differ by no more than this factor are told as the same. Chosen by eye."""
MOST = 0.8
"""And so they are if that share of them may as well be the least. Chosen by eye."""


class Fitted(NamedTuple):
    """How a quantity, drawn by the exact hand, goes with the number of positions: powers of N."""

    quantity: str
    error: Slope
    minutes: Slope
    seconds: Slope


class Optimum(NamedTuple):
    """The number of positions at which a hand errs least, and the first that is at least twice as many.

    ``sure``: the numbers whose error may as well be the least, as far as it is known. ``inside``: whether fewer
    and more were tried. ``flat``: whether the number makes no difference.
    """

    quantity: str
    axis: str
    hand: str
    best: Run
    finer: Run | None
    sure: tuple[int, ...]
    inside: bool
    flat: bool


def divisions(run: Run) -> int:
    """Return into how many parts a run's drawing is divided."""
    return int(run.value)


def along(runs: Iterable[Run], quantity: str, hand: str, axis: str | None = None) -> list[Run]:
    """Return the runs of a quantity along the axis of its number of positions, in order."""
    divided = dividing()
    found = [
        run
        for run in runs
        if run.quantity == quantity
        and run.hand == hand
        and (run.axis == axis if axis is not None else run.axis in divided)
    ]
    return sorted(found, key=divisions)


def fitted(runs: Sequence[Run]) -> tuple[Fitted, ...]:
    """Return the powers of N with which the exact hand's error falls and its costs grow."""
    found = []
    for quantity in dict.fromkeys(run.quantity for run in runs):
        row = [
            r for r in along(runs, quantity, "exact") if divisions(r) >= SMOOTH and r.error > 0.0
        ]
        if len(row) < 3:
            continue
        n = [float(divisions(run)) for run in row]
        times = [run.seconds.median if run.seconds else float("nan") for run in row]
        error, minutes = slope(n, [r.error for r in row]), slope(n, [r.work.minutes for r in row])
        found.append(Fitted(quantity, error, minutes, slope(n, times)))
    return tuple(found)


def optima(runs: Sequence[Run], hands: Sequence[str]) -> tuple[Optimum, ...]:
    """Return, for each quantity and hand, the number of positions at which it errs least."""
    found = []
    for quantity in dict.fromkeys(run.quantity for run in runs):
        for hand in hands:
            row = [r for r in along(runs, quantity, hand) if np.isfinite(r.error)]
            if len(row) > 2 and max(run.error for run in row) > 0.0:
                found.append(_optimum(row))
    return tuple(found)


def _optimum(row: Sequence[Run]) -> Optimum:
    errors = [run.error for run in row]
    at = int(np.argmin(errors))
    best = row[at]
    spread = best.errors.spread if np.isfinite(best.errors.spread) else 0.0
    sure = tuple(
        divisions(run) for run in row if run.error - 2.0 * _both(run, spread) <= best.error
    )
    finer = next((run for run in row if divisions(run) >= 2 * divisions(best)), None)
    flat = max(errors) <= FLAT * best.error or len(sure) >= MOST * len(row)
    inside = 0 < at < len(row) - 1
    return Optimum(best.quantity, best.axis, best.hand, best, finer, sure, inside, flat)


def _both(run: Run, spread: float) -> float:
    """Return the standard error of the difference of two errors."""
    own = run.errors.spread if np.isfinite(run.errors.spread) else 0.0
    return float(np.hypot(own, spread))


def best_of(runs: Sequence[Run], *, machine: bool = False) -> frozenset[Run]:
    """Return the runs on the Pareto front of their quantity and hand: error over minutes, or over seconds."""
    found: list[Run] = []
    for quantity, hand in dict.fromkeys((run.quantity, run.hand) for run in runs):
        row = [r for r in runs if (r.quantity, r.hand) == (quantity, hand) and r.axis not in ASIDE]
        if machine:
            row = [run for run in row if run.seconds is not None]
        costs = [run.seconds.median if machine and run.seconds else run.work.minutes for run in row]
        found += [row[k] for k in front(costs, [run.error for run in row])]
    return frozenset(found)
