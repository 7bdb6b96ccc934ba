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
SAMPLES = 2
"""Samples of a line in a cell that it crosses in the middle: none of these is left out."""
MOST = 2**22
"""Cells of a raster, about: an A1 sheet has three million. On what is larger they are wider."""
FAR, STILL = 1e15, 1e-9
"""What lies farther than this, mm, is nowhere; a step shorter than this, mm, is none."""
Counts = NDArray[np.int64]
Spots = NDArray[np.complex128]
Frame = tuple[float, float, float, float]


class Raster:
    """The ink of some lines over a frame (left, bottom, right, top), mm; what lies outside is not there.

    However large the frame is and however long the lines are, there are about `MOST` cells; what has no place
    (NaN, infinite) leaves no ink.
    """

    def __init__(self, lines: Iterable[Sequence[complex]], frame: Frame) -> None:
        left, bottom, right, top = frame
        self.left, self.bottom = left, bottom
        width, height = right - left, top - bottom
        self.cell = max(
            CELL, math.sqrt(width) * math.sqrt(height / MOST), max(width, height) / MOST
        )
        self.wide, self.high = (max(1, math.ceil(d / self.cell)) for d in (width, height))
        spots = _samples(*_inside(*_pieces(lines), frame), self.cell / SAMPLES)
        x = np.minimum(np.floor((spots.real - left) / self.cell).astype(np.int64), self.wide - 1)
        y = np.minimum(np.floor((spots.imag - bottom) / self.cell).astype(np.int64), self.high - 1)
        row, column = (
            np.maximum(y, 0) + 1,
            np.maximum(x, 0) + 1,
        )  # before the first there is nothing
        shape = (self.high + 1, self.wide + 1)
        ink = np.bincount(row * shape[1] + column, minlength=shape[0] * shape[1])
        self.sums = ink.astype(np.int32).reshape(shape)
        np.cumsum(self.sums, axis=1, out=self.sums)
        for before, now in pairwise(self.sums):  # several times as fast as a sum along columns
            now += before

    def length(self, left: Reals, bottom: Reals, right: Reals, top: Reals) -> Reals:
        """Return about how long the lines are inside boxes, mm; arrays of one shape."""
        x0, x1 = (self._edge(v - self.left, self.wide) for v in (left, right))
        y0, y1 = (self._edge(v - self.bottom, self.high) for v in (bottom, top))
        found = self.sums[y1, x1] - self.sums[y0, x1] - self.sums[y1, x0] + self.sums[y0, x0]
        return np.asarray(found * (self.cell / SAMPLES))

    def _edge(self, way: Reals, most: int) -> Counts:
        return np.maximum(np.minimum(np.rint(way / self.cell), most), 0).astype(np.int64)


def _pieces(lines: Iterable[Sequence[complex]]) -> tuple[Spots, Spots]:
    """Return the straight pieces of polylines: starts and ends; none that has no place."""
    pairs = [pair for points in lines for pair in pairwise(points)]
    starts, ends = np.array(pairs, dtype=complex).reshape(-1, 2).T
    there = (np.abs(starts) < FAR) & (np.abs(ends) < FAR)
    return starts[there], ends[there]


def _inside(starts: Spots, ends: Spots, frame: Frame) -> tuple[Spots, Spots]:
    """Return what of straight pieces lies in a frame."""
    way = ends - starts
    first, last = spans(starts, ends, *frame)
    there = first < last
    start, way, first, last = starts[there], way[there], first[there], last[there]
    return start + first * way, start + last * way


def spans(
    starts: Spots,
    ends: Spots,
    left: Reals | float,
    bottom: Reals | float,
    right: Reals | float,
    top: Reals | float,
) -> tuple[Reals, Reals]:
    """Return from where to where straight pieces run in upright rectangles, as shares of them.

    Where one has nothing in it the second share is the smaller. All are broadcast against each other.
    """
    way = ends - starts
    shape = np.broadcast_shapes(way.shape, np.shape(left))
    first, last = np.zeros(shape), np.ones(shape)
    for at, step, low, high in (
        (starts.real, way.real, left, right),
        (starts.imag, way.imag, bottom, top),
    ):
        still = np.abs(step) < STILL
        stride = np.where(still, 1.0, step)
        u, v = (np.where(still, 0.0, side - at) / stride for side in (low, high))
        first = np.where(still, first, np.maximum(first, np.minimum(u, v)))
        last = np.where(still, last, np.minimum(last, np.maximum(u, v)))
        last = np.where(still & ((at < low) | (at > high)), -1.0, last)
    return first, last


def _samples(starts: Spots, ends: Spots, apart: float) -> Spots:
    """Return places along straight pieces, about ``apart`` mm from each other."""
    way = ends - starts
    counts = np.ceil(np.abs(way) / apart).astype(np.int64)
    last = np.cumsum(counts)
    within = np.arange(last[-1] if last.size else 0) - np.repeat(last - counts, counts)
    share = (within + 0.5) / np.repeat(counts, counts)
    return np.asarray(np.repeat(starts, counts) + share * np.repeat(way, counts))
