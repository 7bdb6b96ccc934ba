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


class Curves(NamedTuple):
    """The curves of all runs of leaves: heights and widths by first leaf and length, in steps of the grid."""

    heights: np.ndarray
    widths: np.ndarray
    below: tuple[Below, ...]

    @property
    def across(self) -> int:
        """How many widths there are."""
        return int(self.heights.shape[2])

    @property
    def down(self) -> int:
        """How many heights there are."""
        return int(self.widths.shape[2])


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
    count, wide = len(leaves), len(leaves[0])
    heights = np.full((count + 1, count, wide), NONE, dtype=np.int16)
    widths = np.full((count + 1, count, height + 1), NONE, dtype=np.int16)
    heights[1] = leaves
    widths[1] = _inverse(heights[1], height + 1)
    for length in range(2, count + 1):
        runs = count - length + 1
        down, above = np.empty((2, runs, wide), dtype=np.int16)
        across, beside = np.empty((2, runs, height + 1), dtype=np.int16)
        down.fill(NONE)
        across.fill(NONE)
        for k in range(1, length):
            second = slice(k, k + runs)
            np.add(heights[k, :runs], heights[length - k, second], out=above)
            np.minimum(down, above, out=down)
            np.add(widths[k, :runs], widths[length - k, second], out=beside)
            for a, b in below:
                beside[max(b - length + 1, 0, a - k + 1) : max(min(a, b - k) + 1, 0)] = NONE
            np.minimum(across, beside, out=across)
        heights[length, :runs] = np.minimum(down, _inverse(across, wide))
        widths[length, :runs] = np.minimum(across, _inverse(down, height + 1))
    return Curves(heights, widths, tuple(below))


def _inverse(found: np.ndarray, size: int) -> np.ndarray:
    """Return, for curves that fall, the least place at which each is no higher than 0 … size − 1.

    Read backward, a curve rises from 0 to ``size``; the rise before a place is the number of heights whose
    least place it is.
    """
    runs, places = found.shape
    rising = np.empty((runs, places + 2), dtype=found.dtype)
    rising[:, 0], rising[:, -1] = 0, size
    np.minimum(found[:, ::-1], size, out=rising[:, 1:-1])
    rises = (rising[:, 1:] - rising[:, :-1]).ravel()
    (at,) = rises.nonzero()
    least = (places - at % (places + 1)).astype(found.dtype)
    least[least == places] = NONE
    return np.asarray(least.repeat(rises[at]).reshape(runs, size))


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
