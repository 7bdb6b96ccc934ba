"""What the steps of a graph leave on paper, where it is not what the steps of a plan leave.

A line on a graph ends where it was met: a ray from the pole at the axis of the ordinates, a level where it was
carried to. The axes and the divisions of the base are their own lines and ticks. Points through which a curve
goes, and those in which it turns, are dots that stay; a curve is drawn over the base only.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.instruments import join, lay_off, meet
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Curve, Kind, Line, Point
from graphic_tmm.paper.clipping import cut
from graphic_tmm.paper.drawing import Bezier, Ink, circle, line
from graphic_tmm.paper.figure import Manner
from graphic_tmm.paper.rules import LEAST, pricked, rule_of, segment
from graphic_tmm.paper.seen import Rule, Seen, finite
from graphic_tmm.paper.shapes import flat
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 6.0
"""How far an axis goes on behind what stands on it, mm."""
TICK = 1.0
"""Half a tick on the base, mm."""
DOT = 0.5
"""Radius of a point through which a curve is drawn, mm."""
EXTREMES = (g.highest, g.lowest)
"""Operations that find where a curve turns."""
OUTLINE = "outline"
"""Kind of figures of a log that are drawn straight from mark to mark, in addition to the curves of a graph."""


class AxesMarks(NamedTuple):
    """The axes of a view as the log records them, in the order of the plan."""

    origin: Mark
    along: Mark
    up: Mark
    feet: Mark
    end: Mark
    middles: Mark
    mu: Mark
    mu_along: Mark
    length: Mark


def axes_of(construction: Construction, view: str) -> AxesMarks:
    """Return the axes of a view."""
    figure = next(f for f in construction.figures if f.view == view and f.kind == "axes")
    return AxesMarks(*figure.marks)


class Graph(Seen):
    """A graph of a log and its numbers: its axes, the length of its base, mm; its origin is 0.

    ``row``: how many intervals; the positions behind the row stand where they belong.
    """

    def __init__(
        self, construction: Construction, reading: Reading, view: str, row: int | None = None
    ) -> None:
        super().__init__(construction, reading, (view,), range(reading.positions))
        self.view, self.row = view, reading.positions if row is None else row
        self.axes = axes_of(construction, view)
        self.length = self.number(self.axes.length, 0)

    @cached_property
    def curved(self) -> Mapping[Mark, tuple[range, ...]]:
        """The points through which curves go, and at which positions."""
        found: dict[Mark, tuple[range, ...]] = {}
        for step in self.steps:
            if step.it.kind is Curve:
                own = range(self.row)
                if step.op is graph_of_stretch:
                    own = range(step.choice["first"], step.choice["last"] + 1)
                found[step.uses[0]] = (*found.get(step.uses[0], ()), own)
        return found

    @cached_property
    def stretched(self) -> frozenset[Mark]:
        """The points that are there only where a stretch of a curve goes through them."""
        return frozenset(s.uses[0] for s in self.steps if s.op is graph_of_stretch)

    @cached_property
    def outlines(self) -> tuple[Figure, ...]:
        """Ink that is no curve: dwells, jumps, given straight lines."""
        figures = self.construction.figures
        return tuple(f for f in figures if f.view == self.view and f.kind == OUTLINE)

    @cached_property
    def high_and_low(self) -> tuple[float, float]:
        """How high and how low stands what stands over the base, mm, the base itself included."""
        heights = [0.0]
        for step in self.steps:
            for piece in curve_over_base(self, step):
                heights += [z.imag for z in flat(piece.controls)]
            if step.it in self.curved or step.op in EXTREMES:
                heights += [self.visible_place(step.it, k).imag for k in self.positions]
        for figure in self.outlines:
            heights += [self.point(mark, 0).imag for mark in figure.marks]
        there = [y for y in heights if finite(y)]
        return max(there), min(there)

    def visible_place(self, mark: Mark, k: int) -> complex:
        """Return where a point is, mm; NaN where no stretch of a curve goes through it."""
        if mark in self.stretched and not self.goes_through(mark, k):
            return complex("nan")
        return self.point(mark, k)

    def goes_through(self, mark: Mark, k: int) -> bool:
        """Whether a curve goes through a point in a position."""
        return any(k in own for own in self.curved.get(mark, ()))


def curve_over_base(graph: Graph, step: Step) -> Iterator[Bezier]:
    """Yield the curve of a step, over the base only; x runs evenly along each of its arcs."""
    if step.it.kind is not Curve:
        return
    for controls in bezier(graph.reading[step.it]):
        x = [z.real for z in controls[::3]]
        start, end = (_at_x(x, to) for to in (0.0, graph.length))
        if end - start > 1e-9:
            pen = "thin" if step.it.role == roles.PART else "main"
            yield Bezier(pen, cut([complex(z) for z in controls], start, end), step.it.name)


def _at_x(x: list[float], to: float) -> float:
    """Return where on a chain of arcs the abscissa ``to`` stands, or the end of it that is nearer."""
    if to <= x[0]:
        return 0.0
    for k in range(len(x) - 1):
        if to <= x[k + 1]:
            return k + (to - x[k]) / (x[k + 1] - x[k])
    return float(len(x) - 1)


def ends_of(seen: Seen, step: Step, k: int) -> tuple[complex, complex]:
    """Return the ends of a line: where it begins, or was met behind its beginning, and where it was met.

    A line common to all positions reaches to every point marked on it in any of them; a level that is itself
    a graph spans the whole base, as its curve does.
    """
    at, along = seen.line(step.it, k)
    if step.it.role == roles.STRAIGHT and isinstance(seen, Graph) and step.op is not join:
        return complex(0.0, at.imag), complex(seen.length, at.imag)
    spots = [seen.point(step.uses[1], k)] if step.op is join else []
    shown = seen.visible_place if isinstance(seen, Graph) else seen.point
    there = (k,) if seen.varies(step) else seen.positions
    for use in seen.uses.get(step.it, ()):
        if use.it.kind is Point:
            spots += [shown(use.it, j) for j in there]
    reach = [((z - at) * along.conjugate()).real for z in spots if finite(z)]
    return at + min([0.0, *reach]) * along, at + max([0.0, *reach]) * along


def ruled(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A line, from where it begins to where it was met, and no farther."""
    if step.op is g.touching:
        yield from (rule_of(step) or pricked)(seen, step, k)
        return
    pen = "main" if step.it.role == roles.STRAIGHT else "thin"
    yield from _drawn(pen, *ends_of(seen, step, k), seen.line(step.it, k)[1])


