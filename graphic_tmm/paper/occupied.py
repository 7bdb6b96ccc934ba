"""What of the paper is taken: ink, sampled onto a grid; letters and their leaders, looked up by squares.

A box costs four look-ups however many lines cross it, so a field of letters costs what its lines and its
letters do, not their product.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame

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
Extent = tuple[float, float, float, float]


class Raster:
    """The ink of some lines over a frame (left, bottom, right, top), mm; what lies outside is not there.

    However large the frame is and however long the lines are, there are about `MOST` cells; what has no place
    (NaN, infinite) leaves no ink.
    """

    def __init__(self, lines: Iterable[Sequence[complex]], frame: Extent) -> None:
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


def _inside(starts: Spots, ends: Spots, frame: Extent) -> tuple[Spots, Spots]:
    """Return the parts of straight pieces inside a frame."""
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


SQUARE = 16.0
"""Side of a square, mm: a few labels wide, so that letters, which keep off each other, are few in one."""


NEXT, ROW = 3.0, 8.0
"""Labels level with each other and nearer than this, mm, are read as one term; of those nearer than that a
stroke between them is read as a minus."""
LEVEL = 0.5
"""Labels are level with each other where the smaller shares so much of its height with the other."""


class Rect(NamedTuple):
    """An upright rectangle: left, bottom, right, top, mm."""

    left: float
    bottom: float
    right: float
    top: float

    def grown(self, by: float) -> Rect:
        """Return the rectangle with ``by`` mm more on each side."""
        return Rect(self.left - by, self.bottom - by, self.right + by, self.top + by)

    def nearest(self, spot: complex) -> complex:
        """Return the point of the rectangle that is nearest to a place."""
        return complex(
            min(max(spot.real, self.left), self.right), min(max(spot.imag, self.bottom), self.top)
        )


class Line(NamedTuple):
    """A straight line between two places, mm."""

    start: complex
    end: complex

    @property
    def about(self) -> Rect:
        """The rectangle about it."""
        (a, b), (c, d) = (sorted(ends) for ends in zip(*map(_xy, self), strict=True))
        return Rect(a, c, b, d)


def _xy(spot: complex) -> tuple[float, float]:
    return spot.real, spot.imag


def upright(frame: Frame) -> list[Rect]:
    """Return upright rectangles that cover a frame: itself if it stands upright, else a row of small ones."""
    straight = min(abs(frame.along.real), abs(frame.along.imag)) < 1e-9
    count = 1 if straight else max(1, math.ceil(frame.width / max(frame.height, 0.5)))
    step, rects = frame.width / count, []
    for k in range(count):
        corners = [
            frame.corner + complex(x, y) * frame.along
            for x in (k * step, (k + 1) * step)
            for y in (0.0, frame.height)
        ]
        x, y = [z.real for z in corners], [z.imag for z in corners]
        rects.append(Rect(min(x), min(y), max(x), max(y)))
    return rects


class Occupied:
    """The rectangles of letters and the lines of leaders that stand already."""

    def __init__(self) -> None:
        self.rects: list[Rect] = []
        self.lines: list[Line] = []
        self._letters: dict[tuple[int, int], list[int]] = {}
        self._leaders: dict[tuple[int, int], list[int]] = {}

    def letter(self, *rects: Rect) -> None:
        """Take the rectangles of a label."""
        for rect in rects:
            for square in _squares(rect):
                self._letters.setdefault(square, []).append(len(self.rects))
            self.rects.append(rect)

    def leader(self, line: Line) -> None:
        """Take the line of a leader."""
        for square in _squares(line.about):
            self._leaders.setdefault(square, []).append(len(self.lines))
        self.lines.append(line)

    def letters_at(self, left: Reals, bottom: Reals, right: Reals, top: Reals) -> Reals:
        """Return how many rectangles of letters each of some rectangles meets."""
        near = self._near(self._letters, left, bottom, right, top)
        if not near:
            return np.zeros(left.shape)
        x0, y0, x1, y1 = np.array([self.rects[k] for k in near]).T
        across = (left[:, None] <= x1) & (x0 <= right[:, None])
        return np.asarray(
            (across & (bottom[:, None] <= y1) & (y0 <= top[:, None])).sum(axis=1, dtype=float)
        )

    def leaders_at(self, left: Reals, bottom: Reals, right: Reals, top: Reals) -> NDArray[np.bool_]:
        """Whether each of some rectangles meets a leader."""
        near = self._near(self._leaders, left, bottom, right, top)
        if not near:
            return np.zeros(left.shape, dtype=bool)
        starts, ends = np.array([self.lines[k] for k in near], dtype=complex).reshape(-1, 2).T
        edges = (v[:, None] for v in (left, bottom, right, top))
        first, last = spans(starts[None, :], ends[None, :], *edges)
        return np.asarray((first <= last).any(axis=1))

    def alone(self, rect: Rect, past: float) -> bool:
        """Whether no label is level with a rectangle, and no leader nearer than ``past`` mm."""
        about = Rect(rect.left - ROW, rect.bottom, rect.right + ROW, rect.top)
        near = list(_squares(about.grown(past)))
        if any(square in self._leaders for square in near):
            return False
        others = (self.rects[k] for square in near for k in self._letters.get(square, ()))
        return not any(
            one.left <= about.right
            and about.left <= one.right
            and one.bottom <= about.top
            and about.bottom <= one.top
            for one in others
        )

    def level(
        self, left: Reals, bottom: Reals, right: Reals, top: Reals
    ) -> tuple[NDArray[np.int64], Reals, Reals, Reals, Reals]:
        """Return which rectangles are level with a label, and the four edges of the gap between."""
        near = self._near(self._letters, left - ROW, bottom, right + ROW, top)
        x0, y0, x1, y1 = np.array([self.rects[k] for k in near]).reshape(-1, 4).T
        low, high = np.maximum(bottom[:, None], y0), np.minimum(top[:, None], y1)
        shared = high - low >= LEVEL * np.minimum((top - bottom)[:, None], y1 - y0)
        before = x0 - right[:, None]
        behind = left[:, None] - x1
        gap = np.maximum(before, behind)
        one, other = np.nonzero(shared & (gap > 0.0) & (gap < ROW))
        first = before[one, other] > 0
        start, end = np.where(first, right[one], x1[other]), np.where(first, x0[other], left[one])
        return one, start, low[one, other], end, high[one, other]

    def crossing(self, starts: Spots, ends: Spots, past: float = 0.0) -> NDArray[np.bool_]:
        """Whether each of some straight lines meets a label, or passes one nearer than ``past`` mm."""
        if not starts.size:
            return np.zeros(0, dtype=bool)
        x, y = (np.sort([u, v], axis=0) for u, v in zip(*map(_sides, (starts, ends)), strict=True))
        near = self._near(self._letters, x[0] - past, y[0] - past, x[1] + past, y[1] + past)
        rects = np.array([self.rects[k].grown(past) for k in near]).reshape(-1, 4).T
        first, last = spans(starts[:, None], ends[:, None], *rects[:, None, :])
        return np.asarray((first <= last).any(axis=1))

    def _near(
        self,
        taken: dict[tuple[int, int], list[int]],
        left: Reals,
        bottom: Reals,
        right: Reals,
        top: Reals,
    ) -> list[int]:
        """Return what is taken in the squares about some rectangles."""
        about = Rect(float(left.min()), float(bottom.min()), float(right.max()), float(top.max()))
        return sorted({k for square in _squares(about) for k in taken.get(square, ())})


def _sides(spots: Spots) -> tuple[Reals, Reals]:
    return spots.real, spots.imag


def _squares(rect: Rect) -> Iterator[tuple[int, int]]:
    for i in range(math.floor(rect.left / SQUARE), math.floor(rect.right / SQUARE) + 1):
        for j in range(math.floor(rect.bottom / SQUARE), math.floor(rect.top / SQUARE) + 1):
            yield i, j
