"""A polygon of forces in ink: sides with arrows, vertices numbered as drawn, reactions across it."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import lay_off, measure, meet
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.forces.detached import Polygon, Reaction, Side
from graphic_tmm.chapters.forces.driving import RodForce
from graphic_tmm.chapters.forces.ink_arrows import LEAST, pricks
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.rules import BEYOND, drawn_line
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.traced import value_at

__all__ = ["LEAST", "bar", "draw_polygon", "spot", "whole"]

THIRD = 1 / 3
"""How far along a rod's force its letter stands: in the middle stand those of the reactions near it."""


def bar(letter: str) -> str:
    r"""Return a force's letter as a vector: R_{12}^{n} -> \bar{R}_{12}^{n}."""
    sign = "−" if letter.startswith("−") else ""
    rest = letter.removeprefix("−")
    return f"{sign}\\bar{{{rest[0]}}}{rest[1:]}"


def spot(reading: Reading, mark: Mark, index: int) -> complex:
    """Return where a mark is in one position."""
    return value_at(reading[mark], index)


def whole(reading: Reading, polygon: Polygon, reactions: Sequence[Reaction], index: int) -> bool:
    """Whether all vertices of a polygon are there in one position."""
    sides = *polygon.sides, *polygon.inside
    ends = [mark for _, tail, head in sides for mark in (tail, head)]
    ends += [mark for one in reactions for mark in (one.tail, one.head)]
    return all(cmath.isfinite(spot(reading, mark, index)) for mark in ends)


