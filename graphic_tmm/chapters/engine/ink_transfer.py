"""The figure of all forces in ink: the mechanism with its cylinder, vectors, parallelograms, arms, angles."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import lay_off, meet
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.engine.ink import outwards
from graphic_tmm.chapters.engine.task import TRANSFER as VIEW
from graphic_tmm.chapters.engine.transfer import Transfer
from graphic_tmm.chapters.forces.ink_polygons import LEAST
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import dimension, told_arrow
from graphic_tmm.paper.symbols.kinematic import (
    channel,
    fixed_pivot,
    round_arrow,
    slider,
    turning_pair,
)

BORE, WALL, HEAD = 22.0, 9.0, 7.0
"""The cylinder as drawn: its bore, how far its walls go on behind the piston, how thick the piston is, mm; all
conventional, chosen by eye."""
GUIDE = 26.0
"""The length of the guide that is shown, mm."""
NEAR, INNER, FAR, OUTER = 12.0, 17.0, 23.0, 40.0
"""Radii of the arcs of φ and φ + β, of M and M′ at the bearing, of β at the crosshead, mm."""
BELOW = 22.0
"""How far below the cylinder's line the arm OB is dimensioned, mm."""


class TransferFigure(NamedTuple):
    """What a figure shows: its position (index), μ_F, the unit of forces, how the crank turns."""

    place: int
    mu: float
    unit: str
    sense: int


class _Points(NamedTuple):
    """Where bearing, pin, crosshead, piston, cover, the foot of the arm are, and the way to the cover."""

    o: complex
    a: complex
    b: complex
    c: complex
    d: complex
    foot: complex
    out: complex


def draw_all_forces(on: Subject, made: Transfer, shown: TransferFigure) -> Drawing:
    """Return the mechanism of one position with all its forces."""
    k, small = shown.place, on.heights.number
    seen = on.seen((VIEW,), (k,))
    o, a, b, c, d = (seen.point(mark, k) for mark in made.points)
    out = (d - b) / abs(d - b) if finite(b, d) and d != b else 1 + 0j
    at = _Points(o, a, b, c, d, seen.point(made.foot, k), out)
    traces = figure(seen, _manner(seen, made, shown))
    strokes = [*_machine(made, at, k), *traces.staying, *_angles(made, at, shown, seen)]
    labels = []
    if finite(at.o, at.b) and abs(at.b - at.o) > LEAST:
        down = -1 if (at.b - at.o).real >= 0 else 1
        told = dimension(at.o, at.b, down * BELOW, "OB", small)
        strokes += body(told.strokes, "dimension", [made.points[0], made.points[2]], k)
        slots = (made.points[0].slot, made.points[2].slot)
        named = made.points[0].letter + made.points[2].letter
        labels.append(told.label._replace(text=markup(named), of=slots, position=k))
    letters = _letters(made, at, shown, seen, on.heights)
    wanted = [*letters, *_vector_letters(seen, made, k, small)]
    return traces.drawing(on, strokes, wanted, labels)


