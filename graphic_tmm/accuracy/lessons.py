"""What the runs of a scene teach: slopes in log-log, the best number of positions, the Pareto front."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import atan, cos, exp, isinf, log, nan, pi, sin, sqrt
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.measure import Measurement
from graphic_tmm.accuracy.settings import dividing


class Slope(NamedTuple):
    """y = e^``level`` · x^``slope``, fitted to ``points`` points.

    ``error``: standard error of the slope, from the scatter of the points about the line; NaN for two points.
    """

    slope: float
    level: float
    error: float
    points: int

    def half_width(self, confidence: float = 0.95) -> float:
        """Return half of the slope's interval of confidence, by Student's distribution."""
        return self.error * student(confidence, self.points - 2) if self.points > 2 else nan

    def at(self, x: float) -> float:
        """Return the fitted y at x."""
        return exp(self.level + self.slope * log(x))


def slope(x: Sequence[float], y: Sequence[float]) -> Slope:
    """Return the line of least squares through log y over log x.

    Points where either is not a positive finite number are left out: an error of exactly 0 has no logarithm.
    All fields but ``points`` are NaN if fewer than two different x are left.

    Raises
    ------
    ValueError
        If there are not as many x as y.
    """
    if len(x) != len(y):
        raise ValueError(f"{len(x)} of x, but {len(y)} of y")
    both = np.array([x, y], dtype=np.float64)
    there = np.all(np.isfinite(both) & (both > 0.0), axis=0)
    u, v = np.log(both[:, there])
    n = u.size
    if n == 0 or u.max() == u.min():
        return Slope(nan, nan, nan, n)
    du, dv = u - u.mean(), v - v.mean()
    spread = float(du @ du)
    found = float(du @ dv) / spread
    left = dv - found * du
    error = sqrt(float(left @ left) / (n - 2) / spread) if n > 2 else nan
    return Slope(found, float(v.mean()) - found * float(u.mean()), error, n)


def student(confidence: float, freedom: int) -> float:
    """Return the t that a variable of Student's distribution stays within, both ways, with that confidence.

    ``freedom``: degrees of freedom, at least 1. NaN unless 0 < ``confidence`` < 1.
    """
    if not (0.0 < confidence < 1.0 and freedom >= 1):
        return nan
    low, high = 0.0, 1.0
    while _within(high, freedom) < confidence and not isinf(high):
        low, high = high, 2.0 * high
    while (middle := (low + high) / 2.0) not in (low, high):
        low, high = (middle, high) if _within(middle, freedom) < confidence else (low, middle)
    return high


def _within(t: float, freedom: int) -> float:
    """Return the probability of |t'| < t: the finite series for whole degrees of freedom."""
    theta = atan(t / sqrt(freedom))
    start = 1 if freedom % 2 else 0
    term, total = (cos(theta), 0.0) if start else (1.0, 0.0)
    for k in range(start, freedom - 1, 2):
        total += term
        term *= (k + 1) / (k + 2) * cos(theta) ** 2
    if start:
        return 2.0 / pi * (theta + sin(theta) * total)
    return sin(theta) * total


def front(costs: Sequence[float], errors: Sequence[float]) -> tuple[int, ...]:
    """Return the indices of the settings on the Pareto front, from the cheapest to the most exact.

    A setting stands on it if no other costs as little and errs as little, one of the two less; of equal ones
    the first stands for all. A cost or an error that is not finite keeps a setting out.
    """
    cost, error = np.asarray(costs, dtype=np.float64), np.asarray(errors, dtype=np.float64)
    there = np.flatnonzero(np.isfinite(cost) & np.isfinite(error))
    order = there[np.lexsort((there, error[there], cost[there]))]
    found, best = [], np.inf
    for index in order:
        if error[index] < best:
            found.append(int(index))
            best = error[index]
    return tuple(found)


ASIDE = ("trials", "slip", "ruler")
"""The axes on which it is not the setting that changes, but who draws."""
SMOOTH = 12
"""From this number of positions on errors follow their power of N."""
FLAT = 1.25
"""Errors within this factor of each other count as equal. Chosen by eye."""
MOST = 0.8
"""And so they are if that share of them may as well be the least. Chosen by eye."""


class Fitted(NamedTuple):
    """How a quantity, drawn by the exact hand, goes with the number of positions: powers of N."""

    quantity: str
    error: Slope
    minutes: Slope
    seconds: Slope


class Optimum(NamedTuple):
    """The number of positions at which a hand errs least.

    ``sure``: the numbers whose error may as well be the least, as far as it is known. ``inside``: whether fewer
    and more were tried. ``flat``: whether the number makes no difference.
    """

    quantity: str
    axis: str
    hand: str
    best: Measurement
    sure: tuple[int, ...]
    inside: bool
    flat: bool


def divisions(run: Measurement) -> int:
    """Return into how many parts a run's drawing is divided."""
    return int(run.value)


def along(
    runs: Iterable[Measurement], quantity: str, hand: str, axis: str | None = None
) -> list[Measurement]:
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


def slopes(runs: Sequence[Measurement]) -> tuple[Fitted, ...]:
    """Return the powers of N with which the exact hand's error falls and its costs grow."""
    found = []
    for quantity in dict.fromkeys(run.quantity for run in runs):
        row = [
            r for r in along(runs, quantity, "exact") if divisions(r) >= SMOOTH and r.error > 0.0
        ]
        if len(row) < 3:
            continue
        n = [float(divisions(run)) for run in row]
        times = [
            run.seconds.least if run.seconds and not run.seconds.doubtful else nan for run in row
        ]
        error, minutes = slope(n, [r.error for r in row]), slope(n, [r.work.minutes for r in row])
        found.append(Fitted(quantity, error, minutes, slope(n, times)))
    return tuple(found)


def optima(runs: Sequence[Measurement], hands: Sequence[str]) -> tuple[Optimum, ...]:
    """Return, for each quantity and hand, the number of positions at which it errs least."""
    found = []
    for quantity in dict.fromkeys(run.quantity for run in runs):
        for hand in hands:
            row = [r for r in along(runs, quantity, hand) if np.isfinite(r.error)]
            if len(row) > 2 and max(run.error for run in row) > 0.0:
                found.append(_optimum(row))
    return tuple(found)


def _optimum(row: Sequence[Measurement]) -> Optimum:
    errors = [run.error for run in row]
    at = int(np.argmin(errors))
    best = row[at]
    spread = best.errors.spread if np.isfinite(best.errors.spread) else 0.0
    sure = tuple(
        divisions(run) for run in row if run.error - 2.0 * _both(run, spread) <= best.error
    )
    flat = max(errors) <= FLAT * best.error or len(sure) >= MOST * len(row)
    inside = 0 < at < len(row) - 1
    return Optimum(best.quantity, best.axis, best.hand, best, sure, inside, flat)


def _both(run: Measurement, spread: float) -> float:
    """Return the standard error of the difference of two errors."""
    own = run.errors.spread if np.isfinite(run.errors.spread) else 0.0
    return float(np.hypot(own, spread))


def best_of(runs: Sequence[Measurement]) -> frozenset[Measurement]:
    """Return the runs on the Pareto front of their quantity and hand: error over minutes at the board."""
    found: list[Measurement] = []
    for quantity, hand in dict.fromkeys((run.quantity, run.hand) for run in runs):
        row = [r for r in runs if (r.quantity, r.hand) == (quantity, hand) and r.axis not in ASIDE]
        costs = [run.work.minutes for run in row]
        found += [row[k] for k in front(costs, [run.error for run in row])]
    return frozenset(found)
