"""Graphs in ink, read off the log: axes, the curve, and what was drawn to find it.

Lines are drawn from where they begin to where they were met: rays from the pole, levels carried across, the
perpendiculars over the base; chords and the segments of an integral between their points.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.graph_curves import graph_of_rays
from graphic_tmm.board.operations.instruments import join, lay_off, measure_along, meet
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Complexes, Curve
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import flat, interrupt, leaders, place
from graphic_tmm.paper.lettering.heights import HEIGHTS, Heights
from graphic_tmm.paper.symbols.dimensions import Dimension, dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead, pole

OVER = 9.0
"""How far an axis goes on behind the base, or above the highest point, mm."""
TICK = 1.0
"""Half a tick on the base, mm."""
DOT = 0.5
"""Radius of the point of a reading, mm."""
TANGENT = 6.0
"""Half the length of a tangent that is drawn, mm."""
POLES = (roles.POLE, roles.LEVEL_POLE)
EXTREMES = (g.highest, g.lowest)
"""Operations that find where a curve turns."""
ASIDE = 14.0
"""From the axis of the ordinates to a dimension line, mm."""
LEAST = 0.3
"""Shorter lines are points, mm."""
ON_AXIS = {roles.EXTREME: (True, -1 + 0j), roles.MEAN: (False, -1 - 0.5j)}
"""Points on the axis of the ordinates that bear their letters: large as at points, or as numbers; the side."""
ROOM = 6.0
"""Room for letters about a graph before they have their places, mm."""


class AxesMarks(NamedTuple):
    """What the log tells of the axes of a view, in the order in which the plan told it."""

    origin: Mark
    along: Mark
    up: Mark
    feet: Mark
    end: Mark
    middles: Mark
    mu: Mark
    mu_along: Mark
    length: Mark


class Names(NamedTuple):
    """What is lettered on a graph: the positions, the quantity of the ordinates, that along the base.

    ``curves``: the label of a curve by its mark or that of the readings of its points, where there are several.
    ``lengths``: the figures of what is dimensioned on the axis of the ordinates.
    """

    positions: Sequence[str]
    up: str
    along: str
    curves: Mapping[Mark, str] = MappingProxyType({})
    lengths: Mapping[Mark, str] = MappingProxyType({})


def axes_ink(
    ends: Sequence[complex], poles: Sequence[complex], low: float, high: float
) -> list[Stroke]:
    """Return two axes with their arrows, and the ticks of the positions; the last of them ends the base.

    The axis along reaches back over the ``poles``; ``low``, ``high``: where that of the ordinates ends.
    """
    right, top = complex(ends[-1].real + OVER, 0), complex(0, high + OVER)
    left = min([0.0, *(spot.real for spot in poles)])
    strokes = [line("thin", complex(left, 0), right), line("thin", complex(0, low), top)]
    strokes += [*arrowhead(right, 1 + 0j, pen="thin"), *arrowhead(top, 1j, pen="thin")]
    return [*strokes, *(line("thin", z - 1j * TICK, z + 1j * TICK) for z in ends)]


def axes_of(construction: Construction, view: str) -> AxesMarks:
    """Return the axes of a view."""
    figure = next(f for f in construction.figures if f.view == view and f.kind == "axes")
    return AxesMarks(*figure.marks)


def draw_graph(
    construction: Construction,
    reading: Reading,
    view: str,
    row: int,
    names: Names,
    title: str,
    *,
    lettered: bool = True,
    heights: Heights = HEIGHTS["A1"],
) -> Drawing:
    """Return a graph: ``row`` intervals; the positions behind the row stand where they belong."""
    ink = _Ink(construction, reading, view, row, heights)
    thin = [stroke for step in ink.steps for stroke in ink.construction_of(step)]
    curves = [piece for step in ink.steps for piece in ink.curve_of(step)]
    dots = [circle("main", z, DOT, filled=True) for z in ink.dots()]
    low, high = ink.extent()
    axes = ink.axes(low, high)
    strokes: list[Stroke | Bezier] = [*thin, *axes, *curves, *dots]
    for spot in ink.poles():
        strokes += pole(spot)
    dimensions = list(ink.dimensions(names))
    strokes += [stroke for made in dimensions for stroke in made.strokes]
    if not lettered:
        beside = [-ASIDE - heights.point] * len(dimensions)
        left = min([0.0, *(spot.real for spot in ink.poles()), *beside])
        bottom = min(low, -heights.number) - ROOM
        cell = (left - ROOM, bottom, ink.length + OVER + ROOM, high + OVER + ROOM)
        return Drawing(view, title, tuple(strokes), cell=cell)
    wanted = list(ink.letters(names, high))
    figures = tuple(made.label for made in dimensions)
    labels = place(wanted, strokes, figures)
    ink_ = interrupt([*strokes, *leaders(wanted, labels)], labels)
    return Drawing(view, title, ink_, (*labels, *figures))


class _Ink:
    """A view of the log and its numbers while it is inked; the origin is 0."""

    def __init__(
        self, construction: Construction, reading: Reading, view: str, row: int, heights: Heights
    ) -> None:
        self.reading, self.row, self.heights = reading, row, heights
        self.marks = axes_of(construction, view)
        self.by_mark = {step.it: step for step in construction.steps}
        self.steps = [step for step in construction.steps if step.it.view == view]
        self.length = float(reading[self.marks.length][0, 0])

    def points(self, mark: Mark) -> Complexes:
        """The places of a point in all positions."""
        return np.broadcast_to(self.reading[mark][0], (self.reading.positions,))

    def starts(self, mark: Mark) -> Complexes:
        """Where a line begins in all positions."""
        return np.broadcast_to(self.reading[mark].at[0], (self.reading.positions,))

    def construction_of(self, step: Step) -> Iterator[Stroke]:
        """The thin lines of a step."""
        rule = _RULES.get(step.op.name)
        if rule is None:
            return
        for start, end in rule(self, step):
            ends = dict.fromkeys(zip(map(complex, start), map(complex, end), strict=True))
            pen = "main" if len(ends) == 1 and step.op is join else "thin"
            for a, b in ends:
                if np.isfinite(a) and np.isfinite(b) and abs(b - a) > LEAST:
                    yield line(pen, a, b)

    def curve_of(self, step: Step) -> Iterator[Bezier]:
        """The curve of a step, over the base only."""
        if step.it.kind is Curve:
            for controls in bezier(self.reading[step.it]):
                yield from _clipped(controls, self.length, step.it.name)

    def dots(self) -> list[complex]:
        """The points through which curves are drawn, and those in which they turn."""
        found: list[complex] = []
        for step in self.steps:
            if step.it.kind is Curve:
                found += map(complex, self.points(step.uses[0])[: self.row])
            if step.op in EXTREMES:
                found.append(complex(self.points(step.it)[0]))
        return [z for z in found if np.isfinite(z)]

    def poles(self) -> list[complex]:
        """The poles, where there are any."""
        return [spot for _, spot in self.lettered_poles()]

    def lettered_poles(self) -> list[tuple[str, complex]]:
        """The poles with their letters."""
        marks = [step.it for step in self.steps if step.it.role in POLES]
        spots = [(mark.name, complex(self.points(mark)[0])) for mark in marks]
        return [(name, spot) for name, spot in spots if np.isfinite(spot)]

    def extent(self) -> tuple[float, float]:
        """The lowest and the highest of what stands over the base, the base itself included."""
        heights = [0.0]
        for step in self.steps:
            for piece in self.curve_of(step):
                heights += [z.imag for z in flat(piece.controls)]
        return min(heights), max(heights)

    def dimensions(self, names: Names) -> Iterator[Dimension]:
        """The dimensions of what is measured along the axis of the ordinates, left of it."""
        for step in self.steps:
            if step.it in names.lengths:
                low, high = (complex(self.points(mark)[0]) for mark in step.uses[:2])
                if np.isfinite(high - low):
                    yield dimension(low, high, ASIDE, names.lengths[step.it])

    def axes(self, low: float, high: float) -> list[Stroke]:
        """The two axes with their arrows, and the ticks of the positions."""
        feet = [*map(complex, self.points(self.marks.feet)), complex(self.length)]
        return axes_ink(feet, self.poles(), low, high)

    def outermost(self, mark: Mark) -> complex:
        """The point of the row that stands farthest from the base; NaN if none stands."""
        spots = self.points(mark)[: self.row]
        spots = spots[np.isfinite(spots)]
        return complex(spots[int(np.argmax(np.abs(spots.imag)))]) if spots.size else complex("nan")

    def letters(self, names: Names, high: float) -> Iterator[Wanted]:
        """The numbers of the positions under the base, the letters of the axes and of the pole."""
        point, small = self.heights.point, self.heights.number
        yield Wanted(names.up, complex(0, high + OVER), point, 1.5, -1 + 0j)
        yield Wanted(names.along, complex(self.length + OVER, 0), point, 1.5, -1j)
        for name, spot in self.lettered_poles():
            yield Wanted(name, spot, small, 1.0, -1 + 0j)
        for step in self.steps:
            if step.it in names.curves and step.op in (join, graph_of_rays):
                spot = self.outermost(step.uses[1 if step.op is join else 0])
                spot = 0.6 * spot if step.op is join else spot
                if np.isfinite(spot):
                    yield Wanted(names.curves[step.it], spot, small, 1.0, 1j - 0.5)
            if step.it in names.curves and step.op is measure_along:
                spot = self.outermost(step.uses[1])
                if np.isfinite(spot):
                    letter = names.curves[step.it]
                    yield Wanted(letter, spot, small, 1.0, spot.imag * 1j)
            yield from self.named(step)
        yield from self.numbers(names)

    def named(self, step: Step) -> Iterator[Wanted]:
        """The letter of a point that is one of a kind: where a curve turns, what is carried to the axis."""
        if step.op in EXTREMES:
            large, way = False, 1j if step.op is g.highest else -1j
        elif step.it.role in ON_AXIS:
            large, way = ON_AXIS[step.it.role]
        else:
            return
        spot = complex(self.points(step.it)[0])
        if np.isfinite(spot):
            size = self.heights.point if large else self.heights.number
            yield Wanted(step.it.name, spot, size, 1.0, way)

    def numbers(self, names: Names) -> Iterator[Wanted]:
        """The numbers of the positions under the base."""
        feet, small = self.points(self.marks.feet), self.heights.number
        for name, foot in zip(names.positions, feet, strict=True):
            yield Wanted(name, complex(foot), small, TICK, -1 - 1.5j)
        yield Wanted(names.positions[0], complex(self.length), small, TICK, -1 - 1.5j)


Ends = Iterator[tuple[Complexes, Complexes]]


def _met(ink: _Ink, step: Step) -> Ends:
    """From where each of two lines begins to where they meet; an axis is drawn already."""
    for used in step.uses:
        drawn = ink.by_mark.get(used)
        if used in (ink.marks.along, ink.marks.up) or drawn is None:
            continue
        begun = ink.by_mark.get(drawn.uses[0])
        if begun is not None and begun.op is g.at_zero:
            continue  # the height of the first point, taken over with the dividers
        yield ink.starts(used), ink.points(step.it)


def _laid(ink: _Ink, step: Step) -> Ends:
    if step.it.role != roles.POLE and step.it not in (ink.marks.feet, ink.marks.end):
        yield ink.starts(step.uses[0]), ink.points(step.it)


def _erected(ink: _Ink, step: Step) -> Ends:
    yield ink.points(step.uses[1]), ink.points(step.it)


def _levelled(ink: _Ink, step: Step) -> Ends:
    starts, ends = (ink.points(mark).real for mark in step.uses[1:])
    height = 1j * ink.points(step.it).imag
    yield starts + height, ends + height


def _joined(ink: _Ink, step: Step) -> Ends:
    yield ink.points(step.uses[0]), ink.points(step.uses[1])


def _touched(ink: _Ink, step: Step) -> Ends:
    at, along = ink.starts(step.it), ink.reading[step.it].along[0]
    yield at - TANGENT * along, at + TANGENT * along


def _succeeded(ink: _Ink, step: Step) -> Ends:
    points = ink.points(step.it)[: ink.row]
    last = next(s.it for s in ink.steps if s.op is g.arrival and s.uses[1] == step.uses[1])
    yield points, np.append(points[1:], ink.points(last)[0])


_RULES: dict[str, Callable[[_Ink, Step], Ends]] = {
    op.name: rule
    for op, rule in (
        (meet, _met),
        (lay_off, _laid),
        (g.erect, _erected),
        (g.level_off, _levelled),
        (join, _joined),
        (g.touching, _touched),
        (g.succession, _succeeded),
    )
}


def _clipped(controls: Complexes, length: float, title: str) -> Iterator[Bezier]:
    """Return the part of a chain of cubic arcs that stands over the base; x runs evenly along each arc."""
    kept: list[complex] = []
    for k in range(0, len(controls) - 1, 3):
        arc = controls[k : k + 4]
        x0, x1 = arc[0].real, arc[3].real
        if x1 <= 1e-9 or x0 >= length - 1e-9:
            continue
        u, v = max(0.0, -x0 / (x1 - x0)), min(1.0, (length - x0) / (x1 - x0))
        piece = _part(arc, u, v)
        kept += [complex(z) for z in (piece if not kept else piece[1:])]
    if kept:
        yield Bezier("main", tuple(kept), title)


def _part(arc: Complexes, u: float, v: float) -> Complexes:
    """Return the controls of the part of a cubic arc between two of its parameters."""
    if u == 0.0 and v == 1.0:
        return arc

    def blossom(a: float, b: float, c: float) -> complex:
        points = list(arc)
        for t in (a, b, c):
            points = [p + t * (q - p) for p, q in pairwise(points)]
        return complex(points[0])

    return np.array([blossom(u, u, u), blossom(u, u, v), blossom(u, v, v), blossom(v, v, v)])
