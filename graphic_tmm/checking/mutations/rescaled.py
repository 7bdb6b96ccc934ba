"""In which scale factor a graph, or polygons of forces, with a mistake may be drawn: of each mistake its own.

Where every length hangs on the mistake none of them has the right ratio; with the mistake all have one.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Mapping
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.mutations.entries import Reading
from graphic_tmm.checking.mutations.evidence import Readings
from graphic_tmm.checking.mutations.mistakes import Offered

Array = NDArray[np.float64]
HAND, SHARE, FARTHEST = 1.0, 0.02, 16.0
"""What a hand is off by on a graph: mm, and of the figure; no reading counts more than such a square."""
SHORT, FEWEST = 6.0, 3
"""Shorter lengths, mm, and fewer of them tell no scale factor."""
CLEAR = 8.0
"""By so much better (half a sum of squares) a mistake in another scale factor must fit."""
LEAST, MOST = 0.03, 2.1
"""Between these a ratio (a logarithm) is one of a scale factor."""
Group = TypeVar("Group", bound=Hashable)


def rescaled(
    readings: Readings, offered: Offered, groups: Mapping[tuple[str, str], Group]
) -> dict[Group, float]:
    """Return plans and how many times as large they are (a logarithm), if a mistake fits readings only so.

    ``groups``: what may be drawn to another scale factor, by plan and segment.
    """
    drawn: dict[Group, list[Reading]] = defaultdict(list)
    rest: dict[str, list[Reading]] = defaultdict(list)
    for one in readings.columns:
        group = groups.get(one.taken.key[:2])
        if one.taken.mm is not None and group is not None:
            drawn[group].append(one)
        elif not one.taken.pointed and not one.beside:
            rest[one.taken.plan].append(one)
    found = {}
    for group, some in drawn.items():
        k = _ratio(offered, some, rest[some[0].taken.plan])
        if k is not None:
            found[group] = k
    return found


def _ratio(offered: Offered, drawn: list[Reading], rest: list[Reading]) -> float | None:
    """Return how many times as large lengths are (a logarithm) with the mistake that fits best so, if any."""
    figures = offered.figures([one.at for one in (*drawn, *rest)])
    due = np.array([figures[one.at] for one in drawn if one.at in figures]).real
    read = np.array([one.found.real for one in drawn if one.at in figures])
    if read.size < FEWEST:
        return None
    with np.errstate(all="ignore"):
        ratios = np.log(np.abs(read[:, None] / due))
        ratios = np.where(np.abs(due) > SHORT, ratios, np.nan)
        enough = np.isfinite(ratios).sum(axis=0) >= FEWEST
        k = np.where(enough, np.nanmedian(np.where(enough, ratios, 0.0), axis=0), 0.0)
    others = sum(
        (_off(one, figures[one.at]) for one in rest if one.at in figures), np.zeros(k.size)
    )
    plain = _fit(read, due, 0.0 * k) + others
    scaled = _fit(read, due, k) + others
    best = int(np.argmin(scaled))
    clear = scaled[best] < min(plain) - CLEAR and LEAST < abs(k[best]) < MOST
    return float(k[best]) if clear else None


def _fit(read: Array, due: Array, k: Array) -> Array:
    """Return half the sum of squares of how far lengths are off that are so many times as large, (mistake,)."""
    off = np.abs(np.abs(read)[:, None] - np.exp(k) * np.abs(due))
    size = np.hypot(HAND, SHARE * np.abs(read))[:, None]
    return np.asarray(_halved(off / size).sum(axis=0))


def _off(one: Reading, due: Array) -> Array:
    size = np.hypot(one.scatter, SHARE * abs(one.found))
    return _halved(np.abs(abs(one.found) - np.abs(due)) / size)


def _halved(off: Array) -> Array:
    return np.asarray(0.5 * np.minimum(np.nan_to_num(off, nan=1e9) ** 2, FARTHEST))
