"""Forces where only their lines of action are to scale: arrows, arms, couples; the links that they act on."""

from __future__ import annotations

import math
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Figure, Mark, Step, segment_name
from graphic_tmm.board.values import Kind, Length, Line, Point
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.ink_wheels import wheels
from graphic_tmm.chapters.kinematics.reaches import VIEW as POSITIONS
from graphic_tmm.chapters.kinematics.reaches import Reach, reach_of
from graphic_tmm.paper.arithmetic import bearing, below, by_case, either, larger, signed, smaller
from graphic_tmm.paper.covering import Covering
from graphic_tmm.paper.drawing import Data, Ink, Stroke, Wanted, circle, line
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.rules import PRICK, traceless
from graphic_tmm.paper.seen import Seen, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import round_arrow

LONGEST, SHORTEST = 34.0, 12.0
"""Lengths of the arrows of the largest force and of the smallest, mm: a small one is seen too."""
LEAST = 0.5
"""What is shorter than this, mm, is a point."""
NEARLY = 0.985
"""Arrows from one point whose directions agree so far (cosine) would lie on each other."""
ARM = 0.05
"""An arm shorter than this, mm, turns nothing: it has no letter."""
FURTHER = 3.0
"""How far a line of action goes on behind the foot of its arm, mm."""
ROUND, ROUNDS = 9.0, 7.0
"""Radius of the arrow of a couple, mm, and of each of several on a link."""
SWEEP, PEN = 210.0, 0.6
"""How far the arrow of a couple goes round, degrees: its letter stands at the middle; how far off its line a
leader to it ends, mm."""
BESIDE = 5.0
"""How far from a link an arrow along it stands that finds no end of it, mm."""
STAGGER = 10.0
"""By how much the farther of two arrows on one line outreaches the other, mm."""


class ArrowText(NamedTuple):
    """What an arrow stands for: its letter in the log, its size (signed, in ``unit``), the marks it comes from.

    ``more``: what else a reader of the sheet is told of it.
    """

    letter: str
    value: float
    unit: str
    of: tuple[int, ...]
    more: Data = ()

    @property
    def data(self) -> Data:
        """What a page reads of it."""
        name = segment_name(self.letter)
        if not math.isfinite(self.value):
            return (("segment", name),)
        return (("segment", name), ("value", f"{self.value:.6g}"), ("unit", self.unit), *self.more)

    @property
    def title(self) -> str:
        """What is told of it in words."""
        name = segment_name(self.letter)
        return f"{name} = {self.value:.4g} {self.unit}" if math.isfinite(self.value) else name


def turning(arm: float, size: float) -> Data:
    """Return the arm of a force as a page reads it, mm: positive where the arrow turns counter-clockwise.

    ``size``: of the force, signed; an arrow is drawn the way that the force acts. Nothing of an arm of which no
    digit is sure.
    """
    return (("arm", f"{arm * (-1 if size < 0 else 1):.2f}"),) if math.isfinite(arm) else ()


def length_of(size: float, largest: float) -> float:
    """Return the conventional length of an arrow, mm: it grows with the force."""
    if not (math.isfinite(size) and largest > 0.0) or size == 0.0:
        return 0.0
    return SHORTEST + (LONGEST - SHORTEST) * smaller(1.0, abs(size) / largest)


