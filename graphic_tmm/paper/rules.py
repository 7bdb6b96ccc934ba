"""What each operation of the board leaves on paper, and which operations leave nothing.

A line is drawn from where it begins to where it was met, and a little on; what was only laid off along it
covers it. An arc of the compass is a short one about where it was cut. Points are pricked. A chapter gives the
rules of operations of its own to `figure` (see `Manner`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.instruments import (
    coincide,
    cut,
    homologous,
    join,
    lay_off,
    meet,
    place,
    similar,
    touch,
)
from graphic_tmm.board.operations.statics import arm, carry
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Arc, Curve, Kind, Line, Point
from graphic_tmm.paper.arithmetic import bearing, by_case, outermost
from graphic_tmm.paper.drawing import Bezier, Ink, arc, circle, line
from graphic_tmm.paper.seen import Rule, Seen, finite

LEAST = 0.3
"""What is shorter is a point, mm."""
BEYOND = 4.0
"""How far a construction line goes on behind where it was met, mm."""
STUB = 12.0
"""The length of a line on which nothing was marked, mm."""
NICK = 2.5
"""Half an arc of the compass about where it was cut, mm."""
PRICK = 0.4
"""The radius of a pricked point, mm."""
TANGENT = 6.0
"""Half the length of a tangent to a curve, mm."""
MEETING = (meet.name, cut.name, touch.name)
"""Operations that find a point where a line was met: such a line stays."""

NAMED_AGAIN = (coincide, g.following)
"""Operations whose points are there already under another letter."""


def stays(seen: Seen, step: Step) -> bool:
    """Whether what a step leaves is usually there at the end: arcs, pricks, lines only laid off on are not."""
    if step.it.kind is Line and step.op is not join:
        return any(use.op.name in MEETING for use in seen.uses.get(step.it, ()))
    return step.it.kind is not Arc and not (step.it.kind is Point and step.op.name not in _SEGMENTS)


def drawn_line(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A line from its beginning to every point marked on it; it runs on past what it crossed."""
    at, along = seen.line(step.it, k)
    found = [(0.0, False)]
    for use in seen.uses.get(step.it, ()):
        if use.it.kind is Point:
            spot = seen.point(use.it, k)
            if finite(spot):
                found.append((((spot - at) * along.conjugate()).real, use.op.name in MEETING))
    if step.op is join:
        end = seen.point(step.uses[1], k)
        found.append((((end - at) * along.conjugate()).real, False))
    low, high = outermost(found)
    if not finite(at, along) or along == 0:
        return
    if high[0] - low[0] < LEAST:
        low, high = (low[0] - STUB / 2, False), (high[0] + STUB / 2, False)
    start = low[0] - by_case(low[1], BEYOND, 0.0)
    end_ = high[0] + by_case(high[1], BEYOND, 0.0)
    yield line("thin", at + start * along, at + end_ * along)


def struck_arc(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """An arc of the compass, about the points where it was cut; whole where it was not."""
    centre, radius = seen.arc(step.it, k)
    if not finite(centre, radius) or radius < LEAST:
        return
    met = [use.it for use in seen.uses.get(step.it, ()) if use.it.kind is Point]
    spots = [seen.point(mark, k) - centre for mark in met]
    half = min(math.degrees(NICK / radius), 45.0)
    near = [z for z in spots if finite(z) and abs(z) > LEAST]
    for z in near:
        yield arc("thin", centre, radius, bearing(z) - half, 2 * half)
    if not near:
        yield circle("thin", centre, radius)


def pricked(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A point, pricked."""
    spot = seen.point(step.it, k)
    if finite(spot):
        yield circle("thin", spot, PRICK)


def drawn_curve(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A curve drawn with the French curve."""
    for controls in bezier(seen.reading[step.it]):
        yield Bezier("main", tuple(complex(z) for z in controls), step.it.name)


def segment(pen: str, start: complex, end: complex) -> Iterator[Ink]:
    """A straight line between two places, unless it is a point or one of them is not there."""
    if finite(start, end) and abs(end - start) > LEAST:
        yield line(pen, start, end)


def laid_off(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The length laid off, from where its line begins."""
    yield from segment("thin", seen.line(step.uses[0], k)[0], seen.point(step.it, k))


def placed(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The length laid off along the line, and the one square to it."""
    at, along = seen.line(step.uses[0], k)
    foot = at + seen.number(step.uses[1], k) * along
    yield from segment("thin", at, foot)
    yield from segment("thin", foot, seen.point(step.it, k))


def from_both(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The two sides of the figure built on a base."""
    for base in step.uses[:2]:
        yield from segment("thin", seen.point(base, k), seen.point(step.it, k))


def from_start(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The segment drawn from where it begins."""
    yield from segment("thin", seen.point(step.uses[0], k), seen.point(step.it, k))


def erected(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The perpendicular from the base to the curve."""
    yield from segment("thin", seen.point(step.uses[1], k), seen.point(step.it, k))


def levelled(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The level carried from one foot to the other."""
    height = 1j * seen.point(step.it, k).imag
    start, end = (seen.point(mark, k).real + height for mark in step.uses[1:])
    yield from segment("thin", start, end)


def touched(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The tangent to a curve, about where it touches."""
    at, along = seen.line(step.it, k)
    if finite(at, along):
        yield line("thin", at - TANGENT * along, at + TANGENT * along)


def squared(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The arm: from the point square to the line of action, and the line drawn on to it."""
    about = seen.point(step.uses[0], k)
    at, along = seen.line(step.uses[1], k)
    foot = at + ((about - at) * along.conjugate()).real * along
    yield from segment("thin", about, foot)
    yield from segment("thin", at, foot)


RULES: dict[str, Rule] = {
    lay_off.name: laid_off,
    place.name: placed,
    similar.name: from_both,
    g.erect.name: erected,
    g.level_off.name: levelled,
    g.touching.name: touched,
    arm.name: squared,
    carry.name: from_start,
    homologous.name: from_start,
}
"""By operation."""
BY_KIND: dict[Kind, Rule] = {
    Line: drawn_line,
    Arc: struck_arc,
    Point: pricked,
    Curve: drawn_curve,
}
"""By the kind of mark that an operation without a rule of its own leaves."""
_SEGMENTS = (lay_off.name, g.erect.name, g.level_off.name, carry.name)
"""Points whose steps leave a segment that stays."""


def traceless(op: Operation) -> bool:
    """Whether an operation leaves no trace: a calculation, what is read or looked up, a point named again."""
    inked = op.name in RULES or op.leaves in BY_KIND
    return bool(op.formula) or op in NAMED_AGAIN or not inked


def rule_of(step: Step) -> Rule | None:
    """Return the usual rule of a step; None if it leaves no trace."""
    return None if traceless(step.op) else RULES.get(step.op.name) or BY_KIND[step.it.kind]
