"""What letters and their leaders have taken of the paper: looked up by squares, however many there are."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame
from graphic_tmm.paper.raster import Spots, spans

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
        """Whether no label can stand level beside a rectangle, and no leader nearer than ``past`` mm."""
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
        """Return which of some rectangles stand level beside a label, and what lies between: its four edges."""
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
