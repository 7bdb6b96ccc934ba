"""The plan of positions in ink: one position in heavy lines, the others thin; trajectories, numbers.

The steps of the plan, and of the extreme positions before it, are drawn with compass and square and rubbed out
again; what stays is the paths of points and the bodies that the plan tells.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.ink_numbers import (
    PIN,
    Letters,
    guide_names,
    letters_apart,
    link_numbers,
    path_numbers,
)
from graphic_tmm.chapters.kinematics.reaches import VIEW as PLAN
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.task import EXTREMES
from graphic_tmm.paper.drawing import Drawing, Ink, Stroke, Wanted, circle
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.seen import Seen, Subject
from graphic_tmm.paper.symbols.kinematic import GROUND_LENGTH, fixed_pivot, round_arrow

SWEEP = 70.0
"""The arrow of ω1 goes over so many degrees."""
AHEAD = 20.0
"""So many degrees ahead of the crank it begins at least, and that of ε1 behind it."""
PAIR = 2.2
"""How far the sign of a pair reaches, with some room, mm."""
FULL, THIN = ("medium", "medium"), ("thin", "thin")
"""Pens of rods and of guides in extreme positions, and in all others that are not the main one."""


class PositionsFigure(NamedTuple):
    """What the plan of positions shows: the positions' names; by index the one drawn heavy, ``main``.

    ``skipped``: those that cannot be drawn, ``extremes``: those in full line. ``crank``: the marks of its pivot
    and pin, ``sense``: of its rotation, ``gaining``: of its angular acceleration, 0 if it has none; ``driver``:
    the number of its link.
    """

    names: Sequence[str]
    main: int
    skipped: Sequence[int]
    crank: tuple[Mark, Mark]
    sense: int
    driver: int = 1
    extremes: Sequence[int] = ()
    gaining: int = 0


def draw_positions_ink(
    on: Subject, reaches: Mapping[Figure, Reach], shown: PositionsFigure
) -> Drawing:
    """Return the plan of positions; ``reaches``: how far each guide is used, mm."""
    names, main, crank, sense = shown.names, shown.main, shown.crank, shown.sense
    point, small = on.heights.point, on.heights.number
    places = [i for i in range(len(names)) if i not in shown.skipped]
    ink = PositionsInk(on.construction, on.reading, reaches, places)
    traces = figure(ink.seen, Manner({french_curve.name: curve("thin")}, path_stays))
    strokes: list[Ink] = [*ink.guides(), *ink.crank_circle(crank), *traces.staying]
    full = [index for index in shown.extremes if index in places and index != main]
    for index in places:
        if index != main:
            strokes += ink.thin(index, FULL if index in full else THIN)
    strokes += ink.heavy(main)
    turns = [(f"ω_{shown.driver}", ink.bow(crank, sense, main), sense)]
    if shown.gaining:
        gain = ink.gain(crank, sense, main, shown.gaining)
        turns.append((f"ε_{shown.driver}", gain, shown.gaining))
    for _, bow, way in turns:
        strokes += body(
            round_arrow(bow.centre, bow.radius, bow.start, way * SWEEP), "turning", crank, main
        )
    letters = ink.letters((ink.frame.name, *ink.names), main, point)
    apart = letters_apart(ink, crank, names, places, (small, point))
    pins = ink.numbers(crank, names, apart)
    of = tuple(mark.slot for mark in crank)
    speeds = [Wanted(n, b.middle, point, 1.0, b.out, of, main) for n, b, _ in turns]
    wanted = [
        *letters,
        *speeds,
        *pins,
        *guide_names(ink, main, small),
        *path_numbers(ink, crank, names, places, [main, *full], apart),
    ]
    circled = link_numbers(ink, main, strokes, [*letters, *speeds, *pins], small)
    strokes += [stroke for one in circled for stroke in one.strokes]
    labels, positions = [one.label for one in circled], ((k, names[k]) for k in ink.places)
    return traces.drawing(on, strokes, wanted, labels, positions)._replace(name=PLAN)


def draw_position_ink(
    on: Subject, reaches: Mapping[Figure, Reach], index: int, upon: Sequence[Stroke] = ()
) -> Drawing:
    """Return the plan of one position by itself.

    ``upon``: what is drawn over the plan; letters stay clear of it.
    """
    ink = PositionsInk(on.construction, on.reading, reaches, [index])
    traces = figure(ink.seen, Manner(stays=lambda _, step: False))
    strokes = (*ink.guides(), *ink.heavy(index), *upon)
    letters = ink.letters((ink.frame.name, *ink.names), index, on.heights.point)
    return traces.drawing(on, strokes, letters)


def path_stays(seen: Seen, step: Step) -> bool:
    """Whether what a step leaves is there at the end: only the paths of points are."""
    return step.it.kind is Curve


def clear_start(reach: float, bearing: float, sense: int, first: float = AHEAD) -> float:
    """Return where the arrow of ω1 begins (degrees): ahead of the crank, clear of the foot of its pivot.

    ``first``: so many degrees ahead, or more.
    """
    starts = np.arange(first, max(first + 1.0, 341.0 - SWEEP), 10.0) * sense + bearing

    def clear(start: float) -> bool:
        turns = np.radians(start + sense * np.linspace(-5.0, SWEEP + 5.0, 15))
        x, y = reach * np.cos(turns), reach * np.sin(turns)
        below = (np.abs(x) < GROUND_LENGTH / 2 + 1.0) & (y < 0.0)
        return not below.any()

    return float(next((start for start in starts if clear(start)), starts[0]))


class Bow(NamedTuple):
    """The arrow of ω1: about what, mm, from where (degrees); its middle, and the way out from there."""

    centre: complex
    radius: float
    start: float
    middle: complex
    out: complex


class PositionsInk(LinksInk):
    """The plan of positions while it is inked: the links in their ``places``, and what stands about them."""

    def __init__(
        self,
        construction: Construction,
        reading: Reading,
        reaches: Mapping[Figure, Reach],
        places: list[int],
    ) -> None:
        super().__init__(construction, reading, reaches)
        self.places = places
        self.seen = Seen(construction, reading, (EXTREMES, PLAN), places)

    def heavy(self, index: int) -> list[Ink]:
        """The whole mechanism in one position: links, what slides, pivots."""
        strokes = [s for name in self.names for s in self.lines(name, index, MAIN)]
        return [*strokes, *self.symbols(self.names, index), *self.pivots()]

    def thin(self, index: int, pens: tuple[str, str] = THIN) -> list[Ink]:
        """The whole mechanism in another position, in lines only."""
        return [
            stroke
            for name in self.names
            for stroke in (*self.lines(name, index, pens), *self.notches(name, index))
        ]

    def pivots(self) -> list[Ink]:
        """The points of the frame: the fixed pivots, and others as what they are."""
        made = list[Ink]()
        for mark in self.frame.marks:
            if mark in self.joined:
                made += body(fixed_pivot(self.at(mark, 0)), "pivot", [mark])
            else:
                made += self.point(mark, None)
        return made

    def crank_circle(self, crank: tuple[Mark, Mark]) -> list[Ink]:
        """The circle on which the crank pin moves."""
        pivot, pin = (self.at(mark, self.places[0]) for mark in crank)
        return [*body([circle("thin", pivot, abs(pin - pivot))], "circle", crank)]

    def bow(self, crank: tuple[Mark, Mark], sense: int, main: int) -> Bow:
        """Where the arrow stands that tells which way the crank turns."""
        return self._bow(crank, sense, main, AHEAD)

    def gain(self, crank: tuple[Mark, Mark], sense: int, main: int, gaining: int) -> Bow:
        """Where that of its angular acceleration stands: behind the other, one way or the other."""
        pivot, pin = (self.at(mark, main) for mark in crank)
        ahead = sense * (
            self.bow(crank, sense, main).start - math.degrees(cmath.phase(pin - pivot))
        )
        found = self._bow(crank, sense, main, ahead + SWEEP + AHEAD)
        return found if gaining == sense else found._replace(start=found.start + sense * SWEEP)

    def _bow(self, crank: tuple[Mark, Mark], sense: int, main: int, first: float) -> Bow:
        pivot, pin = (self.at(mark, main) for mark in crank)
        reach = min(10.0, 0.6 * abs(pin - pivot))
        bearing = float(np.degrees(np.angle(pin - pivot)))
        start = clear_start(reach, bearing, sense, first)
        out = cmath.rect(1.0, math.radians(start + sense * SWEEP / 2))
        return Bow(pivot, reach, start, pivot + reach * out, out)

    def letters(self, names: Sequence[str], main: int, size: float = 5.0) -> list[Wanted]:
        """The letters of links in the main position; points at one place share a label."""
        told = [f for name in names for f in self.of(name, "frame", "link", "centre")]
        marks = dict.fromkeys(mark for one in told for mark in one.marks)
        spots = (Named(self.at(m, main), markup(m.name), (m.slot,), main) for m in marks)
        return lettered(shared(spots), size, PAIR)

    def numbers(
        self, crank: tuple[Mark, Mark], names: Sequence[str], letters: Letters
    ) -> list[Wanted]:
        """The numbers of the positions, outside the circle of the crank pin.

        A position besides the row, 6*, shares the label of one whose pin is at most a digit off.
        """
        pivot, pin = crank
        row = [k for k in self.places if _of_row(names[k])]
        shared = {k: [k] for k in row}
        for extra in (k for k in self.places if k not in shared):
            away = {k: abs(self.at(pin, k) - self.at(pin, extra)) for k in row}
            near = min(away, key=away.__getitem__, default=extra)
            own = near if away.get(near, 0.0) <= letters.small else extra
            shared.setdefault(own, []).append(extra)
        wanted = []
        for first, those in shared.items():
            at = self.at(pin, first)
            told, size = letters.of(pin, ", ".join(names[k] for k in those))
            out = at - self.at(pivot, first)
            wanted.append(Wanted(told, at, size, PIN, out, (pin.slot,), max(those)))
        return wanted


def _of_row(name: str) -> bool:
    """Whether a position divides the turn: 6, or 6, 18 where it comes again; and not 6*."""
    return all(part.isdecimal() for part in name.split(", "))
