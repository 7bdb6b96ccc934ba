"""The planetary train in ink: circles and scheme on one axis, velocities beside them, their plan below."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.trains.formulas import next_satellite
from graphic_tmm.chapters.trains.ink_pairs import occupied, racks_of, wheels_of
from graphic_tmm.chapters.trains.ink_rates import (
    draw_pole,
    picture_letters,
    picture_rules,
    rate_letters,
    rate_rules,
)
from graphic_tmm.chapters.trains.ink_scheme import (
    ASIDE,
    OVER,
    TrainInk,
    draw_scheme,
    spots,
)
from graphic_tmm.chapters.trains.pictures import VIEW
from graphic_tmm.chapters.trains.plan import Planetary
from graphic_tmm.chapters.trains.rates import RATES, VELOCITIES
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, circle, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.mark_rules import leaving
from graphic_tmm.paper.rules import rule_of
from graphic_tmm.paper.seen import Rule, Seen, Subject
from graphic_tmm.paper.shapes import box, outline, shape
from graphic_tmm.paper.symbols.kinematic import (
    CENTRE_BEYOND,
    HATCH_DEPTH,
    RIM,
    ring_ground,
    turning_pair,
)
from graphic_tmm.paper.views import wrapped

CROWDED = 9.0
"""Between circles nearer than this no number has room, mm."""


def pitch_circle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The pitch circle of a wheel."""
    yield circle("main", *seen.arc(step.it, k))


