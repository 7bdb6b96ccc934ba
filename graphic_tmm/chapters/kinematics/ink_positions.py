"""The plan of positions in ink: one position in heavy lines, the others thin; trajectories, numbers.

The steps of the plan, and of the extreme positions before it, are drawn with compass and square and rubbed out
again; what stays is the paths of points and the bodies that the plan tells.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import arc_through, french_curve, open_curve
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.ink_numbers import (
    PIN,
    Letters,
    guide_names,
    letters_apart,
    link_numbers,
    path_numbers,
)
from graphic_tmm.chapters.kinematics.ink_wheels import runs, wheels
from graphic_tmm.chapters.kinematics.reaches import VIEW as PLAN
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.task import EXTREMES
from graphic_tmm.mechanism.records import Drive
from graphic_tmm.paper.drawing import Drawing, Ink, Stroke, Wanted, arc, circle
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import GROUND_LENGTH, fixed_pivot, round_arrow

SWEEP = 70.0
"""The arrow of ω1 goes over so many degrees."""
BESIDE, LONG = 9.0, 12.0
"""How far the arrow of what slides stands beside it, and how long it is, mm."""
AHEAD = 20.0
"""So many degrees ahead of the crank it begins at least, and that of ε1 behind it."""
PAIR = 2.2
"""How far the sign of a pair reaches, with some room, mm."""
FULL, THIN = ("medium", "medium"), ("thin", "thin")
"""Pens of rods and of guides in extreme positions, and in all others that are not the main one."""


class PositionsFigure(NamedTuple):
    """What the plan of positions shows: the positions' names; by index the one drawn heavy, ``main``.

    ``skipped``: those that cannot be drawn, ``extremes``: those in full line. ``led``: the mark that the drive
    leads, and before it the one that it is led about. ``whole``: the row is a turn, or turns. ``turns``: the
    names at the pin of the crank, with those of later turns; along paths stand those of the first one.
    """

    names: Sequence[str]
    main: int
    skipped: Sequence[int]
    led: tuple[Mark, Mark]
    extremes: Sequence[int] = ()
    whole: bool = True
    turns: Sequence[str] = ()


def draw_positions_ink(
    on: Subject,
    reaches: Mapping[Figure, Reach],
    shown: PositionsFigure,
    pairs: Sequence[DrivenPair],
    positions: Positions,
) -> Drawing:
    """Return the plan of positions; ``reaches``: how far each guide is used, mm."""
    names, main, led = shown.turns or shown.names, shown.main, shown.led
    point, small = on.heights.point, on.heights.number
    places = [i for i in range(len(names)) if i not in shown.skipped]
    ink = PositionsInk(on.construction, on.reading, reaches, places)
    traces = figure(ink.seen, Manner(PATHS, path_stays))
    strokes: list[Ink] = [
        *ink.guides(),
        *ink.crank_circles(_arms(pairs, positions), whole=shown.whole),
        *traces.staying,
    ]
    full = [index for index in shown.extremes if index in places and index != main]
    for index in places:
        if index != main:
            strokes += ink.thin(index, FULL if index in full else THIN)
    strokes += ink.heavy(main)
    arrows = list(ink.arrows(pairs, positions, main, point))
    for one in arrows:
        strokes += one.strokes
    letters = ink.letters((ink.frame.name, *ink.names), main, point)
    apart = letters_apart(ink, led, names, places, (small, point))
    pins = ink.numbers(led, names, apart)
    speeds = [one.wanted for one in arrows]
    wanted = [
        *letters,
        *speeds,
        *pins,
        *guide_names(ink, main, small),
        *path_numbers(ink, led, shown.names, places, [main, *full], apart),
    ]
    circled = link_numbers(ink, main, strokes, [*letters, *speeds, *pins], small)
    strokes += [stroke for one in circled for stroke in one.strokes]
    labels, numbered = [one.label for one in circled], ((k, names[k]) for k in ink.places)
    return traces.drawing(on, strokes, wanted, labels, numbered)._replace(name=PLAN)


def _arms(pairs: Sequence[DrivenPair], positions: Positions) -> list[tuple[Mark, ...]]:
    return [ends for ends in (pair.arm_ends(positions) for pair in pairs) if ends]


def draw_position_ink(
    on: Subject, reaches: Mapping[Figure, Reach], index: int, upon: Sequence[Ink] = ()
) -> Drawing:
    """Return the plan of one position by itself.

    ``upon``: what is drawn over the plan; letters stay clear of it.
    """
    ink = PositionsInk(on.construction, on.reading, reaches, [index])
    traces = figure(ink.seen, Manner(stays=lambda _, step: False))
    strokes = (*ink.guides(), *ink.heavy(index), *upon)
    letters = ink.letters((ink.frame.name, *ink.names), index, on.heights.point)
    return traces.drawing(on, strokes, letters)


def swept(centre: complex, radius: float, spots: Sequence[complex]) -> Stroke:
    """Return the arc on which a point stands in these places, one near the next."""
    way = np.degrees(np.unwrap([cmath.phase(z - centre) for z in spots]))
    start, end = (float(way[k]) for k in sorted((int(way.argmin()), int(way.argmax()))))
    return arc("thin", centre, radius, start, end - start)


def _round(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The path of a point about a pivot: as far as it goes over the row; a circle where it goes all round."""
    centre, radius = seen.arc(step.it, k)
    spots = {at: seen.point(step.uses[1], at) for at in seen.positions}
    if not finite(centre, radius, *spots.values()) or len(spots) < 2:
        return
    turn = [cmath.phase(z - centre) for at, z in spots.items() if at < step.choice["turn"]]
    way = np.unwrap([*turn, *turn[:1]])
    whole = bool(turn) and abs(way[-1] - way[0]) > math.pi
    path = circle("thin", centre, radius) if whole else swept(centre, radius, [*spots.values()])
    yield path._replace(title=step.it.name)


