"""Graphs in ink: what the steps of the log leave (`graph_rules`), names of curves, distances, numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
import shapely

from graphic_tmm.board import roles
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.instruments import join, measure_along
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Curve, Point, Reals
from graphic_tmm.paper.axes import position_numbers
from graphic_tmm.paper.drawing import GRAPH, Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import added, body, figure
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.graph_rules import (
    EXTREMES,
    OUTLINE,
    OVER,
    TICK,
    Graph,
    curve_over_base,
    ends_of,
    manner_of,
)
from graphic_tmm.paper.label_places import polylines
from graphic_tmm.paper.labels import Named
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Subject, finite
from graphic_tmm.paper.shapes import flat
from graphic_tmm.paper.symbols.dimensions import SIZE, Dimension, dimension
from graphic_tmm.paper.symbols.kinematic import pole

FAR = 12.0
"""Curves this far apart, mm, are far enough that a name between them is not mistaken."""

INSET = 0.12
"""So far from its ends, of its width, a line is named that has no intervals."""

Lines = tuple[tuple[complex, ...], ...]


def curve_names(graph: Graph, names: Mapping[Mark, str], size: float) -> Iterator[Wanted]:
    """Return the names of curves, by the mark of a curve or that of the readings of its points.

    A name stands at a place of its curve between two positions, so that no ordinate leads to it: where the
    other named curves are farthest, of places where they are far the highest over the base, or the lowest.
    """
    lines = {step.it: _lines(graph, step) for step in graph.steps if step.it in names}
    middles = (np.arange(graph.row) + 0.5) * graph.length / graph.row
    yield from names_beside(lines, names, size, middles)


def names_beside(
    lines: Mapping[Mark, Lines],
    names: Mapping[Mark, str],
    size: float,
    middles: Reals | None = None,
) -> Iterator[Wanted]:
    """Return the names of lines; ``middles``: the abscissae, mm, at which they are named, anywhere if None."""
    for mark, own in lines.items():
        others = tuple(line for other, more in lines.items() if other != mark for line in more)
        found = _place(own, others, middles)
        if found is not None:
            spot, toward, line = found
            of = (mark.slot,)
            yield Wanted(names[mark], spot, size, 1.0, toward, of, line=line, others=others)


def _lines(graph: Graph, step: Step) -> Lines:
    """Return what is drawn of a curve that has a name, its parts, or of the curves through the points read."""
    if step.op is join:
        ends = ends_of(graph, step, 0)
        return (ends,) if finite(*ends) else ()
    steps = [step]
    if step.op is measure_along:
        steps = [s for s in graph.steps if s.it.kind is Curve and s.uses[0] == step.uses[1]]
    pieces = [flat(one.controls) for s in steps for one in curve_over_base(graph, s)]
    return tuple(tuple(complex(z) for z in piece) for piece in pieces)


def _place(
    own: Lines, others: Lines, middles: Reals | None
) -> tuple[complex, complex, tuple[complex, ...]] | None:
    """Return where a curve is named, on which side, and the part of it that stands there; None if nowhere."""
    rivals = polylines(others)
    found = []
    for piece in own:
        for spot in _spots(piece, middles):
            there = shapely.Point(spot.real, spot.imag)
            away = FAR if rivals.is_empty else min(FAR, shapely.distance(rivals, there))
            found.append((round(away, 6), round(abs(spot.imag), 6), spot, piece))
    if not found:
        return None
    away, _, spot, piece = max(found, key=lambda one: one[:2])
    if away == FAR:
        return spot, 1j * (spot.imag or 1.0), piece
    nearest = shapely.shortest_line(rivals, shapely.Point(spot.real, spot.imag)).coords[0]
    return spot, 1j * ((spot.imag - nearest[1]) or 1.0), piece


def _spots(line: Sequence[complex], middles: Reals | None) -> Iterator[complex]:
    """Yield the points of a line over the middles of the intervals; its own middle if it has none there."""
    x, y = np.real(line), np.imag(line)
    if middles is None:
        inset = INSET * np.ptp(x)
        yield from (z for z in line if x.min() + inset <= z.real <= x.max() - inset)
        return
    over = middles[(middles > x[0]) & (middles < x[-1])]
    for at in over if len(over) else [(x[0] + x[-1]) / 2]:
        yield complex(at, np.interp(at, x, y))


ASIDE = 14.0
"""From the axis of the ordinates to a dimension line, mm."""
BEHIND = 3.0
"""From the end of a level line to its name, mm: nearer a stroke of it reads as a minus."""
ABOVE = 1.0
"""From the highest point of a graph to the dimension line of a pole's distance, mm."""
UNDER = 9.0
"""From the lowest point of a graph to a dimension line below it, mm."""