def _manner(seen: Seen, made: Transfer, shown: TransferFigure) -> Manner:
    """Return how it is inked: forces as vectors, thin what closes a parallelogram; all else is rubbed out."""
    by_end = {one.end: one for one in made.vectors}
    closed = {s.uses[0]: s.it for s in seen.steps if s.op is meet and s.it in by_end}

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        one = by_end.get(step.it)
        start, end = (seen.point(m, k) for m in (one.start, one.end)) if one else (0j, 0j)
        if one is not None and finite(start, end) and abs(end - start) >= LEAST:
            letter = ("−" if one.against else "") + one.letter
            yield from told_arrow(start, end, "over", letter, shown.mu, shown.unit)

    def closing(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from segment("thin", seen.point(step.uses[0], k), seen.point(closed[step.it], k))

    lines: dict[Mark, Rule] = dict.fromkeys(closed, closing)
    rules: dict[str, Rule] = {lay_off.name: vector, meet.name: vector}
    return Manner(rules, lambda _, step: step.it in by_end or step.it in closed, lines)


def _machine(made: Transfer, at: _Points, k: int) -> Iterator[Ink]:
    """The mechanism: crank, rods, guide, piston and cylinder."""
    o, a, b, c, d = made.points
    turn = math.degrees(cmath.phase(at.out))
    if finite(at.b, at.c, at.d):
        ends = (at.b - at.out * abs(at.b - at.o), at.d)
        yield from body([line("centre", *ends)], "axis", [o, b, d], k)
    yield from body(segment("thin", at.o, at.a), "link", [o, a], k)
    yield from body(segment("thin", at.a, at.b), "link", [a, b], k)
    if finite(at.b, at.c, at.d):
        yield from body(channel(at.b, turn, GUIDE), "guide", [b], k)
        face = at.c - at.out * HEAD
        yield from body(segment("thin", at.b, face), "link", [b, c], k)
        yield from body(_piston(at), "piston", [c], k)
        yield from body(_cylinder(at), "cylinder", [c, d], k)
        yield from body(slider(at.b, turn, pin=False), "guide", [b], k)
    yield from body(fixed_pivot(at.o), "pivot", [o])
    yield from body([*turning_pair(at.a)], "pair", [a], k)
    yield from body([*turning_pair(at.b)], "pair", [b], k)


def _piston(at: _Points) -> Iterator[Ink]:
    half, back = 1j * at.out * BORE / 2, at.out * HEAD
    yield line(
        "body", at.c - back - half, at.c - half, at.c + half, at.c - back + half, closed=True
    )


def _cylinder(at: _Points) -> Iterator[Ink]:
    """The cylinder: its cover and both walls as far as the piston, open towards the crank."""
    half, near = 1j * at.out * BORE / 2, at.c - at.out * (HEAD + WALL)
    yield line("main", near + half, at.d + half, at.d - half, near - half)


def _angles(made: Transfer, at: _Points, shown: TransferFigure, seen: Seen) -> Iterator[Ink]:
    """The arcs of φ, β and φ + β, the arm of Q, the arrows of both couples."""
    k, (o, a, *_) = shown.place, made.points
    for arc_ in _arcs(made, at, shown.sense):
        if finite(arc_.vertex) and abs(arc_.sweep) > LEAST:
            bow = arc("thin", arc_.vertex, arc_.radius, arc_.start, arc_.sweep)
            yield from body([bow], "angle", arc_.marks, k)
    if finite(at.o, at.a, at.foot):
        lines = [*segment("thin", at.o, at.foot), *segment("thin", at.a, at.foot)]
        yield from body(lines, "arm", [o, a, made.foot], k)
    for turn in _turns(made, at, shown, seen):
        bow_ = round_arrow(at.o, turn.radius, turn.start, turn.sweep)
        yield from body(bow_, "couple", turn.marks, k)


class _Arc(NamedTuple):
    """An arc: its centre, its radius, where it begins and how far it goes (degrees), its marks, its letter."""

    vertex: complex
    radius: float
    start: float
    sweep: float
    marks: tuple[Mark, ...]
    letter: str

    @property
    def middle(self) -> complex:
        """Where its letter stands."""
        turn = math.radians(self.start + self.sweep / 2)
        return self.vertex + cmath.rect(self.radius, turn)


def _arcs(made: Transfer, at: _Points, sense: int) -> Iterator[_Arc]:
    """Yield the angles: φ is counted from the dead centre at the cover, as the crank turns."""
    o, a, b, *_ = made.points
    begun = _phase(at.out)
    turned = sense * ((_phase((at.a - at.o) / at.out) * sense) % 360.0)
    yield _Arc(at.o, NEAR, begun, turned, (o, a, b), "φ")
    yield _between(at.b, at.o - at.b, at.a - at.b, OUTER, (a, b, o), "β")
    yield _between(at.a, at.o - at.a, at.a - at.b, NEAR, (o, a, b), "φ + β")


def _between(
    vertex: complex,
    first: complex,
    last: complex,
    radius: float,
    marks: tuple[Mark, ...],
    letter: str,
) -> _Arc:
    sweep = _phase(last / first) if first and last else 0.0
    return _Arc(vertex, radius, _phase(first), sweep, marks, letter)


def _phase(way: complex) -> float:
    return math.degrees(cmath.phase(way))


def _turns(made: Transfer, at: _Points, shown: TransferFigure, seen: Seen) -> Iterator[_Arc]:
    """Yield the arrows of both couples, where no force acts at the bearing: M, and M′ against it."""
    value, o = seen.number(made.moments[0], shown.place), made.points[0]
    if not finite(value, at.a, at.o) or value == 0.0:
        return
    sense = math.copysign(1.0, value) * shown.sense
    above = ((at.a - at.o) / at.out).imag > 0.0
    first, last = (195.0, 250.0) if above else (165.0, 110.0)
    if (last - first) * sense < 0.0:
        first, last = last, first
    begun, sweep = first + _phase(at.out), last - first
    yield _Arc(at.o, INNER, begun, sweep, (o, made.moments[0]), "M")
    yield _Arc(at.o, FAR, begun + sweep, -sweep, (o, made.moments[1]), "M′")


def _letters(
    made: Transfer, at: _Points, shown: TransferFigure, seen: Seen, heights: Heights
) -> Iterator[Wanted]:
    """The letters of pins, angles, of the arm and of the couples."""
    k, (o, a, b, *_) = shown.place, made.points
    for mark, spot, toward in (
        (o, at.o, -1j * at.out),
        (a, at.a, (at.a - at.o) + (at.b - at.a) / 4),
        (b, at.b, 1j * at.out),
    ):
        if finite(spot):
            yield Wanted(markup(mark.letter), spot, heights.point, 2.2, toward, (mark.slot,), k)
    arcs = [one for one in _arcs(made, at, shown.sense) if abs(one.sweep) > LEAST]
    for one in (*arcs, *_turns(made, at, shown, seen)):
        if finite(one.middle):
            slots = tuple(mark.slot for mark in one.marks)
            out = one.middle - one.vertex
            yield Wanted(one.letter, one.middle, heights.number, 0.8, out, slots, k)
    if finite(at.o, at.foot) and abs(at.foot - at.o) > LEAST:
        middle = (at.o + at.foot) / 2
        yield Wanted("h", middle, heights.number, 0.8, at.out, (made.foot.slot,), k)


def _vector_letters(seen: Seen, made: Transfer, k: int, size: float) -> Iterator[Wanted]:
    """The letters of the vectors, at their ends: each nearer to its own than to another."""
    ends = {one.end: (seen.point(one.start, k), seen.point(one.end, k)) for one in made.vectors}
    there = {
        mark: own for mark, own in ends.items() if finite(*own) and abs(own[1] - own[0]) >= LEAST
    }
    for one in made.vectors:
        if one.end not in there:
            continue
        own = there[one.end]
        others = tuple(line for mark, line in there.items() if mark != one.end)
        letter = f"\\bar{{{one.letter[0]}}}{one.letter[1:]}"
        text = f"−{letter}" if one.against else letter
        spot = own[0] + 0.72 * (own[1] - own[0])
        out = outwards(own, others)
        yield Wanted(text, spot, size, 0.8, out, (one.end.slot,), k, own, others)
