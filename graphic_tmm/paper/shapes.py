"""The shapes of strokes and letters, mm: the paper that they cover."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import shapely

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.clipping import Frame
from graphic_tmm.paper.drawing import Bezier, Label, Stroke
from graphic_tmm.paper.lettering.letters import letter

TRUE, CHORDS = 0.1, 256
"""Chords of arcs and curves run no farther off them, mm: an eighth of what is kept clear about a letter; no arc
gets more chords than this."""


@lru_cache(maxsize=4096)
def box(label: Label) -> shapely.Polygon:
    """Return the ink box of a label, turned as the label is."""
    return shapely.Polygon([(z.real, z.imag) for z in corners(label)])


def corners(label: Label) -> list[complex]:
    """Return the corners of the ink box of a label."""
    ink = frame(label)
    own = (0j, ink.width + 0j, complex(ink.width, ink.height), 1j * ink.height)
    return [ink.corner + corner * ink.along for corner in own]


def frame(label: Label) -> Frame:
    """Return the ink box of a label; leaning tops reach out over its last letter."""
    made = letter(label.text, size=label.size, inclined=label.inclined)
    start = {"start": 0.0, "middle": -made.width / 2, "end": -made.width}[label.anchor]
    turn = complex(math.cos(math.radians(label.turn)), math.sin(math.radians(label.turn)))
    corner = label.at + complex(start + made.left, -made.descent) * turn
    return Frame(corner, turn, made.right - made.left, made.ascent + made.descent)


def shape(stroke: Stroke | Bezier) -> shapely.LineString | shapely.Polygon:
    """Return a stroke as a shape; curves by points near enough for placing."""
    points = [(z.real, z.imag) for z in outline(stroke)]
    solid = isinstance(stroke, Stroke) and stroke.filled
    return shapely.Polygon(points) if solid else shapely.LineString(points)


def shapes(strokes: Sequence[Stroke | Bezier]) -> np.ndarray:
    """Return strokes as shapes, all of them at once; see `shape`."""
    lines = [outline(stroke) for stroke in strokes]
    spots = np.array([spot for points in lines for spot in points], dtype=complex)
    which = np.repeat(np.arange(len(lines)), [len(points) for points in lines])
    made = np.asarray(shapely.linestrings(spots.real, spots.imag, indices=which))
    for k, stroke in enumerate(strokes):
        if isinstance(stroke, Stroke) and stroke.filled:
            made[k] = shape(stroke)
    return made


def outline(stroke: Stroke | Bezier) -> list[complex]:
    """Return the corners of a stroke; curves by points near enough for placing."""
    if isinstance(stroke, Bezier):
        return list(_flattened(stroke.controls))
    if not any(bulge for _, _, bulge in stroke.path):
        points = [complex(x, y) for x, y, _ in stroke.path]
        return [*points, points[0]] if stroke.closed else points
    points, count = [], len(stroke.path)
    for k, (x, y, bulge) in enumerate(stroke.path):
        points.append(complex(x, y))
        if bulge and (stroke.closed or k + 1 < count):
            nx, ny, _ = stroke.path[(k + 1) % count]
            points += _bow(complex(x, y), complex(nx, ny), bulge)
    if stroke.closed:
        points.append(points[0])
    return points


def flat(controls: Sequence[complex]) -> list[complex]:
    """Return points along a chain of cubic arcs, eight to an arc or as many as it takes to stay close to it."""
    points = [controls[0]]
    for k in range(0, len(controls) - 1, 3):
        a, b, c, d = controls[k : k + 4]
        bend = 6 * max(abs(a - 2 * b + c), abs(b - 2 * c + d))  # of the arc, at most
        count = _count(math.sqrt(bend / (8 * TRUE)), 8)
        own, second, third, last = _weights(count)
        points += (own * a + second * b + third * c + last * d).tolist()
    return points


@lru_cache(maxsize=1024)
def _flattened(controls: tuple[complex, ...]) -> tuple[complex, ...]:
    """Return the same, cached, for a curve that is needed many times while its view is drawn."""
    return tuple(flat(controls))


@lru_cache(maxsize=CHORDS)
def _weights(count: int) -> tuple[Reals, Reals, Reals, Reals]:
    """Return the weights of an arc's control points at the ends of a number of chords, except the first."""
    t = np.linspace(0.0, 1.0, count + 1)[1:]
    return (1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3


def _bow(start: complex, end: complex, bulge: float) -> list[complex]:
    """Return points inside an arc given by its bulge."""
    quarter = math.atan(bulge)
    centre = (start + end) / 2 + (end - start) * 0.5j / math.tan(2 * quarter)
    turn = abs(4 * quarter)
    chords = turn * math.sqrt(abs(start - centre) / (8 * TRUE))
    count = _count(chords, math.ceil(turn / math.radians(20)))
    turns = [4 * quarter * k / count for k in range(1, count)]
    return [centre + (start - centre) * complex(math.cos(t), math.sin(t)) for t in turns]


def _count(chords: float, least: int) -> int:
    """Return how many chords an arc gets: ``least`` where ``chords`` is no number."""
    return max(2, least, 0 if math.isnan(chords) else math.ceil(min(chords, CHORDS)))