class Level(NamedTuple):
    """A limit: a level line across a graph, its height in mm, what it is called."""

    height: float
    text: str


class Span(NamedTuple):
    """A stretch of the base that is dimensioned below the graph, from and to where, mm; its figure."""

    start: float
    end: float
    text: str


class Names(NamedTuple):
    """What is lettered on a graph: the positions, the quantity of the ordinates, that along the base.

    ``curves``: the label of a curve by its mark or that of the readings of its points, where there are several.
    ``points``: names of points on the axis of ordinates that differ from those in the log.
    ``lengths``: figures of dimensions, by their marks: measured ordinates along the axis, the distance of a
    pole below the graph. ``levels``: limits; ``spans``: of the base; ``at``: its further named places.
    ``closes``: whether its end is the first position once more.
    """

    positions: Sequence[str]
    up: str
    along: str
    curves: Mapping[Mark, str] = MappingProxyType({})
    points: Mapping[Mark, str] = MappingProxyType({})
    lengths: Mapping[Mark, str] = MappingProxyType({})
    levels: Sequence[Level] = ()
    spans: Sequence[Span] = ()
    at: Sequence[tuple[float, str]] = ()
    closes: bool = True


def draw_graph(
    on: Subject, view: str, row: int, names: Names, rules: Mapping[str, Rule] = MappingProxyType({})
) -> Drawing:
    """Return a graph: ``row`` intervals; the positions behind the row stand where they belong.

    ``rules``: what the operations of a chapter leave, by their names.
    """
    graph, small = Graph(on.construction, on.reading, view, row), on.heights.number
    traces = figure(graph, manner_of(graph, rules))
    strokes = [*traces.staying, *_outlines(graph), *_poles(graph), *_levels(graph, names)]
    made = [
        *_lengths(graph, names, small),
        *_distances(graph, names, small),
        *_spans(graph, names, small),
    ]
    for mark, one in made:
        drawn = one.strokes
        strokes += added(drawn, "dimension") if mark is None else body(drawn, "dimension", [mark])
    numbers = position_numbers(*_positions(graph, names), strokes, small)
    figures = [one.label._replace(of=_slots(mark)) for mark, one in made]
    drawing = traces.drawing(on, strokes, _letters(graph, names, on.heights), (*figures, *numbers))
    begins = (graph.axes.along.slot, graph.axes.up.slot)
    return drawing._replace(begins=begins, role=GRAPH)


def _slots(mark: Mark | None) -> tuple[int, ...]:
    return () if mark is None else (mark.slot,)


def _outlines(graph: Graph) -> Iterator[Ink]:
    """The bodies of the plan: everything but the curves."""
    for one in graph.outlines:
        for start, end in zip(one.marks, one.marks[1:], strict=False):
            ends = graph.point(start, 0), graph.point(end, 0)
            yield from body(segment("main", *ends), OUTLINE, [start, end])


def _poles(graph: Graph) -> Iterator[Ink]:
    for step in graph.steps:
        spot = graph.point(step.it, 0) if step.it.role == roles.POLE else complex("nan")
        if finite(spot):
            yield from body(pole(spot), "pole", [step.it])


def _levels(graph: Graph, names: Names) -> Iterator[Ink]:
    for height, _ in names.levels:
        yield from added([line("dashed", 1j * height, graph.length + 1j * height)], "limit")


Dimensioned = Iterator[tuple[Mark | None, Dimension]]


def _lengths(graph: Graph, names: Names, size: float) -> Dimensioned:
    """What is measured along the axis of the ordinates, left of it."""
    for step in graph.steps:
        if step.it in names.lengths and step.op is measure_along:
            low, high = (graph.point(mark, 0) for mark in step.uses[:2])
            if finite(low, high):
                yield step.it, dimension(low, high, ASIDE, names.lengths[step.it], size)


