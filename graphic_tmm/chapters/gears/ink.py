"""The meshing of two gears in ink: teeth, circles, line of action, working flanks, arcs of engagement."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.gears.ink_rack import (
    DOT,
    OVER,
    RackInk,
    rack_bodies,
    rack_letters,
    rack_rules,
)
from graphic_tmm.chapters.gears.line import VIEW
from graphic_tmm.chapters.gears.outline import RULES, flank, hatched, outline, part, sector, spot
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.teeth import Wheel
from graphic_tmm.language.numbers import fixed
from graphic_tmm.paper.clipping import cut, nearest, points
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label, Wanted, arc, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.mark_rules import dotted, leaving
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.seen import Rule, Seen, Subject
from graphic_tmm.paper.symbols.dimensions import BEYOND, dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead, round_arrow, turning_pair

TICK = 2.0
"""Half of a stroke across the line of action, mm."""
WHOLE, REACH = 450.0, 200.0
"""Where the centres are farther apart, one farther than the second from the pitch point is left out, mm."""
TURN = 16.0
"""Radius of the arrow of an angular velocity, mm."""
ANGLE = 0.4
"""Radius of the arc of α_w, of the length N1N2."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""


class MeshInk:
    """The numbers of a gear pair while it is inked."""

    def __init__(self, reading: Reading, made: Gear) -> None:
        self.reading, self.made, self.line = reading, made, made.line
        self.pole = self.at(made.line.pole)
        self.limits = [self.at(mark) for mark in made.line.limits]
        self.ends = [self.at(mark) for mark in made.line.ends]
        self.centres = [self.at(circles.centre) for circles in made.line.circles]
        self.ring, self.rack = made.sizes.ring is not None, made.line.rack
        self.teeth = None
        if made.rack is not None and self.rack is not None:
            self.teeth = RackInk(reading, made.rack, self.rack)
        self.sides = (-1, -1) if self.ring else (-1, 1)[: len(self.centres)]
        self.opposite = self.at(self.rack.foot) if self.rack else self.centres[1]
        self.angle = self.real(made.line.angle)
        self.way = cmath.rect(1.0, math.radians(self.angle))

    @property
    def reach(self) -> float:
        """The radius of the arc of α_w, mm; N1N2 may be far longer than the teeth of a ring are broad."""
        own = ANGLE * self.real(self.line.length)
        whole = abs(self.ends[1] - self.limits[0])
        if self.rack:
            return min(ANGLE * whole, abs(self.ends[1] - self.pole))
        return min(own, whole) if self.ring else own

    def at(self, mark: Mark) -> complex:
        """Where a point stands."""
        return spot(self.reading, mark)

    def real(self, mark: Mark) -> float:
        """A number or a length."""
        return float(self.reading[mark][0, 0])

    def radius(self, mark: Mark) -> float:
        """The radius of an arc, mm."""
        return float(self.reading[mark].radius[0, 0])

    def shows_centre(self, k: int) -> bool:
        """Whether the centre of a wheel stands on the drawing."""
        whole = abs(self.opposite - self.centres[0]) <= WHOLE
        return whole or abs(self.centres[k] - self.pole) <= REACH


def circles_of(wheel: Wheel) -> tuple[tuple[Mark, str, str], ...]:
    """Return the circles of a wheel with their pens and letters."""
    own, i = wheel.circles, wheel.sizes.number
    working = ((own.working, "centre", f"r_{{w{i}}}"),)
    return (
        (own.tip, "thin", f"r_{{a{i}}}"),
        *(working if own.working is not own.pitch else ()),
        (own.pitch, "centre", f"r_{{{i}}}"),
        (own.base, "thin", f"r_{{b{i}}}"),
        (own.root, "thin", f"r_{{f{i}}}"),
    )


ASIDE = 8.0
"""From the ink to the dimension of the distance of the centres, mm."""


def draw_gear_ink(on: Subject, made: Gear) -> Drawing:
    """Return the picture of the meshing.

    A centre too far for the drawing is left out; the centre line ends in an arrow towards it.
    """
    ink = MeshInk(on.reading, made)
    traces = figure(on.seen((VIEW,), range(made.rows.axis)), showing(_rules(ink), RULES))
    strokes: list[Ink] = [*traces.staying, *_bodies(ink)]
    taken: list[Label] = []
    if all(map(ink.shows_centre, range(len(ink.centres)))):
        left = bounds(Drawing(VIEW, on.title, tuple(strokes)))[0]
        letter = made.sizes.a_w.letter
        told = f"{letter} = {fixed(1000 * ink.real(made.sizes.a_w), 2, on.language)}"
        aside = TURN + 2 * ASIDE if ink.ring else ink.centres[0].real - left + ASIDE
        size = dimension(ink.centres[0], ink.opposite, aside, told, on.heights.number)
        centres = [circles.centre for circles in made.line.circles]
        centres += [ink.rack.foot] if ink.rack else []
        shown = list(size.strokes)
        if ink.teeth is not None:  # the datum line itself leads to the dimension
            end = ink.opposite - aside - BEYOND
            shown[1] = line("thin", complex(ink.teeth.ends[0].real - OVER, end.imag), end)
        strokes += body(shown, "dimension", centres)
        taken.append(size.label._replace(of=tuple(mark.slot for mark in centres)))
    return traces.drawing(on, strokes, _letters(ink, on.heights), taken)


