"""A Geneva wheel in ink: its rim with slots and hollows, the disc that locks it, the crank at the entry."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.geneva.plan import Geneva
from graphic_tmm.chapters.geneva.task import GENEVA
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.seen import Seen, Subject
from graphic_tmm.paper.symbols.dimensions import angular
from graphic_tmm.paper.symbols.kinematic import fixed_pivot

BEYOND = 6.0
"""How far lines of the construction go on behind what they join, mm."""
AT_CENTRE, AT_ORIGIN = 16.0, 20.0
"""Radii of the arcs that show the angles at the wheel's centre and at the crank's, mm."""
PIVOT = 3.0
"""How far the symbol of a pivot reaches, mm."""


class _Ink(Seen):
    """The view of the wheel while it is inked: places and lengths on the sheet, mm."""

    def __init__(self, on: Subject, wheel: Geneva) -> None:
        super().__init__(on.construction, on.reading, (GENEVA,), (0,))
        self.wheel, self.heights = wheel, on.heights
        self.origin, self.centre = (self.fixed_place(one) for one in (wheel.origin, wheel.centre))
        self.ends = [self.fixed_place(one.at) for one in (wheel.entry, wheel.exit)]
        self.apart, self.crank, self.pin, self.lock, self.rim, self.bottom = (
            self.fixed_number(one)
            for one in (wheel.apart, wheel.crank, wheel.pin, wheel.lock, wheel.rim, wheel.bottom)
        )

    @property
    def pitch(self) -> float:
        """The angle from slot to slot, rad."""
        return math.tau / self.wheel.order.slots


def draw_wheel(on: Subject, wheel: Geneva) -> Drawing:
    """Return the wheel at the entry of the pin."""
    ink = _Ink(on, wheel)
    traces = figure(ink, showing({}))
    strokes = [*traces.staying, *_construction(ink), *_wheel(ink), *_disc(ink), *_angles(ink)]
    strokes += [*fixed_pivot(ink.origin), *fixed_pivot(ink.centre)]
    return traces.drawing(on, strokes, _letters(ink))


def _of(ink: _Ink, *marks: Mark) -> list[Mark]:
    return [ink.wheel.origin, ink.wheel.centre, *marks]


def _construction(ink: _Ink) -> Iterator[Ink]:
    """The line of centres, the crank and the slot at the exit, the way of the pin between both."""
    wheel, (entry, exit_) = ink.wheel, ink.ends
    way = (ink.centre - ink.origin) / ink.apart
    yield from body(
        [line("centre", ink.origin - BEYOND * way, ink.centre + (ink.rim + BEYOND) * way)],
        "axis", _of(ink),
    )  # fmt: skip
    for end, place in ((entry, wheel.entry), (exit_, wheel.exit)):
        strokes: list[Ink] = [line("thin", ink.centre, end), line("thin", ink.origin, end)]
        yield from body(strokes, "normal", _of(ink, place.at))
    yield from body(
        [arc("thin", ink.origin, abs(entry - ink.origin), *_seen(ink, ink.origin))],
        "path", _of(ink, wheel.entry.at, wheel.exit.at),
    )  # fmt: skip


def _wheel(ink: _Ink) -> Iterator[Ink]:
    """The rim from slot to slot: an edge of a slot and its round bottom, rim, hollow of the disc, rim."""
    centre, pitch, strokes = ink.centre, ink.pitch, list[Ink]()
    ahead = math.asin(min(1.0, ink.pin / ink.rim))
    room = _hollow(ink)
    top = math.sqrt(max(0.0, ink.rim**2 - ink.pin**2))
    start = cmath.phase(ink.ends[0] - centre)
    for k in range(ink.wheel.order.slots):
        slot = start + k * pitch
        way = cmath.rect(1.0, slot)
        for side in (-1j, 1j):
            edge = side * ink.pin * way
            strokes.append(
                line("main", centre + top * way + edge, centre + _floor(ink) * way + edge)
            )
        strokes.append(
            arc("main", centre + _floor(ink) * way, ink.pin, math.degrees(slot) + 90.0, 180.0)
        )
        middle = slot + pitch / 2.0
        if room is None:
            strokes.append(_rim(ink, slot + ahead, pitch - 2.0 * ahead))
            continue
        at, wide = room
        strokes += [
            _rim(ink, slot + ahead, pitch / 2.0 - at - ahead),
            _rim(ink, middle + at, pitch / 2.0 - at - ahead),
            arc(
                "main", centre + cmath.rect(ink.apart, middle), ink.lock,
                math.degrees(middle + math.pi - wide), math.degrees(2.0 * wide),
            ),
        ]  # fmt: skip
    marks = _of(ink, ink.wheel.entry.at, ink.wheel.rim, ink.wheel.bottom, ink.wheel.pin)
    yield from body(strokes, "wheel", [*marks, ink.wheel.lock])


def _hollow(ink: _Ink) -> tuple[float, float] | None:
    """Return half the angles of a hollow of the rim, seen from the wheel's centre and from its own (rad).

    None where it would cut into the slots, or the disc does not reach the rim: a disc that goes free of the pin
    does neither.
    """
    apart, rim, lock = ink.apart, ink.rim, ink.lock
    at = (apart**2 + rim**2 - lock**2) / (2.0 * apart * rim)
    wide = (apart**2 + lock**2 - rim**2) / (2.0 * apart * lock)
    if not (abs(at) < 1.0 and abs(wide) < 1.0 and ink.pin < rim):
        return None
    half = math.acos(at)
    return (half, math.acos(wide)) if half < ink.pitch / 2.0 - math.asin(ink.pin / rim) else None


def _floor(ink: _Ink) -> float:
    """How far the round bottom of a slot has its centre from the wheel's: at the nearest place of the pin."""
    return ink.bottom + ink.pin


