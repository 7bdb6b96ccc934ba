"""How figures scatter over many drawings by one hand: exact quantiles of each column, block by block."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Results
from graphic_tmm.readers.columns import Column

Counts = NDArray[np.intp]
SURE = 6.0
"""So many standard deviations what comes may move a quantile: more happens to two rows of a billion."""
SLACK = 4
"""Further figures kept: two are needed at the end, and few figures do not scatter as many do."""


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

    def quantile(self, come: Counts) -> tuple[Reals, NDArray[np.bool_]]:
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
    """Return ``count`` figures of each row from its ``first`` on, then ∞."""
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
        return any(window.quantile(self._come)[1].any() for window in self._windows)

    @property
    def kept(self) -> int:
        """How many figures are kept."""
        return sum(window.values.size for window in self._windows)

    def result(self) -> Reals:
        """Return the quantiles, (share, row); NaN where no trial has a figure."""
        return np.array([window.quantile(self._come)[0] for window in self._windows])


QUANTILES = {"median": 0.5, "p5": 0.05, "p95": 0.95}
"""Statistics of the trials, by the suffix of a column's name."""
ATTEMPTS = (SURE, 4 * SURE, 1e12)
"""Margins of what is kept, attempt by attempt; the last one keeps everything."""


class Scattered:
    """Figures along some places over ``trials`` drawings; one row as long as all drawings are alike."""

    def __init__(self, trials: int, sure: float) -> None:
        self._alike: Reals | None = None
        self._times = 0
        self._quantiles = Quantiles(tuple(QUANTILES.values()), trials, sure)

    def add(self, rows: Reals, trials: int) -> None:
        """Take a block of drawings in, (trial, place), or the one row (1, place) of all of them."""
        first = self._alike if self._alike is not None else rows
        if self._quantiles.empty and len(rows) == 1 and np.array_equal(first, rows, equal_nan=True):
            self._alike, self._times = first, self._times + trials
            return
        if self._alike is not None:
            self._quantiles.add(np.broadcast_to(self._alike.T, (rows.shape[1], self._times)))
            self._alike = None
        self._quantiles.add(np.broadcast_to(rows, (trials, rows.shape[1])).T)

    @property
    def missed(self) -> bool:
        """Whether too little was kept."""
        return self._quantiles.missed

    def result(self) -> Reals:
        """Return the `QUANTILES`, (quantile, place); NaN where no drawing has a figure."""
        if self._alike is None:
            return self._quantiles.result()
        row = np.where(np.isfinite(self._alike), self._alike, np.nan)
        return np.repeat(row, len(QUANTILES), axis=0)


class Spread:
    """The columns and results of a drawing, and how those of ``trials`` drawings scatter about them."""

    def __init__(
        self, columns: Sequence[Column], results: Results, trials: int, sure: float = SURE
    ) -> None:
        self._columns, self._results = columns, results
        self._scattered = [Scattered(trials, sure) for _ in columns]
        self._figures = {name: Scattered(trials, sure) for name in results}

    def add(self, columns: Sequence[Column], results: Results, trials: int) -> None:
        """Take in the same columns, and the results, of a further block of drawings."""
        for held, base, column in zip(self._scattered, self._columns, columns, strict=True):
            held.add(_paired(column.placed_as(base)), trials)
        for name, figure in self._figures.items():
            rows = results[name][0] if name in results else np.full(1, np.nan)
            figure.add(rows[:, None], trials)

    @property
    def missed(self) -> bool:
        """Whether too little was kept for all quantiles."""
        return any(one.missed for one in (*self._scattered, *self._figures.values()))

    def columns(self) -> Iterator[Column]:
        """Yield each column followed by its quantiles; a drawing that failed is left out of them."""
        for column, held in zip(self._columns, self._scattered, strict=True):
            yield column
            for name, row in zip(QUANTILES, held.result(), strict=True):
                mm, value = np.split(row[None], 2, axis=1)
                segment, letter = f"{column.segment}_{name}", f"{column.letter} {name}"
                yield replace(column, segment=segment, letter=letter, mm=mm, value=value)

    def results(self) -> Results:
        """Return each result followed by its quantiles over the drawings that have it."""
        found: dict[str, tuple[Reals, str]] = {}
        for name, (figures, unit) in self._results.items():
            found[name] = figures, unit
            told = self._figures[name].result()
            if np.isfinite(told).any():
                rows = zip(QUANTILES, told, strict=True)
                found |= {f"{name}_{key}": (figure, unit) for key, figure in rows}
        return found


def _paired(column: Column) -> Reals:
    """Return mm and figures of a column side by side, (trial, place)."""
    count = max(len(column.mm), len(column.value))
    rows = (np.broadcast_to(one, (count, one.shape[1])) for one in (column.mm, column.value))
    return np.concatenate(tuple(rows), axis=1)
