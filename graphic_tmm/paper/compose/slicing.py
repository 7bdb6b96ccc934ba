"""Ordered slicing: units in order cut into a rectangle by vertical and horizontal cuts, all ways at once.

Each run of units has a curve: the least height at each width, on a grid. One above the other the heights of
two curves add, side by side their widths do; the best of all cuts of a run is the least of all sums. With the
curves of all runs known, cuts that fit a rectangle are read off from the whole to the parts (the shape curves
of Stockmeyer, Information and Control 57, 1983; over all ordered trees instead of one).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import as_strided

GRID = 2.0
"""The grid of the curves, mm."""
FINE, FEW = 0.5, 7
"""The grid where there are so few leaves that it takes no time: on small sheets a step decides."""
NONE = np.int16(16_000)
"""A height at which nothing fits, in steps of the grid; twice as much is still a number of its type."""

Below = tuple[int, int]


class Leaf(NamedTuple):
    """A leaf, by its place in the order, and the cell that it may fill, in steps of the grid."""

    place: int
    width: int
    height: int


class Cut(NamedTuple):
    """A cut: what stands side by side (``across``), or one below the other, in order."""

    across: bool
    parts: tuple[Cut | Leaf, ...]


Tree = Cut | Leaf


class CurveRow(NamedTuple):
    """How both curves of a run stand in one row of numbers: heights by width, then widths from the top down.

    Heights fall to a bound of 0, widths rise from one: each curve is read off the other from left to right.
    """

    across: int
    down: int

    @property
    def heights(self) -> slice:
        """Where the heights stand, by width."""
        return slice(1, self.across + 1)

    @property
    def widths(self) -> slice:
        """Where the widths stand, by height, the greatest first."""
        return slice(self.across + 2, self.across + 2 + self.down)

    def empty(self, *shape: int) -> np.ndarray:
        """Return rows in which nothing fits, with their bounds."""
        found = np.full((*shape, self.across + self.down + 3), NONE, dtype=np.int16)
        found[..., self.across + 1] = 0
        return found

    def ranks(self) -> tuple[np.ndarray, np.ndarray]:
        """Return, by place in a row, the number of the other curve from there on, and how far that goes."""
        width, height = np.arange(self.across), np.arange(self.down)[::-1]
        other = np.concatenate([width, [NONE, NONE], height, [0]]).astype(np.int16)
        return other, np.where(np.arange(len(other)) > self.across, *self).astype(np.int16)


class Curves(NamedTuple):
    """The curves of all runs of leaves by length and first leaf, in steps of the grid."""

    runs: np.ndarray
    row: CurveRow
    below: tuple[Below, ...]

    @property
    def heights(self) -> np.ndarray:
        """The least height of a run at each width."""
        return self.runs[..., self.row.heights]

    @property
    def widths(self) -> np.ndarray:
        """The least width of a run at each height."""
        return self.runs[..., self.row.widths][..., ::-1]


def grid_of(leaves: int) -> float:
    """Return the grid, mm, for a number of leaves."""
    return FINE if leaves <= FEW else GRID


def steps(length: float, grid: float = GRID) -> int:
    """Return a length in steps of the grid, no shorter."""
    return math.ceil(length / grid - 1e-6)


def curve(
    sizes: Iterable[tuple[float, float]], width: int, height: int, grid: float = GRID
) -> np.ndarray:
    """Return the least height at each width up to ``width`` for what can have some sizes, mm."""
    found = np.full(width + 1, NONE, dtype=np.int16)
    for wide, high in sizes:
        across, down = steps(wide, grid), steps(high, grid)
        if across <= width and down <= height:
            np.minimum(found[across:], down, out=found[across:])
    return found


def curves(leaves: Sequence[np.ndarray], height: int, below: Sequence[Below] = ()) -> Curves:
    """Return the curves of all runs of leaves on a sheet so high, in steps.

    ``below``: pairs of leaves, in order, of which the second stands below the first.
    """
    count, row = len(leaves), CurveRow(len(leaves[0]), height + 1)
    runs, ranks = row.empty(count + 1, count), row.ranks()
    runs[1, :, row.heights] = leaves
    runs[1, :, row.widths] = _other(runs[1], *ranks)[:, : row.down]
    long, one, step = runs.strides
    by_last = as_strided(runs[0, 1:], runs.shape, (long - one, one, step), writeable=False)
    for length in range(2, count + 1):
        firsts = count - length + 1
        sums = runs[1:length, :firsts] + by_last[length - 1 : 0 : -1, length - 1 :]
        for a, b in below:
            for first in range(max(b - length + 1, 0), min(a + 1, firsts)):
                sums[a - first : b - first, first, row.widths] = NONE
        least = np.minimum.reduce(sums)
        other = _other(least, *ranks)
        for own, read in ((row.widths, other[:, : row.down]), (row.heights, other[:, row.down :])):
            np.minimum(least[:, own], read, out=runs[length, :firsts, own])
    return Curves(runs, row, tuple(below))


def _other(rows: np.ndarray, ranks: np.ndarray, most: np.ndarray) -> np.ndarray:
    """Return, by rows, the widths that the heights give, from the top down, and the heights of the widths.

    Where a curve goes from one number to the next, the other one stays for as many places.
    """
    flat, (runs, length) = rows.ravel(), rows.shape
    at = (flat[1:] != flat[:-1]).nonzero()[0]
    place = at % length
    end = most[place]
    times = np.abs(np.minimum(flat[at], end) - np.minimum(flat[at + 1], end))
    return np.asarray(ranks[place].repeat(times).reshape(runs, length - 3))


def tree(found: Curves, width: int, height: int) -> Tree | None:
    """Return cuts that fit a sheet of ``width`` × ``height`` steps; None if there are none."""
    count = found.heights.shape[1]
    if found.heights[count, 0, width] > height:
        return None
    return _cut(found, 0, count, width, height)


def _cut(found: Curves, first: int, length: int, width: int, height: int) -> Tree:
    """Return the cuts of a run: of those that fit the ones that leave most room, by its share of the side."""
    if length == 1:
        return Leaf(first, width, height)
    best: tuple[float, bool, int] = (-math.inf, False, 0)
    heights, widths = found.heights, found.widths
    for k in range(1, length):
        down = int(heights[k, first, width]) + int(heights[length - k, first + k, width])
        best = max(best, ((height - down) / height, False, -k))
        across = int(widths[k, first, height]) + int(widths[length - k, first + k, height])
        if not any(first <= a < first + k <= b < first + length for a, b in found.below):
            best = max(best, ((width - across) / width, True, -k))
    _, across_, k = best[0], best[1], -best[2]
    if across_:
        wide = int(widths[k, first, height])
        parts = (
            _cut(found, first, k, wide, height),
            _cut(found, first + k, length - k, width - wide, height),
        )
    else:
        high = int(heights[k, first, width])
        parts = (
            _cut(found, first, k, width, high),
            _cut(found, first + k, length - k, width, height - high),
        )
    return _flat(across_, parts)


def _flat(across: bool, parts: Sequence[Tree]) -> Cut:
    """Return a cut whose parts are cut the other way."""
    found: list[Tree] = []
    for part in parts:
        found += part.parts if isinstance(part, Cut) and part.across == across else (part,)
    return Cut(across, tuple(found))