def _rules(ink: MeshInk) -> dict[Mark, Rule]:
    """What stays of the meshing, by mark."""
    made, own = ink.made, ink.made.line
    rules: dict[Mark, Rule] = {
        own.centres: leaving(*_centre_line(ink)),
        own.pole: dotted(DOT),
        own.line: leaving(_action(ink)),
        own.angle: leaving(*_angle(ink)),
        own.working: leaving(line("medium", *ink.ends)),
    }
    rules |= dict.fromkeys(own.ends, dotted(DOT))
    for k, mark in enumerate(own.limits):
        rules[mark] = _limit(ink, k)
    for wheel in made.wheels:
        rules |= {mark: _circle(ink, wheel, pen) for mark, pen, _ in circles_of(wheel)}
    if ink.teeth is not None:
        rules |= rack_rules(ink.teeth, own)
    for mark in made.contact.pair:
        z = ink.at(mark)
        rules[mark] = leaving(line("thin", z - TICK * 1j * ink.way, z + TICK * 1j * ink.way))
    for wheel, engaged in zip(made.wheels, made.contact.wheels, strict=True):
        rules |= dict.fromkeys((engaged.entering, engaged.leaving), _touching(ink, wheel))
        rules |= dict.fromkeys(engaged.arc, dotted(DOT))
        start, end = (ink.at(mark) for mark in engaged.arc)
        rules[engaged.length] = leaving(*_arc(ink.at(wheel.circles.centre), start, end))
    return rules


def _centre_line(ink: MeshInk) -> Iterator[Ink]:
    """The line of centres; to one that is left out an arrow points."""
    ends = [ink.pole + 1j * OVER] if ink.ring else []
    if ink.teeth is not None:
        ends = [1j * (ink.teeth.ends[0].imag + OVER)]
    for k, side in enumerate(ink.sides):
        own = abs(ink.centres[k] - ink.pole) + OVER
        reach = own if ink.shows_centre(k) else min(own, REACH)
        ends.append(ink.pole + reach * side * 1j)
        if not ink.shows_centre(k):
            yield from arrowhead(ends[-1], side * 1j, pen="thin")
    yield line("centre", ends[0], ends[-1])


def _action(ink: MeshInk) -> Ink:
    """The line of action from limit to limit, of a ring to b, and a little farther."""
    spots = (ink.limits[-1], ink.ends[1]) if ink.ring or ink.rack else ink.limits
    return line("thin", spots[0] - OVER * ink.way, spots[1] + OVER * ink.way)


def _limit(ink: MeshInk, k: int) -> Rule:
    """A limit of the line of action, with the radius to it."""
    dot = dotted(DOT)

    def limit(seen: Seen, step: Step, at: int) -> Iterator[Ink]:
        if ink.shows_centre(k):
            yield line("thin", ink.centres[k], ink.limits[k])
        yield from dot(seen, step, at)

    return limit


def _angle(ink: MeshInk) -> Iterator[Ink]:
    """The common tangent and the angle α_w of the line of action with it."""
    reach = ink.reach
    yield line("thin", ink.pole, ink.pole + reach + OVER)
    yield arc("thin", ink.pole, reach, 0.0, ink.angle)
    if reach * math.radians(ink.angle) > 3 * HEAD:
        yield from arrowhead(ink.pole + reach, -1j, pen="thin", length=HEAD)
        yield from arrowhead(ink.pole + reach * ink.way, 1j * ink.way, pen="thin", length=HEAD)


