"""Where the centre of a cam may stand, in ink: tangents, levers of a rocker, region, radii."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.cam.centre import VIEW, Centre
from graphic_tmm.chapters.cam.ink_rules import (
    OVER,
    POINT,
    CamInk,
    arrow_axis,
    between,
    numbered,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, arc, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.mark_rules import curve, leaving, reached, straight
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, hatching

LEAST = 0.3
"""What is shorter has no dimension, mm."""
BELOW = 30.0
"""How far the limits of the region go on below the point where they meet, mm."""
ABOVE = 12.0
"""How far a tangent goes on behind the point of contact, mm."""
ANGLE = 24.0
"""Radius of the arc that shows an allowed pressure angle, mm."""
ASIDE = 12.0
"""From the outermost point of the curve to the dimension of a radius, mm."""


class CentreNames(NamedTuple):
    """What is lettered: positions, the axes of displacement and derivative, the two radii with their values.

    ``limits``: the allowed pressure angles towards the rise and the return; ``offset``: e with its value.
    """

    positions: Sequence[str]
    up: str
    out: str
    least: str
    r0: str
    limits: tuple[str, str] = ("[α]", "[α]")
    offset: str = "e"


def draw_centre_ink(on: Subject, cam: Cam, names: CentreNames) -> Drawing:
    """Return the S–dS/dφ diagram of a translating roller with the region of allowed centres."""
    made = cam.centre
    assert isinstance(made, Centre)
    ink = _Region(CamInk(on, cam, VIEW), made)
    traces = figure(ink.on, showing(_rules(ink)))
    radii = list(_dimensions(ink, names))
    strokes = [*traces.staying, *added(_axes(ink), "axis"), *_bodies(ink)]
    strokes += [stroke for found, _ in radii for stroke in found]
    labels = [label for _, label in radii if label is not None]
    positions = enumerate(names.positions)
    return traces.drawing(on, strokes, _letters(ink, names), labels, positions)


class _Region:
    """The places of the diagram, mm; ``out``: to which side dS/dφ of the rise is laid off."""

    def __init__(self, on: CamInk, made: Centre) -> None:
        self.on, self.made, self.out = on, made, complex(-on.cam.sense)
        self.points = on.all(made.points)
        side = (self.points * np.conj(self.out)).real
        self.near = float(np.nanmin(side, initial=0.0))
        self.far = float(np.nanmax(side, initial=0.0))
        self.top = float(np.nanmax(self.points.imag, initial=0.0))
        assert made.apex is not None
        self.apex = on.fixed_place(made.apex)
        self.centre, self.least = on.fixed_place(made.centre), on.fixed_place(made.least_centre)
        self.bottom = self._bottom()

    def _bottom(self) -> float:
        """How low the region is drawn."""
        if not finite(self.apex):
            return 0.0
        deepest = [z.imag - ABOVE for z in (self.least, self.centre) if finite(z)]
        return min([0.0, self.apex.imag - BELOW, *deepest])

    @property
    def foot(self) -> complex:
        """How far the line of the centres goes down."""
        if not finite(self.centre):
            return 1j * self.bottom
        return complex(self.centre.real, min(self.centre.imag, self.least.imag) - 3.0)


def _rules(ink: _Region) -> dict[Mark, Rule]:
    """What stays of the steps: the curve with what was laid off to it, the limits, the line of the centres."""
    made = ink.made
    rules: dict[Mark, Rule] = {made.points: reached(POINT), **dict.fromkeys(made.curves, curve())}
    for mark in made.limits:
        spot, way = ink.on.line(mark, 0)
        if finite(spot, ink.apex):
            rules[mark] = straight("main", _down(ink, mark), spot + ABOVE * way)
    down = ink.on.used(made.ends[0])
    rules[down] = straight("centre", complex(ink.foot.real, 8.0), ink.foot)
    return rules


def _down(ink: _Region, limit: Mark) -> complex:
    """Where a limit of the region ends below."""
    spot, way = ink.on.line(limit, 0)
    return spot + way * ((ink.bottom - spot.imag) / way.imag)


def _axes(ink: _Region) -> Iterator[Ink]:
    yield from arrow_axis(ink.out * (ink.near - OVER), ink.out * (ink.far + OVER))
    yield from arrow_axis(0j, complex(0, ink.top + OVER))


def _bodies(ink: _Region) -> Iterator[Ink]:
    """The hatching of the region, the allowed pressure angles, the chosen centre and the least one."""
    made, cam = ink.made, ink.on.cam
    assert made.apex is not None
    for mark, end, phase in zip(made.limits, made.ends, cam.diagrams.turn.ways, strict=True):
        spot, way = ink.on.line(mark, 0)
        if finite(spot, ink.apex):
            side = -1 if phase.sign * cam.sense < 0 else 1
            strokes = hatching(_down(ink, mark), ink.apex, side)
            yield from body(strokes, "hatching", [mark, made.apex])
        at = ink.on.fixed_place(end)
        if finite(at, way):
            bow = arc("thin", at, ANGLE, 90.0, math.degrees(cmath.phase(way / 1j)))
            yield from body([bow], "dimension", [mark, end])
    if finite(ink.least):
        dot = circle("main", ink.least, 0.7, filled=True)
        yield from body([dot], "point", [made.least_centre])
    if finite(ink.centre):
        yield from body([circle("joint", ink.centre, 1.2)], "pivot", [made.centre])


def _dimensions(ink: _Region, names: CentreNames) -> Iterator[tuple[tuple[Ink, ...], Label | None]]:
    """The dimensions of both radii on either side, that of an offset; a radius that leans is a line."""
    made, small = ink.made, ink.on.heights.number
    rows = (
        (made.least_centre, ink.least, names.least, -ink.out, -ink.near),
        (made.centre, ink.centre, names.r0, ink.out, ink.far),
    )
    for mark, spot, text, way, room in rows:
        if not finite(spot):
            continue
        if abs(spot.real) <= LEAST:
            left = 1.0 if (-1j * spot * np.conj(way)).real > 0 else -1.0
            size = dimension(spot, 0j, left * (min(room, 40.0) + ASIDE), text, small)
            strokes, label = list[Ink](size.strokes), size.label
        elif mark == made.centre:
            low = complex(0, spot.imag)
            ends = (low, spot) if spot.real > 0 else (spot, low)
            size = dimension(*ends, -(ABOVE + ASIDE), names.offset, small)
            strokes = [line("thin", spot, 0j), line("thin", 0j, low), *size.strokes]
            label = size.label
        else:
            continue
        of = (mark, made.lowest)
        told = tuple(body(strokes, "dimension", of))
        yield told, label._replace(of=tuple(one.slot for one in of))


def _letters(ink: _Region, names: CentreNames) -> Iterator[Wanted]:
    """The letters of axes and points, the allowed angles, a radius that leans, the numbers of positions."""
    made, point, small = ink.made, ink.on.heights.point, ink.on.heights.number
    yield Wanted(names.up, complex(0, ink.top + OVER), point, 1.5, -ink.out)
    yield Wanted(names.out, ink.out * (ink.far + OVER), point, 1.5, -1j)
    yield Wanted("B_{0}", 0j, small, 1.0, -ink.out - 1j, (made.lowest.slot,))
    rows = (
        (made.least_centre, ink.least, "O_{min}", small, -ink.out),
        (made.centre, ink.centre, "O", point, ink.out),
    )
    for mark, spot, letter, size, way in rows:
        if finite(spot):
            yield Wanted(letter, spot, size, 1.4, way, (mark.slot,))
    if finite(ink.centre) and abs(ink.centre.real) > LEAST:
        yield Wanted(names.r0, 0.45 * ink.centre, small, 0.5, ink.out, (made.centre.slot,))
    for limit, mark, text in zip(made.limits, made.ends, names.limits, strict=True):
        spot, way = ink.on.fixed_place(mark), ink.on.line(limit, 0)[1]
        if finite(spot, way):
            turn = math.radians(90.0) + cmath.phase(way / 1j) / 2
            middle = cmath.rect(ANGLE, turn)
            yield Wanted(text, spot + middle, small, 0.5, middle, (mark.slot, limit.slot))
    toward = ink.points - 0.5j * ink.top
    yield from numbered(ink.on, names.positions, made.points, ink.points, toward)


AROUND = 12.0
"""How far, in degrees, the arc of the centres is drawn behind what stands on it."""
BEYOND = 10.0
"""How far the limit that binds goes on behind the circle of the centres, mm."""
ROCKER_ANGLE = 18.0
"""Radius of the arc that shows the allowed pressure angle, mm."""


class Bound(NamedTuple):
    """A limit below the lowest lever in a position: how far (radians), Q, its end on the circle, its text."""

    turn: float
    position: int
    start: complex
    end: complex
    text: str
    marks: tuple[Mark, Mark]


def draw_rocker_ink(on: Subject, cam: Cam, names: CentreNames) -> Drawing:
    """Return the levers with dS/dφ laid off along them, the limits, and the centres on their circle."""
    made, path = cam.centre, cam.path
    assert isinstance(made, Centre)
    assert isinstance(path, Lever)
    ink = CamInk(on, cam, VIEW)
    bounds = list(_bounds(ink, made, path, names.limits))
    traces = figure(ink, showing(_rocker_rules(ink, made, path, bounds)))
    strokes = (*traces.staying, *_rocker_bodies(ink, made, path, bounds))
    wanted = _rocker_letters(ink, made, path, names, bounds)
    return traces.drawing(on, strokes, wanted, (), enumerate(names.positions))


def _bounds(ink: CamInk, made: Centre, path: Lever, texts: tuple[str, str]) -> Iterator[Bound]:
    """The limits that end on the circle below the lowest lever, by phase and position."""
    points, lowest = ink.all(made.points), ink.fixed_place(made.lowest)
    rows = zip(made.limits, made.ends, texts, ink.cam.diagrams.turn.ways, strict=True)
    for limit, mark, text, phase in rows:
        ends = ink.all(mark)
        for k in ink.cam.diagrams.turn.among(phase):
            q, end = complex(points[k]), complex(ends[k])
            if finite(q, end):
                turn = -path.sense * cmath.phase(end / lowest)
                if turn > 0.0:
                    yield Bound(turn, k, q, end, text, (limit, mark))


def _rocker_rules(ink: CamInk, made: Centre, path: Lever, bounds: list[Bound]) -> dict[Mark, Rule]:
    """What stays of the steps: levers with what was laid off along them, limits, the circle of the centres."""
    roller, lowest = ink.all(made.roller), ink.fixed_place(made.lowest)
    levers, begin = ink.used(made.roller), ink.used(made.lowest)
    spots = [
        *(one.end for one in bounds),
        ink.fixed_place(made.least_centre),
        ink.fixed_place(made.centre),
    ]
    rules: dict[Mark, Rule] = {
        begin: straight("main", 0j, lowest),
        levers: between(np.zeros_like(roller), roller),
        made.points: reached(POINT),
        path.line: straight("thin", 0j, ink.fixed_place(made.centre)),
        ink.used(made.ends[0], 1): leaving(
            *part_of_circle(lowest, ink.fixed_number(path.centres), spots, AROUND)
        ),
    }
    for mark in dict.fromkeys(one.marks[0] for one in bounds):
        own = {one.position: one for one in bounds if one.marks[0] == mark}
        rules[mark] = _limit(own)
    return rules | dict.fromkeys(made.curves, curve())


def _limit(own: dict[int, Bound]) -> Rule:
    """Return the rule of a limit: from Q to the circle, where it ends below the lowest lever."""

    def limit(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        if k in own:
            yield from segment("thin", own[k].start, own[k].end)

    return limit


def part_of_circle(
    lowest: complex, radius: float, spots: list[complex], around: float
) -> Iterator[Ink]:
    """The part of a circle about the pivot on which places stand, and ``around`` (degrees) to either side."""
    turns = [math.degrees(cmath.phase(z / lowest)) for z in spots if finite(z)]
    if turns:
        low, high = min(turns) - around, max(turns) + around
        yield arc("thin", 0j, radius, math.degrees(cmath.phase(lowest)) + low, high - low)


def _rocker_bodies(ink: CamInk, made: Centre, path: Lever, bounds: list[Bound]) -> Iterator[Ink]:
    """The path of the roller, the limit that binds with its angle, the centres, the pivot."""
    lowest, centre, least = (
        ink.fixed_place(mark) for mark in (made.lowest, made.centre, made.least_centre)
    )
    roller = [complex(z) for z in ink.all(made.roller)]
    yield from body(part_of_circle(lowest, abs(lowest), roller, 0.0), "circle", [made.roller])
    if bounds:
        worst = max(bounds)
        yield from body(_binding(worst), "dimension", worst.marks, worst.position)
    if finite(least):
        yield from body([circle("main", least, 0.7, filled=True)], "point", [made.least_centre])
    if finite(centre):
        yield from body([line("thin", lowest, centre)], "dimension", [made.centre])
        yield from body([circle("joint", centre, 1.2)], "pivot", [made.centre])
    yield from body(fixed_pivot(0j), "pivot", [ink.used(made.lowest)])


def _square(bound: Bound) -> tuple[complex, complex]:
    """The direction of a limit, and the path of Q turned to the side of the centre."""
    way = (bound.end - bound.start) / abs(bound.end - bound.start)
    square = 1j * bound.start / abs(bound.start)
    return way, square * (1.0 if (square * way.conjugate()).real > 0 else -1.0)


def _binding(bound: Bound) -> Iterator[Ink]:
    """The limit that binds, heavily, with the path of Q and the angle between them."""
    way, square = _square(bound)
    yield line("main", bound.start - 6.0 * way, bound.end + BEYOND * way)
    yield line("thin", bound.start, bound.start + (ROCKER_ANGLE + 6.0) * square)
    sweep = math.degrees(cmath.phase(way / square))
    yield arc("thin", bound.start, ROCKER_ANGLE, math.degrees(cmath.phase(square)), sweep)


def _rocker_letters(
    ink: CamInk, made: Centre, path: Lever, names: CentreNames, bounds: list[Bound]
) -> Iterator[Wanted]:
    """The letters of the centres and the pivot, the allowed angle, r0, the numbers of the positions."""
    point, small = ink.heights.point, ink.heights.number
    lowest, centre, least = (
        ink.fixed_place(mark) for mark in (made.lowest, made.centre, made.least_centre)
    )
    if bounds:
        worst = max(bounds)
        way, square = _square(worst)
        middle = ROCKER_ANGLE * square * cmath.exp(0.5j * cmath.phase(way / square))
        of = tuple(mark.slot for mark in worst.marks)
        yield Wanted(worst.text, worst.start + middle, small, 0.5, middle, of, worst.position)
    yield Wanted("O_{1}", 0j, point, 2.0, -lowest)
    low = lowest - 1j * abs(lowest)
    yield Wanted("B_{0}", lowest, small, 1.0, low, (made.lowest.slot,))
    if finite(least):
        yield Wanted("O_{min}", least, small, 1.2, least - lowest, (made.least_centre.slot,))
    if finite(centre):
        yield Wanted("O", centre, point, 1.8, centre, (made.centre.slot,))
        yield Wanted(names.r0, (lowest + centre) / 2, small, 0.5, lowest, (made.centre.slot,))
    points = ink.all(made.points)
    toward = points - complex(np.nanmean(points))
    yield from numbered(ink, names.positions, made.points, points, toward)
