"""Lines cut: broken where something stands on them, curves into parts; each piece keeps its kind."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.paper.drawing import Bezier, Ink, Path

Controls = tuple[complex, ...]
_SAMPLES = 16
"""Places of an arc that are tried before the best of them is narrowed; chosen by eye."""
_NARROWINGS = 60
"""Each leaves two thirds: 60 leave 3·10⁻¹¹ of an arc, far below what ink shows."""
_THIRD = 1.0 / 3.0


def at(controls: Sequence[complex], u: float) -> complex:
    """Return the point of a chain of cubic arcs at ``u``, 0 … the number of arcs."""
    k = min(int(u), len(controls) // 3 - 1)
    a, b, c, d = controls[3 * k : 3 * k + 4]
    t = u - k
    s = 1.0 - t
    return complex(s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d))


def nearest(controls: Sequence[complex], spot: complex) -> float:
    """Return where on a chain of cubic arcs the point nearest to ``spot`` stands."""
    arcs = len(controls) // 3
    spots = _sampled(tuple(controls))
    best = int(np.argmin(np.abs(spots - spot))) / _SAMPLES
    low, high = max(0.0, best - 1 / _SAMPLES), min(float(arcs), best + 1 / _SAMPLES)
    for _ in range(_NARROWINGS):
        u, v = low + _THIRD * (high - low), high - _THIRD * (high - low)
        if abs(at(controls, u) - spot) <= abs(at(controls, v) - spot):
            high = v
        else:
            low = u
    return (low + high) / 2


@lru_cache(maxsize=64)
def _sampled(controls: Controls) -> np.ndarray:
    """Return the points of a chain of cubic arcs at which the nearest is looked for first."""
    return points(controls, len(controls) // 3 * _SAMPLES + 1)


def cut(controls: Sequence[complex], start: float, end: float) -> Controls:
    """Return the part of a chain of cubic arcs between two of its places, run from ``start`` to ``end``."""
    if start > end:
        return cut(controls, end, start)[::-1]
    made: list[complex] = []
    for k in range(int(start), min(math.ceil(end), len(controls) // 3)):
        arc, u, v = controls[3 * k : 3 * k + 4], max(start - k, 0.0), min(end - k, 1.0)
        part = [_blossom(arc, knots) for knots in ((u, u, u), (u, u, v), (u, v, v), (v, v, v))]
        made += part if not made else part[1:]
    return tuple(made)


def points(controls: Sequence[complex], count: int) -> np.ndarray:
    """Return ``count`` points along a chain of cubic arcs, evenly by its arcs."""
    chain, arcs = np.asarray(controls), len(controls) // 3
    u = np.linspace(0.0, arcs, count)
    k = np.minimum(u.astype(int), arcs - 1)
    a, b, c, d = (chain[3 * k + n] for n in range(4))
    t = u - k
    s = 1.0 - t
    return s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d)  # type: ignore[no-any-return]


def _blossom(arc: Sequence[complex], knots: tuple[float, float, float]) -> complex:
    spots = list(arc)
    for t in knots:
        spots = [p + t * (q - p) for p, q in pairwise(spots)]
    return complex(spots[0])


NEAR = 1e-9
"""Shares of a piece no farther apart are one."""
Span = tuple[float, float]
"""From where to where on a piece, each 0 … 1."""


class Frame(NamedTuple):
    """A rectangle that may be turned: its lower left corner, the way along its base (1 mm), its sides, mm."""

    corner: complex
    along: complex
    width: float
    height: float

    def grown(self, by: float) -> Frame:
        """Return the frame with ``by`` mm more on each side."""
        corner = self.corner - complex(by, by) * self.along
        return Frame(corner, self.along, self.width + 2 * by, self.height + 2 * by)

    def seen(self, spot: complex) -> complex:
        """Return a place as seen from the corner along the base."""
        return (spot - self.corner) * self.along.conjugate()

    def holds(self, spot: complex) -> bool:
        """Whether a place is inside."""
        at = self.seen(spot)
        return 0.0 < at.real < self.width and 0.0 < at.imag < self.height


class _Piece(NamedTuple):
    """A straight piece or an arc of a path: its ends, its bulge, and the place at a share of it."""

    start: complex
    end: complex
    bulge: float

    def at(self, u: float) -> complex:
        """Return the place at ``u``, 0 … 1."""
        if not self.bulge:
            return self.start + u * (self.end - self.start)
        centre = self.centre()
        return centre + (self.start - centre) * cmath.exp(4j * math.atan(self.bulge) * u)

    def centre(self) -> complex:
        """Return the centre of an arc."""
        half = 2 * math.atan(self.bulge)
        return (self.start + self.end) / 2 + (self.end - self.start) * 0.5j / math.tan(half)

    def crossings(self, frame: Frame) -> list[float]:
        """Return where it meets the four lines along the sides of a frame."""
        a, b = frame.seen(self.start), frame.seen(self.end)
        sides = ((0.0, frame.width), (0.0, frame.height))
        if not self.bulge:
            ends = ((a.real, b.real), (a.imag, b.imag))
            return [
                (s - u) / (v - u)
                for (u, v), two in zip(ends, sides, strict=True)
                if u != v
                for s in two
            ]
        centre = frame.seen(self.centre())
        radius, first, sweep = abs(a - centre), cmath.phase(a - centre), 4 * math.atan(self.bulge)
        turns: list[float] = []
        for s in sides[0]:
            if abs(s - centre.real) < radius:
                turn = math.acos((s - centre.real) / radius)
                turns += [turn, -turn]
        for s in sides[1]:
            if abs(s - centre.imag) < radius:
                turn = math.asin((s - centre.imag) / radius)
                turns += [turn, math.pi - turn]
        way = math.copysign(1.0, sweep)
        return [((turn - first) * way % math.tau) / abs(sweep) for turn in turns]

    def part(self, span: Span) -> _Piece:
        """Return what lies between two shares of it."""
        bulge = math.tan(math.atan(self.bulge) * (span[1] - span[0])) if self.bulge else 0.0
        return _Piece(self.at(span[0]), self.at(span[1]), bulge)

    @property
    def length(self) -> float:
        """How long it is, mm."""
        chord, quarter = abs(self.end - self.start), math.atan(self.bulge)
        return chord if not self.bulge else chord * abs(2 * quarter / math.sin(2 * quarter))


def broken(stroke: Ink, frames: Sequence[Frame], least: float) -> list[Ink]:
    """Return what is left of a stroke outside frames, but for parts no longer than ``least`` mm.

    A closed stroke comes open where it is broken. What it comes from stands on each part.
    """
    if isinstance(stroke, Bezier):
        return _smooth(stroke, frames, least)
    corners = [complex(x, y) for x, y, _ in stroke.path]
    bulges = [bulge for _, _, bulge in stroke.path]
    if stroke.closed:
        corners.append(corners[0])
    pieces = [_Piece(a, b, bulge) for (a, b), bulge in zip(pairwise(corners), bulges, strict=False)]
    runs: list[list[_Piece]] = [[]]
    for piece in pieces:
        for span in _outside(piece.at, piece.crossings, frames):
            if span[0] > 0.0 and runs[-1]:
                runs.append([])
            runs[-1].append(piece.part(span) if span != (0.0, 1.0) else piece)
            if span[1] < 1.0:
                runs.append([])
        if runs[-1] and abs(runs[-1][-1].end - piece.end) > 1e-9:
            runs.append([])
    runs = [run for run in runs if run]
    if [len(run) for run in runs] == [len(pieces)] and runs[0] == pieces:
        return [stroke]
    if stroke.closed and len(runs) > 1 and abs(runs[0][0].start - runs[-1][-1].end) < 1e-9:
        runs = [[*runs[-1], *runs[0]], *runs[1:-1]]
    kept = (run for run in runs if sum(piece.length for piece in run) > least)
    return [stroke._replace(path=_path(run), closed=False) for run in kept]


def _path(run: Sequence[_Piece]) -> Path:
    last = run[-1].end
    path = [(piece.start.real, piece.start.imag, piece.bulge) for piece in run]
    return (*path, (last.real, last.imag, 0.0))


def _smooth(stroke: Bezier, frames: Sequence[Frame], least: float) -> list[Ink]:
    """Return the parts of a smooth curve."""
    arcs = len(stroke.controls) // 3
    spans: list[list[float]] = []
    for k in range(arcs):
        arc = np.array(stroke.controls[3 * k : 3 * k + 4])

        def at(u: float, arc: np.ndarray = arc) -> complex:
            a, b, c, d = arc
            v = 1.0 - u
            return complex(v**3 * a + 3 * v * v * u * b + 3 * v * u * u * c + u**3 * d)

        def met(frame: Frame, arc: np.ndarray = arc) -> list[float]:
            return _met(frame, arc)

        for start, end in _outside(at, met, frames):
            if spans and spans[-1][1] == k + start:
                spans[-1][1] = k + end
            else:
                spans.append([k + start, k + end])
    if spans == [[0.0, float(arcs)]]:
        return [stroke]
    parts = (cut(stroke.controls, start, end) for start, end in spans)
    return [stroke._replace(controls=part) for part in parts if _reach(part) > least]


def _reach(controls: Sequence[complex]) -> float:
    return sum(abs(b - a) for a, b in pairwise(controls[::3]))


def _met(frame: Frame, arc: np.ndarray) -> list[float]:
    """Return where a cubic arc meets the four lines along the sides of a frame."""
    a, b, c, d = (arc - frame.corner) * frame.along.conjugate()
    powers = (d - 3 * c + 3 * b - a, 3 * c - 6 * b + 3 * a, 3 * b - 3 * a, a)
    found: list[float] = []
    for part, sides in (
        ([z.real for z in powers], (0.0, frame.width)),
        ([z.imag for z in powers], (0.0, frame.height)),
    ):
        for side in sides:
            roots = np.roots([*part[:3], part[3] - side])
            found += [float(root.real) for root in roots if abs(root.imag) < 1e-9]
    return found


def _outside(
    at: Callable[[float], complex],
    crossings: Callable[[Frame], Iterable[float]],
    frames: Sequence[Frame],
) -> list[Span]:
    """Return the spans of a piece that lie in no frame."""
    cuts = [0.0]
    for u in sorted(u for frame in frames for u in crossings(frame)):
        if cuts[-1] + NEAR < u < 1.0 - NEAR:
            cuts.append(u)
    spans: list[Span] = []
    for start, end in pairwise([*cuts, 1.0]):
        middle = at((start + end) / 2)
        if any(frame.holds(middle) for frame in frames):
            continue
        if spans and spans[-1][1] == start:
            spans[-1] = (spans[-1][0], end)
        else:
            spans.append((start, end))
    return spans
