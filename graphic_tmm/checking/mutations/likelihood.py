"""How likely a reading is that is so far off, or that is so many times what is due."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ODD, ANY = 0.01, 0.01
"""The share of readings that a hand's slips spread more widely, and of those that are anything."""
WIDER = 3.0
"""So many times wider are the former: a Cauchy distribution."""
MAGNITUDES = float(np.log(1e6))
"""What is anything is so over some six orders of magnitude (natural logarithm)."""
BEYOND = 4.0
"""Farther off than so many standard deviations a reading is not explained: one of 16,000 is by chance."""
SLIP = 5.0
"""Of what a mistake moves and does not explain it is taken to be so many standard deviations off."""
LEAST_MM, LEAST_SHARE, OF_CHANGE = 0.35, 0.005, 0.02
"""No error is told more finely than this: mm on the paper (a pencil line is so wide), of the figure, of what a
mistake moves it by (a longer line swings farther)."""

MOVED = 1e-6
"""By so many standard deviations a reading is moved at least by what moves it; less is rounding."""
PLAN = 100.0
"""How large the figure of a point is taken, mm: how far off anything is on a plan."""
LOST = -50.0
"""The logarithm of how likely a reading is of what cannot be drawn: never, whatever else it explains."""
FARTHEST = 1e9
"""What moves farther is nowhere: its square is still a number of the machine."""


def log_density(error: Any, size: Any, figure: Any) -> Array:
    """Return the logarithm of the density of an error, of that standard deviation, of such a figure."""
    off = np.minimum(np.abs(error), FARTHEST)
    normal = np.exp(-0.5 * (off / size) ** 2) / (size * np.sqrt(2.0 * np.pi))
    wide = 1.0 / (np.pi * WIDER * size * (1.0 + (off / (WIDER * size)) ** 2))
    found = (1.0 - ODD - ANY) * normal + ODD * wide + ANY * broad(off, size, figure)
    return np.asarray(np.log(found))


def broad(off: Any, size: Any, figure: Any) -> Array:
    """Return the density of an error of which nothing is known but the figure's own magnitude."""
    whole = np.maximum(np.abs(figure), 10.0 * size)
    even = np.where(off <= 2.0 * whole, 0.125 / whole, 0.0)
    return np.asarray(even + 0.25 / ((off + size) * MAGNITUDES))


class Likelihood(NamedTuple):
    """How likely readings are (logarithm), how far off, standard deviations, 1 for what cannot be drawn."""

    likely: Array
    off: Array
    gone: Array


class Evidence(NamedTuple):
    """What hypotheses gain on the base, (hypothesis, position and, last, what has none of the mechanism's).

    ``beyond``, ``lost``: how many readings each leaves unexplained, and how many it cannot draw. ``moved``,
    ``squares``: how many it moves and explains, and the sum of the squares of how far off these are.
    """

    gain: Array
    beyond: Array
    lost: Array
    moved: Array
    squares: Array

    @classmethod
    def none(cls, count: int, places: int) -> Evidence:
        """Return the evidence for so many hypotheses before anything has been read."""
        return cls(*(np.zeros((count, places + 1)) for _ in cls._fields))

    def begin(self, at: Any, base: Likelihood) -> None:
        """Count which readings ``at`` positions are beyond by the base, and so by all hypotheses as yet."""
        self.beyond[:, at] += base.off > BEYOND

    def add(self, rows: Any, at: Any, now: Likelihood, base: Likelihood) -> None:
        """Add what some hypotheses, ``rows``, make of readings that are counted by the base."""
        self.gain[rows, at] += now.likely - base.likely
        self.beyond[rows, at] += (now.off > BEYOND) * 1.0 - (base.off > BEYOND)
        self.lost[rows, at] += now.gone
        moved, squares = explained(now.off, base.off)
        self.moved[rows, at] += moved
        self.squares[rows, at] += squares

    def plus(self, other: Evidence) -> Evidence:
        """Return the evidence of other readings, too."""
        return Evidence(*map(np.add, self, other))


