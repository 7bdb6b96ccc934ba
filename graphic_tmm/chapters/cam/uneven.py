"""A table of displacements at uneven angles: a spline through its lines tells those at even ones.

It is that of the flexible ruler: cubic between two lines, slope and curvature the same on both sides of each.
At an end at rest it is level; where the table begins or ends with a velocity it has that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam.task_motion import SAME, Law

SHOCK = 0.1
"""The velocity with which a table begins, of h/Φ, from which on it does not begin at rest.

Tables of the other laws have 0.011 at most, from 6 steps on; one of even motion has 1.
"""


def is_even(law: Law) -> bool:
    """Whether the lines of a table stand at even angles."""
    shares = [share for share, _ in law.points]
    return bool(np.abs(shares - np.linspace(0.0, 1.0, len(shares))).max() <= SAME)


def evened(law: Law) -> Law:
    """Return a table with as many lines at even angles, read off a spline through its own."""
    if is_even(law):
        return law
    x, y = np.array(law.points).T
    at, far = np.linspace(0.0, 1.0, x.size), np.diff(x)
    slopes, k = _slopes(x, y, law.digit), np.clip(np.searchsorted(x, at) - 1, 0, far.size - 1)
    u, h = (at - x[k]) / far[k], far[k]
    heights = (
        (2 * u + 1) * (u - 1) ** 2 * y[k]
        + u * (u - 1) ** 2 * h * slopes[k]
        + u * u * (3 - 2 * u) * y[k + 1]
        + u * u * (u - 1) * h * slopes[k + 1]
    )
    return replace(law, points=tuple(zip(at.tolist(), heights.tolist(), strict=True)))


def _slopes(x: Reals, y: Reals, digit: float) -> Reals:
    """Return the slopes of the spline at its lines: with them its curvature is the same on both sides."""
    steep, wanted = 1.0 / np.diff(x), np.zeros_like(y)
    system = np.diag([1.0, *2.0 * (steep[:-1] + steep[1:]), 1.0])
    system[1:-1] += np.eye(y.size)[:-2] * steep[:-1, None] + np.eye(y.size)[2:] * steep[1:, None]
    sums = 3.0 * np.diff(y) * steep**2
    wanted[1:-1] = sums[:-1] + sums[1:]
    wanted[[0, -1]] = _begins(x, y, digit), _begins(1.0 - x[::-1], 1.0 - y[::-1], digit)
    return np.asarray(np.linalg.solve(system, wanted))


def _begins(x: Sequence[float] | Reals, y: Sequence[float] | Reals, digit: float) -> float:
    """Return the slope of the cubic parabola through the first four lines; 0 if it may be one of rest."""
    weights = np.zeros(4)
    for k in range(1, 4):
        others = [m for m in range(1, 4) if m != k]
        weights[k] = np.prod([(x[0] - x[m]) / (x[k] - x[m]) for m in others]) / (x[k] - x[0])
    speed, doubt = float(weights @ y[:4]), 0.5 * digit * float(np.abs(weights).sum())
    return speed if speed > SHOCK + doubt else 0.0
