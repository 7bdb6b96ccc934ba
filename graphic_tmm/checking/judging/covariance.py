"""How readings of a position go together in the drawings of a hand, and how rare those of a drawing are.

A ray that swings moves all that is drawn from it. Given the others, a reading is known better than by itself:
its residual is (P x)ᵢ/√Pᵢᵢ, P the inverse of the covariance of the hand's drawings, x the deviations, each by
what it usually is. The limits are those of the hand's own drawings, not of a normal table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from statistics import NormalDist
from typing import Any, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board.values import Reals

T = TypeVar("T")

RIDGE = 0.04
"""Is added to the variance of every reading, each measured by its size: no reading is known better than a fifth
of what a hand is off by it, whatever others tell. With 0 to 0.25 the power is the same within 2 %."""
LOOSE = 3.5
"""Of 400 normal figures the largest is above so many standard deviations once in six: where the farthest of the
hand's drawings is more, it has long tails there, and its size is taken for so much larger."""
FEWEST = 4
"""Of fewer drawings a reading no covariance is known."""
FALSE_ALARMS = 0.0003
"""In this share of the drawings of the hand some reading is wrong given the others. With the limits of each by
itself (`Limits`) it makes 0.1 %."""
FEW, MUCH_WORSE = 20, 1.6
"""Fewer readings do not tell how far off a hand is; none is taken for more than so many times worse, else a
mistake would hide."""
EULER = 0.5772156649015329
KEPT = 1000
"""So much that was found out of readings is kept at the most: of drawings of one form some fifty."""


class Covariance(NamedTuple):
    """How readings go together: the inverse of their covariance, and what it makes of the hand's drawings.

    ``sizes``: of residuals; ``residuals``: by their sizes, without signs, (reading, drawing); ``squares``:
    their sum of squares, (drawing,).
    """

    precision: Reals
    sizes: Reals
    residuals: Reals
    squares: Reals


class Usual(NamedTuple):
    """What is usual of a drawing: the median of its residuals, the limit of the largest, sums of squares."""

    median: float
    limit: float
    squares: Reals


class Covariances:
    """The covariances of the readings of a hand's drawings: each is found once, whatever is judged."""

    def __init__(self) -> None:
        self._hand: dict[int, tuple[object, Reals]] = {}
        self._kept: dict[tuple[Any, ...], tuple[Any, Sequence[object]]] = {}

    def hand(self, by: object, found: Callable[[], Reals]) -> Reals:
        """Return what the hand's drawings have of a reading; ``by``: of what it is known, there to stay."""
        if id(by) not in self._hand:
            self._hand[id(by)] = (by, found())
        return self._hand[id(by)][1]

    def of(self, rows: Sequence[Reals]) -> Covariance | None:
        """Return how readings go together; None if too few drawings tell. ``rows``: as `hand` returns them."""
        if FEWEST * len(rows) > rows[0].size:
            return None
        return self._once("readings", rows, lambda: covariance(np.array(rows, np.float64)))

    def summed(self, rows: Sequence[Reals], shares: Reals) -> tuple[float, Reals]:
        """Return the root mean square of the sum of readings, each with its share, and the sums so measured."""
        return self._once("sum", rows, lambda: summed(np.array(rows, np.float64), shares))

    def usual(self, some: Sequence[Covariance]) -> Usual:
        """Return what is usual of drawings with all these readings."""
        return self._once("usual", some, lambda: usual(some))

    def _once(self, kind: str, some: Sequence[object], found: Callable[[], T]) -> T:
        """Return what is found out of some things, which are kept with it: they are known by being the same."""
        key = (kind, *map(id, some))
        if key not in self._kept:
            if len(self._kept) >= KEPT:
                self._kept.clear()
            self._kept[key] = (found(), tuple(some))
        return self._kept[key][0]  # type: ignore[no-any-return]


def covariance(hand: Reals) -> Covariance:
    """Return how readings go together; ``hand``: of each how far off the drawings are, (reading, drawing)."""
    count, drawings = hand.shape
    precision = np.linalg.inv(hand @ hand.T / drawings + RIDGE * np.eye(count))
    moved = precision @ hand
    squares = np.einsum("it,it->t", hand, moved)
    # as if each drawing were judged by the covariance of all others
    alone = 1.0 - np.minimum(squares / drawings, 0.5)
    moved, squares = moved / alone, squares / alone
    residuals = np.abs(moved) / np.sqrt(np.diag(precision))[:, None]
    root = np.sqrt(np.mean(residuals**2, axis=1))
    sizes = np.maximum(root, np.max(residuals, axis=1) / LOOSE)
    return Covariance(precision, sizes, residuals / sizes[:, None], squares)


def summed(hand: Reals, shares: Reals) -> tuple[float, Reals]:
    """Return the root mean square of the sum of readings, each with its share, and the sums so measured."""
    row = shares @ hand
    size = float(np.sqrt(np.mean(row**2)))
    return size, row / size


def without(precision: Reals, at: int) -> Reals:
    """Return the inverse of a covariance as it is without one of its readings, by its number."""
    rest = np.delete(np.arange(len(precision)), at)
    row = precision[rest, at]
    return precision[np.ix_(rest, rest)] - np.outer(row, row) / precision[at, at]  # type: ignore[no-any-return]


def usual(some: Sequence[Covariance]) -> Usual:
    """Return what is usual of drawings with all readings of these covariances."""
    residuals = np.concatenate([one.residuals for one in some])
    medians = np.median(residuals, axis=0)
    median = float(np.median(medians))
    worse = np.array([worse_than(median, float(one), len(residuals)) for one in medians])
    limit = math.sqrt(rare_largest(np.max(residuals / worse, axis=0) ** 2, FALSE_ALARMS))
    return Usual(median, limit, np.sum([one.squares for one in some], axis=0))


def worse_than(usual: float, median: float, count: int) -> float:
    """Return how many times worse a hand is, by the median of so many residuals and the usual one."""
    return 1.0 if count < FEW else min(max(median / usual, 1.0), MUCH_WORSE)


def rare_largest(largest: Reals, share: float) -> float:
    """Return what the largest of some figures exceeds in a small share of drawings; ``largest``: of drawings.

    By Gumbel's distribution of their mean and variance, which largest squares of normal figures tend to.

    >>> draws = np.random.default_rng(1).standard_normal((40, 20000)) ** 2
    >>> most = rare_largest(np.max(draws[:, :400], axis=0), 0.001)
    >>> bool(0.0003 < np.mean(np.max(draws, axis=0) > most) < 0.003)
    True
    """
    width = float(np.std(largest)) * math.sqrt(6.0) / math.pi
    return float(np.mean(largest)) - width * (EULER + math.log(-math.log1p(-share)))


def tail(here: float, hand: Reals) -> float:
    """Return in which share of a hand's drawings a sum of squares is as large; 1 where one of them has it.

    Beyond the drawings it is that of a multiple of χ² with their mean and variance (Satterthwaite), by
    Wilson's and Hilferty's cube root.
    """
    if not here > float(np.max(hand)):
        return 1.0
    mean, variance = float(np.mean(hand)), float(np.var(hand))
    freedom = 2.0 * mean * mean / variance
    spread = 2.0 / (9.0 * freedom)
    return NormalDist().cdf(-((here / mean) ** (1.0 / 3.0) - (1.0 - spread)) / math.sqrt(spread))
