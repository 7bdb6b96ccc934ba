"""Diagrams of a cam in ink: curves of the stretches, dwells and jumps, and what was drawn to find them."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.instruments import join, lay_off, meet, place
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam import law_formulas as law
from graphic_tmm.chapters.cam.ink_numbers import DOT, LEAST, NUMBER, OVER, SIZE, finished
from graphic_tmm.chapters.cam.operations import divide_semicircle
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, Wanted, arc, circle, line
from graphic_tmm.paper.graph import TICK, axes_ink, axes_of
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import pole

PHASES = 9.0
"""From the lowest point of a diagram to the dimension line of its phases, mm."""


class CamNames(NamedTuple):
    """What is lettered on a diagram: the positions, the quantity of the ordinates, that along the base.

    ``phases``: for each phase its name with its angle and where it ends (degrees), in order. ``levels``:
    straight lines of limits, their height (mm) and their name. ``spots``: points of the log that bear a name.
    """

    positions: Sequence[str]
    up: str
    along: str
    phases: Sequence[tuple[str, float]] = ()
    levels: Sequence[tuple[float, str]] = ()
    spots: Sequence[tuple[Mark, str]] = ()


def draw_cam_graph(
    construction: Construction,
    reading: Reading,
    view: str,
    names: CamNames,
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return a diagram of a cam with the construction that gave it."""
    ink = _Ink(construction, reading, view)
    thin = [stroke for step in ink.steps for stroke in ink.construction_of(step)]
    curves = [piece for step in ink.steps for piece in ink.curve_of(step)]
    dots = [circle("main", z, DOT, filled=True) for z in ink.dots()]
    low, high = ink.extent(names)
    strokes: list[Stroke | Bezier] = [*thin, *ink.axes(low, high), *ink.outline(), *curves, *dots]
    for height, _ in names.levels:
        strokes.append(line("dashed", 1j * height, ink.length + 1j * height))
    for mark, _ in names.spots:
        spot = ink.one(mark)
        if np.isfinite(spot):
            strokes.append(circle("main", spot, 1.5 * DOT, filled=True))
    for spot in ink.poles():
        strokes += pole(spot)
    found = [made for made in ink.phases(names, low)]
    strokes += [stroke for lines, _ in found for stroke in lines]
    figures = tuple(label for _, label in found)
    wanted = list(ink.letters(names, high)) if lettered else []
    return finished(view, title, strokes, wanted, figures, lettered)


