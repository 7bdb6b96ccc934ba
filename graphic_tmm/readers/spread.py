"""How figures scatter over many drawings by one hand: median, 5th and 95th hundredths beside each column.

The drawings come block by block, and no more of their figures is kept than those quantiles need.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Results
from graphic_tmm.readers.columns import (
    Column,
)
from graphic_tmm.readers.quantiles import SURE, Quantiles

QUANTILES = {"median": 0.5, "p5": 0.05, "p95": 0.95}
"""What is told of the trials, by the end of a column's name."""
ATTEMPTS = (SURE, 4 * SURE, 1e12)
"""How sure it is made, attempt by attempt, that all needed is kept; the last one keeps everything."""


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

    def told(self) -> Reals:
        """Return the `QUANTILES`, (quantile, place); NaN where no drawing has a figure."""
        if self._alike is None:
            return self._quantiles.told()
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
        """Take the same columns, and the results, of a block of so many drawings in."""
        for held, base, column in zip(self._scattered, self._columns, columns, strict=True):
            held.add(_beside(column.placed_as(base)), trials)
        for name, figure in self._figures.items():
            rows = results[name][0] if name in results else np.full(1, np.nan)
            figure.add(rows[:, None], trials)

    @property
    def missed(self) -> bool:
        """Whether too little was kept to tell all quantiles."""
        return any(one.missed for one in (*self._scattered, *self._figures.values()))

    def columns(self) -> Iterator[Column]:
        """Yield each column followed by its quantiles; a drawing that failed is left out of them."""
        for column, held in zip(self._columns, self._scattered, strict=True):
            yield column
            for name, row in zip(QUANTILES, held.told(), strict=True):
                mm, value = np.split(row[None], 2, axis=1)
                segment, letter = f"{column.segment}_{name}", f"{column.letter} {name}"
                yield replace(column, segment=segment, letter=letter, mm=mm, value=value)

    def results(self) -> Results:
        """Return each result followed by its quantiles over the drawings that have it."""
        found: dict[str, tuple[Reals, str]] = {}
        for name, (figures, unit) in self._results.items():
            found[name] = figures, unit
            told = self._figures[name].told()
            if np.isfinite(told).any():
                rows = zip(QUANTILES, told, strict=True)
                found |= {f"{name}_{key}": (figure, unit) for key, figure in rows}
        return found


def _beside(column: Column) -> Reals:
    """Return mm and figures of a column beside one another, (trial, place)."""
    count = max(len(column.mm), len(column.value))
    rows = (np.broadcast_to(one, (count, one.shape[1])) for one in (column.mm, column.value))
    return np.concatenate(tuple(rows), axis=1)