def explained(off: Any, before: Any) -> tuple[Array, Array]:
    """Return which readings something moves, and the squares of how far off these then are.

    ``off``, ``before``: in standard deviations, with it and without. A reading that it moves and leaves beyond
    may be a slip beside it: it counts as `SLIP`, which a score of others outweigh.
    """
    change = np.abs(off - before)
    moved = np.where(off <= BEYOND, change > MOVED, change > 1.0)
    return moved * 1.0, np.where(moved, np.minimum(off, SLIP), 0.0) ** 2


def size_of(scatter: Any, figure: Any, mm: Any, change: Any = 0.0) -> Array:
    """Return the standard deviation by which an error is measured.

    ``scatter``: the hand's; ``figure``: what is read; ``mm``: what a millimetre is in its unit (0 of what
    is not measured); ``change``: by how much a mistake moves it.
    """
    moved = OF_CHANGE * np.minimum(np.abs(change), FARTHEST)
    least = LEAST_MM * mm, LEAST_SHARE * np.abs(figure), moved
    return np.asarray(np.sqrt(scatter**2 + sum(one**2 for one in least)))


LEAST = 3
"""So many readings must be of one number, or it tells nothing."""
DECADES = float(2.0 * np.log(10.0))
"""The number is of these orders of magnitude (natural logarithm)."""


def multiple(
    found: Array, due: Array, scatter: Array, figure: Array, mm: float, *, own: bool = False
) -> float:
    """Return what readings gain, (logarithm) by being so many times as large as is due; 0 where they are few.

    All of one segment, (position,), NaN where it was not read. The number is the likeliest; what is lost by its
    being any other is Laplace's: the width of its peak against all that it may be. ``own``: the number is of a
    scale factor, which has no sign to reverse.
    """
    size = size_of(scatter, figure, mm)
    known = np.isfinite(found + due + size) & (np.abs(due) > size)
    if known.sum() < LEAST:
        return 0.0
    found, due, size, figure, scatter = (one[known] for one in (found, due, size, figure, scatter))
    weights = np.abs(due / size)
    times = _median(found / due, weights)
    if times <= 0.0 and own:
        return 0.0
    size_now = size_of(scatter, figure, mm, (times - 1.0) * due)
    width = 1.0 / float(np.sqrt(np.sum((due / size_now) ** 2)))
    cost = np.log(np.sqrt(2.0 * np.pi) * width / max(abs(times), width)) - np.log(DECADES)
    gains = log_density(found - times * due, size_now, figure)
    gains = gains - log_density(found - due, size, figure)
    return max(0.0, float(np.sum(gains)) + min(0.0, float(cost)))


SHORT, NEAR = 6.0, 2.5
"""Shorter lengths, mm, tell no number that all have; nor do those that are so many usual errors off it."""


def common(read: Array, due: Array) -> float:
    """Return how many times as long as due most lengths are, by least squares; 1 where few are long."""
    long = due > SHORT
    if long.sum() < LEAST:
        return 1.0
    read, due = read[long], due[long]
    near = np.abs(read / due - np.median(read / due)) <= NEAR * np.hypot(0.9 / due, 0.02)
    if not near.any():
        return 1.0
    return float((read * due)[near].sum() / (due**2)[near].sum())


def _median(of: Array, weights: Array) -> float:
    """Return a weighted median: a slip of one reading does not move it far."""
    order = np.argsort(of, kind="stable")
    whole = np.cumsum(weights[order])
    return float(of[order][np.searchsorted(whole, 0.5 * whole[-1])])


def scores(gains: Iterable[float], prior: float) -> list[float]:
    """Return how likely (logarithm) it is that one of some segments is so, each, of what they gain."""
    some = list(gains)
    each = float(np.log(prior / max(1, len(some))))
    return [each + gain for gain in some if gain > 0.0]