def _distances(graph: Graph, names: Names, size: float) -> Dimensioned:
    """The distances of the poles, above the rays."""
    for step in graph.steps:
        if step.it.role == roles.POLE and step.uses[1] in names.lengths:
            spot = graph.point(step.it, 0)
            if finite(spot) and spot:
                high, _ = graph.high_and_low
                text = names.lengths[step.uses[1]]
                away = high + ABOVE - spot.imag
                yield step.it, dimension(complex(0, spot.imag), spot, -away, text, size)


def _spans(graph: Graph, names: Names, size: float) -> Dimensioned:
    """Stretches of the base; one whose figure finds no room stands lower."""
    _, low = graph.high_and_low
    low = min([low, *(one.height for one in names.levels)])
    under = UNDER * max(1.0, size / SIZE)
    for start, end, text in names.spans:
        if end - start > TICK:
            level = low - under / 3
            wide = letter(text, size=size).width > end - start - 2.0
            ends = complex(start, level), complex(end, level)
            yield None, dimension(*ends, -(2 if wide else 1) * under, text, size)


def _positions(graph: Graph, names: Names) -> tuple[list[Named], list[Named]]:
    """Return the positions of the row with their feet, and the others with the end of the base."""
    feet, end = graph.axes.feet, graph.axes.end
    named = [
        Named(graph.point(feet, k), text, (feet.slot,), k) for k, text in enumerate(names.positions)
    ]
    row = min(graph.row, len(named))
    last = Named(graph.point(end, 0), _closing(names.positions[0], named[:row], graph), (end.slot,))
    if len(named) > row and named[row].text.isdigit():
        row += 1  # of a row that does not come back the last stands at the end
    whole = row and abs(named[row - 1].at - last.at) < TICK
    return named[:row], named[row:] if whole or not names.closes else [last, *named[row:]]


def _closing(first: str, named: Sequence[Named], graph: Graph) -> str:
    """Return what the end of the base is called: 0 (8) of an even row, else as the first position."""
    if len(named) < 2 or not first.isdigit():
        return first
    step = named[1].at - named[0].at
    even = abs(named[-1].at + step - graph.point(graph.axes.end, 0)) < TICK
    return f"{first} ({int(first) + len(named)})" if even else first


def _letters(graph: Graph, names: Names, heights: Heights) -> Iterator[Wanted]:
    """The names of the axes, of poles, limits and curves, and of points that are one of a kind."""
    point, small = heights.point, heights.number
    high, _ = graph.high_and_low
    aside = any(True for _ in _distances(graph, names, heights.number))
    tip = complex(0, high + OVER - point / 2)
    yield Wanted(names.up, tip, point, 1.5, 1 + 0j if aside else -1 + 0j)
    yield Wanted(names.along, complex(graph.length + OVER, 0), point, 1.5, -1j)
    for height, text in names.levels:
        yield Wanted(text, complex(graph.length, height), small, BEHIND, 1 + 0j)
    for place, text in names.at:
        yield Wanted(text, complex(place, 0), small, TICK, -1j)
    yield from curve_names(graph, names.curves, small)
    for step in graph.steps:
        for one in _point_name(graph, names, step, heights):
            if finite(one.at):
                yield one._replace(of=(step.it.slot,))


def _point_name(graph: Graph, names: Names, step: Step, heights: Heights) -> Iterator[Wanted]:
    """The letter of a pole, of a point where a curve turns, of what is carried to the axis; of a mean."""
    if step.it.kind is not Point:
        return
    spot = graph.point(step.it, 0)
    if step.it.role == roles.POLE:
        yield Wanted(step.it.name, spot, heights.number, 1.0, -1 + 0j)
    elif step.op in EXTREMES:
        way = 1j if step.op is g.highest else -1j
        yield Wanted(step.it.name, spot, heights.number, 1.0, way)
    elif step.it.role == roles.EXTREME:
        yield Wanted(step.it.name, spot, heights.point, 1.0, -1 + 0j)
    elif step.it.role == roles.MEAN:
        text = names.points.get(step.it, step.it.name)
        yield Wanted(text, spot + graph.length, heights.number, BEHIND, 1 + 0j)
