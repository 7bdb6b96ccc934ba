"""How one quantity grows with another: the slope of a straight line in log-log, and how sure it is."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan, cos, exp, isinf, log, nan, pi, sin, sqrt
from typing import NamedTuple

import numpy as np


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
