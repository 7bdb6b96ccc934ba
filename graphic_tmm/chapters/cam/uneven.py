"""A table of displacements at uneven angles: a spline through its lines tells those at even ones.

It is that of the flexible ruler: cubic between two lines, slope and curvature the same on both sides of each.
At an end at rest it is level; where the table begins or ends with a velocity it has that. Where it would swing
beyond the lines of a gap the ruler is held: there it is no steeper than leaves it between them.
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

BEYOND = 1e-3
"""A spline swings beyond the lines of a gap by more of the stroke: of 3,000 random tables of smooth laws whose
gaps are up to nine times as long as others none does so by more than 2.2e-4."""
BETWEEN = np.linspace(0.0, 1.0, 18)[1:-1, None]
"""Where that is looked for, of a gap."""


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
    slopes, k = (
        _held(x, y, _slopes(x, y, law.digit)),
        np.clip(np.searchsorted(x, at) - 1, 0, far.size - 1),
    )
    heights = _cubic((at - x[k]) / far[k], far[k], (y[k], y[k + 1]), (slopes[k], slopes[k + 1]))
    points = tuple(zip(at.tolist(), heights.tolist(), strict=True))
    return replace(law, points=points, ends=(float(slopes[0]), float(slopes[-1])))


def _cubic(u: Reals, far: Reals, ends: tuple[Reals, Reals], slopes: tuple[Reals, Reals]) -> Reals:
    """Return the heights of a cubic in gaps as long as ``far``, at shares ``u`` of them."""
    return (
        (2 * u + 1) * (u - 1) ** 2 * ends[0]
        + u * (u - 1) ** 2 * far * slopes[0]
        + u * u * (3 - 2 * u) * ends[1]
        + u * u * (u - 1) * far * slopes[1]
    )


def _held(x: Reals, y: Reals, slopes: Reals) -> Reals:
    """Return slopes with which no gap is left by more than `BEYOND`.

    With slopes of up to three times the smaller chord about a line a cubic rises where its lines do (Fritsch,
    Carlson).
    """
    far, chords = np.diff(x), np.diff(y) / np.diff(x)
    before, behind = (np.concatenate(two) for two in ((chords[:1], chords), (chords, chords[-1:])))
    most = (
        3.0 * np.minimum(np.abs(before), np.abs(behind)) * (before * behind > 0.0) * np.sign(before)
    )
    low, high = np.minimum(y[:-1], y[1:]), np.maximum(y[:-1], y[1:])
    for _ in far:
        between = _cubic(BETWEEN, far, (y[:-1], y[1:]), (slopes[:-1], slopes[1:]))
        swings = np.maximum(between.max(axis=0) - high, low - between.min(axis=0)) > BEYOND
        about = np.append(swings, False) | np.insert(swings, 0, False)
        limited = np.clip(slopes, np.minimum(most, 0.0), np.maximum(most, 0.0))
        slopes = np.where(about, limited, slopes)
    return slopes


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
