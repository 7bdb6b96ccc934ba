"""The plate on tracing paper, where no leg turns: its points keep to guides, guides of its own pass by points.

Turned by any angle, a plate is at one place where two of its three legs hold it; how far it is off the third,
times the sine of the angle between the two, is one sum of all three legs alike. Of that sum places are zeros.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.geometry import PARALLEL, along, cis, pick, vector, wedge
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.operations.slots import Slot
from graphic_tmm.board.operations.tracing import Laid, pricked, turned_by
from graphic_tmm.board.values import Angle, Complexes, Length, Line, Point, Reals
from graphic_tmm.language.said import said

_FAILS = "the plate cannot be laid on its three guides"
_SYMBOL = "3P1 + 3P2 + 4R1 + 2R2"
_WHY = said(
    "No leg turns: each keeps a point of the plate to a guide, or a guide of the plate to a point, and it is "
    "rigid, so it is where all three are there at once; of the places where they are it is the one next to "
    "that of the neighbouring position."
)


class Hold(NamedTuple):
    """How a leg holds a plate that is turned as it lies, its first point at the origin.

    ``normal``: the direction in which it holds it; ``off``: how far it is off; ``turn``, ``slope``: how both
    change as it turns, per radian; ``size``: the lengths from which that comes.
    """

    normal: Complexes
    off: Reals
    turn: Complexes
    slope: Reals
    size: Reals


class OnSlides(NamedTuple):
    """A plate that lies turned to ``way``, and how three legs hold it whose first is at ``origin``."""

    way: Complexes
    origin: Complexes
    first: Hold
    second: Hold
    third: Hold


def guide_hold(guide: Line, arm: Complexes, way: Complexes, origin: Complexes) -> Hold:
    """Return how a guide holds a plate by a point of it, ``arm`` from its first in its own axes."""
    pin, off = arm * way, wedge(guide.along, guide.at - origin)
    return Hold(
        guide.along * 1j,
        wedge(guide.along, pin) - off,
        guide.along * 0.0,
        along(pin, guide.along),
        np.abs(arm) + np.abs(off),
    )


def slot_hold(pivot: Point, slot: Slot, way: Complexes, origin: Complexes) -> Hold:
    """Return how a pivot holds a plate by a guide of it."""
    own, far = slot.way * way, pivot - origin
    return Hold(
        own * 1j,
        slot.height - wedge(own, far),
        own * -1.0,
        along(far, own),
        np.abs(far) + np.abs(slot.height),
    )


class Balance(NamedTuple):
    """How far a plate is off its three legs, how that grows as it turns, where they leave it from the origin.

    ``square``: of how squarely the legs cross, 0 where all three hold it in one direction; then no ``place``.
    """

    off: Reals
    growth: Reals
    square: Reals
    place: Complexes


def balance(plate: OnSlides) -> Balance:
    """Return how far a plate is off its three legs."""
    a, b, c = plate.first, plate.second, plate.third
    bc, ca, ab = wedge(b.normal, c.normal), wedge(c.normal, a.normal), wedge(a.normal, b.normal)
    growth = a.slope * bc + b.slope * ca + c.slope * ab
    growth = growth + a.off * (wedge(b.turn, c.normal) + wedge(b.normal, c.turn))
    growth = growth + b.off * (wedge(c.turn, a.normal) + wedge(c.normal, a.turn))
    growth = growth + c.off * (wedge(a.turn, b.normal) + wedge(a.normal, b.turn))
    square = bc * bc + ca * ca + ab * ab
    # where two legs leave it, of the three twos each counts by the square of the sine of their angle
    place = bc * (b.off * c.normal - c.off * b.normal)
    place = place + ca * (c.off * a.normal - a.off * c.normal)
    place = place + ab * (a.off * b.normal - b.off * a.normal)
    off = a.off * bc + b.off * ca + c.off * ab
    crossing = pick(square > PARALLEL * PARALLEL, square, np.nan)
    return Balance(off, growth, square, place * (1j / crossing))


def corrected_on_slides(plate: OnSlides) -> Complexes:
    """Return the direction of a plate's line after one correction."""
    found = balance(plate)
    return turned_by(plate.way, -found.off / found.growth)


def slides_laid(plate: OnSlides) -> Laid:
    """Return how a plate came to lie."""
    found = balance(plate)
    squarely = np.sqrt(found.square)
    # as it turns the sum bends by no more than this, the sines of three angles and three lengths changing
    size = 4.0 * (plate.first.size + plate.second.size + plate.third.size) / squarely
    held = found.growth / squarely
    return Laid(
        vector(found.off / squarely, 0.0 * held), size, np.abs(plate.origin), 0.0, held * size
    )


def _pricked(plate: OnSlides, near: OnSlides) -> Line:
    """Return the line of a plate; NaN where it does not fit, or went to another place than it was near."""
    way, before = plate.way, near.way
    place = balance(plate).place
    line = Line(plate.origin + place, way + 0.0 * place)
    laid = slides_laid(plate)
    return pricked(line, Line(way, way), Line(before, before), laid, balance(near).growth)


def _on_guides(
    way: Complexes, first: Line, second: Line, third: Line, c: Complexes, f: Complexes
) -> OnSlides:
    """Return a plate turned to ``way``, three of its points on guides."""
    return OnSlides(
        way,
        first.at,
        guide_hold(first, 0.0 * c, way, first.at),
        guide_hold(second, c, way, first.at),
        guide_hold(third, f, way, first.at),
    )


def _on_guides_past(
    way: Complexes, first: Line, second: Line, third: Point, c: Complexes, slot: Slot
) -> OnSlides:
    """Return a plate turned to ``way``, two of its points on guides, its own guide at a point."""
    return OnSlides(
        way,
        first.at,
        guide_hold(first, 0.0 * c, way, first.at),
        guide_hold(second, c, way, first.at),
        slot_hold(third, slot, way, first.at),
    )


