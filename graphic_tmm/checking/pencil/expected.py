"""What should be on a sheet: of each view its points, the straight lines through them, their rings.

The log's own ink tells: a stroke knows its position, a point where it stands; which lines go through which
points is plane geometry. Lines that cover one another are one line of pencil.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Point
from graphic_tmm.checking.cells import pointed
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.drawing import Drawing, Sheet, Stroke

Name = tuple[str, str, str]
"""Plan, letter, position."""
ONE = 0.3
"""Points nearer than this are one place, mm: pencil does not tell them apart."""
ON = 0.3
"""A point is on a line that passes it as near, mm."""
HEAD = 6.0
"""The line of a vector ends in its head, so far from its point at most, mm."""
SHORTEST = 4.0
"""A shorter stroke is part of a sign, no line, mm."""
ALIKE = 0.3
"""Two lines are one if their ends are so near to the other's axis, mm."""
LINES = ("", "link", "guide")
"""Parts of a view whose strokes are lines of its construction."""


class Place(NamedTuple):
    """A place of a view, mm on the sheet, and the points that stand there."""

    at: complex
    names: tuple[Name, ...]


class Line(NamedTuple):
    """A straight line of a view, mm on the sheet, and the places (indices) on it; ``ends``: those at which it ends."""

    start: complex
    end: complex
    places: tuple[int, ...]

    @property
    def length(self) -> float:
        """How long it is, mm."""
        return abs(self.end - self.start)

    @property
    def way(self) -> complex:
        """Its direction."""
        return (self.end - self.start) / self.length


class View(NamedTuple):
    """A view of a sheet: its places and lines; the place (index) of each pole, by plan and position.

    ``ink``: by place the straight pieces, (pieces, 2), of the signs there: heads of vectors, rings, nicks.
    """

    name: str
    places: tuple[Place, ...]
    lines: tuple[Line, ...]
    poles: dict[tuple[str, str], int]
    ink: tuple[np.ndarray, ...]


def views(made: DrawnScene, sheet: Sheet) -> tuple[View, ...]:
    """Return what a sheet of a scene should show of its plans whose points can be read."""
    found = (view_of(made, drawing) for drawing in sheet.drawings)
    return tuple(view for view in found if view is not None)


def view_of(made: DrawnScene, drawing: Drawing) -> View | None:
    """Return what a view should show; None if no points can be read off it."""
    shown = [plan for plan in drawing.shows if plan in pointed()]
    if made.mechanism is None or not shown:
        return None
    places: list[tuple[complex, list[Name]]] = []
    poles = {}
    for plan, position, letter, at in _points(made, drawing, shown):
        k = next((k for k, (z, _) in enumerate(places) if abs(z - at) < ONE), len(places))
        if k == len(places):
            places.append((at, []))
        if letter:
            places[k][1].append((plan, letter, position))
        else:
            poles[plan, position] = k
    spots = np.array([at for at, _ in places])
    lines = _merged(_segments(drawing))
    return View(
        drawing.name,
        tuple(Place(at, tuple(names)) for at, names in places),
        tuple(line for line in (_through(spots, *one) for one in lines) if line.places),
        poles,
        tuple(_signs(drawing, at) for at in spots),
    )


def _points(
    made: DrawnScene, drawing: Drawing, shown: Sequence[str]
) -> Iterable[tuple[str, str, str, complex]]:
    """Yield plan, position, letter and place of all points of a view, mm; first of each the pole, letter ""."""
    work = made.mechanism
    assert work is not None
    inked = {stroke.position for stroke in drawing.strokes}
    for plan in shown:
        reading, row, origin = work.of(plan), work.row(plan), drawing.origin(plan)
        if reading is None:
            continue
        marks = [
            step.it
            for step in work.construction.steps
            if step.it.view == plan and step.it.kind is Point and not step.op.across
        ]
        for k, place in enumerate(row):
            if k not in inked:
                continue
            yield plan, work.names[place], "", origin
            for mark in marks:
                value = reading[mark]
                spot = complex(value[0, k if value.shape[1] > 1 else 0])
                if cmath.isfinite(spot):
                    yield plan, work.names[place], mark.key[1], origin + spot


