"""A planetary train seen along its axis: pitch circles, the carrier, centre lines, the ground of a ring."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.planetary.ink_numbers import BESIDE, OVER, TrainInk
from graphic_tmm.paper.drawing import Ink, Wanted, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.seen import Rule, Seen
from graphic_tmm.paper.symbols.gears import CENTRE_BEYOND, RIM, ring_ground
from graphic_tmm.paper.symbols.kinematic import HATCH_DEPTH, turning_pair

CROWDED = 9.0
"""Between circles nearer than this no number has room, mm."""


def pitch_circle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The pitch circle of a wheel."""
    yield circle("main", *seen.arc(step.it, k))


def circle_rules(ink: TrainInk) -> dict[Mark, Rule]:
    """What stays of the view along the axis: circles, centre lines, the levels of A, B and C."""
    end, c = ink.made.end, ink.centre
    ways = ink.seen.by_mark[end.satellites].uses[0]
    out = max(ink.radius(w) for w in ink.wheels[1:-1]) + CENTRE_BEYOND

    def main_axis(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        right = complex(ink.scheme.right + OVER, c.imag)
        yield line("centre", c - ink.beyond, right)
        yield line("thin", right, ink.zeros[0])

    def below(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield line("centre", c, c - 1j * ink.beyond)

    def through_satellite(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        at, way = seen.point(end.satellites, k), seen.line(step.it, k)[1]
        above = abs(way.real) < 1e-9 and way.imag > 0.0
        yield line("centre", c, c + 1j * ink.beyond if above else at + out * way)

    rules: dict[Mark, Rule] = dict.fromkeys(end.circles.values(), pitch_circle)
    rules |= {end.axis: main_axis, end.up: below, ways: through_satellite}
    return rules | {
        level: _carried(a, b)
        for level, a, b in zip(end.levels, ink.points, ink.zeros[1:], strict=True)
    }


def _carried(start: complex, end: complex) -> Rule:
    """A level, from its point to the zero line of the picture."""

    def level(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield line("thin", start, end)

    return level


def draw_circle_bodies(ink: TrainInk) -> Iterator[Ink]:
    """The carrier, the rims of rings and the ground of a fixed one, as the plan tells them."""
    c = ink.centre
    for carrier in ink.figures("carrier"):
        origin, satellites = carrier.marks
        yield from body([circle("centre", c, ink.radius("H"))], "axis", [satellites])
        for k, at in zip(ink.seen.positions, ink.axes, strict=True):
            yield from body([line("rod", c, at), *turning_pair(at)], "carrier", carrier.marks, k)
        yield from body(turning_pair(c), "pivot", [origin])
    for ring in ink.figures("ring"):
        radius = ink.radius(ring.name) + RIM
        yield from body([circle("main", c, radius)], "ring", ring.marks)
        if ring.name == ink.fixed:
            yield from body(ring_ground(c, radius), "hatching", ring.marks)


def circle_letters(ink: TrainInk) -> list[Wanted]:
    """The numbers of the wheels, the letters of the centre, of B and of the points of contact.

    C stands on the fixed wheel: where that is a ring, below it, off its ground.
    """
    end, small = ink.made.end, ink.heights.point
    wanted = [Wanted("O", ink.centre, small, 1.5, -1 + 1j, (end.origin.slot,))]
    for name, at, mark in zip("ABC", ink.points, end.points, strict=True):
        below = name == "C" and ink.ring(ink.fixed)
        wanted.append(Wanted(name, at, small, 1.5, 1 - 1j if below else 1 + 1j, (mark.slot,)))
    between = min(180.0 / len(ink.axes), 70.0)
    turns = (90.0 + between, 90.0 - between)
    wanted += _numbers(ink, ink.centre, ("1", ink.fixed), turns)
    wanted += _numbers(ink, ink.axes[0], ink.wheels[1:-1], (135.0, 330.0))
    of = (end.satellites.slot,)
    last = ink.seen.positions[-1]
    wanted.append(Wanted("H", _free(ink), ink.heights.point, 0.8, 1j, of, last))
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
        if out and wheel == ink.fixed:
            out += HATCH_DEPTH
        way = cmath.rect(1.0, math.radians(turn))
        at = centre + (ink.radius(wheel) + out) * way
        of = (ink.made.end.circles[wheel].slot,)
        toward = -way if inward else way
        wanted.append(Wanted(wheel, at, ink.heights.point, BESIDE, toward, of))
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