def _rim(ink: _Ink, start: float, turn: float) -> Ink:
    return arc("main", ink.centre, ink.rim, math.degrees(start), math.degrees(turn))


def _disc(ink: _Ink) -> Iterator[Ink]:
    """The crank with its pin, and the disc: convex but where a pin carries the wheel past it."""
    wheel, pins = ink.wheel, ink.wheel.order.pins
    first, engaged = (math.radians(one) for one in _seen(ink, ink.origin))
    half = abs(engaged) / 2.0
    crank: list[Ink] = []
    disc: list[Ink] = []
    for k in range(pins):
        to = first + k * math.tau / pins
        way = cmath.rect(1.0, to)
        at = ink.origin + ink.crank * way
        crank += [line("main", ink.origin, at - ink.pin * way), circle("main", at, ink.pin)]
        convex = math.degrees(math.tau / pins - 2.0 * half)
        disc.append(_cut_out(ink, way, half))
        if convex > 0.0:
            disc.append(arc("main", ink.origin, ink.lock, math.degrees(to + half), convex))
    yield from body(crank, "crank", _of(ink, wheel.entry.at, wheel.crank, wheel.pin))
    if ink.lock > 0.0:
        yield from body(disc, "disc", _of(ink, wheel.entry.at, wheel.exit.at, wheel.lock))


def _cut_out(ink: _Ink, way: complex, half: float) -> Ink:
    """The part of the disc that is cut out: the rim in the middle of a motion, as much smaller as the disc."""
    share = ink.lock / ink.crank
    centre = ink.origin + share * ink.apart * way
    ends = [ink.origin + ink.lock * way * cmath.rect(1.0, side * half) for side in (1.0, -1.0)]
    start, end = (cmath.phase(one - centre) for one in ends)
    turn = (math.degrees(end - start) + 180.0) % 360.0 - 180.0
    return arc("main", centre, abs(ends[0] - centre), math.degrees(start), turn)


def _angles(ink: _Ink) -> Iterator[Ink]:
    """The angles at both centres, from entry to exit."""
    for vertex, radius in ((ink.centre, AT_CENTRE), (ink.origin, AT_ORIGIN)):
        start, turn = _seen(ink, vertex)
        yield from added(angular(vertex, start, turn, radius), "angle")


def _seen(ink: _Ink, vertex: complex) -> tuple[float, float]:
    """Return where the entry is seen from a centre, and how far the exit from it (degrees)."""
    entry, exit_ = (one - vertex for one in ink.ends)
    return math.degrees(cmath.phase(entry)), math.degrees(cmath.phase(exit_ / entry))


def _letters(ink: _Ink) -> Iterator[Wanted]:
    wheel, size = ink.wheel, ink.heights.point
    named = {
        wheel.origin: (ink.origin, PIVOT),
        wheel.centre: (ink.centre, PIVOT),
        wheel.entry.at: (ink.ends[0], ink.pin),
        wheel.exit.at: (ink.ends[1], PIVOT),
    }
    for mark, (at, radius) in named.items():
        yield Wanted(mark.letter, at, size, radius, of=(mark.slot,))
    for vertex, radius, mark, text in (
        (ink.centre, AT_CENTRE, wheel.half, "2β"), (ink.origin, AT_ORIGIN, wheel.engaged, "2φ"),
    ):  # fmt: skip
        start, turn = _seen(ink, vertex)
        way = cmath.rect(1.0, math.radians(start + 0.35 * turn))
        yield Wanted(text, vertex + radius * way, size, 1.0, toward=way, of=(mark.slot,))
