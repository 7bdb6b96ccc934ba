"""A segment that is so many times what is due, by whatever was done: what a name of a mistake must beat.

Figures that are all too large by one number are explained by it as well as by a mistake that happens to make
them nearly so large. The number is one of some hundred that readings tell apart; that is what it costs.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.mutations.density import log_density, size_of

Array = NDArray[np.float64]
LEAST = 3
"""So many readings must be of one number, or it tells nothing."""
DECADES = float(2.0 * np.log(10.0))
"""The number is of these orders of magnitude (natural logarithm)."""


def multiple(found: Array, due: Array, scatter: Array, figure: Array, mm: float) -> float:
    """Return what readings gain, (logarithm) by being so many times as large as is due; 0 where they are few.

    All of one segment, (position,), NaN where it was not read. The number is the likeliest; what is lost by its
    being any other is Laplace's: the width of its peak against all that it may be.
    """
    size = size_of(scatter, figure, mm)
    known = np.isfinite(found + due + size) & (np.abs(due) > size)
    if known.sum() < LEAST:
        return 0.0
    found, due, size, figure, scatter = (one[known] for one in (found, due, size, figure, scatter))
    weights = np.abs(due / size)
    times = _median(found / due, weights)
    size_now = size_of(scatter, figure, mm, (times - 1.0) * due)
    width = 1.0 / float(np.sqrt(np.sum((due / size_now) ** 2)))
    cost = np.log(np.sqrt(2.0 * np.pi) * width / max(abs(times), width)) - np.log(DECADES)
    gains = log_density(found - times * due, size_now, figure)
    gains = gains - log_density(found - due, size, figure)
    return max(0.0, float(np.sum(gains)) + min(0.0, float(cost)))


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
