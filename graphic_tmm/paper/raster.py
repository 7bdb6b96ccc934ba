"""How much ink lies in a box: lines sampled onto a grid, and sums over its cells from a corner.

A box costs four look-ups however many lines cross it, so a field of letters costs what its lines and its
letters do, not their product.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals

CELL = 0.4
"""Width of a cell, mm; half of what is kept clear about a letter."""
SAMPLE = 0.2
"""Samples of a line stand no farther apart, mm: none of the cells it crosses in the middle is left out."""
Counts = NDArray[np.int64]
Frame = tuple[float, float, float, float]


class Raster:
    """The ink of some lines over a frame (left, bottom, right, top), mm; what lies outside is not there."""

    def __init__(self, lines: Iterable[Sequence[complex]], frame: Frame) -> None:
        left, bottom, right, top = frame
        self.left, self.bottom = left, bottom
        self.wide, self.high = (max(1, math.ceil(d / CELL)) for d in (right - left, top - bottom))
        spots = _samples(lines)
        x = np.floor((spots.real - left) / CELL).astype(np.int64)
        y = np.floor((spots.imag - bottom) / CELL).astype(np.int64)
        there = (x >= 0) & (x < self.wide) & (y >= 0) & (y < self.high)
        cells = y[there] * self.wide + x[there]
        ink = np.bincount(cells, minlength=self.wide * self.high).reshape(self.high, self.wide)
        self.sums = np.zeros((self.high + 1, self.wide + 1), dtype=np.int64)
        self.sums[1:, 1:] = ink.cumsum(axis=0).cumsum(axis=1)

    def length(self, left: Reals, bottom: Reals, right: Reals, top: Reals) -> Reals:
        """Return about how long the lines are inside boxes, mm; arrays of one shape."""
        x0, x1 = (_edge(v - self.left, self.wide) for v in (left, right))
        y0, y1 = (_edge(v - self.bottom, self.high) for v in (bottom, top))
        found = self.sums[y1, x1] - self.sums[y0, x1] - self.sums[y1, x0] + self.sums[y0, x0]
        return np.asarray(found * SAMPLE)


def _edge(way: Reals, most: int) -> Counts:
    return np.clip(np.rint(way / CELL).astype(np.int64), 0, most)


def _samples(lines: Iterable[Sequence[complex]]) -> NDArray[np.complex128]:
    """Return places along polylines, about `SAMPLE` mm apart."""
    starts: list[complex] = []
    ways: list[complex] = []
    for points in lines:
        starts += points[:-1]
        ways += (b - a for a, b in pairwise(points))
    start, way = np.array(starts, dtype=complex), np.array(ways, dtype=complex)
    counts = np.ceil(np.abs(way) / SAMPLE).astype(np.int64)
    ends = np.cumsum(counts)
    within = np.arange(ends[-1] if ends.size else 0) - np.repeat(ends - counts, counts)
    share = (within + 0.5) / np.repeat(counts, counts)
    return np.asarray(np.repeat(start, counts) + share * np.repeat(way, counts))
