"""The digits of figures in tables: the mm of a table times its μ give its quantity.

Lengths of one plan are drawn to one μ, so all are known equally well: their quantities have the same decimals.
A length read by a ruler has one decimal of a mm; one calculated and laid off has two where one does not give
its quantity. On the edge between two figures the quantity follows from mm and μ as they are printed: equal
lengths of a plan never stand for unequal quantities.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from graphic_tmm.readers.columns import Column, Row

DIGITS = 3
"""Significant digits of the largest figure of a row, at least."""
COARSEST = 0.5
"""The last decimal of a drawn quantity is worth less than this, mm."""
ROUGH, FINE = 1, 2
"""Decimals of a length in mm: read by a ruler, and calculated before it is laid off."""
WRITTEN = 4
"""Significant digits of a μ as it is written."""
NOISE = 1e-12
"""By so much of itself a product of two written numbers may be off in the last bits."""


class Figures(NamedTuple):
    """The figures of a column as tables print them: mm and quantities, each with its number of decimals."""

    mm: Row
    mm_places: int
    value: Row
    places: int


def rounded_figures(columns: Sequence[Column]) -> list[Figures]:
    """Return the figures of the columns of a table, in order."""
    found: dict[int, Figures] = {}
    order = sorted(range(len(columns)), key=lambda k: _kind(columns[k]))
    for _, same in groupby(order, key=lambda k: _kind(columns[k])):
        at = list(same)
        drawn = [k for k in at if columns[k].drawn and not math.isnan(_mu(columns[k]))]
        if drawn:
            found |= dict(zip(drawn, _measured([columns[k] for k in drawn]), strict=True))
        for k in at:
            found.setdefault(k, _calculated(columns[k]))
    return [found[k] for k in range(len(columns))]


def worth(mm: float, value: float, length: float) -> float:
    """Return what ``length`` mm stand for where ``mm`` stand for ``value``, by the μ as it is written.

    >>> worth(72.453, 5.433975, 72.45), worth(0.0, 0.0, 0.0)
    (5.43375, 0.0)
    """
    return length * _written(value / mm) if mm else value


def told_as(mm: float | None, value: float | None, fine: int) -> float | None:
    """Return a quantity from its length in mm rounded to a number of decimals."""
    if mm is None or value is None:
        return value
    return worth(mm, value, rounded(mm, fine))


def rounded(value: float, places: int) -> float:
    """Return a number rounded as people round: halves go up, away from nothing.

    >>> rounded(0.6915, 3), rounded(-2.5, 0), rounded(2.675, 2)
    (0.692, -3.0, 2.68)
    """
    if not math.isfinite(value):
        return value
    power = 10.0**places
    whole = math.floor(abs(value) * power * (1 + NOISE) + 0.5)
    return math.copysign(whole / power, value)


def decimals(row: Sequence[float | None], digits: int = DIGITS) -> int:
    """Return the decimals that give the largest figure of a row its significant digits.

    >>> decimals([0.5, 48.71, None]), decimals([0.0]), decimals([1234.0])
    (1, 0, 0)
    """
    largest = max((abs(x) for x in row if x is not None), default=0.0)
    return max(0, digits - 1 - math.floor(math.log10(largest))) if largest > 0 else 0


def _kind(column: Column) -> tuple[str, str, float]:
    """Return what columns with the same decimals have in common: plan, unit, μ."""
    mu = _mu(column)
    return column.plan, column.unit, -1.0 if math.isnan(mu) else mu


def _mu(column: Column) -> float:
    """Return what a mm stands for, as it is written; NaN where nothing is both measured and known."""
    found = (
        abs(value / mm) for mm, value in zip(*column.first_figures, strict=True) if mm and value
    )
    return _written(next(found, math.nan))


def _written(mu: float) -> float:
    return float(f"{mu:.{WRITTEN}g}")


def _calculated(column: Column) -> Figures:
    """Return figures that no length in mm stands for, or lengths that stand for nothing."""
    mm, value = column.first_figures
    places = decimals(value)
    return Figures([_at(x, ROUGH) for x in mm], ROUGH, value, _fewest(column, places))


def _fewest(column: Column, places: int) -> int:
    """Return how many decimals of ``places`` the figures of a column have, if they are shares of a hundred."""
    if column.unit != "%":
        return places
    there = [x for x in column.first_figures[1] if x is not None]
    return next((k for k in range(places) if all(round(x, k) == x for x in there)), places)


def _measured(columns: Sequence[Column]) -> Iterator[Figures]:
    """Yield the figures of columns that are drawn to one μ."""
    places = _common(columns)
    for column in columns:
        lengths, values = column.first_figures
        roughly, finely = (
            [_at(told_as(*pair, few), places) for pair in zip(lengths, values, strict=True)]
            for few in (ROUGH, FINE)
        )
        fine = ROUGH if roughly == finely else FINE
        yield Figures([_at(x, fine) for x in lengths], fine, finely, places)


def _common(columns: Sequence[Column]) -> int:
    """Return the decimals of what is drawn to one μ."""
    mu = _mu(columns[0])
    by_mm = math.floor(-math.log10(COARSEST * mu)) + 1
    finest = max(by_mm, math.ceil(-math.log10(10.0**-FINE * mu)))
    return min(
        max(by_mm, decimals([x for one in columns for x in one.first_figures[1]])), max(0, finest)
    )


def _at(value: float | None, places: int) -> float | None:
    return None if value is None else rounded(value, places)
