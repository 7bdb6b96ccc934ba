"""A detached group in ink: its links in one position, loads at their points, arms, reactions to be found.

Points, lines of action and arms are to the figure's own scale factor of lengths. The arrows of forces are not:
they show points, directions and which of two is larger.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import lay_off, parallel
from graphic_tmm.board.operations.statics import action, arm
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.ink_arrows import (
    LEAST,
    Arrows,
    Told,
    arm_shows,
    drawn_arm,
    drawn_on,
    length_of,
    pricks,
    turning,
)
from graphic_tmm.chapters.forces.ink_polygons import bar
from graphic_tmm.chapters.forces.loads import VIEW as LOADS
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.kinematics.ink_links import LinksInk
from graphic_tmm.chapters.kinematics.ink_positions import HEAVY
from graphic_tmm.chapters.kinematics.reaches import VIEW as POSITIONS
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.finish import Named, lettered, shared
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.seen import Seen, finite

SHOWN = 18.0
"""Length of the arrow of a reaction that is not known yet, mm."""


class Reactive(NamedTuple):
    """A reaction to be found: its letter, the point where it acts, its vector on the polygon.

    ``value``, ``arm``, ``link``: of a component found by moments, its size (N), its arm about the closing point
    and the link on which it acts.
    """

    letter: str
    at: Mark
    tail: Mark
    head: Mark
    value: Mark | None = None
    arm: Mark | None = None
    link: int = 0


class Shown(NamedTuple):
    """What a figure shows: its links, forces and couples on them, reactions.

    ``circles``: friction circles, their pins and radii (m). ``balance``: of the driving link, the line and
    the arm of the force that balances it.
    """

    figure: Detached
    links: tuple[int, ...]
    forces: Sequence[Force]
    couples: Sequence[Couple]
    reactions: Sequence[Reactive]
    circles: Sequence[tuple[Mark, Mark]] = ()
    balance: tuple[Mark, Mark] | None = None


def draw_group(
    construction: Construction,
    reading: Reading,
    reaches: Mapping[Figure, Reach],
    shown: Shown,
    index: int,
    name: str,
    title: str,
    factors: tuple[Mark, int],
    language: str,
    high: Heights,
) -> Drawing:
    """Return a detached group, or the driving link, in one position.

    ``factors``: μ_l of the plan of positions, and to how many decimals the ruler tells a length. ``language``:
    of the sheet; ``high``: how high its letters are.
    """
    mu_l, decimals = factors
    view = shown.figure.view
    seen = Seen(construction, reading, (view,), [index])
    rules = {
        op: _nothing for op in dict.fromkeys(s.op.name for s in seen.steps) if _drawn(op, seen)
    }
    rules |= {arm.name: drawn_arm, parallel.name: drawn_on, action.name: drawn_on}

    # of the passes of friction the last one stays
    lines = {shown.figure.lines.get(force.line) for force in shown.forces}

    def stays(seen: Seen, step: Step) -> bool:
        if step.it.kind is Point or not {step.it, *step.uses} & lines:
            return False
        return arm_shows(seen, step, index)

    traces = figure(seen, Manner(rules, stays))
    times = seen.number(mu_l, index) / seen.number(shown.figure.mu, index)
    bodies = _Bodies(construction, reading, reaches, shown, index, times)
    loads = _Loads(seen, shown, index, high, language)
    for force in shown.forces:
        loads.force(force)
    for reaction in shown.reactions:
        loads.reaction(reaction)
    for link in shown.links:
        loads.couples(link, *bodies.ends(str(link)))
    circles = [
        circle("thin", seen.point(shown.figure.point(pin), index), rho)._replace(
            of=(shown.figure.points[pin].slot, radius.slot), position=index
        )
        for pin, radius in shown.circles
        for rho in [seen.number(radius, index) / seen.number(shown.figure.mu, index)]
    ]
    above = _Above(construction, reading, shown, index)
    displaced = loads.displaced(above, times, decimals)
    strokes = (*bodies.strokes(), *circles, *loads.arrows.strokes, *displaced, *traces.staying)
    drawn = (*strokes, *traces.rubbed)
    rubbed = (*traces.rubbed, *pricks(seen, drawn, index), *pricks(above, drawn, index, times))
    wanted = (*bodies.letters(high), *loads.arrows.wanted, *loads.arms(traces.staying, decimals))
    return Drawing(
        name, title, strokes, rubbed=rubbed, shows=(view, LOADS), wanted=(*wanted, *loads.offs)
    )


def _drawn(op: str, seen: Seen) -> bool:
    """Whether an operation leaves lines of forces: those are drawn as arrows."""
    return any(step.op.name == op and step.it.kind is Line for step in seen.steps)


def _nothing(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    yield from ()


class _Above(Seen):
    """Of the loads those steps on which what acts on a figure depends."""

    def __init__(
        self, construction: Construction, reading: Reading, shown: Shown, index: int
    ) -> None:
        super().__init__(construction, reading, (LOADS,), [index])
        self.shown = shown

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """These steps, in the order in which they were done."""
        wanted = [mark for f in self.shown.forces for mark in (f.line, f.value, f.point)]
        wanted += [couple.value for couple in self.shown.couples]
        there = {step.it: step for step in super().steps}
        found = set[Mark]()
        while wanted:
            mark = wanted.pop()
            if mark in there and mark not in found:
                found.add(mark)
                wanted += there[mark].uses
        return tuple(step for mark, step in there.items() if mark in found)


class _Bodies:
    """The links of a figure: those of the plan of positions, drawn to another scale."""

    def __init__(
        self,
        construction: Construction,
        reading: Reading,
        reaches: Mapping[Figure, Reach],
        shown: Shown,
        index: int,
        times: float,
    ) -> None:
        figures = [one for one in construction.figures if one.view == POSITIONS]
        marks = dict.fromkeys(mark for one in figures for mark in one.marks)
        values = {mark.slot: _larger(reading[mark], times) for mark in marks}
        larger = {one: reach.times(times) for one, reach in reaches.items()}
        self.ink = LinksInk(construction, Reading(values, reading.positions), larger)
        self.names = [str(number) for number in shown.links]
        self.points, self.index = shown.figure.points, index

    def strokes(self) -> Iterator[Ink]:
        """The links, and what slides on them; they stand on the points of the figure."""
        found = [s for name in self.names for s in self.ink.lines(name, self.index, HEAVY)]
        found += self.ink.symbols(self.names, self.index)
        own = {of.slot: mark.slot for of, mark in self.points.items()}
        for stroke in found:
            of = tuple(own[slot] for slot in stroke.of if slot in own)
            yield stroke._replace(of=of or tuple(own.values()))

    def letters(self, high: Heights) -> list[Wanted]:
        """The letters of the points of the links."""
        marks = dict.fromkeys(
            mark
            for name in self.names
            for told in self.ink.of(name, "link", "centre")
            for mark in told.marks
        )
        named = [
            Named(self.ink.at(m, self.index), markup(m.name), (self.points[m].slot,), self.index)
            for m in marks
            if m in self.points
        ]
        return lettered(shared(named), high.point, 2.2)

    def ends(self, name: str) -> tuple[complex, complex]:
        """Between which of its points couples on a link are drawn: those farthest apart."""
        pins = [*self.ink.spots(name, self.index)]
        pins += [one.foot for one in self.ink.bars(name, self.index)]
        if len(pins) < 2:
            return (pins[0], pins[0]) if pins else (0j, 0j)
        return max(((a, b) for a in pins for b in pins), key=lambda ends: abs(ends[1] - ends[0]))


def _larger(value: Any, times: float) -> Any:
    if isinstance(value, Line):
        return value._replace(at=value.at * times)
    return value * times if np.iscomplexobj(value) else value


class _Loads:
    """What acts on a figure while it is drawn."""

    def __init__(self, seen: Seen, shown: Shown, index: int, high: Heights, language: str) -> None:
        self.seen, self.shown, self.index = seen, shown, index
        self.high, self.language = high, language
        self.arrows = Arrows(index, high.point)
        self.offs: list[Wanted] = []
        sizes = [abs(seen.number(force.value, index)) for force in shown.forces]
        self.largest = max((size for size in sizes if finite(size)), default=0.0)

    def called(self, letter: str) -> str:
        """Return what a letter of the log is called in the language of the sheet."""
        return symbol(letter, self.language)

    def at(self, mark: Mark) -> Mark:
        """Return where a point of the plan of positions stands in the figure."""
        return self.shown.figure.points.get(mark, mark)

    def force(self, force: Force) -> None:
        """A load at its point, along its line of action, as long as is usual."""
        k, size = self.index, self.seen.number(force.value, self.index)
        _, along = self.seen.line(force.line, k)
        point = self.at(force.point)
        line_of = self.shown.figure.lines.get(force.line, force.line)
        of = (point.slot, force.line.slot, line_of.slot, force.value.slot)
        more = (("link", str(force.link)), ("arm", turning(self._arm(force), size)))
        told = Told(force.letter, abs(size), "N", tuple(dict.fromkeys(of)), more)
        way = along * (-1 if size < 0 else 1)
        length = length_of(size, self.largest)
        self.arrows.put(
            self.seen.point(point, k), way, length, bar(self.called(force.letter)), told
        )

    def _arm(self, force: Force) -> float:
        """Return the arm of a force about the point of the figure, mm; 0 of one through it.

        That of the balancing force is the crank.
        """
        if self.shown.balance is not None and force.line == self.shown.balance[0]:
            return self.seen.number(self.shown.balance[1], self.index)
        own = self.shown.figure.lines.get(force.line)
        for step in self.seen.steps:
            if step.op is arm and step.uses[1] == own:
                return self.seen.number(step.it, self.index)
        return 0.0

    def reaction(self, reaction: Reactive) -> None:
        """A reaction to be found, by its direction; of one found by moments its size and its arm are told."""
        k = self.index
        tail, head = self.seen.point(reaction.tail, k), self.seen.point(reaction.head, k)
        if not abs(head - tail) >= LEAST:
            return
        point = self.at(reaction.at)
        of = [point.slot, reaction.tail.slot, reaction.head.slot]
        size, more = float("nan"), tuple[tuple[str, str], ...]()
        if reaction.value is not None and reaction.arm is not None:
            signed = self.seen.number(reaction.value, k)
            size, about = abs(signed), -self.seen.number(reaction.arm, k)
            more = (("link", str(reaction.link)), ("arm", turning(about, signed)))
            of.append(reaction.value.slot)
        told = Told(reaction.letter, size, "N", tuple(of), more)
        way = (head - tail) / abs(head - tail)
        called = bar(self.called(reaction.letter))
        self.arrows.put(self.seen.point(point, k), way, SHOWN, called, told, "thin")

    def couples(self, link: int, start: complex, end: complex) -> None:
        """The couples on a link."""
        own = [couple for couple in self.shown.couples if couple.link == link]
        values = [self.seen.number(couple.value, self.index) for couple in own]
        told = [
            (
                markup(self.called(one.letter)),
                Told(one.letter, value, "N·m", (one.value.slot,), (("link", str(link)),)),
            )
            for one, value in zip(own, values, strict=True)
        ]
        self.arrows.couples(start, end, told)

    def arms(self, drawn: Sequence[Ink], decimals: int) -> Iterator[Wanted]:
        """The letters of the arms that were drawn, and their mm."""
        slots = {slot for stroke in drawn for slot in stroke.of}
        for step in self.seen.steps:
            if step.op is arm and step.it.slot in slots:
                about = self.seen.point(step.uses[0], self.index)
                at, along = self.seen.line(step.uses[1], self.index)
                foot = at + ((about - at) * along.conjugate()).real * along
                mm = abs(self.seen.number(step.it, self.index))
                text = f"{markup(self.called(step.it.name))} = {fixed(mm, decimals, self.language)}"
                out = 1j * (foot - about)
                size = self.high.number
                yield Wanted(text, (about + foot) / 2, size, 0.8, out, (step.it.slot,), self.index)

    def displaced(self, loads: Seen, times: float, decimals: int) -> Iterator[Ink]:
        """How far a force that stands for a force and a couple lies off the mass centre."""
        k = self.index
        for step in loads.steps:
            if step.op is not lay_off:
                continue
            across, by = step.uses
            a, b = times * loads.line(across, k)[0], times * loads.point(step.it, k)
            if finite(a, b) and abs(b - a) >= LEAST:
                of = (across.slot, loads.by_mark[across].uses[1].slot, by.slot, step.it.slot)
                yield line("thin", a, b)._replace(of=of, position=k)
                told, way = fixed(abs(b - a), decimals, self.language), 1j * (b - a)
                text = f"{markup(self.called(by.name))} = {told}"
                number = Wanted(text, (a + b) / 2, self.high.number, 0.8, way, (by.slot,), k)
                self.offs.append(number)