class _Sides:
    """The sides of a polygon by the steps that drew them, and its reactions by those that measured them."""

    def __init__(
        self,
        seen: Seen,
        polygon: Polygon,
        reactions: Sequence[Reaction],
        rods: Sequence[RodForce],
        mu: float,
    ) -> None:
        self.seen, self.rods, self.mu = seen, rods, mu
        known = [{seen.by_mark[step.uses[0]].uses[0], head} for head, step in self.own.items()]
        # what holds a leg that slides along a plate is a side too: it lies across what was laid off there
        laid = [s for s in polygon.sides if s[2] not in self.own or {*s[1:]} in known]
        ends = {(tail, head) for _, tail, head in (*laid, *polygon.inside)}
        self.across = {r.length: r for r in reactions if (r.tail, r.head) not in ends}
        # of two plates one side is laid off from its head
        self.laid = {side[:0:-1]: side for side in polygon.inside}
        self.laid |= {side[1:]: side for side in (*polygon.sides, *polygon.inside)}
        self.inside = set(polygon.inside)
        self.found = [side for side in polygon.sides if side[2] not in self.own]
        self.closes = not any(step.op is meet for step in seen.steps)
        closing = [one for one in reactions if one.head not in self.own]
        late = closing if self.closes else self.across.values()
        self.lengths = {(r.tail, r.head): r.length for r in late}
        self.split = [side for rod in rods if rod.rest for side in (rod.side, rod.rest)]
        self.split += [one for one in polygon.inside if {*one[1:]} not in known]

    @property
    def own(self) -> Mapping[Mark, Step]:
        """The steps that laid a side off, by its head."""
        return {step.it: step for step in self.seen.steps if step.op is lay_off}

    def side(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A known side, laid off; its arrow."""
        start = seen.by_mark[step.uses[0]].uses[0]
        side = self.laid.get((start, step.it))
        if side is not None:
            yield from self.arrow(*side, k, "thin" if side in self.inside else "main")

    def measured(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A reaction across the polygon; another one is a side, or was measured of one."""
        reaction = self.across.get(step.it)
        if reaction is not None:
            ends = reaction.tail, reaction.head
            pen = "main" if ends in self.laid else "medium"
            yield from self.arrow(reaction.letter, *ends, k, pen)

    def met(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The sides of unknown size, once their lines have met; these go on a little behind the vertex."""
        lines = {seen.by_mark[use].uses[0]: use for use in step.uses}
        sides, pen = self.found, "main"
        if not any(step.it in side for side in sides):
            sides, pen = [side for side in self.split if step.it in side], "thin"
        for letter, tail, head in sides:
            begun = tail if head == step.it else head
            of = (lines.get(begun, step.it).slot, step.it.slot)
            for stroke in self.arrow(letter, tail, head, k, pen):
                yield stroke._replace(of=of)
            start, top = seen.point(begun, k), seen.point(step.it, k)
            if finite(start, top) and abs(top - start) >= LEAST:
                way = (top - start) / abs(top - start)
                yield line("thin", top, top + BEYOND * way)._replace(of=of)

    def closing(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The side that closes a polygon without unknown lines: the frame's reaction, as measured."""
        if step.it in self.across:
            yield from self.measured(seen, step, k)
            return
        if step.it not in self.lengths.values():
            return  # of a belt the pull is a side that is laid off, and measured, before
        for letter, tail, head in self.found:
            yield from self.arrow(letter, tail, head, k, "main")

    def lettered(self, polygon: Polygon) -> Iterator[tuple[Side, float, tuple[int, ...]]]:
        """Yield what bears a letter, how far along it, and the marks with which that is there.

        These are its ends and its length, if it is there when measured.
        """
        across = [(r.letter, r.tail, r.head) for r in self.across.values()]
        rests = (rod.rest for rod in self.rods if rod.rest is not None)
        for side in dict.fromkeys((*polygon.sides, *polygon.inside, *across, *rests)):
            length = self.lengths.get(side[1:])
            yield side, 0.5, tuple(mark.slot for mark in (*side[1:], length) if mark is not None)
        for rod in self.rods:
            # on a side that is there already its letter comes with the step that reads it
            marks = (rod.tail, rod.head, *(() if rod.rest else (rod.length,)))
            yield rod.side, THIRD, tuple(mark.slot for mark in marks)

    def arrow(self, letter: str, tail: Mark, head: Mark, k: int, pen: str) -> Iterator[Ink]:
        """The arrow of a side, unless it is a point."""
        a, b = self.seen.point(tail, k), self.seen.point(head, k)
        if finite(a, b) and abs(b - a) >= LEAST:
            yield from told_arrow(a, b, pen, letter, self.mu, "N")


def _stays(seen: Seen, step: Step) -> bool:
    """Whether what a step leaves is there at the end: the lines are covered by the sides found on them."""
    return step.op in (lay_off, measure, meet)


def draw_polygon(
    on: Subject,
    polygon: Polygon,
    reactions: Sequence[Reaction],
    index: int,
    mu: float,
    rods: Sequence[RodForce] = (),
    helping: bool = True,
) -> Drawing:
    """Return a polygon of forces in one position; the last sides were unknown.

    ``reactions``: of the group; those that are no side of the polygon are drawn across it. ``mu``: of the
    forces, N/mm. ``rods``: what drives them. Not ``helping``: without what is rubbed out.
    """
    seen, high = on.seen((polygon.view,), [index]), on.heights
    sides = _Sides(seen, polygon, reactions, rods, mu)
    rules = {
        lay_off.name: sides.side,
        measure.name: sides.closing if sides.closes else sides.measured,
        meet.name: sides.met,
    }
    lines = {step.op.name: drawn_line for step in seen.steps if step.it.kind is Line}
    traces = figure(seen, Manner({**lines, **rules}, _stays), helping=helping)
    if helping:
        traces.rubbed += pricks(seen, (*traces.staying, *traces.rubbed), index)
    corners = [seen.point(tail, index) for _, tail, _ in polygon.sides]
    middle = complex(np.mean(corners))
    wanted = [
        _label(symbol(letter, on.language), tail, head, seen, middle, high, far)._replace(of=of)
        for (letter, tail, head), far, of in sides.lettered(polygon)
        if abs(seen.point(head, index) - seen.point(tail, index)) >= LEAST
    ]
    vertices = (mark for _, *ends in (*polygon.sides, *sides.split) for mark in ends)
    numbers = [
        Named(seen.point(mark, index), mark.name, (mark.slot,), index)
        for mark in dict.fromkeys(vertices)
    ]
    wanted += lettered(shared(numbers, LEAST), high.number, away_from=middle)
    return traces.drawing(on, traces.staying, wanted)._replace(position=index)


def _label(
    letter: str, tail: Mark, head: Mark, seen: Seen, middle: complex, high: Heights, far: float
) -> Wanted:
    (index,) = seen.positions
    a, b = seen.point(tail, index), seen.point(head, index)
    at, out = a + far * (b - a), 1j * (b - a) / abs(b - a)
    if ((at - middle) * out.conjugate()).real < 0:
        out = -out
    return Wanted(bar(letter), at, high.point, 1.0, out, position=index)