PATHS: Mapping[str, Rule] = {
    french_curve.name: curve("thin"),
    open_curve.name: curve("thin"),
    arc_through.name: _round,
}
"""What draws the paths of points."""


def path_stays(seen: Seen, step: Step) -> bool:
    """Whether what a step leaves is there at the end: only the paths of points are."""
    return step.op.name in PATHS


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


class Arrow(NamedTuple):
    """An arrow of a drive and its letter."""

    strokes: tuple[Ink, ...]
    wanted: Wanted


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
        strokes = [*wheels(self, (self.frame.name, *self.names), index), *runs(self, index)]
        strokes += [s for name in self.names for s in self.lines(name, index, MAIN)]
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
                support = fixed_pivot(self.at(mark, 0), self.supports[mark])
                made += body(support, "pivot", [mark])
            else:
                made += self.point(mark, None)
        return made

    def crank_circles(self, arms: Iterable[Sequence[Mark]], *, whole: bool) -> list[Ink]:
        """The circles on which crank pins move; of a row that is no ``whole`` turn the arcs of it."""
        drawn = list[Ink]()
        for crank in arms:
            pivot, pin = (self.at(mark, self.places[0]) for mark in crank)
            path = circle("thin", pivot, abs(pin - pivot))
            if not whole:
                spots = [self.at(crank[1], k) for k in self.places]
                path = swept(pivot, abs(pin - pivot), spots)
            drawn += body([path], "circle", crank)
        return drawn

    def arrows(
        self, pairs: Iterable[DrivenPair], positions: Positions, main: int, size: float
    ) -> Iterator[Arrow]:
        """Yield the arrows that tell which way each drive goes, and whether it gains speed."""
        for pair in (one for one in pairs if one.drive.speed):
            arm = pair.arm_ends(positions)
            yield from (
                self._turns(pair.drive, arm, main, size)
                if arm
                else self._slides(pair, positions, main, size)
            )

    def _turns(self, drive: Drive, arm: Sequence[Mark], main: int, size: float) -> Iterator[Arrow]:
        sense, gains = drive.sense, int(np.sign(drive.acceleration))
        first = self._bow(arm, sense, main, AHEAD)
        bows = [(f"ω_{drive.link}", first, sense)]
        if gains:
            bows.append((f"ε_{drive.link}", self._gain(arm, first, sense, main, gains), gains))
        for letter, bow, way in bows:
            strokes = round_arrow(bow.centre, bow.radius, bow.start, way * SWEEP)
            of = tuple(mark.slot for mark in arm)
            wanted = Wanted(letter, bow.middle, size, 1.0, bow.out, of, main)
            yield Arrow(tuple(body(strokes, "turning", arm, main)), wanted)

    def _slides(
        self, pair: DrivenPair, positions: Positions, main: int, size: float
    ) -> Iterator[Arrow]:
        """Arrows beside what slides: of its speed, and behind that of its acceleration."""
        start, end = pair.led(positions)
        path = pair.path(positions, self._uses)
        way = self.way(path, main)
        at, beside = self.at(end, main), 1j * way if (1j * way).imag >= 0.0 else -1j * way
        rows = [(pair.speed_letter, pair.drive.sense, BESIDE)]
        if pair.drive.acceleration:
            gains = int(np.sign(pair.drive.acceleration))
            rows.append((pair.gain_letter, gains, BESIDE + 2.0 * size))
        for letter, sense, off in rows:
            tail = at + off * beside - 0.5 * sense * LONG * way
            strokes = arrow(tail, tail + sense * LONG * way, "thin")
            wanted = Wanted(letter, at + off * beside, size, 1.0, beside, (end.slot,), main)
            yield Arrow(tuple(body(strokes, "sliding", (start, end), main)), wanted)

    def _uses(self, mark: Mark) -> tuple[Mark, ...]:
        step = self.construction.step(mark)
        return step.uses if step is not None else ()

    def _gain(self, crank: Sequence[Mark], first: Bow, sense: int, main: int, gaining: int) -> Bow:
        """Where the arrow of angular acceleration stands: behind the other, one way or the other."""
        pivot, pin = (self.at(mark, main) for mark in crank)
        ahead = sense * (first.start - math.degrees(cmath.phase(pin - pivot)))
        found = self._bow(crank, sense, main, ahead + SWEEP + AHEAD)
        return found if gaining == sense else found._replace(start=found.start + sense * SWEEP)

    def _bow(self, crank: Sequence[Mark], sense: int, main: int, first: float) -> Bow:
        pivot, pin = (self.at(mark, main) for mark in crank)
        reach = min(10.0, 0.6 * abs(pin - pivot))
        bearing = float(np.degrees(np.angle(pin - pivot)))
        foot = self.supports.get(crank[0], 0.0)
        start = clear_start(reach, bearing - foot, sense, first) + foot
        out = cmath.rect(1.0, math.radians(start + sense * SWEEP / 2))
        return Bow(pivot, reach, start, pivot + reach * out, out)

    def letters(self, names: Sequence[str], main: int, size: float = 5.0) -> list[Wanted]:
        """The letters of links in the main position; points at one place share a label."""
        told = [f for name in names for f in self.of(name, "frame", "link", "centre", "wheel")]
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
