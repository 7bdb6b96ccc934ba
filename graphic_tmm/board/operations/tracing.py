"""The plate on tracing paper: three of its points are laid on three loci, arcs or guides, and it is pricked.

Nothing closed does that: of a plate on three links there are up to six places. Which of them is meant is given
as two angles near it; corrections in straight arithmetic lead to the place itself, or to none. How the plate
lies is kept as a `Line` of two directions: ``at`` that of its first link, ``along`` that of its own line.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.geometry import TANGENT, along, cis, pick, vector, wedge
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.values import Angle, Arc, Complexes, Length, Line, Point, Reals
from graphic_tmm.language.said import said

OFF = 1e-9
"""A plate is laid if one more correction turns it by less than this share of the way to where it can move."""
FAR = 0.7
"""The cosine of the angle by which corrections may turn the plate or its first link: 45°.

What is given is nearer by far, but where lengths were changed on a page; a plate that went farther has come to
another of its places, and so has one that is held the other way round."""
_FAILS = "the plate cannot be laid on what holds its three points"
_SYMBOL = "3P1 + 3P2 + 4R1 + 2R2"
_WHY = said(
    "Each of the three points keeps to its own locus and the plate is rigid, so it is where all three are "
    "there at once; of the places where they are it is the one next to that of the neighbouring position."
)


def arc_off(point: Complexes, arc: Arc) -> Reals:
    """Return how far a point is outside an arc; the distance itself within its square by the diameter."""
    arm = point - arc.centre
    return 0.5 * ((arm.real * arm.real + arm.imag * arm.imag) * (1.0 / arc.radius) - arc.radius)


def arc_normal(point: Complexes, arc: Arc) -> Complexes:
    """Return the direction in which a point goes away from an arc fastest; unit on the arc."""
    return (point - arc.centre) * (1.0 / arc.radius)


def line_off(point: Complexes, line: Line) -> Reals:
    """Return how far a point is to the left of a line."""
    return wedge(line.along, point - line.at)


class Fit(NamedTuple):
    """How a plate keeps to one of its loci, or by a guide of its own to a point.

    ``arm``: from its first point, in its own axes, to where it is held; ``off``: how far that is off, to the
    side of ``normal``; ``reach``: the lengths from which that comes; ``bend``: of the locus, 1 by its radius.
    """

    arm: Complexes
    off: Reals
    normal: Complexes
    reach: Reals | float
    bend: Reals | float


class TracedPlate(NamedTuple):
    """A plate as it lies: its first point ``b`` on an arc of that radius, how its others keep to their loci."""

    lies: Line
    radius: Reals
    b: Complexes
    second: Fit
    third: Fit


def arc_fit(arc: Arc, arm: Complexes, b: Complexes, lies: Line) -> Fit:
    """Return how a point of a plate keeps to an arc; ``b``: the plate's first point."""
    pin = b + arm * lies.along
    return Fit(arm, arc_off(pin, arc), arc_normal(pin, arc), arc.radius, 1.0 / arc.radius)


def line_fit(line: Line, arm: Complexes, b: Complexes, lies: Line) -> Fit:
    """Return how a point of a plate keeps to a guide; ``b``: the plate's first point."""
    pin = b + arm * lies.along
    return Fit(arm, line_off(pin, line), line.along * 1j, np.abs(pin - line.at), 0.0)


def first_pin(first: Arc, lies: Line) -> Complexes:
    """Return the first point of a plate, on its arc."""
    return first.centre + first.radius * lies.at


def held(plate: TracedPlate) -> Reals:
    """Return how well a plate is held, per length of it: 0 where it can move on its three loci."""
    swing, turn = plate.lies.at * 1j, plate.lies.along * 1j
    second, third = plate.second, plate.third
    return along(swing, second.normal) * along(third.arm * turn, third.normal) - along(
        swing, third.normal
    ) * along(second.arm * turn, second.normal)


def turned_by(direction: Complexes, angle: Reals) -> Complexes:
    """Return a direction turned by about an angle, radians; it stays of length 1."""
    half = 0.5 * angle
    square = half * half
    share = 1.0 / (1.0 + square)
    return direction * vector((1.0 - square) * share, angle * share)


def corrected(plate: TracedPlate) -> Line:
    """Return how a plate lies after one correction."""
    lies, second, third = plate.lies, plate.second, plate.third
    swing, turn = plate.radius * (lies.at * 1j), lies.along * 1j
    second_swing, second_turn = along(swing, second.normal), along(second.arm * turn, second.normal)
    third_swing, third_turn = along(swing, third.normal), along(third.arm * turn, third.normal)
    off = vector(second.off, third.off)
    return both_turned(lies, off, second_swing, second_turn, third_swing, third_turn)


def both_turned(
    lies: Line, off: Complexes, first_at: Reals, first_along: Reals, at: Reals, along_: Reals
) -> Line:
    """Return both directions turned so that two lengths fit; the last four: how they grow as it turns."""
    share = 1.0 / (first_at * along_ - at * first_along)
    by_at = (off.imag * first_along - off.real * along_) * share
    by_along = (off.real * at - off.imag * first_at) * share
    return Line(turned_by(lies.at, by_at), turned_by(lies.along, by_along))


