"""What letters and their leaders have taken of the paper: looked up by squares, however many there are."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame

SQUARE = 16.0
"""Side of a square, mm: a few labels wide, so that letters, which keep off each other, are few in one."""


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

    def meets(self, rect: Rect) -> bool:
        """Whether the line and a rectangle have a point in common."""
        low, high = 0.0, 1.0
        way = self.end - self.start
        for at, step, first, last in (
            (self.start.real, way.real, rect.left, rect.right),
            (self.start.imag, way.imag, rect.bottom, rect.top),
        ):
            if step == 0.0:
                if not first <= at <= last:
                    return False
                continue
            u, v = sorted(((first - at) / step, (last - at) / step))
            low, high = max(low, u), min(high, v)
        return low <= high


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
        about = Rect(float(left.min()), float(bottom.min()), float(right.max()), float(top.max()))
        near = {k for square in _squares(about) for k in self._letters.get(square, ())}
        if not near:
            return np.zeros(left.shape)
        x0, y0, x1, y1 = np.array([self.rects[k] for k in sorted(near)]).T
        across = (left[:, None] <= x1) & (x0 <= right[:, None])
        return np.asarray(
            (across & (bottom[:, None] <= y1) & (y0 <= top[:, None])).sum(axis=1, dtype=float)
        )

    def leader_at(self, rect: Rect) -> bool:
        """Whether a rectangle meets a leader."""
        near = (self.lines[k] for s in _squares(rect) for k in self._leaders.get(s, ()))
        return any(one.meets(rect) for one in near)

    def crossed(self, line: Line) -> bool:
        """Whether a line meets a label."""
        near = (self.rects[k] for s in _squares(line.about) for k in self._letters.get(s, ()))
        return any(line.meets(one) for one in near)


def _squares(rect: Rect) -> Iterator[tuple[int, int]]:
    for i in range(math.floor(rect.left / SQUARE), math.floor(rect.right / SQUARE) + 1):
        for j in range(math.floor(rect.bottom / SQUARE), math.floor(rect.top / SQUARE) + 1):
            yield i, j