class Arrows:
    """Arrows and letters while they are drawn; arrows from one point do not lie on each other."""

    def __init__(self, index: int, size: float) -> None:
        self.index, self.size = index, size
        self.strokes: list[Stroke] = []
        self._named: list[Wanted] = []
        self.taken: list[tuple[complex, complex, float]] = []
        self.links = Covering()

    @property
    def wanted(self) -> list[Wanted]:
        """The letters: each nearer to its own arrow than to another."""
        lines = [one.line for one in self._named]
        return [
            one._replace(others=tuple(line for line in lines if line and line != one.line))
            if one.line
            else one
            for one in self._named
        ]

    def reach(self, at: complex, way: complex) -> float:
        """Return how far arrows go from a place in a direction already, mm; 0 if none does."""
        there = (
            length * below(abs(z - at), LEAST) * below(NEARLY, (way * d.conjugate()).real)
            for z, d, length in self.taken
        )
        return larger(0.0, *there)

    def stands_on(self, links: Iterable[Ink]) -> None:
        """Tell the links that arrows stand on (see `put`)."""
        self.links = Covering(_covering(one) for one in links if isinstance(one, Stroke))

    def put(
        self,
        at: complex,
        way: complex,
        length: float,
        called: str,
        told: ArrowText,
        pen: str = "over",
    ) -> None:
        """Draw an arrow along ``way`` (of length 1) from its point; to it where another goes there already.

        Where both sides are taken it outreaches the other. A thin one does not lie on the links, none in the
        tube of a cylinder: where the link is on one side of its point only it stands on the other; where it is
        on both, beside it.
        """
        if not (finite(at, way) and length >= LEAST and way):
            return
        links = self.links if pen == "thin" else self.links.areas
        there, on = self.reach(at, way), links.covers(at, at + length * way)
        behind = either(below(0.0, self.reach(at, -way)), links.covers(at, at - length * way))
        led = either(on, below(0.0, there)) * (1.0 - behind)
        start = by_case(on * behind, at + BESIDE * 1j * way, at)
        start = by_case(led, at - length * way, start)
        beside = below(0.0, there) * behind * (1.0 - on)
        length = by_case(beside, larger(length, there + STAGGER), length)
        self.taken.append((at, by_case(led, -way, way), length))
        shaft, *head = arrow(start, start + length * way, pen)
        self._add([shaft._replace(title=told.title, data=told.data), *head], told.of)
        end = by_case(led, start, start + length * way)
        own = (start, start + length * way)
        self._named.append(Wanted(called, end, self.size, 1.5, end - at, told.of, self.index, own))

    def couples(self, start: complex, end: complex, told: Sequence[tuple[str, ArrowText]]) -> None:
        """Draw couples as round arrows in their senses, beside one another along a line."""
        there = [(called, one) for called, one in told if math.isfinite(one.value) and one.value]
        if not finite(start, end):
            return
        far, radius = abs(end - start), ROUND if len(there) < 2 else ROUNDS
        way = (end - start) / far if far >= LEAST else 1j
        pitch = larger(far / (len(there) + 1), 2.4 * radius)
        for k, (called, one) in enumerate(there):
            at = (start + end) / 2 + (k - (len(there) - 1) / 2) * pitch * way
            self.couple(at, radius, called, one)

    def couple(
        self, at: complex, radius: float, called: str, told: ArrowText, way: complex = 1j
    ) -> None:
        """Draw a couple as a round arrow in its sense about a place, its letter on the side of ``way``."""
        if not (finite(at, told.value) and told.value and way):
            return
        sense, out = signed(1.0, told.value), way / abs(way)
        start = bearing(out) - sense * SWEEP / 2
        bow, *head = round_arrow(at, radius, start, sense * SWEEP)
        self._add([bow._replace(title=told.title, data=told.data), *head], told.of)
        top = at + radius * out
        self._named.append(Wanted(called, top, self.size, PEN, out, told.of, self.index))

    def _add(self, strokes: Iterable[Stroke], of: tuple[int, ...]) -> None:
        self.strokes += [s._replace(of=of, position=self.index) for s in strokes]


def _covering(stroke: Stroke) -> Stroke:
    """Return a stroke as it covers paper: a tube hides what lies in it."""
    tube = stroke.pen == "body" and stroke.part == "cylinder"
    return stroke._replace(filled=True) if tube else stroke


def action(seen: Seen, step: Step, k: int) -> tuple[complex, complex, complex]:
    """Return of the step that measures an arm: about what, where its line of action begins, the arm's foot."""
    about = seen.point(step.uses[0], k)
    at, along = seen.line(step.uses[1], k)
    return about, at, at + ((about - at) * along.conjugate()).real * along