def _drawn(pen: str, start: complex, end: complex, along: complex) -> Iterator[Ink]:
    """A line; one that was met where it begins is no longer than a tick."""
    if finite(start, end) and abs(end - start) <= LEAST:
        yield line("thin", start - TICK * along, start + TICK * along)
    else:
        yield from segment(pen, start, end)


def erected(graph: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The perpendicular from the base to a curve."""
    yield from _drawn("thin", graph.point(step.uses[1], k), graph.point(step.it, k), 1j)


def ordinate(graph: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A length laid off: an ordinate from the base, the distance of a pole from the axis."""
    assert isinstance(graph, Graph)
    if laid_along_base(graph, step):
        yield from pricked(graph, step, k)
    else:
        at, along = graph.line(step.uses[0], k)
        yield from _drawn("thin", at, graph.visible_place(step.it, k), along)


def laid_along_base(graph: Graph, step: Step) -> bool:
    """Whether a point was only marked on the base or on a level of it: it is pricked."""
    _, along = graph.line(step.uses[0], 0)
    return not step.it.role and abs(along.imag) < 1e-9


def succeeded(graph: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A segment of an integral, from its beginning to that of the next."""
    last = next(s.it for s in graph.steps if s.op is g.arrival and s.uses[1] == step.uses[1])
    if k < step.choice["row"]:
        after = graph.point(step.it, k + 1) if k + 1 < step.choice["row"] else graph.point(last, k)
        yield from segment("thin", graph.point(step.it, k), after)


def bent(graph: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The curve of a step, over the base."""
    assert isinstance(graph, Graph)
    yield from curve_over_base(graph, step)


def turning(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A point in which a curve turns."""
    yield from dot(seen.point(step.it, k))


def dot(spot: complex) -> Iterator[Ink]:
    """A point of a curve."""
    if finite(spot):
        yield circle("main", spot, DOT, filled=True)


def axis(start: complex, end: complex) -> Iterator[Ink]:
    """An axis with its arrow at ``end``."""
    yield line("thin", start, end)
    yield from arrowhead(end, end - start, pen="thin")


def manner_of(graph: Graph, rules: Mapping[str, Rule]) -> Manner:
    """Return how a graph is inked; ``rules``: of the operations of a chapter, by their names."""
    own: dict[str, Rule] = {
        lay_off.name: ordinate,
        g.erect.name: erected,
        g.succession.name: succeeded,
        **{op.name: turning for op in EXTREMES},
        **rules,
    }
    by_kind: dict[Kind, Rule] = {Line: ruled, Curve: bent}
    high, low = graph.high_and_low
    axes = {
        graph.axes.along: (0j, complex(graph.length + OVER, 0)),
        graph.axes.up: (1j * low, 1j * (high + OVER)),
    }

    def inked(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        if step.it in axes:
            yield from axis(*axes[step.it])
        elif step.it in (graph.axes.feet, graph.axes.end):
            foot = seen.point(step.it, k)
            yield from segment("thin", foot - 1j * TICK, foot + 1j * TICK)
        else:
            yield from drawn(seen, step, k)

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        rule = own.get(step.op.name) or by_kind.get(step.it.kind) or rule_of(step)
        dotted = step.it in graph.curved
        if rule is not None and not (dotted and rule is pricked):
            yield from rule(seen, step, k)
        if dotted and graph.goes_through(step.it, k):
            yield from dot(seen.point(step.it, k))

    traced = [s.op.name for s in graph.steps if rule_of(s) is not None or s.op.name in own]
    return Manner(
        dict.fromkeys(traced, inked), lambda _, step: step.op.name in rules or stays(graph, step)
    )


def stays(graph: Graph, step: Step) -> bool:
    """Whether what a step of a graph leaves is there at the end: what only carried a height over is not."""
    if step.it.kind is Line:
        begun = graph.by_mark.get(step.uses[0])
        if begun is not None and begun.op is g.at_zero:
            return False  # the height of the first point, taken over with the dividers
        met = any(use.op is meet for use in graph.uses.get(step.it, ()))
        lasting = (graph.axes.along, graph.axes.up)
        graph_of_its_own = step.it.role == roles.STRAIGHT
        return met or graph_of_its_own or step.it in lasting or step.op in (join, g.touching)
    if step.it.role == roles.LEVEL_POLE:
        return False  # from there the rays of another diagram are drawn
    if step.op is lay_off:
        return step.it in (graph.axes.feet, graph.axes.end) or not laid_along_base(graph, step)
    lasting_points = (g.erect, g.level_off, g.succession, *EXTREMES)
    return step.it.kind is Curve or step.it in graph.curved or step.op in lasting_points
