"""Where the centre of a cam with a rocking roller may stand, in ink: levers, limits, circle of centres."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.chapters.cam.centre import VIEW, Centre
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_letters import numbered
from graphic_tmm.chapters.cam.ink_rules import (
    CamInk,
    between,
    curve,
    drawn,
    picture,
    reached,
    straight,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Seen, finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot

AROUND = 12.0
"""How far, in degrees, the arc of the centres is drawn behind what stands on it."""
BEYOND = 10.0
"""How far the limit that binds goes on behind the circle of the centres, mm."""
ANGLE = 18.0
"""Radius of the arc that shows the allowed pressure angle, mm."""


class Bound(NamedTuple):
    """A limit below the lowest lever in a position: how far (radians), Q, its end on the circle, its text."""

    turn: float
    position: int
    start: complex
    end: complex
    text: str
    marks: tuple[Mark, Mark]


def draw_rocker_ink(
    construction: Construction,
    reading: Reading,
    cam: Cam,
    names: CentreNames,
    title: str,
    heights: Heights,
) -> Drawing:
    """Return the levers with dS/dφ laid off along them, the limits, and the centres on their circle."""
    made, path = cam.centre, cam.path
    assert isinstance(made, Centre)
    assert isinstance(path, Lever)
    ink = CamInk(construction, reading, cam, VIEW, heights)
    bounds = list(_bounds(ink, made, path, names.limits))
    traces = figure(ink.seen, showing(_rules(ink, made, path, bounds)))
    strokes = (*traces.staying, *_bodies(ink, made, path, bounds))
    wanted = _letters(ink, made, path, names, bounds)
    return picture((VIEW, title), traces, strokes, wanted, names.positions)


def _bounds(ink: CamInk, made: Centre, path: Lever, texts: tuple[str, str]) -> Iterator[Bound]:
    """The limits that end on the circle below the lowest lever, by phase and position."""
    points, lowest = ink.all(made.points), ink.one(made.lowest)
    rows = zip(made.limits, made.ends, texts, ink.cam.diagrams.turn.phases, strict=True)
    for limit, mark, text, phase in rows:
        ends = ink.all(mark)
        for k in range(phase.first, phase.last + 1):
            q, end = complex(points[k]), complex(ends[k])
            if finite(q, end):
                turn = -path.sense * cmath.phase(end / lowest)
                if turn > 0.0:
                    yield Bound(turn, k, q, end, text, (limit, mark))


def _rules(ink: CamInk, made: Centre, path: Lever, bounds: list[Bound]) -> dict[Mark, Rule]:
    """What stays of the steps: levers with what was laid off along them, limits, the circle of the centres."""
    roller, lowest = ink.all(made.roller), ink.one(made.lowest)
    levers, begin = ink.used(made.roller), ink.used(made.lowest)
    spots = [*(one.end for one in bounds), ink.one(made.least_centre), ink.one(made.centre)]
    rules: dict[Mark, Rule] = {
        begin: straight("main", 0j, lowest),
        levers: between(np.zeros_like(roller), roller),
        made.points: reached,
        path.line: straight("thin", 0j, ink.one(made.centre)),
        ink.used(made.ends[0], 1): drawn(*_part(lowest, ink.length(path.centres), spots, AROUND)),
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


def _part(lowest: complex, radius: float, spots: list[complex], around: float) -> Iterator[Ink]:
    """The part of a circle about the pivot on which places stand, and ``around`` (degrees) to either side."""
    turns = [math.degrees(cmath.phase(z / lowest)) for z in spots if finite(z)]
    if turns:
        low, high = min(turns) - around, max(turns) + around
        yield arc("thin", 0j, radius, math.degrees(cmath.phase(lowest)) + low, high - low)


def _bodies(ink: CamInk, made: Centre, path: Lever, bounds: list[Bound]) -> Iterator[Ink]:
    """The path of the roller, the limit that binds with its angle, the centres, the pivot."""
    lowest, centre, least = (
        ink.one(mark) for mark in (made.lowest, made.centre, made.least_centre)
    )
    roller = [complex(z) for z in ink.all(made.roller)]
    yield from body(_part(lowest, abs(lowest), roller, 0.0), "circle", [made.roller])
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
    yield line("thin", bound.start, bound.start + (ANGLE + 6.0) * square)
    sweep = math.degrees(cmath.phase(way / square))
    yield arc("thin", bound.start, ANGLE, math.degrees(cmath.phase(square)), sweep)


def _letters(
    ink: CamInk, made: Centre, path: Lever, names: CentreNames, bounds: list[Bound]
) -> Iterator[Wanted]:
    """The letters of the centres and the pivot, the allowed angle, r0, the numbers of the positions."""
    point, small = ink.heights.point, ink.heights.number
    lowest, centre, least = (
        ink.one(mark) for mark in (made.lowest, made.centre, made.least_centre)
    )
    if bounds:
        worst = max(bounds)
        way, square = _square(worst)
        middle = ANGLE * square * cmath.exp(0.5j * cmath.phase(way / square))
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
