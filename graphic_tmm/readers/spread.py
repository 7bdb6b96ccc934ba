"""How figures scatter over many drawings by one hand: median, 5th and 95th hundredths beside each column."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Results
from graphic_tmm.readers.columns import (
    Column,
)

QUANTILES = {"median": 0.5, "p5": 0.05, "p95": 0.95}
"""What is told of the trials, by the end of a column's name."""


def spread_columns(base: Sequence[Column], trials: Sequence[Column]) -> list[Column]:
    """Return each column followed by its quantiles over the trials; a trial that failed is left out of them.

    ``trials``: the same columns of many drawings, in the order of ``base``.
    """
    found = []
    for column, drawn in zip(base, trials, strict=True):
        found.append(column)
        rows = zip(quantiles(drawn.mm), quantiles(drawn.value), strict=True)
        for name, (mm, value) in zip(QUANTILES, rows, strict=True):
            segment, letter = f"{column.segment}_{name}", f"{column.letter} {name}"
            told = {"segment": segment, "letter": letter, "mm": mm[None], "value": value[None]}
            found.append(replace(column, **told))
    return found


def spread_results(base: Results, trials: Results) -> Results:
    """Return each result followed by its quantiles over the trials that have it."""
    found: dict[str, tuple[Reals, str]] = {}
    for name, (figures, unit) in base.items():
        found[name] = figures, unit
        if name in trials and np.isfinite(trials[name][0]).any():
            told = quantiles(trials[name][0][:, None])
            keys = (f"{name}_{key}" for key in QUANTILES)
            found |= {key: (figure, unit) for key, figure in zip(keys, told, strict=True)}
    return found


def joined_columns(blocks: Sequence[tuple[int, Sequence[Column]]]) -> list[Column]:
    """Return the columns of blocks of drawings, each of so many trials, as those of all of them."""
    trials = [n for n, _ in blocks]
    found = []
    for same in zip(*(columns for _, columns in blocks), strict=True):
        mm, value = (
            _joined(rows, trials) for rows in zip(*((c.mm, c.value) for c in same), strict=True)
        )
        found.append(replace(same[0], mm=mm, value=value))
    return found


def joined_results(blocks: Sequence[tuple[int, Results]]) -> Results:
    """Return the results of blocks of drawings, each of so many trials, as those of all of them."""
    trials, nothing = [n for n, _ in blocks], np.full(1, np.nan)
    units = {name: unit for _, some in blocks for name, (_, unit) in some.items()}
    rows = {name: [some.get(name, (nothing,))[0] for _, some in blocks] for name in units}
    return {name: (_joined(rows[name], trials), unit) for name, unit in units.items()}


def _joined(blocks: Sequence[Reals], trials: Sequence[int]) -> Reals:
    """Return rows of blocks one below the other; a single one where nothing varies."""
    first = blocks[0]
    if len(first) == 1 and all(np.array_equal(rows, first, equal_nan=True) for rows in blocks):
        return first
    pairs = zip(blocks, trials, strict=True)
    return np.concatenate([np.broadcast_to(rows, (n, *rows.shape[1:])) for rows, n in pairs])


def quantiles(rows: Reals) -> Reals:
    """Return the `QUANTILES` over the trials, (quantile, position); NaN where no trial has a figure.

    ``rows``: (trial, position), NaN where a trial failed.
    """
    rows = np.sort(np.where(np.isfinite(rows), rows, np.nan), axis=0)
    there = np.isfinite(rows).sum(axis=0)
    found = np.full((len(QUANTILES), rows.shape[1]), np.nan)
    for count in np.unique(there[there > 0]):
        alike = there == count
        found[:, alike] = np.quantile(rows[:count, alike], tuple(QUANTILES.values()), axis=0)
    return found
