"""The meshing of two gears in ink: teeth, circles, line of action, working flanks, arcs of engagement."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.line import VIEW
from graphic_tmm.chapters.gears.outline import flank, outline, part, sector, spot
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.teeth import Wheel
from graphic_tmm.language.numbers import fixed
from graphic_tmm.paper.curve_parts import cut, nearest, points
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, Wanted, arc, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead, round_arrow, turning_pair

OVER = 14.0
"""How far the line of action, the centre line and the circles go on, mm."""
DOT, TICK = 0.6, 2.0
"""Radius of a point of the construction; half of a stroke across the line of action, mm."""
BAND, PITCH = 2.0, 1.6
"""Breadth of the hatched band along the working part of a flank, and the pitch of its strokes, mm."""
WHOLE, REACH = 450.0, 200.0
"""Where the centres are farther apart, one farther than the second from the pitch point is left out, mm."""
TURN = 16.0
"""Radius of the arrow of an angular velocity, mm."""
ANGLE = 0.4
"""Radius of the arc of α_w, of the length N1N2."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""
SIZE, NUMBER = 5.0, 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
ROOM = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


class _Ink:
    """The numbers of a gear pair while it is inked."""

    def __init__(self, reading: Reading, made: Gear) -> None:
        self.reading, self.made, self.line = reading, made, made.line
        self.pole = self.at(made.line.pole)
        self.limits = [self.at(mark) for mark in made.line.limits]
        self.ends = [self.at(mark) for mark in made.line.ends]
        self.centres = [self.at(circles.centre) for circles in made.line.circles]
        self.angle = self.real(made.line.angle)
        self.way = cmath.rect(1.0, math.radians(self.angle))

    def at(self, mark: Mark) -> complex:
        return spot(self.reading, mark)

    def real(self, mark: Mark) -> float:
        return float(self.reading[mark][0, 0])

    def radius(self, mark: Mark) -> float:
        return float(self.reading[mark].radius[0, 0])

    def shown(self, k: int) -> bool:
        """Whether the centre of a wheel stands on the drawing."""
        whole = abs(self.centres[1] - self.centres[0]) <= WHOLE
        return whole or abs(self.centres[k] - self.pole) <= REACH


def draw_gear_ink(
    reading: Reading, made: Gear, language: str, title: str, *, lettered: bool = True
) -> Drawing:
    """Return the picture of the meshing; ``language`` writes the figure of the centre distance.

    A centre too far for the drawing is left out; the centre line ends in an arrow towards it.
    """
    ink = _Ink(reading, made)
    thin = [*_frame(ink), *_circles(ink), *_turned(ink), *_bands(ink)]
    outlines = [stroke for wheel in made.wheels for stroke in outline(reading, wheel)]
    strokes: list[Stroke | Bezier] = [*thin, *outlines, *_engaged(ink), *_dots(ink)]
    taken: list[Label] = []
    if ink.shown(0) and ink.shown(1):
        left = bounds(Drawing(VIEW, title, tuple(strokes)))[0]
        figure = f"a_{{w}} = {fixed(1000 * ink.real(made.sizes.a_w), 2, language)}"
        size = dimension(ink.centres[0], ink.centres[1], ink.centres[0].real - left + ROOM, figure)
        strokes += size.strokes
        taken.append(size.label)
    if not lettered:
        left, low, right, top = bounds(Drawing(VIEW, title, tuple(strokes), tuple(taken)))
        cell = (left - ROOM, low - ROOM, right + ROOM, top + ROOM)
        return Drawing(VIEW, title, tuple(strokes), tuple(taken), cell)
    wanted = list(_letters(ink))
    labels = place(wanted, strokes, taken)
    inked = interrupt([*strokes, *leaders(wanted, labels)], labels)
    return Drawing(VIEW, title, inked, (*taken, *labels))


def _frame(ink: _Ink) -> Iterator[Stroke]:
    """The centre line, the common tangent, the line of action, radii to its limits, the angle α_w."""
    ends = []
    for k, outward in ((0, -1j), (1, 1j)):
        own = abs(ink.centres[k] - ink.pole) + OVER
        reach = own if ink.shown(k) else min(own, REACH)
        ends.append(ink.pole + reach * outward)
        if ink.shown(k):
            yield from turning_pair(ink.centres[k])
            yield line("thin", ink.centres[k], ink.limits[k])
            turn = (130.0, -80.0) if k == 0 else (-130.0, 80.0)
            yield from round_arrow(ink.centres[k], TURN, *turn)
        else:
            yield from arrowhead(ends[k], outward, pen="thin")
    yield line("centre", *ends)
    reach = ANGLE * ink.real(ink.line.length)
    yield line("thin", ink.pole, ink.pole + reach + OVER)
    yield line("thin", ink.limits[0] - OVER * ink.way, ink.limits[1] + OVER * ink.way)
    yield arc("thin", ink.pole, reach, 0.0, ink.angle)
    if reach * math.radians(ink.angle) > 3 * HEAD:
        yield from arrowhead(ink.pole + reach, -1j, pen="thin", length=HEAD)
        yield from arrowhead(ink.pole + reach * ink.way, 1j * ink.way, pen="thin", length=HEAD)


def _circles(ink: _Ink) -> Iterator[Stroke]:
    """The circles of both wheels as far as their teeth are drawn, and a little farther to their letters."""
    for wheel in ink.made.wheels:
        low, high = sector(ink.reading, wheel)
        for mark, pen, _ in _circles_of(wheel):
            radius = ink.radius(mark)
            beyond = math.degrees(OVER / radius)
            sweep = min(high - low + 1.5 * beyond, 360.0)
            yield arc(pen, ink.at(wheel.circles.centre), radius, low - beyond, sweep)


