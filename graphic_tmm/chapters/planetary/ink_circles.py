"""A planetary train seen along its axis: pitch circles, the carrier, centre lines, the ground of a ring."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise

from graphic_tmm.chapters.planetary.ink_numbers import BESIDE, NUMBER, SIZE, TrainInk
from graphic_tmm.paper.drawing import Stroke, Wanted, circle, line
from graphic_tmm.paper.symbols.gears import CENTRE_BEYOND, RIM
from graphic_tmm.paper.symbols.kinematic import HATCH_DEPTH, hatching, turning_pair

CROWDED = 9.0
"""Between circles nearer than this no number has room, mm."""


def draw_circles(ink: TrainInk) -> list[Stroke]:
    """The view along the axis: pitch circles, the carrier, centre lines, the ground of a fixed ring."""
    c, strokes = ink.centre, []
    strokes.append(line("centre", c - 1j * ink.beyond, c + 1j * ink.beyond))
    strokes.append(circle("centre", c, ink.radius("H")))
    for at in ink.axes:
        way = (at - c) / abs(at - c)
        out = max(ink.radius(w) for w in ink.wheels[1:-1]) + CENTRE_BEYOND
        if abs(way.real) > 1e-9:  # the first one stands on the vertical line
            strokes.append(line("centre", c, at + out * way))
        strokes += [circle("main", at, ink.radius(w)) for w in ink.wheels[1:-1]]
        strokes += [line("rod", c, at), *turning_pair(at)]
    for wheel in ("1", ink.fixed):
        strokes.append(circle("main", c, ink.radius(wheel)))
        if ink.ring(wheel):
            strokes.append(circle("main", c, ink.radius(wheel) + RIM))
    return [*strokes, *_ground(ink), *turning_pair(c)]


def _ground(ink: TrainInk) -> list[Stroke]:
    """Hatching outside a fixed ring, between the centre lines, where nothing else is drawn."""
    radius, strokes = ink.radius(ink.fixed) + RIM, list[Stroke]()
    if not ink.ring(ink.fixed) or ink.radius("1") >= ink.radius(ink.fixed):
        return strokes
    half = math.degrees(8.0 / radius)
    rim = max(ink.radius(w) for w in ink.wheels[1:-1])
    for turn in (45.0, 135.0, 225.0, 315.0):
        ends = [ink.centre + cmath.rect(radius, math.radians(turn + d)) for d in (-half, 0, half)]
        if min(abs(at - z) for at in ink.axes for z in ends) > rim + HATCH_DEPTH:
            strokes += hatching(ends[0], ends[1], -1) + hatching(ends[1], ends[2], -1)
    return strokes


def circle_letters(ink: TrainInk) -> list[Wanted]:
    """The numbers of the wheels, the letters of the centre, of B and of the points of contact."""
    wanted = [Wanted("O", ink.centre, NUMBER, 1.5, -1 + 1j)]
    for name, at in zip("ABC", ink.points, strict=True):
        wanted.append(Wanted(name, at, NUMBER, 1.5, 1 + 1j))
    between = min(180.0 / len(ink.axes), 70.0)
    turns = (90.0 + between, 90.0 - between)
    wanted += _numbers(ink, ink.centre, ("1", ink.fixed), turns)
    wanted += _numbers(ink, ink.axes[0], ink.wheels[1:-1], (135.0, 330.0))
    wanted.append(Wanted("H", _free(ink), SIZE, 0.8, 1j))
    return wanted


def _numbers(
    ink: TrainInk, centre: complex, wheels: Sequence[str], turns: Sequence[float]
) -> list[Wanted]:
    """The numbers of circles about one centre, each on the side where no other circle is near."""
    smaller = min(wheels, key=ink.radius)
    apart = max(ink.radius(w) for w in wheels) - ink.radius(smaller)
    wanted = []
    for wheel, turn in zip(wheels, turns, strict=False):
        inward = wheel == smaller and apart < CROWDED
        out = 0.0 if inward or not ink.ring(wheel) else RIM
        way = cmath.rect(1.0, math.radians(turn))
        at = centre + (ink.radius(wheel) + out) * way
        wanted.append(Wanted(wheel, at, SIZE, BESIDE, -way if inward else way))
    return wanted


def _free(ink: TrainInk) -> complex:
    """The middle of the longest part of the last arm of the carrier that no circle cuts."""
    axis = ink.radius("H")
    cuts = [ink.radius("1"), ink.radius(ink.fixed)]
    cuts += [axis - ink.radius(w) for w in ink.wheels[1:-1]]
    marks = sorted([0.0, axis, *(cut for cut in cuts if 0.0 < cut < axis)])
    low, high = max(pairwise(marks), key=lambda part: round(part[1] - part[0], 6))
    way = (ink.axes[-1] - ink.centre) / axis
    return ink.centre + (low + high) / 2 * way