def _past_both(
    way: Complexes, first: Line, second: Point, third: Point, one: Slot, two: Slot
) -> OnSlides:
    """Return a plate turned to ``way``, a point of it on a guide, two guides of its own at points."""
    return OnSlides(
        way,
        first.at,
        guide_hold(first, 0.0 * one.way, way, first.at),
        slot_hold(second, one, way, first.at),
        slot_hold(third, two, way, first.at),
    )


def _past_all(
    way: Complexes, first: Point, second: Point, third: Point, other: Slot, one: Slot, two: Slot
) -> OnSlides:
    """Return a plate turned to ``way``, three guides of its own at points."""
    return OnSlides(
        way,
        first,
        slot_hold(first, other, way, first),
        slot_hold(second, one, way, first),
        slot_hold(third, two, way, first),
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def lay_on_guides(
    first: Line, second: Line, third: Line, apart: Length, x: Length, y: Length, plate: Angle
) -> Line:
    """Lay a tracing of the plate ({apart}; {x}, {y}) on guides {first}, {second} and {third}; prick {it}.

    ``apart``: its second point from the first along its line; ``x``, ``y``: its third along it and to the left.
    """
    c, f, near = vector(apart, 0.0 * apart), vector(x, y), cis(plate)
    way = corrected_on_slides(_on_guides(near, first, second, third, c, f))
    way = corrected_on_slides(_on_guides(way, first, second, third, c, f))
    way = corrected_on_slides(_on_guides(way, first, second, third, c, f))
    way = corrected_on_slides(_on_guides(way, first, second, third, c, f))
    way = corrected_on_slides(_on_guides(way, first, second, third, c, f))
    way = corrected_on_slides(_on_guides(way, first, second, third, c, f))
    return _pricked(
        _on_guides(way, first, second, third, c, f), _on_guides(near, first, second, third, c, f)
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def lay_on_guides_past(
    first: Line, second: Line, third: Point, apart: Length, h: Length, bend: Angle, plate: Angle
) -> Line:
    """Lay its tracing ({apart}) on guides {first}, {second}, its guide ({bend}; {h}) at {third}; prick {it}.

    ``apart``: its second point from the first along its line; ``bend``: the angle from that to the guide;
    ``h``: how far ``third`` is to the left of a parallel to the guide through the first point.
    """
    c, slot, near = vector(apart, 0.0 * apart), Slot(cis(bend), h), cis(plate)
    way = corrected_on_slides(_on_guides_past(near, first, second, third, c, slot))
    way = corrected_on_slides(_on_guides_past(way, first, second, third, c, slot))
    way = corrected_on_slides(_on_guides_past(way, first, second, third, c, slot))
    way = corrected_on_slides(_on_guides_past(way, first, second, third, c, slot))
    way = corrected_on_slides(_on_guides_past(way, first, second, third, c, slot))
    way = corrected_on_slides(_on_guides_past(way, first, second, third, c, slot))
    return _pricked(
        _on_guides_past(way, first, second, third, c, slot),
        _on_guides_past(near, first, second, third, c, slot),
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def lay_on_guide_past(
    first: Line, second: Point, third: Point, apart: Length, h: Length, bend: Angle, plate: Angle
) -> Line:
    """Lay its tracing on guide {first}, its guides ({apart}) at {second}, ({bend}; {h}) at {third}; prick {it}.

    The plate's line goes through its first point along its first guide; ``bend``: the angle from that to the
    second; ``apart``, ``h``: how far the points are to the left of parallels to the guides through the first.
    """
    one, two, near = Slot(cis(0.0 * bend), apart), Slot(cis(bend), h), cis(plate)
    way = corrected_on_slides(_past_both(near, first, second, third, one, two))
    way = corrected_on_slides(_past_both(way, first, second, third, one, two))
    way = corrected_on_slides(_past_both(way, first, second, third, one, two))
    way = corrected_on_slides(_past_both(way, first, second, third, one, two))
    way = corrected_on_slides(_past_both(way, first, second, third, one, two))
    way = corrected_on_slides(_past_both(way, first, second, third, one, two))
    return _pricked(
        _past_both(way, first, second, third, one, two),
        _past_both(near, first, second, third, one, two),
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def lay_past_all(
    first: Point,
    second: Point,
    third: Point,
    apart: Length,
    h: Length,
    bend: Angle,
    other: Length,
    tilt: Angle,
    plate: Angle,
) -> Line:
    """Lay it, guides ({tilt}; {other}) at {first}, ({apart}) at {second}, ({bend}; {h}) at {third}; prick {it}.

    Its line goes from its first point along its second guide; ``tilt``, ``bend``: the angles from that to the
    others; ``apart``, ``h``, ``other``: how far the points are to the left of parallels to the guides there.
    """
    one, two, near = Slot(cis(0.0 * bend), apart), Slot(cis(bend), h), cis(plate)
    tilted = Slot(cis(tilt), other)
    way = corrected_on_slides(_past_all(near, first, second, third, tilted, one, two))
    way = corrected_on_slides(_past_all(way, first, second, third, tilted, one, two))
    way = corrected_on_slides(_past_all(way, first, second, third, tilted, one, two))
    way = corrected_on_slides(_past_all(way, first, second, third, tilted, one, two))
    way = corrected_on_slides(_past_all(way, first, second, third, tilted, one, two))
    way = corrected_on_slides(_past_all(way, first, second, third, tilted, one, two))
    return _pricked(
        _past_all(way, first, second, third, tilted, one, two),
        _past_all(near, first, second, third, tilted, one, two),
    )