def _circles_of(wheel: Wheel) -> tuple[tuple[Mark, str, str], ...]:
    """The circles of a wheel with their pens and letters."""
    own, i = wheel.circles, wheel.sizes.number
    return (
        (own.tip, "thin", f"r_{{a{i}}}"),
        (own.working, "centre", f"r_{{w{i}}}"),
        (own.pitch, "centre", f"r_{{{i}}}"),
        (own.base, "thin", f"r_{{b{i}}}"),
        (own.root, "thin", f"r_{{f{i}}}"),
    )


def _turned(ink: _Ink) -> Iterator[Stroke | Bezier]:
    """The flanks that touch in a and in b, dashed."""
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        side = wheel.teeth[1].right
        start, tip = ink.at(side.start), ink.at(wheel.corner)
        for curve in (engaged.entering, engaged.leaving):
            piece = part(ink.reading, curve, wheel.flank, start, tip)
            if piece:
                yield Bezier("dashed", piece, curve.name)


def _bands(ink: _Ink) -> Iterator[Stroke]:
    """The working parts of the flanks through the pitch point: a hatched band inside the tooth."""
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        whole, low = flank(ink.reading, wheel.teeth[1].right), ink.at(engaged.lowest)
        if not (whole and cmath.isfinite(low)):
            continue
        piece = cut(whole, nearest(whole, low), float(len(whole) // 3))
        spots = [complex(z) for z in points(piece, 60)]
        inner = [z + BAND * 1j * (w - z) / abs(w - z) for z, w in pairwise(spots) if w != z]
        if len(inner) < 2:
            continue  # the flank works in one point only
        yield line("thin", *inner)
        gone = 0.0
        for k, (z, w) in enumerate(pairwise(spots)):
            gone += abs(w - z)
            if gone >= PITCH and k + 2 < len(inner):
                gone = 0.0
                yield line("thin", w, inner[min(k + 2, len(inner) - 1)])


def _engaged(ink: _Ink) -> Iterator[Stroke]:
    """The working line ab with its base pitches, and the arcs of engagement on the working circles."""
    yield line("medium", *ink.ends)
    for mark in ink.made.contact.pair:
        z = ink.at(mark)
        yield line("thin", z - TICK * 1j * ink.way, z + TICK * 1j * ink.way)
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        centre = ink.at(wheel.circles.centre)
        start, end = (ink.at(mark) - centre for mark in engaged.arc)
        if cmath.isfinite(start) and cmath.isfinite(end):
            turn = math.degrees(cmath.phase(end / start))
            yield arc("medium", centre, abs(start), math.degrees(cmath.phase(start)), turn)


def _dots(ink: _Ink) -> Iterator[Stroke]:
    """The points that are lettered."""
    marks = [mark for engaged in ink.made.contact.wheels for mark in engaged.arc]
    spots = [ink.pole, *ink.limits, *ink.ends, *(ink.at(mark) for mark in marks)]
    for z in spots:
        if cmath.isfinite(z):
            yield circle("main", z, DOT, filled=True)


def _letters(ink: _Ink) -> Iterator[Wanted]:
    """The letters of centres, limits, ends, circles, arcs of engagement."""
    yield Wanted("P", ink.pole, SIZE, 1.0, -1 + 1j)
    for k, side in ((0, -1), (1, 1)):
        if ink.shown(k):
            yield Wanted(f"O_{{{k + 1}}}", ink.centres[k], SIZE, 2.0, complex(side, side))
            tip = ink.centres[k] - side * cmath.rect(TURN, math.radians(90.0 + side * 40.0))
            yield Wanted(f"ω_{{{k + 1}}}", tip, SIZE, 1.0, 1 + 0j)
        else:
            end = ink.pole + REACH * 1j * side
            yield Wanted(f"O_{{{k + 1}}}", end, SIZE, 1.5, 1 + 0j)
        yield Wanted(f"N_{{{k + 1}}}", ink.limits[k], SIZE, 1.0, side * ink.way * (1j + 0.4))
    for name, end, toward in (("a", ink.ends[0], -1 + 1j), ("b", ink.ends[1], 1 - 1j)):
        yield Wanted(name, end, SIZE, 1.0, toward)
    for name, mark in zip(("b′", "a′"), ink.made.contact.pair, strict=True):
        yield Wanted(name, ink.at(mark), NUMBER, TICK, 1j * ink.way)
    middle = ANGLE * ink.real(ink.line.length)
    yield Wanted(
        "α_{w}", ink.pole + cmath.rect(middle, math.radians(ink.angle / 2)), SIZE, 0.5, 1 + 0.2j
    )
    for wheel, engaged in zip(ink.made.wheels, ink.made.contact.wheels, strict=True):
        centre, i = ink.at(wheel.circles.centre), wheel.sizes.number
        low, _ = sector(ink.reading, wheel)
        for mark, _, text in _circles_of(wheel):
            radius = ink.radius(mark)
            end = centre + cmath.rect(radius, math.radians(low) - OVER / radius)
            yield Wanted(text, end, NUMBER, 0.5, -1j * (end - centre))
        for mark, name in zip(engaged.arc, "cd", strict=True):
            z = ink.at(mark)
            if cmath.isfinite(z):
                yield Wanted(f"{name}_{{{i}}}", z, NUMBER, 1.0, centre - z)