class _Ink:
    """A view of the log and its numbers while it is inked; the origin is 0."""

    def __init__(self, construction: Construction, reading: Reading, view: str) -> None:
        self.construction, self.reading, self.view = construction, reading, view
        self.marks = axes_of(construction, view)
        self.by_mark = {step.it: step for step in construction.steps}
        self.steps = [step for step in construction.steps if step.it.view == view]
        self.length = float(reading[self.marks.length][0, 0])
        self.axis_lines = (self.marks.along, self.marks.up)
        self.ranges: dict[Mark, list[tuple[int, int]]] = {}
        for step in self.steps:
            if step.op is graph_of_stretch:
                ends = (step.choice["first"], step.choice["last"])
                self.ranges.setdefault(step.uses[0], []).append(ends)

    def points(self, mark: Mark) -> Complexes:
        """The places of a point in all positions."""
        return np.broadcast_to(self.reading[mark][0], (self.reading.positions,))

    def shown(self, mark: Mark) -> Complexes:
        """The places of a point where a curve is drawn through it; everywhere if none is."""
        spots = self.points(mark)
        if mark not in self.ranges:
            return spots
        k = np.arange(spots.size)
        inside = [(k >= first) & (k <= last) for first, last in self.ranges[mark]]
        return np.where(np.logical_or.reduce(inside), spots, np.nan)

    def starts(self, mark: Mark) -> Complexes:
        """Where a line begins in all positions."""
        return np.broadcast_to(self.reading[mark].at[0], (self.reading.positions,))

    def one(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return complex(self.reading[mark][0, 0])

    def construction_of(self, step: Step) -> Iterator[Stroke]:
        """The thin lines of a step."""
        if step.op is divide_semicircle:
            yield from self.semicircle(step)
            return
        rule = _RULES.get(step.op.name)
        if rule is None:
            return
        for start, end in rule(self, step):
            for a, b in dict.fromkeys(zip(map(complex, start), map(complex, end), strict=True)):
                if np.isfinite(a) and np.isfinite(b) and abs(b - a) > LEAST:
                    yield line("thin", a, b)

    def semicircle(self, step: Step) -> Iterator[Stroke]:
        """The semicircle with its points of division."""
        struck, begun = self.reading[step.uses[0]], self.reading[step.uses[1]]
        centre, way = complex(struck.centre[0, 0]), complex(begun.along[0, 0])
        radius, sense = float(struck.radius[0, 0]), step.choice["sense"]
        by = self.by_mark[step.uses[2]].op
        start = math.degrees(math.atan2(way.imag, way.real))
        if by is law.half_around_outer:
            yield arc("thin", centre, radius, start, 90.0 * sense)
        else:
            start -= 90.0 * sense if by is law.around_outer else 0.0
            yield arc("thin", centre, radius, start, 180.0 * sense)
            end = centre + cmath.rect(radius, math.radians(start))
            yield line("thin", end, 2 * centre - end)
        spots = self.points(step.it)
        spots = spots[np.isfinite(spots)]
        for z in dict.fromkeys(complex(round(z.real, 6), round(z.imag, 6)) for z in spots):
            yield circle("thin", z, DOT)

    def curve_of(self, step: Step) -> Iterator[Bezier]:
        """The curve of a step."""
        if step.op is graph_of_stretch:
            for controls in bezier(self.reading[step.it]):
                yield Bezier("main", tuple(complex(z) for z in controls), step.it.name)

    def outline(self) -> Iterator[Stroke]:
        """What is drawn besides the curves: dwells, jumps, straight lines that are given."""
        for figure in self.construction.figures:
            if figure.view == self.view and figure.kind == "outline":
                spots = [self.one(mark) for mark in figure.marks]
                for a, b in pairwise(spots):
                    if np.isfinite(a) and np.isfinite(b) and abs(b - a) > LEAST:
                        yield line("main", a, b)

    def dots(self) -> list[complex]:
        """The points through which curves are drawn."""
        found: dict[complex, None] = {}
        for step in self.steps:
            if step.op is graph_of_stretch:
                part = slice(step.choice["first"], step.choice["last"] + 1)
                found |= {
                    complex(z): None for z in self.points(step.uses[0])[part] if np.isfinite(z)
                }
        return list(found)

    def poles(self) -> list[complex]:
        """The pole, where there is one."""
        marks = self.construction.roles(self.view, roles.POLE)
        return [complex(self.points(mark)[0]) for mark in marks]

    def extent(self, names: CamNames) -> tuple[float, float]:
        """The lowest and the highest of what stands over the base, the base itself included."""
        heights = [0.0, *(z.imag for z in self.dots()), *(height for height, _ in names.levels)]
        for figure in self.construction.figures:
            if figure.view == self.view and figure.kind == "outline":
                heights += [self.one(mark).imag for mark in figure.marks]
        there = [y for y in heights if math.isfinite(y)]
        return min(there), max(there)

    def axes(self, low: float, high: float) -> list[Stroke]:
        """The two axes with their arrows, and the ticks of the positions."""
        ends = [*map(complex, self.points(self.marks.feet)), complex(self.length)]
        return axes_ink(ends, self.poles(), low, high)

    def phases(self, names: CamNames, low: float) -> Iterator[tuple[tuple[Stroke, ...], Label]]:
        """Dimension lines of the phases below the diagram."""
        start, level = 0.0, low - 3.0
        for text, end in names.phases:
            a, b = (complex(angle * self.length / 360.0, level) for angle in (start, end))
            if abs(b - a) > LEAST:
                wide = letter(text, size=3.5).width > abs(b - a) - 2.0
                made = dimension(a, b, -(2 if wide else 1) * PHASES, text)
                yield made.strokes, made.label
            start = end

    def letters(self, names: CamNames, high: float) -> Iterator[Wanted]:
        """The numbers of the positions at the base, the letters of the axes, of limits and of extremes."""
        yield Wanted(names.up, complex(0, high + OVER), SIZE, 1.5, -1 + 0j)
        yield Wanted(names.along, complex(self.length + OVER, 0), SIZE, 1.5, -1j)
        for spot in self.poles():
            yield Wanted("P", spot, 3.5, 1.0, -1 + 0j)
        for height, text in names.levels:
            yield Wanted(text, complex(self.length, height), 3.5, 0.5, 1 + 0j)
        for mark, text in names.spots:
            if np.isfinite(self.one(mark)):
                spot = self.one(mark)
                beside = [
                    y for y, _ in names.levels if y * spot.imag > 0 and abs(y) > abs(spot.imag)
                ]
                if beside:  # behind the limit, for there is no room before it
                    spot = complex(spot.real, beside[0])
                    yield Wanted(text, spot, 3.5, 0.3, 1j * spot.imag)
                else:
                    yield Wanted(text, spot, 3.5, 1.0)
        heights = {round(z.real, 3): z.imag for z in self.dots()}
        feet = [*self.points(self.marks.feet)]
        texts = list(names.positions)
        if abs(self.length - feet[-1].real) > LEAST:
            feet, texts = [*feet, complex(self.length)], [*texts, names.positions[0]]
        for text, foot in zip(texts, feet, strict=True):
            below = heights.get(round(foot.real, 3), 0.0) < -LEAST
            yield Wanted(text, complex(foot), NUMBER, TICK, 1j if below else -1j)


Ends = Iterator[tuple[Complexes, Complexes]]


def _met(ink: _Ink, step: Step) -> Ends:
    """From where each of two lines begins to where they meet; an axis is drawn already."""
    for used in step.uses:
        if used not in ink.axis_lines:
            yield ink.starts(used), ink.shown(step.it)


def _laid(ink: _Ink, step: Step) -> Ends:
    """From the base to a point laid off above or below it; what lies on the base has its tick."""
    if step.it.role != roles.POLE and step.uses[0] not in ink.axis_lines:
        start, end = ink.starts(step.uses[0]), ink.shown(step.it)
        level = np.abs((end - start).imag) > LEAST
        yield np.where(level, start, np.nan), end


def _erected(ink: _Ink, step: Step) -> Ends:
    yield ink.points(step.uses[1]), ink.points(step.it)


def _joined(ink: _Ink, step: Step) -> Ends:
    yield ink.points(step.uses[0]), ink.points(step.uses[1])


def _succeeded(ink: _Ink, step: Step) -> Ends:
    points = ink.points(step.it)
    last = next(s.it for s in ink.steps if s.op is g.arrival and s.uses[1] == step.uses[1])
    yield points, np.append(points[1:], ink.points(last)[0])


_RULES: dict[str, Callable[[_Ink, Step], Ends]] = {
    op.name: rule
    for op, rule in (
        (meet, _met),
        (lay_off, _laid),
        (place, _laid),
        (g.erect, _erected),
        (join, _joined),
        (g.succession, _succeeded),
    )
}
