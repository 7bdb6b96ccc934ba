"""A detached group in ink: its links in one position, loads at their points, arms, reactions to be found.

Points, lines of action and arms are to the figure's own scale factor of lengths. The arrows of forces are not:
they show points, directions and which of two is larger.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Container, Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.operations.instruments import lay_off, parallel, square
from graphic_tmm.board.operations.statics import action, arm, at_friction_angle
from graphic_tmm.board.record import Figure, Mark, Step
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.ink_arrows import (
    LEAST,
    ROUNDS,
    Arrows,
    ArrowText,
    Bodies,
    arm_shows,
    drawn_arm,
    drawn_on,
    length_of,
    pricks,
    turning,
)
from graphic_tmm.chapters.forces.ink_arrows import action as acting
from graphic_tmm.chapters.forces.ink_polygons import bar
from graphic_tmm.chapters.forces.loads import VIEW as LOADS
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.special import Special
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.arithmetic import larger, signed
from graphic_tmm.paper.drawing import Drawing, Ink, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen, Subject, finite

SEEN = 2.0
"""A smaller circle of friction, mm, lies under the sign of its pin: no line touches it."""
TOUCH, STEP = 14.0, 3.5
"""Half of what is drawn of a line that touches a circle of friction, mm; between two couples about a pin."""
ASIDE = cmath.exp(-2j * math.pi / 3)
"""By how much the letter of the next couple about a pin is turned, so that they are told apart."""
SPOT = 0.8
"""Radius of the sign of a special point, mm."""
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


class Rubbed(NamedTuple):
    """Friction in a pin of a link: the pin, the radius of its circle (m), its couple, the pin's reaction.

    ``tail``, ``head``: the vector of the reaction, as it acts on the link of the couple.
    """

    pin: Mark
    radius: Mark
    couple: Couple
    tail: Mark
    head: Mark


class GroupFigure(NamedTuple):
    """What a figure shows: its links, forces and couples on them, reactions.

    ``rubbed``: friction in its pins. ``balance``: of the driving link, the line and
    the arm of the force that balances it. ``special``: of a plate on three legs, what its special point gives.
    """

    figure: Detached
    links: tuple[int, ...]
    forces: Sequence[Force]
    couples: Sequence[Couple]
    reactions: Sequence[Reactive]
    rubbed: Sequence[Rubbed] = ()
    balance: tuple[Mark, Mark] | None = None
    special: Special | None = None

    @property
    def lines(self) -> set[Mark | None]:
        """The lines of the figure whose arms are measured."""
        found = {self.figure.lines.get(force.line) for force in self.forces}
        if self.special is not None:
            found |= {force.line for force in self.special.forces}
            found |= {self.special.third.line} if self.special.third is not None else set()
        return found

    @property
    def earlier(self) -> set[Mark]:
        """The special points of earlier passes of friction."""
        own = {mark for mark, at in self.figure.points.items() if mark == at}
        return own - {self.special.point} if self.special is not None else own


def draw_group(
    on: Subject,
    reaches: Mapping[Figure, Reach],
    shown: GroupFigure,
    index: int,
    factors: tuple[Mark, int],
    helping: bool = True,
) -> Drawing:
    """Return a detached group, or the driving link, in one position.

    ``factors``: μ_l of the plan of positions, and to how many decimals the ruler tells a length. Not
    ``helping``: without what is rubbed out.
    """
    mu_l, decimals = factors
    view = shown.figure.view
    seen = on.seen((view,), [index])
    rules = {
        op: _nothing for op in dict.fromkeys(s.op.name for s in seen.steps) if _drawn(op, seen)
    }
    earlier = shown.earlier
    on_to_arms = partial(drawn_on, but=earlier)
    drawn_to_arms = (parallel, action, square, at_friction_angle)
    rules |= {arm.name: drawn_arm, **{op.name: on_to_arms for op in drawn_to_arms}}

    # of the passes of friction the last one stays
    lines = shown.lines

    def stays(seen: Seen, step: Step) -> bool:
        if step.it.kind is Point or not {step.it, *step.uses} & lines:
            return False
        return arm_shows(seen, step, index, earlier)

    traces = figure(seen, Manner(rules, stays), helping=helping)
    times = seen.number(mu_l, index) / seen.number(shown.figure.mu, index)
    bodies = Bodies(seen, reaches, shown.links, shown.figure.points, times)
    links = [*bodies.strokes()]
    loads = _Loads(seen, shown, index, on)
    loads.arrows.stands_on(links)
    for force in shown.forces:
        loads.force(force)
    for reaction in shown.reactions:
        loads.reaction(reaction)
    for link in shown.links:
        loads.couples(link, *bodies.ends(str(link)))
    circles = [*loads.friction(bodies.middle)]
    above = _Above(on, shown, index)
    displaced = loads.displaced(above, times, decimals)
    crossing = [*_crossing(seen, shown.special, index)]
    strokes = (*links, *circles, *loads.arrows.strokes, *displaced, *traces.staying, *crossing)
    if helping:
        drawn = (*strokes, *traces.rubbed)
        traces.rubbed += (*pricks(seen, drawn, index), *pricks(above, drawn, index, times))
    arms = loads.arms(lines, decimals)
    letters = [*bodies.letters(on.heights), *_lettered(seen, shown.special, index, on)]
    wanted = (*letters, *loads.arrows.wanted, *arms, *loads.offs)
    found = traces.drawing(on, strokes, wanted)
    return found._replace(shows=(view, LOADS), role=roles.DETACHED, position=index)


def _crossing(seen: Seen, special: Special | None, k: int) -> Iterator[Ink]:
    """The special point of a plate, or of two, and the lines that lead to it."""
    if special is None:
        return
    at = seen.point(special.point, k)
    for along in special.lines:
        start, _ = seen.line(along, k)
        if finite(start, at) and abs(at - start) >= LEAST:
            yield line("thin", start, at)._replace(of=(along.slot, special.point.slot), position=k)
    if finite(at):
        yield circle("thin", at, SPOT)._replace(of=(special.point.slot,), position=k)


def _lettered(seen: Seen, special: Special | None, k: int, on: Subject) -> list[Wanted]:
    """The letter of the special point."""
    if special is None or not finite(at := seen.point(special.point, k)):
        return []
    called = markup(symbol(special.point.name, on.language))
    return lettered(shared([Named(at, called, (special.point.slot,), k)]), on.heights.point, SPOT)


def _drawn(op: str, seen: Seen) -> bool:
    """Whether an operation leaves lines of forces: those are drawn as arrows."""
    return any(step.op.name == op and step.it.kind is Line for step in seen.steps)


def _nothing(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    yield from ()


class _Above(Seen):
    """Of the loads those steps on which what acts on a figure depends."""

    def __init__(self, on: Subject, shown: GroupFigure, index: int) -> None:
        super().__init__(on.construction, on.reading, (LOADS,), [index])
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


class _Loads:
    """What acts on a figure while it is drawn."""

    def __init__(self, seen: Seen, shown: GroupFigure, index: int, on: Subject) -> None:
        self.seen, self.shown, self.index = seen, shown, index
        self.high, self.language = on.heights, on.language
        self.arrows = Arrows(index, on.heights.point)
        self.offs: list[Wanted] = []
        sizes = [abs(seen.number(force.value, index)) for force in shown.forces]
        self.largest = larger(0.0, *(size for size in sizes if finite(size)))

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
        more = (("link", str(force.link)), *turning(self._arm(force), size))
        told = ArrowText(force.letter, abs(size), "N", tuple(dict.fromkeys(of)), more)
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
            more = (("link", str(reaction.link)), *turning(about, signed))
            of.append(reaction.value.slot)
        told = ArrowText(reaction.letter, size, "N", tuple(of), more)
        way = (head - tail) / abs(head - tail)
        called = bar(self.called(reaction.letter))
        self.arrows.put(self.seen.point(point, k), way, SHOWN, called, told, "thin")

    def couples(self, link: int, start: complex, end: complex) -> None:
        """The couples on a link, but for those of friction."""
        pinned = [one.couple for one in self.shown.rubbed]
        own = [one for one in self.shown.couples if one.link == link and one not in pinned]
        told = [self._couple(one, self.seen.number(one.value, self.index)) for one in own]
        self.arrows.couples(start, end, told)

    def friction(self, middle: complex) -> Iterator[Ink]:
        """The circles of friction, couples about them; the line of a force with its couple touches its circle.

        ``middle``: of the figure, off which the letters of couples stand.
        """
        k, pins = self.index, list[Mark]()
        for one in self.shown.rubbed:
            point = self.at(one.pin)
            at, rho = self.seen.point(point, k), self.seen.number(one.radius, k)
            rho /= self.seen.number(self.shown.figure.mu, k)
            turns = self.seen.number(one.couple.value, k)
            if one.pin not in pins:
                of = (point.slot, one.radius.slot)
                yield circle("thin", at, rho)._replace(of=of, position=k)
                more = (one.couple.value.slot, one.tail.slot, one.head.slot)
                for touching in self._touching(one, at, signed(rho, turns)):
                    yield touching._replace(of=(*of, *more), position=k)
            radius = larger(ROUNDS, rho + 2.0) + STEP * pins.count(one.pin)
            called, told = self._couple(one.couple, turns)
            out = (at - middle or 1j) * ASIDE ** pins.count(one.pin)
            self.arrows.couple(at, radius, called, told, out)
            pins.append(one.pin)

    def _touching(self, one: Rubbed, at: complex, rho: float) -> Iterator[Stroke]:
        """The line of the force that stands for a reaction and its couple: ``rho`` mm off the pin.

        ``rho`` has the sense of the couple.
        """
        force = self.seen.point(one.head, self.index) - self.seen.point(one.tail, self.index)
        if finite(at, force, rho) and abs(force) >= LEAST and abs(rho) >= SEEN:
            way = force / abs(force)
            touched = at - 1j * way * rho
            yield line("thin", touched - TOUCH * way, touched + TOUCH * way)

    def _couple(self, couple: Couple, value: float) -> tuple[str, ArrowText]:
        link = (("link", str(couple.link)),)
        told = ArrowText(couple.letter, value, "N·m", (couple.value.slot,), link)
        return markup(self.called(couple.letter)), told

    def arms(self, lines: Container[Mark | None], decimals: int) -> Iterator[Wanted]:
        """The letters of the arms of lines of action, and their mm."""
        for step in self.seen.steps:
            if step.op is not arm or step.uses[1] not in lines:
                continue
            if arm_shows(self.seen, step, self.index, self.shown.earlier):
                about, _, foot = acting(self.seen, step, self.index)
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