def circle_rules(ink: TrainInk) -> dict[Mark, Rule]:
    """What stays of the view along the axis: circles, centre lines, the levels of A, B and C."""
    end, c = ink.made.end, ink.centre
    ways = ink.seen.by_mark[end.satellites].uses[0]
    out = max(ink.radius(w) for w in ink.rims) + CENTRE_BEYOND

    def main_axis(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        right = complex(ink.scheme.right + OVER, c.imag)
        yield line("centre", c - ink.beyond, right)
        yield line("thin", right, ink.zeros["O"])

    def below(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield line("centre", c, c - 1j * ink.beyond)

    def through_satellite(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        at, way = seen.point(end.satellites, k), seen.line(step.it, k)[1]
        above = abs(way.real) < 1e-9 and way.imag > 0.0
        yield line("centre", c, c + 1j * ink.beyond if above else at + out * way)

    rules: dict[Mark, Rule] = dict.fromkeys(end.circles.values(), pitch_circle)
    rules |= {end.axis: main_axis, end.up: below, ways: through_satellite}
    return rules | {
        level: leaving(line("thin", ink.points[at], ink.zeros[at]))
        for at, level in end.levels.items()
    }


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

    A letter on a ring stands below it, off its ground.
    """
    end, small = ink.made.end, ink.heights.point
    wanted = [Wanted("O", ink.centre, small, 1.5, -1 + 1j, (end.origin.slot,))]
    spots = ink.made.train.scheme.spots
    for name, mark in end.points.items():
        below = name > "B" and ink.ring(spots[name])
        toward = 1 - 1j if below else 1 + 1j
        wanted.append(Wanted(name, ink.points[name], small, 1.5, toward, (mark.slot,)))
    between = min(180.0 / len(ink.axes), 70.0)
    third = 3.0 * between if len(ink.axes) > 2 else 180.0 + between
    turns = (90.0 + between, 90.0 - between, 90.0 + third)
    wanted += _tooth_numbers(ink, ink.centre, ink.central, turns)
    wanted += _tooth_numbers(ink, ink.axes[0], ink.rims, (135.0, 330.0))
    of = (end.satellites.slot,)
    last = ink.seen.positions[-1]
    wanted.append(Wanted("H", _free(ink), ink.heights.point, 0.8, 1j, of, last))
    return wanted


def _tooth_numbers(
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
        wanted.append(Wanted(wheel, at, ink.heights.point, ASIDE, toward, of))
    return wanted


def _free(ink: TrainInk) -> complex:
    """The middle of the longest part of the last arm of the carrier that no circle cuts."""
    axis = ink.radius("H")
    cuts = [*map(ink.radius, ink.central), *(axis - ink.radius(w) for w in ink.rims)]
    marks = sorted([0.0, axis, *(cut for cut in cuts if 0.0 < cut < axis)])
    low, high = max(pairwise(marks), key=lambda part: round(part[1] - part[0], 6))
    way = (ink.axes[-1] - ink.centre) / axis
    return ink.centre + (low + high) / 2 * way


VIEWS = (VIEW, VELOCITIES, RATES)
"""The plans that are drawn as one."""
TRACELESS = frozenset({next_satellite.name})
"""Operations that leave no trace: the axis of a satellite is there already."""
PITCH = 0.6
"""Clear height between the lines of a caption, of the height of its letters."""
COLUMN = 24.0
"""Lines below the plan of rates wider than it are broken, but not into shorter ones; of their height."""
BELOW = (5.0, 7.5, 9.0)
"""From the views, the axis and the pole down to their captions, mm."""
CLEAR = 2.0
"""From what stands left of the caption of a picture to it, mm."""
HEAVY = ("main", "medium", "rod", "joint")
"""The pens of lines that no caption may stand on."""


class Captions(NamedTuple):
    """Lines of lettering (mark-up) below the two views, the picture of velocities, the plan of rates."""

    views: Sequence[str] = ()
    velocities: Sequence[str] = ()
    rates: Sequence[str] = ()


def draw_planetary_ink(on: Subject, made: Planetary, captions: Captions) -> Drawing:
    """Return the train in two views with the picture of linear and the plan of angular velocities.

    The first line of each caption is its title.
    """
    ink = TrainInk(on.seen(VIEWS, range(made.train.satellites)), made, on.heights)
    traces = figure(ink.seen, showing(circle_rules(ink) | picture_rules(ink) | rate_rules(ink)))
    strokes = (*traces.staying, *draw_circle_bodies(ink), *_scheme(ink), *draw_pole(ink))
    wanted = [*_numbers(ink), *circle_letters(ink), *picture_letters(ink), *rate_letters(ink)]
    labels = with_steps(ink, _captions(ink, captions, strokes))
    positions = ((k, str(k + 1)) for k in ink.seen.positions)
    return traces.drawing(on, strokes, wanted, labels, positions)


def _bodies(ink: TrainInk) -> Mapping[str, tuple[Mark, ...]]:
    """What the bodies of the scheme stand on, by their names."""
    told = [figure for kind in ("disc", "pair", "arm") for figure in ink.figures(kind)]
    marks = {figure.name: figure.marks for figure in told}
    return marks | {rack: marks[on] for rack, (on, _) in racks_of(ink.scheme.outside).items()}


def _scheme(ink: TrainInk) -> Iterator[Ink]:
    marks = _bodies(ink)
    rims = [mark for wheel in ink.rims for mark in marks[wheel]]
    for name, strokes in draw_scheme(ink.scheme):
        on = (*rims, *marks[name]) if name == "H" else marks[name]
        yield from body(strokes, "carrier" if name == "H" else "wheel", on)


def _numbers(ink: TrainInk) -> Iterator[Wanted]:
    """The numbers of the wheels in the scheme, the letter of its carrier."""
    marks = _bodies(ink)
    for name, (at, toward) in spots(ink.scheme).items():
        of = tuple(mark.slot for mark in marks[name])
        yield Wanted(name, at, ink.heights.point, ASIDE, toward, of)


def with_steps(ink: TrainInk, captions: Sequence[Sequence[Label]]) -> Iterator[Label]:
    """Yield the captions: titles and scales come with the first step of a picture, results with its last."""
    for view, lines in zip(VIEWS, captions, strict=True):
        steps = [step.it.slot for step in ink.seen.steps if step.it.view == view and rule_of(step)]
        for k, one in enumerate(lines):
            yield one._replace(of=(steps[0 if k < 2 else -1],) if steps else ())


def _captions(ink: TrainInk, captions: Captions, strokes: Sequence[Ink]) -> list[list[Label]]:
    """The captions: below the two views, between picture and plan, below the plan.

    One that would stand on another, on a line or on a wheel outside the train goes below it; that of the
    picture to the right of it, clear of the scheme.
    """
    picture = [z.real for z in (*ink.zeros.values(), *ink.tips.values())]
    rates = [z.real for z in (ink.foot, *ink.ends.values())]
    views = [ink.centre.real - ink.beyond, ink.scheme.right]
    low = min(
        [
            ink.centre.imag - ink.beyond,
            *(side.far.imag for side in wheels_of(ink.scheme.outside).values()),
        ]
    )
    heights = (low, ink.centre.imag, ink.pole.imag)
    wide = max(max(rates) - min(rates), COLUMN * ink.heights.point)
    labels: list[list[Label]] = []
    taken: list[BaseGeometry] = [shapely.box(*sides) for sides in occupied(ink.scheme.outside)]
    heavy = (one for one in strokes if one.pen in HEAVY)
    taken += [shape(one) for one in heavy if np.isfinite(outline(one)).all()]
    for lines, xs, y, down, most in zip(
        captions, (views, picture, rates), heights, BELOW, (math.inf, math.inf, wide), strict=True
    ):
        sizes = (ink.heights.title, *[ink.heights.point] * len(lines))
        told = [
            (part, size)
            for text, size in zip(lines, sizes, strict=False)
            for part in in_lines(text, size, most)
        ]
        block = _clear(told, complex((min(xs) + max(xs)) / 2, y - down), taken, xs is picture)
        labels.append(block)
        taken += [box(one) for one in block]
    return labels


def _clear(
    lines: Sequence[tuple[str, float]], at: complex, taken: Sequence[BaseGeometry], aside: bool
) -> list[Label]:
    """Lines of a caption from the middle of its top, right of what they cross (``aside``) or below it."""
    while True:
        block = block_of_lines(lines, at.real, at.imag)
        room = shapely.union_all([box(one) for one in block])
        crossed = [one.bounds for one in taken if one.intersects(room)]
        if not crossed:
            return block
        if aside:
            at += max(right for _, _, right, _ in crossed) + CLEAR - room.bounds[0]
        else:
            low = min(low for _, low, _, _ in crossed) - PITCH * min(size for _, size in lines)
            at = complex(at.real, low)


def in_lines(text: str, size: float, most: float) -> list[str]:
    """Return a line of a caption in lines no wider than ``most`` mm: an equality before its signs =."""
    first, *rest = text.split(" = ")
    if not rest:
        return wrapped(text, size, most)
    lines = [f"{first} = {rest[0]}"]
    for part in rest[1:]:
        longer = f"{lines[-1]} = {part}"
        if letter(longer, size=size).width <= most:
            lines[-1] = longer
        else:
            lines.append(f"= {part}")
    return lines


def block_of_lines(lines: Sequence[tuple[str, float]], middle: float, y: float) -> list[Label]:
    """Lines of a caption, each in its height, the first just below a height."""
    labels = []
    for text, size in lines:
        made = letter(text, size=size)
        y -= made.ascent
        labels.append(Label(text, complex(middle, y), size, "middle"))
        y -= made.descent + PITCH * size
    return labels
