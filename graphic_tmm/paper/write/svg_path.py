"""Strokes as the data of SVG paths: numbers, lines, arcs and cubic arcs, y turned over."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Bezier, Ink, Stroke, Vertex

FLAT = 5e-4
"""An arc that departs from its chord by less (mm) is drawn straight."""

SAMPLES = 16
"""Chords by which the length of one cubic arc is taken, for its dashes."""


def number(value: float) -> str:
    """Return a number with at most three decimals, without trailing zeros or a negative zero."""
    if not math.isfinite(value):
        raise SheetError(f"a coordinate of the sheet is not a finite number: {value}")
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def path_data(stroke: Ink, height: float) -> str:
    """Return the path data of a stroke on a page ``height`` mm high, y downward."""
    if isinstance(stroke, Bezier):
        if len(stroke.controls) % 3 != 1:
            raise SheetError(f"a curve of cubic arcs has 3n + 1 points, not {len(stroke.controls)}")
        first, *rest = (f"{number(z.real)} {number(height - z.imag)}" for z in stroke.controls)
        return f"M{first}C{' '.join(rest)}"
    if not stroke.path:
        raise SheetError(f"a stroke of the pen {stroke.pen!r} has no points")
    x, y, _ = stroke.path[0]
    parts = [f"M{number(x)} {number(height - y)}"]
    straight_home = stroke.closed and stroke.path[-1][2] == 0  # which "Z" draws
    segments = _segments(stroke)[:-1] if straight_home else _segments(stroke)
    parts += [_segment(a, b, height) for a, b in segments]
    return "".join(parts) + ("Z" if stroke.closed else "")


def _segment(a: Vertex, b: Vertex, height: float) -> str:
    """Return a line or an arc, in pieces of 90° at most so that rounding keeps its centre."""
    start, end, bulge = complex(*a[:2]), complex(*b[:2]), a[2]
    chord = end - start
    if bulge == 0 or abs(bulge * chord) / 2 < FLAT:
        return f"L{number(end.real)} {number(height - end.imag)}"
    centre = (start + end) / 2 + 1j * chord * (1 - bulge * bulge) / (4 * bulge)
    angle = 4 * math.atan(bulge)
    pieces = math.ceil(abs(angle) / (math.pi / 2) - 1e-9)
    radius, sweep = number(abs(start - centre)), 0 if bulge > 0 else 1
    ends = [centre + (start - centre) * cmath.rect(1, angle * k / pieces) for k in range(1, pieces)]
    return "".join(
        f"A{radius} {radius} 0 0 {sweep} {number(z.real)} {number(height - z.imag)}"
        for z in (*ends, end)
    )


def _segments(stroke: Stroke) -> list[tuple[Vertex, Vertex]]:
    """Return the pairs of vertices that a stroke joins, for a closed one back to its start."""
    path = stroke.path
    pairs = list(pairwise(path))
    return [*pairs, (path[-1], path[0])] if stroke.closed else pairs


def length(stroke: Ink) -> float:
    """Return the length of a stroke in mm; of a curve by its chords."""
    if isinstance(stroke, Bezier):
        points = _samples(stroke.controls)
        return sum(abs(b - a) for a, b in pairwise(points))
    total = 0.0
    for (x, y, bulge), (u, v, _) in _segments(stroke):
        chord, angle = math.hypot(u - x, v - y), 4 * math.atan(abs(bulge))
        total += chord if bulge == 0 else chord * angle / (2 * math.sin(angle / 2))
    return total


def _samples(controls: Sequence[complex]) -> list[complex]:
    """Return points along cubic arcs, `SAMPLES` chords to each."""
    points = [controls[0]]
    for k in range(0, len(controls) - 1, 3):
        a, b, c, d = controls[k : k + 4]
        for t in (i / SAMPLES for i in range(1, SAMPLES + 1)):
            s = 1 - t
            points.append(s**3 * a + 3 * s * s * t * b + 3 * s * t * t * c + t**3 * d)
    return points


def clockwise(stroke: Ink) -> bool:
    """Tell whether a filled shape runs clockwise: both turns in one path would leave holes."""
    if isinstance(stroke, Bezier) or not stroke.filled:
        return False
    area = sum(a[0] * b[1] - b[0] * a[1] + _bow(a, b) for a, b in _segments(stroke))
    return area < 0


def _bow(a: Vertex, b: Vertex) -> float:
    """Return twice the area between an arc and its chord, taken as a parabola."""
    return (4 / 3) * a[2] * ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) / 2
