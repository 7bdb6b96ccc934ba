"""What a path is to a CAD program: a line, a circle, an arc; all else stays a polyline with bulges."""

from __future__ import annotations

import cmath
import math
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.paper.drawing import Stroke, Vertex

SAME = 1e-6
"""Places nearer to each other than this, mm, are one: a thousandth of what an SVG tells."""


class Line(NamedTuple):
    """A straight line."""

    start: complex
    end: complex


class Circle(NamedTuple):
    """A full circle."""

    centre: complex
    radius: float


class Arc(NamedTuple):
    """An arc, counter-clockwise from ``start`` to ``end``, degrees."""

    centre: complex
    radius: float
    start: float
    end: float


def recognised(stroke: Stroke) -> Line | Circle | Arc | None:
    """Return what a stroke is as a whole; None for a polyline."""
    path = stroke.path
    if len(path) == 2 and not stroke.closed and path[0][2] == 0.0:
        return Line(complex(*path[0][:2]), complex(*path[1][:2]))
    segments = [*pairwise(path), *([(path[-1], path[0])] if stroke.closed else [])]
    bulges = [a[2] for a, _ in segments]
    if not bulges or not (all(b > 0 for b in bulges) or all(b < 0 for b in bulges)):
        return None
    centres = [_centre(a, b) for a, b in segments]
    centre = centres[0]
    start, end = complex(*path[0][:2]), complex(*segments[-1][1][:2])
    radius = abs(start - centre)
    reaches = [abs(complex(*vertex[:2]) - centre) for vertex in path]
    if max(abs(z - centre) for z in centres) > SAME or max(reaches) - min(reaches) > SAME:
        return None
    turn = sum(4 * math.atan(b) for b in bulges)
    if abs(end - start) <= SAME and abs(abs(turn) - 2 * math.pi) < 1e-6:
        return Circle(centre, radius)
    if abs(turn) >= 2 * math.pi:
        return None
    ends = [math.degrees(cmath.phase(z - centre)) % 360.0 for z in (start, end)]
    return Arc(centre, radius, *(ends if turn > 0 else reversed(ends)))


def _centre(a: Vertex, b: Vertex) -> complex:
    """Return the centre of the arc between two vertices; its bulge is not 0."""
    start, chord, bulge = complex(*a[:2]), complex(b[0] - a[0], b[1] - a[1]), a[2]
    return start + chord / 2 + 1j * chord * (1 - bulge * bulge) / (4 * bulge)
