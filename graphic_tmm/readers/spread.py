"""How figures scatter over many drawings by one hand: median, 5th and 95th hundredths beside each column."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphic_tmm.readers.columns import Column

QUANTILES = {"median": 0.5, "p5": 0.05, "p95": 0.95}
"""What is told of the trials, by the end of a column's name."""
Results = Mapping[str, tuple[float, str]]


def spread_columns(base: Sequence[Column], trials: Sequence[Sequence[Column]]) -> list[Column]:
    """Return each column followed by its quantiles over the trials; a trial that failed is left out of them.

    ``trials``: the columns of every trial, in the order of ``base``.
    """
    found = []
    for k, column in enumerate(base):
        found.append(column)
        mm = _rows([trial[k].mm for trial in trials])
        value = _rows([trial[k].value for trial in trials])
        for name, share in QUANTILES.items():
            segment, letter = f"{column.segment}_{name}", f"{column.letter} {name}"
            rows = _quantile(mm, share), _quantile(value, share)
            found.append(Column(column.plan, segment, letter, column.unit, *rows, column.at))
    return found


def spread_results(base: Results, trials: Sequence[Results]) -> dict[str, tuple[float, str]]:
    """Return each result followed by its quantiles over the trials that have it."""
    found: dict[str, tuple[float, str]] = {}
    for name, (value, unit) in base.items():
        found[name] = (value, unit)
        drawn = np.array([trial[name][0] for trial in trials if name in trial])
        drawn = drawn[np.isfinite(drawn)]
        for key, share in QUANTILES.items():
            if drawn.size:
                found[f"{name}_{key}"] = (float(np.quantile(drawn, share)), unit)
    return found


def _rows(rows: Sequence[Sequence[float | None]]) -> np.ndarray:
    return np.array([[np.nan if x is None else x for x in row] for row in rows], dtype=np.float64)


def _quantile(rows: np.ndarray, share: float) -> tuple[float | None, ...]:
    """Return the quantile of every position; None where no trial has a figure."""
    found: list[float | None] = []
    for column in rows.T:
        there = column[np.isfinite(column)]
        found.append(float(np.quantile(there, share)) if there.size else None)
    return tuple(found)
