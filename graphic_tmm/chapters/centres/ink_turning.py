"""The scheme of centres as it moves with the crank, in a window about the mechanism: arrows lead out of it.

Its lines end by the least and the greatest of distances, not by cases: what a page ties to marks it tries in
every case, and each line has many centres.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any, NamedTuple

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import join, parallel, square
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.centres.ink import BEYOND, RADIUS
from graphic_tmm.chapters.centres.network import Centre
from graphic_tmm.chapters.centres.record import Centres
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.kinematics.figures import rigid
from graphic_tmm.chapters.kinematics.ink_positions import PAIR, PositionsInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.paper.arithmetic import below, by_case, larger, signed, smaller
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.labels import Named, lettered
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject, finite
from graphic_tmm.paper.symbols.kinematic import arrowhead

AROUND = 0.3
"""The window goes beyond the mechanism by this share of its size."""
ONE_LINE, CROSSED = 1e-6, 2
"""The sine of two lines that are one; so many lead to a centre."""
UPRIGHT = 1e-9
"""A line leaves the window where its direction is off an axis by no less."""


class Window(NamedTuple):
    """What is seen of the scheme: its middle, half its width and its height, mm."""

    middle: complex
    wide: float
    high: float

    def part(self, at: complex, way: complex) -> tuple[float, float]:
        """Return between which distances along a line it lies inside; the first is greater where not."""
        ends, off = [], self.middle - at
        for mid, half, along in ((off.real, self.wide, way.real), (off.imag, self.high, way.imag)):
            by = signed(larger(abs(along), UPRIGHT), along)
            ends.append(((mid - half) / by, (mid + half) / by))
        return larger(*(smaller(*one) for one in ends)), smaller(*(larger(*one) for one in ends))

    def beyond(self, spot: complex) -> float:
        """Return how far a place lies outside, mm; below 0 where it is inside."""
        off = spot - self.middle
        return larger(abs(off.real) - self.wide, abs(off.imag) - self.high)


class CentreLine(NamedTuple):
    """A line of the scheme, the points that it is drawn by, all that lie on it; its centre at infinity."""

    it: Mark
    by: tuple[Mark, ...]
    points: tuple[Mark, ...]
    far: Centre | None


class Ends(NamedTuple):
    """How a line is drawn: its ends; where it begins, its direction, where it enters and leaves the window."""

    drawn: tuple[complex, complex]
    at: complex
    way: complex
    low: float
    high: float
    along: Mapping[Mark, float]


class Lead(NamedTuple):
    """The head of an arrow: its tip and direction, the mark that it is of, what it leads to."""

    tip: complex
    way: complex
    mark: Mark
    text: str


class TurningScheme:
    """The scheme of centres at any angle; ``mu_l``: the scale of the plan of positions."""

    def __init__(
        self, on: Subject, made: Centres, reaches: Mapping[Figure, Reach], mu_l: Mark
    ) -> None:
        self.made, self.on, self.seen = made, on, on.seen((CENTRES,), [0])
        times = self.seen.fixed_number(mu_l) / self.seen.fixed_number(made.mu)
        figures = [one for one in on.construction.figures if one.view == POSITIONS]
        values: dict[int, Any] = {}
        for mark in dict.fromkeys(mark for one in figures for mark in one.marks):
            value = values[mark.slot] = on.reading[mark]
            if mark.kind is Line:
                values[mark.slot] = value._replace(at=value.at * times)
            elif mark.kind is Point:
                values[mark.slot] = value * times
        whole = {one: reach.times(times) for one, reach in reaches.items()}
        reading = Reading(values, on.reading.positions)
        self.links = PositionsInk(on.construction, reading, whole, [0])
        self.points = {of.slot: mark.slot for of, mark in made.points.items()}

    def at(self, k: int) -> Drawing:
        """Return the scheme at an angle (index), its letters still wanted."""
        links = list(self._mechanism(k))  # before anything is compared
        spots = {mark: self.seen.point(mark, k) for mark in self.marks}
        window = self.window(spots)
        sure = self._sure(spots, window, k)
        inside = {mark: window.beyond(spots[mark]) < 0.0 for mark in self._own if mark in sure}
        strokes, wanted = list[Ink](), self._letters(k, inside)
        for mark in (mark for mark, holds in inside.items() if holds):
            strokes.append(circle("joint", spots[mark], RADIUS)._replace(of=(mark.slot,)))
        lettered_ = set[Mark]()
        for one in self.lines:
            points = {mark: spots[mark] for mark in one.points if mark in sure}
            if not sure.issuperset(one.by) or not (ends := self._ends(one, points, window, k)):
                continue
            strokes.append(line("thin", *ends.drawn)._replace(of=(one.it.slot,)))
            for lead in self._leads(one, ends, inside):
                of = lead.mark.slot, one.it.slot
                head = arrowhead(lead.tip, lead.way, pen="thin")
                strokes += (stroke._replace(of=of) for stroke in head)
                if lead.mark not in lettered_:
                    size = self.on.heights.number
                    wanted.append(Wanted(lead.text, lead.tip, size, 1.0, -lead.way, of[:1]))
                lettered_.add(lead.mark)
        return Drawing(CENTRES, "", (*strokes, *links), wanted=tuple(wanted))

    @cached_property
    def marks(self) -> tuple[Mark, ...]:
        """The points of the mechanism, and all centres that are none."""
        return tuple(dict.fromkeys((*self.made.points.values(), *self.names)))

    @cached_property
    def _own(self) -> list[Mark]:
        """The centres that are no points of the mechanism, none at infinity, each place once."""
        there = self.made.points.values()
        marks = dict.fromkeys(one.mark for one in self.made.centres if not one.far)
        return [mark for mark in marks if mark not in there]

    def window(self, spots: Mapping[Mark, complex]) -> Window:
        """Return what is seen at an angle: the mechanism, and what is near to it."""
        links = [spots[mark] for mark in self.made.points.values()]
        sides = list[tuple[float, float]]()
        for own in ([spot.real for spot in links], [spot.imag for spot in links]):
            low, high = smaller(*own), larger(*own)
            sides.append(((low + high) / 2.0, (high - low) / 2.0))
        (x, wide), (y, high) = sides
        more = 2.0 * AROUND * larger(wide, high)
        return Window(x + 1j * y, wide + more, high + more)

    @cached_property
    def lines(self) -> list[CentreLine]:
        """The lines, and what lies on each."""
        found = []
        for step in self.seen.steps:
            if step.op in (join, parallel, square) and step.uses[0].view == CENTRES:
                own = [one for one in self.made.centres if step.it in (*one.lines, one.mark)]
                own += [one for one in self.made.centres if one.mark in step.uses]
                by = tuple(mark for mark in step.uses if mark in self.marks)
                points = [*by, *(one.mark for one in own if not one.far)]
                far = next((one for one in own if one.far and one.mark == step.it), None)
                found.append(CentreLine(step.it, by, tuple(dict.fromkeys(points)), far))
        return found

    def _sure(self, spots: Mapping[Mark, complex], window: Window, k: int) -> set[Mark]:
        """Return the points that are there; none where two lines are one, nor what hangs on it.

        ``good``: the least sine of two lines that lead to a centre, or to one that it hangs on; outside the
        window lines may be parallel.
        """
        good = dict.fromkeys(self.made.points.values(), 1.0)
        by = {one.it: one.by for one in self.lines}
        for one in self.made.centres:
            if one.mark not in self.names or one.mark in good:
                continue
            own = [good[mark] for line_ in one.lines for mark in by.get(line_, ()) if mark in good]
            if len(one.lines) == CROSSED and finite(spots[one.mark]):
                first, second = (self.seen.line(line_, k)[1] for line_ in one.lines)
                beyond = below(0.0, window.beyond(spots[one.mark]))
                own.append(larger(abs((second / first).imag), beyond))
            good[one.mark] = smaller(1.0, *own)
        return {
            mark for mark, sine in good.items() if finite(spots[mark], sine) and sine > ONE_LINE
        }

    def _ends(
        self, one: CentreLine, points: Mapping[Mark, complex], window: Window, k: int
    ) -> Ends | None:
        """Return how far a line is drawn: as far as its centres are, inside the window."""
        at, way = self.seen.line(one.it, k)
        along = {mark: ((spot - at) / way).real for mark, spot in points.items()}
        if not finite(at, way, *along.values()):
            return None
        low, high = window.part(at, way)
        first = larger(low, smaller(*along.values()) - BEYOND)
        last = high if one.far else smaller(high, larger(*along.values()) + BEYOND)
        if not first < last:
            return None
        return Ends((at + first * way, at + last * way), at, way, low, high, along)

    def _leads(self, one: CentreLine, ends: Ends, inside: Mapping[Mark, bool]) -> Iterator[Lead]:
        """Yield the heads of arrows to centres on a line that are outside the window."""
        for mark in (mark for mark in one.points if inside.get(mark) is False):
            behind = below(ends.along[mark], 0.5 * (ends.low + ends.high))
            tip = by_case(behind, ends.low, ends.high)
            way = by_case(behind, -1.0, 1.0) * ends.way
            yield Lead(ends.at + tip * ends.way, way, mark, f"→ {self.names[mark]}")
        if one.far:
            text = f"→ {one.far.name}∞"
            yield Lead(ends.at + ends.high * ends.way, ends.way, one.points[0], text)

    @cached_property
    def names(self) -> dict[Mark, str]:
        """What the centres in one place are called."""
        found = dict[Mark, str]()
        for one in (one for one in self.made.centres if not one.far):
            found[one.mark] = f"{found[one.mark]}, {one.name}" if one.mark in found else one.name
        return found

    def _letters(self, k: int, inside: Mapping[Mark, bool]) -> list[Wanted]:
        """The letters of points and of centres inside the window, the numbers of links."""
        told = {mark: markup(of.name) for of, mark in self.made.points.items()}
        named = list[Named]()
        for mark in self.marks:
            if mark not in self._own or inside.get(mark):
                text = ", ".join(one[mark] for one in (told, self.names) if mark in one)
                named.append(Named(self.seen.point(mark, k), text, (mark.slot,), k))
        return [*lettered(named, self.on.heights.number, PAIR), *self._numbers(k)]

    def _numbers(self, k: int) -> Iterator[Wanted]:
        """Yield the numbers of the moving links, each at a line of its link."""
        for name in self.links.names:
            marks = rigid(self.links.figures, name)[:2]
            spot = sum(self.links.at(mark, k) for mark in marks) / len(marks)
            slots = tuple(self.points[mark.slot] for mark in marks)
            yield Wanted(name, spot, self.on.heights.number, PAIR, 0j, slots, k)

    def _mechanism(self, k: int) -> Iterator[Ink]:
        """The links, which stand on the points of the scheme."""
        every = tuple(self.points.values())
        for stroke in (*self.links.guides(), *self.links.heavy(k)):
            own = tuple(self.points[slot] for slot in stroke.of if slot in self.points)
            yield stroke._replace(of=own or every, position=k)