def drawn_arm(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The arm of a force, square to its line of action; a page is told its mm, without which none is drawn."""
    about, _, foot = action(seen, step, k)
    mm = abs(seen.number(step.it, k))
    if finite(about, foot, mm) and abs(foot - about) >= LEAST:
        name = segment_name(step.it.name)
        data = (("segment", name), ("mm", f"{mm:.2f}"))
        yield line("thin", about, foot)._replace(data=data, title=f"{name} = {mm:.1f} mm")


def drawn_on(seen: Seen, step: Step, k: int, but: Container[Mark] = frozenset()) -> Iterator[Ink]:
    """A line of action, drawn on from the force to behind the foot of its arm; about no point of ``but``."""
    at, along = seen.line(step.it, k)
    for use in seen.uses.get(step.it, ()):
        if use.it.kind is Length and use.uses[0] not in but:
            _, _, foot = action(seen, use, k)
            reach = ((foot - at) * along.conjugate()).real
            if finite(foot) and along != 0 and abs(reach) >= LEAST:
                yield line("thin", at, foot + along * signed(FURTHER, reach))


def arm_shows(seen: Seen, step: Step, k: int, but: Container[Mark] = frozenset()) -> bool:
    """Whether an arm, or the line of action that one was measured to, stays: it stands in an equation.

    None about the points of ``but`` does.
    """
    if step.it.kind is Line:
        arms = (use for use in seen.uses.get(step.it, ()) if _is_arm(use))
        return any(arm_shows(seen, use, k, but) for use in arms)
    return step.uses[0] not in but and abs(seen.number(step.it, k)) >= ARM


def _is_arm(step: Step) -> bool:
    return step.it.kind is Length and not step.op.formula


def pricks(seen: Seen, drawn: Iterable[Ink], k: int, times: float = 1.0) -> tuple[Ink, ...]:
    """Return the pricks of steps that left nothing else: what is too short to be drawn is a point.

    ``times``: how much larger than their views they are drawn.
    """
    shown = {slot for stroke in drawn for slot in stroke.of}
    return tuple(
        circle("thin", times * spot, PRICK)._replace(of=(step.it.slot,), position=k)
        for step in seen.steps
        if step.it.slot not in shown and not traceless(step.op)
        for spot in [_spot(seen, step, k)]
        if finite(spot)
    )


def _spot(seen: Seen, step: Step, k: int) -> complex:
    """Return where a step was done."""
    kind: Kind = step.it.kind
    if kind is Point:
        return seen.point(step.it, k)
    if kind is Line:
        return seen.line(step.it, k)[0]
    first: Mark = step.uses[0]
    return seen.point(first, k) if first.kind is Point else complex("nan")


SEEN = 8.0
"""So much farther a guide that is cut off goes on behind its stone, mm: its link is seen to have one."""


TEETH = 40.0
"""So many degrees of a pitch circle are shown about where a tooth presses: the whole would be large."""


class Bodies:
    """The links of a figure: those of the plan of positions, drawn to another scale.

    A guide ends at its stone where its whole path would be longer than all else that the figure shows.
    """

    def __init__(
        self,
        seen: Seen,
        reaches: Mapping[Figure, Reach],
        links: Sequence[int],
        points: Mapping[Mark, Mark],
        times: float,
    ) -> None:
        """``points``: by those of the plan of positions; ``times``: how much larger than there."""
        construction, reading = seen.construction, seen.reading
        figures = [one for one in construction.figures if one.view == POSITIONS]
        marks = dict.fromkeys(mark for one in figures for mark in one.marks)
        values = {mark.slot: _larger(reading[mark], times) for mark in marks}
        self.names = [str(number) for number in links]
        self.points, self.index = points, seen.positions[0]
        larger = Reading(values, reading.positions)
        whole = {one: reach.times(times) for one, reach in reaches.items()}
        self.ink = LinksInk(construction, larger, whole)
        spread = max(abs(a - b) for a, b in map(self.ends, self.names))
        self.ink.reaches = {
            one: reach.near(
                reach_of(construction, larger, one, reach.anchor, self.index).longer(SEEN), spread
            )
            for one, reach in whole.items()
        }

    def strokes(self) -> Iterator[Ink]:
        """The links, and what slides on them; they stand on the points of the figure."""
        found = [*wheels(self.ink, self.names, self.index, TEETH)]
        found += [s for name in self.names for s in self.ink.lines(name, self.index, MAIN)]
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
            for told in self.ink.of(name, "link", "centre", "wheel")
            for mark in told.marks
        )
        named = [
            Named(self.ink.at(m, self.index), markup(m.name), (self.points[m].slot,), self.index)
            for m in marks
            if m in self.points
        ]
        return lettered(shared(named), high.point, 2.2)

    @property
    def middle(self) -> complex:
        """The middle of the points of all links."""
        ends = [end for name in self.names for end in self.ends(name)]
        return sum(ends) / len(ends)

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