def _segments(drawing: Drawing) -> list[tuple[complex, complex]]:
    """Return the straight lines of a view's construction and of its links."""
    found = []
    for stroke in drawing.strokes:
        if not isinstance(stroke, Stroke) or stroke.pen == "paper" or stroke.filled:
            continue
        if stroke.part in LINES:
            found += [(a, b) for a, b in _pieces(stroke) if abs(b - a) >= SHORTEST]
    return found


def _pieces(stroke: Stroke) -> list[tuple[complex, complex]]:
    """Return the straight pieces of a stroke."""
    path = (*stroke.path, stroke.path[0]) if stroke.closed else stroke.path
    pairs = zip(path, path[1:], strict=False)
    return [(complex(*a[:2]), complex(*b[:2])) for a, b in pairs if abs(a[2]) < 1e-9]


def _merged(segments: list[tuple[complex, complex]]) -> list[tuple[complex, complex]]:
    """Return lines of which none covers another, in part."""
    found: list[tuple[complex, complex]] = []
    for one in sorted(segments, key=lambda ends: -abs(ends[1] - ends[0])):
        for k, (a, b) in enumerate(found):
            own = (np.array(one) - a) / (b - a) * abs(b - a)
            low, high = min(own.real), max(own.real)
            if max(abs(own.imag)) < ALIKE and high > ALIKE and low < abs(b - a) - ALIKE:
                way = (b - a) / abs(b - a)
                found[k] = (a + way * min(low, 0.0), a + way * max(high, abs(b - a)))
                break
        else:
            found.append(one)
    return found


def _through(spots: np.ndarray, start: complex, end: complex) -> Line:
    """Return a line with the places on it; it reaches those that its vectors' heads do."""
    length = abs(end - start)
    own = (spots - start) / (end - start) * length
    near = (abs(own.imag) < ON) & (own.real > -HEAD) & (own.real < length + HEAD)
    on = np.flatnonzero(near)
    if on.size:
        way = (end - start) / length
        low, high = float(own.real[on].min()), float(own.real[on].max())
        start, end = start + way * min(low, 0.0), start + way * max(high, length)
    return Line(start, end, tuple(int(k) for k in on))


def _signs(drawing: Drawing, at: complex) -> np.ndarray:
    """Return the straight pieces, (pieces, 2), of all strokes that touch a place, within its neighbourhood."""
    found = [piece for stroke in drawing.strokes for piece in _near(stroke, at)]
    return np.array(found, dtype=np.complex128).reshape(-1, 2)


def _near(stroke: object, at: complex) -> list[tuple[complex, complex]]:
    if not isinstance(stroke, Stroke) or stroke.pen == "paper" or stroke.part in ("leader", "number"):
        return []
    pieces = _chords(stroke)
    if not pieces:
        return []
    own = np.array(pieces)
    a, b = own[:, 0], own[:, 1]
    length = np.maximum(abs(b - a), 1e-9)
    along = np.clip(((at - a) / (b - a + 1e-12)).real, 0, 1)
    nearest = abs(a + along * (b - a) - at)
    if nearest.min() > (ON if length.max() > SHORTEST else 2.0):
        return []
    return pieces


def _chords(stroke: Stroke) -> list[tuple[complex, complex]]:
    """Return the pieces of a stroke, arcs as eight chords each."""
    path = (*stroke.path, stroke.path[0]) if stroke.closed else stroke.path
    found = []
    for one, other in zip(path, path[1:], strict=False):
        a, b, bulge = complex(*one[:2]), complex(*other[:2]), one[2]
        if abs(bulge) < 1e-9 or a == b:
            found.append((a, b))
            continue
        half = 2 * np.arctan(bulge)
        centre = (a + b) / 2 + 1j * (b - a) / 2 / np.tan(half)
        arc = centre + (a - centre) * np.exp(2j * half * np.linspace(0, 1, 9))
        found += [(complex(p), complex(q)) for p, q in zip(arc, arc[1:], strict=False)]
    return found
