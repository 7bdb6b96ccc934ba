"""The scheme of centres as it moves with the crank: in one window, so that what flies off leaves arrows there.

Its lines end by the least and the greatest of distances, not by cases: what a page ties to marks it tries in
every case, and each line has many centres.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import join, parallel, square
from graphic_tmm.board.record import Figure, Mark, Step
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.centres.ink import BEYOND, RADIUS
from graphic_tmm.chapters.centres.network import Centre
from graphic_tmm.chapters.centres.plan import Centres
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.kinematics.ink_positions import PAIR, PositionsInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.paper.arithmetic import below, by_case, extremes, larger, signed, smaller
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.labels import Named, lettered
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject, finite
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.paper.traced import alone_of

AROUND = 0.3
"""The window goes beyond the mechanism, over its turn, by this share of its size."""
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


class TurningScheme:
    """The scheme of centres at any angle; ``mu_l``: the scale of the plan of positions."""

    def __init__(
        self, on: Subject, made: Centres, reaches: Mapping[Figure, Reach], mu_l: Mark
    ) -> None:
        self.made, self.on, self.seen = made, on, on.seen((CENTRES,), [0])
        times = self.times = self.seen.fixed_number(mu_l) / self.seen.fixed_number(made.mu)
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
        strokes, wanted = list(self._lines(k)), list(self._letters(k))
        for mark in self._own:
            if self._inside(mark, k):
                strokes.append(_circle(self.seen.point(mark, k), mark))
        for tip, way, of, text in self._leads(k):
            slots = tuple(mark.slot for mark in of)
            strokes += (one._replace(of=slots) for one in arrowhead(tip, way, pen="thin"))
            if text:
                wanted.append(Wanted(text, tip, self.on.heights.number, 1.0, 0j, slots))
        return Drawing(CENTRES, "", (*strokes, *self._mechanism(k)), wanted=tuple(wanted))

    @cached_property
    def _own(self) -> list[Mark]:
        """The centres that are no points of the mechanism, none at infinity, each place once."""
        there = self.made.points.values()
        marks = dict.fromkeys(one.mark for one in self.made.centres if not one.far)
        return [mark for mark in marks if mark not in there]

    @cached_property
    def window(self) -> Window:
        """What is seen: it hangs on the plan of positions, which a page has at all angles at once."""
        rows = [self.on.reading[of] * self.times for of in self.made.points]
        sides = list[tuple[float, float]]()
        for turned in (1.0, -1j):
            ends = [_extremes(row * turned) for row in rows]
            low, high = smaller(*(one for one, _ in ends)), larger(*(one for _, one in ends))
            sides.append(((low + high) / 2.0, (high - low) / 2.0))
        (x, wide), (y, high) = sides
        more = 2.0 * AROUND * larger(wide, high)
        return Window(x + 1j * y, wide + more, high + more)

    @cached_property
    def lines(self) -> list[tuple[Step, list[Mark], list[Centre]]]:
        """The lines, what lies on each: points, and centres at infinity."""
        found = []
        for step in self.seen.steps:
            if step.op in (join, parallel, square) and step.uses[0].view == CENTRES:
                own = [one for one in self.made.centres if step.it in (*one.lines, one.mark)]
                own += [one for one in self.made.centres if one.mark in step.uses]
                points = [mark for mark in step.uses if mark.kind is Point and mark.view == CENTRES]
                points += [one.mark for one in own if not one.far]
                far = [one for one in own if one.far]
                found.append((step, [*dict.fromkeys(points)], [*dict.fromkeys(far)]))
        return found

    def _lines(self, k: int) -> Iterator[Ink]:
        """Yield the lines through centres, as far as these are, inside the window."""
        for step, points, far in self.lines:
            at, way = self.seen.line(step.it, k)
            low, high = self.window.part(at, way)
            along = [((self.seen.point(one, k) - at) / way).real for one in points]
            low = larger(low, smaller(*along) - BEYOND)
            if all(one.mark != step.it for one in far):
                high = smaller(high, larger(*along) + BEYOND)
            if finite(at, way, *along) and low < high:
                yield line("thin", at + low * way, at + high * way)._replace(of=(step.it.slot,))

    def _inside(self, mark: Mark, k: int) -> bool:
        spot = self.seen.point(mark, k)
        return finite(spot) and self.window.beyond(spot) < 0.0

    def _leads(self, k: int) -> Iterator[tuple[complex, complex, tuple[Mark, ...], str]]:
        """Yield the heads of arrows to centres outside: tip, direction, marks; once each a letter."""
        said = set[Mark]()
        for step, points, far in self.lines:
            at, way = self.seen.line(step.it, k)
            if not finite(at, way):
                continue
            low, high = self.window.part(at, way)
            for mark in (one for one in points if one in self._own):
                spot = self.seen.point(mark, k)
                if not finite(spot) or self.window.beyond(spot) < 0.0 or not low < high:
                    continue
                behind = below(((spot - at) / way).real, 0.5 * (low + high))
                tip, on = by_case(behind, low, high), by_case(behind, -1.0, 1.0)
                text = "" if mark in said else f"→ {self.names[mark]}"
                said.add(mark)
                yield at + tip * way, on * way, (step.it, mark), text
            for one in far:
                if one.mark == step.it and low < high:
                    yield at + high * way, way, (step.it,), f"→ {one.name}∞"

    @cached_property
    def names(self) -> dict[Mark, str]:
        """What the centres in one place are called."""
        found = dict[Mark, str]()
        for one in (one for one in self.made.centres if not one.far):
            found[one.mark] = f"{found[one.mark]}, {one.name}" if one.mark in found else one.name
        return found

    @cached_property
    def _labels(self) -> list[tuple[tuple[Mark, ...], str]]:
        """The letters, each with the points that it stands at."""
        found = list[tuple[tuple[Mark, ...], str]]()
        told = {mark: markup(of.name) for of, mark in self.made.points.items()}
        for mark in dict.fromkeys((*told, *self.names)):
            texts = [one[mark] for one in (told, self.names) if mark in one]
            found.append(((mark,), ", ".join(texts)))
        return found

    def _letters(self, k: int) -> list[Wanted]:
        """The letters of points and of the centres that are inside."""
        named = list[Named]()
        for marks, text in self._labels:
            if marks[0] not in self._own or self._inside(marks[0], k):
                spot = self.seen.point(marks[0], k)
                named.append(Named(spot, text, tuple(one.slot for one in marks), k))
        return lettered(named, self.on.heights.point, PAIR)

    def _mechanism(self, k: int) -> Iterator[Ink]:
        """The links, which stand on the points of the scheme."""
        every = tuple(self.points.values())
        for stroke in (*self.links.guides(), *self.links.heavy(k)):
            own = tuple(self.points[slot] for slot in stroke.of if slot in self.points)
            yield stroke._replace(of=own or every, position=k)


def _extremes(row: Any) -> tuple[float, float]:
    """Return the least and the greatest real part of a row, (trial, position), wherever it is."""
    there = np.flatnonzero(np.isfinite(alone_of(row)[0]))
    return extremes(row, [int(k) for k in there]) if there.size else (np.nan, np.nan)


def _circle(at: complex, mark: Mark) -> Ink:
    return circle("joint", at, RADIUS)._replace(of=(mark.slot,))