def _circle(ink: MeshInk, wheel: Wheel, pen: str) -> Rule:
    """A circle as far as teeth are drawn, and a little farther to its letter."""
    low, high = sector(ink.reading, wheel)

    def circle_(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        centre, radius = seen.arc(step.it, k)
        beyond = math.degrees(OVER / radius)
        turn = min(high - low + 1.5 * beyond, 360.0)
        if wheel.sizes.cut is None:
            yield arc(pen, centre, radius, high + beyond, -turn)
        else:
            yield arc(pen, centre, radius, low - beyond, turn)

    return circle_


def _touching(ink: MeshInk, wheel: Wheel) -> Rule:
    """The flank where it touches at an end of the working line, dashed."""
    start, tip = ink.at(wheel.teeth[1].right.start), ink.at(wheel.corner)

    def touching(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        piece = part(ink.reading, step.it, wheel.flank, start, tip)
        if piece:
            yield Bezier("dashed", piece, step.it.name)

    return touching


def _arc(centre: complex, start: complex, end: complex) -> Iterator[Ink]:
    """An arc of engagement."""
    a, b = start - centre, end - centre
    if cmath.isfinite(a) and cmath.isfinite(b):
        turn = math.degrees(cmath.phase(b / a))
        yield arc("medium", centre, abs(a), math.degrees(cmath.phase(a)), turn)


def _bodies(ink: MeshInk) -> Iterator[Ink]:
    """The teeth, the working parts of their flanks, the shafts with the senses in which they turn."""
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        yield from outline(ink.reading, wheel)
        strokes = _band(ink, wheel, engaged.lowest)
        yield from body(strokes, "hatching", [wheel.flank, engaged.lowest])
    if ink.teeth is not None:
        yield from rack_bodies(ink.teeth)
    for k, side in enumerate(ink.sides):
        start, sweep = -130.0 * side, 80.0 * side
        if ink.shows_centre(k):
            centre = [ink.line.circles[k].centre]
            yield from body(turning_pair(ink.centres[k]), "pivot", centre)
            yield from body(round_arrow(ink.centres[k], TURN, start, sweep), "sense", centre)


def _band(ink: MeshInk, wheel: Wheel, lowest: Mark) -> Iterator[Ink]:
    """The working part of the flank through the pitch point: a hatched band inside the tooth."""
    whole, low = flank(ink.reading, wheel.teeth[1].right), ink.at(lowest)
    if not (whole and cmath.isfinite(low)):
        return
    piece = cut(whole, nearest(whole, low), float(len(whole) // 3))
    yield from hatched([complex(z) for z in points(piece, 60)])


def _letters(ink: MeshInk, heights: Heights) -> Iterator[Wanted]:
    """The letters of centres, limits, ends, circles, arcs of engagement."""
    point, own = heights.point, ink.line
    yield Wanted("P", ink.pole, point, 1.0, -1 + 1j, (own.pole.slot,))
    for k, side in enumerate(ink.sides):
        yield from _centre_letters(ink, k, side, point)
        limit = own.limits[k]
        toward = side * ink.way * (1j + 0.4)
        yield Wanted(limit.letter, ink.limits[k], point, 1.0, toward, (limit.slot,))
    for end, toward in zip(own.ends, (-1 + 1j, 1 - 1j), strict=True):
        if end in own.limits:
            continue
        yield Wanted(end.letter, ink.at(end), point, 1.0, toward, (end.slot,))
    for mark in ink.made.contact.pair:
        yield Wanted(mark.letter, ink.at(mark), heights.number, TICK, 1j * ink.way, (mark.slot,))
    if ink.teeth is not None:
        yield from rack_letters(ink.teeth, heights)
    middle = cmath.rect(ink.reach, math.radians(ink.angle / 2))
    yield Wanted(own.angle.letter, ink.pole + middle, point, 0.5, 1 + 0.2j, (own.angle.slot,))
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        centre = ink.at(wheel.circles.centre)
        sense = -1 if wheel.sizes.cut else 1
        edge = math.radians(sector(ink.reading, wheel)[sense > 0])
        for mark, _, text in circles_of(wheel):
            radius = ink.radius(mark)
            spot = centre + cmath.rect(radius, edge + sense * OVER / radius)
            toward = sense * 1j * (spot - centre)
            yield Wanted(text, spot, heights.number, 0.5, toward, (mark.slot,))
        for mark in engaged.arc:
            z = ink.at(mark)
            if cmath.isfinite(z):
                yield Wanted(mark.letter, z, heights.number, 1.0, centre - z, (mark.slot,))


def _centre_letters(ink: MeshInk, k: int, side: int, size: float) -> Iterator[Wanted]:
    """The letters of a centre and of the sense in which its wheel turns; far ones at the arrow to them."""
    mark, centre = ink.line.circles[k].centre, ink.centres[k]
    if not ink.shows_centre(k):
        far = ink.pole + REACH * side * 1j
        yield Wanted(mark.letter, far, size, 1.5, 1 + 0j, (mark.slot,))
        return
    yield Wanted(mark.letter, centre, size, 2.0, complex(side, side), (mark.slot,))
    tip = centre - side * cmath.rect(TURN, math.radians(90.0 + side * 40.0))
    yield Wanted(f"ω_{{{k + 1}}}", tip, size, 1.0, 1 + 0j, (mark.slot,))
