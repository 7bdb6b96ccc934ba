"""Quantiles of figures that come block by block, exact, without keeping all of the figures.

Of each row as many figures are kept about each quantile as may still become it: so many chance may bring below
or above it while the rest comes. What is kept grows with the square root of how many there are. Whether the
quantile has stayed among them is known at the end; where it has not, it is ``missed``.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals

Counts = NDArray[np.intp]
SURE = 6.0
"""So many standard deviations what comes may move a quantile: more happens to two rows of a billion."""
SLACK = 4
"""Figures kept beside those: at the end two are wanted, and few figures do not scatter as many do."""


class Window:
    """The figures about one quantile of each row: consecutive ones in order, and how many lie below them."""

    def __init__(self, share: float, rows: int, sure: float) -> None:
        self.share, self.sure = share, sure
        self.values = np.empty((rows, 0))
        self.size, self.below = np.zeros((2, rows), np.intp)
        self.cut = np.zeros(rows, np.bool_)

    def add(self, block: Reals, come: Counts, left: float) -> None:
        """Take figures in.

        Parameters
        ----------
        block
            (row, figure), in order, NaN last.
        come
            How many figures each row has by now, with these.
        left
            Which share of all trials is still to come.
        """
        low, high = self._bounds()
        first = (block < low).sum(axis=1)
        inside = (block <= high).sum(axis=1) - first
        self.below += first
        merged = np.concatenate([self.values, _cut(block, first, inside)], axis=1)
        merged.sort(axis=1)
        size = self.size + inside
        rank = self.share * (come - 1)
        reach = SLACK + self.sure * np.sqrt(self.share * (1.0 - self.share) * come * left)
        last = np.maximum(size - 1, 0)
        start = np.clip(np.floor(np.maximum(rank - reach, 0.0)) - self.below, 0, last)
        stop = np.clip(np.ceil(np.minimum(rank + reach, come)) + 1 - self.below, start + 1, size)
        begin, self.size = (
            start.astype(np.intp),
            np.where(size > 0, stop - start, 0).astype(np.intp),
        )
        self.cut |= begin + self.size < size
        self.below += begin
        self.values = _cut(merged, begin, self.size)

    def _bounds(self) -> tuple[Reals, Reals]:
        """Return between which figures nothing was left out so far, (row, 1) each."""
        if not self.values.shape[1]:
            return np.full((len(self.size), 1), -np.inf), np.full((len(self.size), 1), np.inf)
        top = np.take_along_axis(self.values, np.maximum(self.size - 1, 0)[:, None], axis=1)
        low = np.where(self.below[:, None] > 0, self.values[:, :1], -np.inf)
        return low, np.where(self.cut[:, None], top, np.inf)

    def told(self, come: Counts) -> tuple[Reals, NDArray[np.bool_]]:
        """Return the quantile of each row, between two figures by their distances, and where it is missed.

        NaN where a row has no figure, or where it is missed.
        """
        place = self.share * (come - 1)
        lower = np.floor(place).astype(np.intp)
        upper = np.minimum(lower + 1, come - 1)
        missed = (come > 0) & ((lower < self.below) | (upper >= self.below + self.size))
        there = (come > 0) & ~missed
        found = np.full(len(come), np.nan)
        rows = np.flatnonzero(there)
        a, b = (self.values[rows, (at - self.below)[rows]] for at in (lower, upper))
        part = (place - lower)[rows]
        # from the nearer end, as numpy does it: the last bits are those of a quantile of the whole row
        found[rows] = np.where(part < 0.5, a + (b - a) * part, b - (b - a) * (1.0 - part))
        return found, missed


def _cut(values: Reals, first: Counts, count: Counts) -> Reals:
    """Return so many figures of each row from its ``first`` on, ∞ behind them."""
    places = np.arange(int(count.max(initial=0)))
    at = np.minimum(first[:, None] + places, max(values.shape[1] - 1, 0))
    return np.where(places < count[:, None], np.take_along_axis(values, at, axis=1), np.inf)


class Quantiles:
    """Quantiles of rows of figures over many trials; ``trials``: how many will come altogether."""

    def __init__(self, shares: Sequence[float], trials: int, sure: float = SURE) -> None:
        self.shares, self.trials, self.sure = tuple(shares), trials, sure
        self._seen = 0
        self._come: Counts = np.empty(0, np.intp)
        self._windows: tuple[Window, ...] = ()

    def add(self, figures: Reals) -> None:
        """Take the figures of a block of trials in, (row, trial); what is not finite is left out."""
        if not self._windows:
            rows = len(figures)
            self._come = np.zeros(rows, np.intp)
            self._windows = tuple(Window(share, rows, self.sure) for share in self.shares)
        there = np.isfinite(figures)
        block = np.where(there, figures, np.nan)
        block.sort(axis=1)
        self._seen += figures.shape[1]
        self._come += there.sum(axis=1)
        left = max(self.trials - self._seen, 0) / self.trials
        for window in self._windows:
            window.add(block, self._come, left)

    @property
    def empty(self) -> bool:
        """Whether no figures have come yet."""
        return not self._windows

    @property
    def missed(self) -> bool:
        """Whether a quantile of a row is not among the figures that were kept."""
        return any(window.told(self._come)[1].any() for window in self._windows)

    @property
    def kept(self) -> int:
        """How many figures are kept."""
        return sum(window.values.size for window in self._windows)

    def told(self) -> Reals:
        """Return the quantiles, (share, row); NaN where no trial has a figure."""
        return np.array([window.told(self._come)[0] for window in self._windows])