def on_arcs(
    lies: Line, first: Arc, second: Arc, third: Arc, c: Complexes, f: Complexes
) -> TracedPlate:
    """Return a plate as it lies on three arcs."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, arc_fit(second, c, b, lies), arc_fit(third, f, b, lies)
    )


def on_guide(
    lies: Line, first: Arc, second: Arc, third: Line, c: Complexes, f: Complexes
) -> TracedPlate:
    """Return a plate as it lies on two arcs and a guide."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, arc_fit(second, c, b, lies), line_fit(third, f, b, lies)
    )


def on_guides(
    lies: Line, first: Arc, second: Line, third: Line, c: Complexes, f: Complexes
) -> TracedPlate:
    """Return a plate as it lies on an arc and two guides."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, line_fit(second, c, b, lies), line_fit(third, f, b, lies)
    )


class Laid(NamedTuple):
    """How a plate, or two, came to lie: by how much it does not fit, and of what lengths that is to be judged.

    ``size``: no point moves by more as an angle does, rad; ``reach``: further lengths that rounding comes of;
    ``bend``: of the arcs that points keep to, together; ``held``: how well it is held, per area.
    """

    off: Complexes
    size: Reals
    reach: Reals
    bend: Reals | float
    held: Reals


def plate_laid(plate: TracedPlate) -> Laid:
    """Return how a plate came to lie."""
    second, third = plate.second, plate.third
    return Laid(
        vector(second.off, third.off),
        plate.radius + np.abs(second.arm) + np.abs(third.arm),
        np.abs(plate.b) + second.reach + third.reach,
        second.bend + third.bend,
        plate.radius * held(plate),
    )


def is_laid(laid: Laid) -> Any:
    """Return whether there is a place next to where it lies, and how it moves there is sure.

    By Kantorovich's theorem there is one if ``off`` is less than ``sure``, which falls with the square of how
    well it is held. Where rounding alone is more, two places meet: its motion there has no sure digit.
    """
    size = laid.size
    sure = (laid.held / size) * (laid.held / size) / (2.0 * size * (1.0 + size * laid.bend))
    rounding = TANGENT * (size + laid.reach)
    return (rounding <= sure) & (np.abs(laid.off) <= np.maximum(rounding, OFF * sure))


def pricked(line: Line, lies: Line, near: Line, laid: Laid, before: Reals) -> Line:
    """Return a line; NaN where what is laid does not fit, or went to another place.

    ``before``: of another sign than how it is held where it is held the other way round near the place.
    """
    there = (
        is_laid(laid)
        & (laid.held * before >= 0.0)
        & (along(lies.at, near.at) > FAR)
        & (along(lies.along, near.along) > FAR)
    )
    return Line(line.at, pick(there, line.along, line.along * np.nan))


def pricked_plate(plate: TracedPlate, near: TracedPlate) -> Line:
    """Return the line of a plate; NaN where it does not fit, or went to another place than it was near."""
    line = Line(plate.b, plate.lies.along)
    return pricked(line, plate.lies, near.lies, plate_laid(plate), held(near))


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace(
    first: Arc,
    second: Arc,
    third: Arc,
    apart: Length,
    x: Length,
    y: Length,
    leg: Angle,
    plate: Angle,
) -> Line:
    """On tracing paper lay the plate ({apart}; {x}, {y}) on {first}, {second} and {third}; prick {it} through.

    ``apart``: its second point from the first along its line; ``x``, ``y``: its third along it and to the left.
    """
    c, f = vector(apart, 0.0 * apart), vector(x, y)
    near = Line(cis(leg), cis(plate))
    lies = corrected(on_arcs(near, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    lies = corrected(on_arcs(lies, first, second, third, c, f))
    return pricked_plate(
        on_arcs(lies, first, second, third, c, f), on_arcs(near, first, second, third, c, f)
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace_on_guide(
    first: Arc,
    second: Arc,
    third: Line,
    apart: Length,
    x: Length,
    y: Length,
    leg: Angle,
    plate: Angle,
) -> Line:
    """On tracing paper lay the plate ({apart}; {x}, {y}) on {first}, {second} and {third}; prick {it} through.

    ``apart``: its second point from the first along its line; ``x``, ``y``: its third along it and to the left.
    """
    c, f = vector(apart, 0.0 * apart), vector(x, y)
    near = Line(cis(leg), cis(plate))
    lies = corrected(on_guide(near, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    lies = corrected(on_guide(lies, first, second, third, c, f))
    return pricked_plate(
        on_guide(lies, first, second, third, c, f), on_guide(near, first, second, third, c, f)
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace_on_guides(
    first: Arc,
    second: Line,
    third: Line,
    apart: Length,
    x: Length,
    y: Length,
    leg: Angle,
    plate: Angle,
) -> Line:
    """On tracing paper lay the plate ({apart}; {x}, {y}) on {first}, {second} and {third}; prick {it} through.

    ``apart``: its second point from the first along its line; ``x``, ``y``: its third along it and to the left.
    """
    c, f = vector(apart, 0.0 * apart), vector(x, y)
    near = Line(cis(leg), cis(plate))
    lies = corrected(on_guides(near, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    lies = corrected(on_guides(lies, first, second, third, c, f))
    return pricked_plate(
        on_guides(lies, first, second, third, c, f), on_guides(near, first, second, third, c, f)
    )


@operation(symbol=FREE, why=said("The first of the three points stands where the line begins."))
def prick(line: Line) -> Point:
    """Where {line} begins, prick {it} through."""
    return Point(line.at + 0.0 * line.along)
