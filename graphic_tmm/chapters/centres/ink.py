"""The scheme of centres in ink: the mechanism, lines through centres, circles, arrows to what lies far off."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import join, parallel, square
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.centres.network import Centre
from graphic_tmm.chapters.centres.record import Centres
from graphic_tmm.chapters.centres.scales import room, spots
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PAIR, PositionsInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import figure, showing
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import leaving
from graphic_tmm.paper.seen import Rule, Subject, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.window import Window

RADIUS = 1.3
"""Of the small circle about a centre, mm."""
TOGETHER = 15.0
"""Arrows to one centre that end no farther apart share a letter, mm."""
EDGE, BEYOND, LEAST = 16.0, 4.0, 14.0
"""How far lines to far centres go on beyond all else; others beyond their centres; the shortest arrow, mm."""


Ends = tuple[complex, complex]
Stretch = tuple[Ends, Sequence[tuple[complex, complex, tuple[Centre, ...]]]]
"""What is drawn of a line: its ends, mm; tips of arrows there, their ways, the far centres they lead to."""


class SchemeInk:
    """The scheme in one position while it is inked."""

    def __init__(
        self, on: Subject, made: Centres, reaches: Mapping[Figure, Reach], place: int, times: float
    ) -> None:
        self.made, self.place, self.on = made, place, on
        self.seen = on.seen((CENTRES,), [place])
        figures = [one for one in on.construction.figures if one.view == POSITIONS]
        marks = dict.fromkeys(mark for one in figures for mark in one.marks)
        values: dict[int, Any] = {mark.slot: on.reading[mark] for mark in marks}
        for mark in marks:
            if mark.kind is Line:
                values[mark.slot] = on.reading[mark]._replace(at=on.reading[mark].at * times)
            elif mark.kind is Point:
                values[mark.slot] = on.reading[mark] * times
        whole = {one: reach.times(times) for one, reach in reaches.items()}
        reading = Reading(values, on.reading.positions)
        self.links = PositionsInk(on.construction, reading, whole, [place])
        self.room = (room(*spots(made, on.reading, place)) or Window(0j, 0j)).grown(EDGE)

    def mechanism(self) -> Iterator[Ink]:
        """Yield the links, which stand on the points of the scheme."""
        own = {of.slot: mark.slot for of, mark in self.made.points.items()}
        for stroke in (*self.links.guides(), *self.links.heavy(self.place)):
            of = tuple(own[slot] for slot in stroke.of if slot in own)
            yield stroke._replace(of=of or tuple(own.values()), position=self.place)

    def lines(self) -> dict[Mark, Stretch]:
        """Every line of the scheme with what is drawn of it."""
        steps = [step for step in self.seen.steps if step.op in (join, parallel, square)]
        found = {}
        for step in steps:
            if step.uses[0].view == CENTRES and (drawn := self._stretch(step.it, step.uses)):
                found[step.it] = drawn
        return found

    def _stretch(self, of: Mark, uses: tuple[Mark, ...]) -> Stretch | None:
        at, way = self.seen.line(of, self.place)
        if not finite(at, way):
            return None
        inside = self.room.span(at, way)
        own = [one for one in self.made.centres if of in (*one.lines, one.mark) or one.mark in uses]
        there = {mark for mark in uses if mark.kind is Point and mark.view == CENTRES}
        there |= {one.mark for one in own if not one.far}
        along = {k: ((self.seen.point(k, self.place) - at) / way).real for k in there}
        along = {k: far for k, far in along.items() if np.isfinite(far)}
        if inside is None or not along:
            return None
        low, high = inside
        near = [far for far in along.values() if low + EDGE / 2 <= far <= high - EDGE / 2]
        if not near:
            return None
        first, last = max(low, min(near) - BEYOND), min(high, max(near) + BEYOND)
        leads = []
        for sign, end in ((-1.0, low), (1.0, high)):
            away = {k for k, far in along.items() if sign * (far - end) > -EDGE / 2}
            centres = tuple(one for one in own if one.mark in away)
            infinite = tuple(one for one in own if one.far and one.mark == of)
            if infinite and sign == (1.0 if (way.imag or way.real) > 0.0 else -1.0):
                centres += infinite
            if not centres:
                continue
            reach = max(near) if sign > 0 else min(near)
            tip = end
            if all(one.far for one in centres):
                tip = sign * min(sign * end, sign * reach + 2.0 * LEAST)
            if abs(tip - reach) < LEAST:
                tip = reach + sign * LEAST
            first, last = min(first, tip), max(last, tip)
            leads.append((at + tip * way, sign * way, centres))
        return (at + first * way, at + last * way), leads

    def letters(self) -> list[Wanted]:
        """The letters of points and of centres; what stands in one place shares a label."""
        told = [(mark, markup(of.name)) for of, mark in self.made.points.items()]
        told += [(one.mark, one.name) for one in self.near]
        at, k = self.seen.point, self.place
        named = (Named(at(mark, k), text, (mark.slot,), k) for mark, text in told)
        return lettered(shared(named), self.on.heights.point, PAIR)

    @cached_property
    def near(self) -> list[Centre]:
        """The centres that are drawn as points."""
        inside, at = self.room.grown(-EDGE / 2), self.seen.point
        there = [one for one in self.made.centres if not one.far]
        return [one for one in there if inside.holds(at(one.mark, self.place))]

    def circles(self) -> Iterator[tuple[Mark, Rule]]:
        """The small circles of centres that are no pins."""
        for mark in (one.mark for one in self.near):
            if mark not in self.made.points.values():
                yield mark, leaving(circle("joint", self.seen.point(mark, self.place), RADIUS))

    def arrows(self, of: Mark, stretch: Stretch) -> Iterator[tuple[list[Ink], Wanted]]:
        """The arrows at the ends of a line, with the centres to which they lead."""
        for tip, way, centres in stretch[1]:
            names = ", ".join(f"{one.name}{'∞' if one.far else ''}" for one in centres)
            slots = tuple(dict.fromkeys((of.slot, *(one.mark.slot for one in centres))))
            head = arrow(tip - 8.0 * way, tip, "thin")
            letter = Wanted(f"→ {names}", tip, self.on.heights.number, 1.0, way, slots, self.place)
            yield [one._replace(of=slots, position=self.place) for one in head], letter


def letters_of_arrows(arrows: Sequence[Wanted]) -> Iterator[Wanted]:
    """Yield the letters of arrows: of those to one centre, close together, the one with most room about it."""
    left = list(arrows)
    while left:
        near = [k for k in left if k.text == left[0].text and abs(k.at - left[0].at) < TOGETHER]
        away = [k.at for k in arrows if k.text != left[0].text]
        left = [k for k in left if k not in near]
        yield max(near, key=lambda own: min((abs(z - own.at) for z in away), default=0.0))


def draw_scheme(
    on: Subject, made: Centres, reaches: Mapping[Figure, Reach], place: int, times: float
) -> Drawing:
    """Return the scheme of centres in one position; ``times``: how much larger than the plan of positions."""
    ink = SchemeInk(on, made, reaches, place, times)
    lines = ink.lines()
    rules: dict[Mark, Rule] = {k: leaving(line("thin", *one[0])) for k, one in lines.items()}
    rules |= dict(ink.circles())
    traces = figure(ink.seen, showing(rules), helping=False)
    strokes = [*traces.staying, *ink.mechanism()]
    wanted, arrows = ink.letters(), list[Wanted]()
    for mark, stretch in lines.items():
        for head, letter in ink.arrows(mark, stretch):
            strokes += head
            arrows.append(letter)
    wanted += letters_of_arrows(arrows)
    circled = link_numbers(ink.links, place, strokes, wanted, on.heights.number)
    strokes += [stroke for one in circled for stroke in one.strokes]
    found = traces.drawing(on, strokes, wanted, [one.label for one in circled])
    return found._replace(position=place)
