"""The places of a plate in ink: loci, the plate and its legs thin in each place, heavy in its own."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Arc
from graphic_tmm.chapters.kinematics.closings import PinLeg
from graphic_tmm.chapters.loci.record import Loci, Pins
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.mark_rules import curve, dotted
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, guide, turning_pair

BEYOND = 14.0
"""How far a guide goes on behind the pins on it, mm; an arc, degrees."""
DOT = 0.4
"""Radius of the dots through which the curves are drawn, mm."""
PIVOT, PIN = 3.0, 2.0
"""What letters keep from a pivot and from a pin, mm."""


def draw_loci(on: Subject, made: Loci, count: int) -> Drawing:
    """Return the construction; ``count``: points by which the curves are drawn."""
    seen = Seen(on.construction, on.reading, (LOCI,), range(count))
    drawn = {mark: seen.by_mark[mark].uses[0] for mark in made.curves}
    marks = dict.fromkeys(drawn, curve("medium")) | dict.fromkeys(drawn.values(), dotted(DOT))
    traces = figure(seen, Manner({}, lambda seen, step: step.it in marks, marks))
    strokes: list[Ink] = [*traces.staying]
    for k, (start, held) in enumerate(made.held):
        strokes += body(_held(seen, made, k, held), "path", (start, held))
    order = sorted(range(len(made.places)), key=lambda k: k == made.own)
    for k in order:
        strokes += body(_plate(seen, made, made.places[k], k == made.own), "link", made.places[k])
    for (pivot, _), leg in zip(made.held, made.closing.legs, strict=True):
        if isinstance(leg, PinLeg):
            strokes += body(fixed_pivot(seen.fixed_place(pivot)), "pivot", (pivot,))
    return traces.drawing(on, strokes, _letters(seen, made, on.heights.point))


def _held(seen: Seen, made: Loci, k: int, held: Mark) -> Iterator[Ink]:
    """What a leg leaves its pin: the whole circle of the first, of others as much as there are pins on it."""
    spots = [seen.fixed_place(one[k]) for one in made.places]
    spots = [z for z in spots if finite(z)]
    if held.kind is not Arc:
        at, along = seen.line(held, 0)
        ways = [((z - at) / along).real for z in spots] or [0.0]
        yield from guide(at + (min(ways) - BEYOND) * along, at + (max(ways) + BEYOND) * along)
        return
    centre, radius = seen.arc(held, 0)
    if k == 0 or not spots:
        yield circle("thin", centre, radius)
        return
    angles = sorted(math.degrees(cmath.phase(z - centre)) % 360.0 for z in spots)
    gaps = [(b - a) % 360.0 or 360.0 for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
    widest = max(range(len(gaps)), key=gaps.__getitem__)
    beyond = min(BEYOND, gaps[widest] / 2.0)
    start = angles[(widest + 1) % len(angles)] - beyond
    yield arc("thin", centre, radius, start, 360.0 - gaps[widest] + 2.0 * beyond)


def _plate(seen: Seen, made: Loci, laid: Pins, own: bool) -> Iterator[Ink]:
    """The plate in one of its places, and its legs."""
    pins = [seen.fixed_place(mark) for mark in laid]
    if not finite(*pins):
        return
    for (pivot, _), leg, pin in zip(made.held, made.closing.legs, pins, strict=True):
        if isinstance(leg, PinLeg):
            yield line("main" if own else "thin", seen.fixed_place(pivot), pin)
    yield line("main" if own else "thin", *pins, closed=True)
    if own:
        for pin in pins:
            yield from turning_pair(pin)
    else:
        yield circle("thin", pins[2], 1.0)


def _letters(seen: Seen, made: Loci, size: float) -> Iterator[Wanted]:
    for (pivot, _), leg in zip(made.held, made.closing.legs, strict=True):
        if isinstance(leg, PinLeg):
            yield Wanted(pivot.name, seen.fixed_place(pivot), size, PIVOT, of=(pivot.slot,))
    for k, one in enumerate(made.places):
        for mark in one if k == made.own else one[2:]:
            at = seen.fixed_place(mark)
            if finite(at):
                yield Wanted(mark.name, at, size, PIN, of=(mark.slot,))
