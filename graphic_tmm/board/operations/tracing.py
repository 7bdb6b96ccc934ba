"""The plate on tracing paper: three of its points are laid on three loci, arcs or guides, and it is pricked.

Two plates that turn about pivots and are joined by two links are laid alike, each on a sheet of its own.

Nothing closed does that: of a plate on three links there are up to six places. Which of them is meant is given
as two angles near it; corrections in straight arithmetic lead to the place itself, or to none. How the plate
lies is kept as a `Line` of two directions: ``at`` that of its first link, ``along`` that of its own line.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.geometry import along, cis, pick, vector, wedge
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.values import Angle, Arc, Complexes, Length, Line, Point, Reals
from graphic_tmm.language.said import said

OFF = 1e-9
"""A plate whose points stay off their loci by more than this share of the lengths is not laid."""
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
    return 0.5 * ((arm.real * arm.real + arm.imag * arm.imag) / arc.radius - arc.radius)


def arc_normal(point: Complexes, arc: Arc) -> Complexes:
    """Return the direction in which a point goes away from an arc fastest; unit on the arc."""
    return (point - arc.centre) / arc.radius


def line_off(point: Complexes, line: Line) -> Reals:
    """Return how far a point is to the left of a line."""
    return wedge(line.along, point - line.at)


def held(lies: Line, c: Complexes, f: Complexes, second: Complexes, third: Complexes) -> Reals:
    """Return how well a plate is held, per length of it: 0 where it can move on its three loci.

    ``c``, ``f``: two of its points from the first, in its own axes; ``second``, ``third``: the normals there.
    """
    swing, turn = lies.at * 1j, lies.along * 1j
    return along(swing, second) * along(f * turn, third) - along(swing, third) * along(
        c * turn, second
    )


def turned_by(direction: Complexes, angle: Reals) -> Complexes:
    """Return a direction turned by about an angle, radians; it stays of length 1."""
    half = 0.5 * angle
    square = half * half
    return direction * vector((1.0 - square) / (1.0 + square), angle / (1.0 + square))


def corrected(
    lies: Line,
    radius: Reals,
    c: Complexes,
    f: Complexes,
    off: Complexes,
    second: Complexes,
    third: Complexes,
) -> Line:
    """Return how a plate lies after one correction; ``off``: how far its two points are off their loci."""
    swing, turn = radius * (lies.at * 1j), lies.along * 1j
    second_swing, second_turn = along(swing, second), along(c * turn, second)
    third_swing, third_turn = along(swing, third), along(f * turn, third)
    return _both_turned(lies, off, second_swing, second_turn, third_swing, third_turn)


def _both_turned(
    lies: Line, off: Complexes, first_at: Reals, first_along: Reals, at: Reals, along_: Reals
) -> Line:
    """Return both directions turned so that two lengths fit; the last four: how they grow as it turns."""
    share = 1.0 / (first_at * along_ - at * first_along)
    by_at = (off.imag * first_along - off.real * along_) * share
    by_along = (off.real * at - off.imag * first_at) * share
    return Line(turned_by(lies.at, by_at), turned_by(lies.along, by_along))


def on_arcs(lies: Line, first: Arc, second: Arc, third: Arc, c: Complexes, f: Complexes) -> Line:
    """Return how a plate lies after one correction, its points on three arcs."""
    b = first.centre + first.radius * lies.at
    at_c, at_f = b + c * lies.along, b + f * lies.along
    off = vector(arc_off(at_c, second), arc_off(at_f, third))
    at_second, at_third = arc_normal(at_c, second), arc_normal(at_f, third)
    return corrected(lies, first.radius, c, f, off, at_second, at_third)


def on_guide(lies: Line, first: Arc, second: Arc, third: Line, c: Complexes, f: Complexes) -> Line:
    """Return how a plate lies after one correction, its third point on a guide."""
    b = first.centre + first.radius * lies.at
    at_c, at_f = b + c * lies.along, b + f * lies.along
    off = vector(arc_off(at_c, second), line_off(at_f, third))
    normal = arc_normal(at_c, second)
    return corrected(lies, first.radius, c, f, off, normal, third.along * 1j)


def on_guides(
    lies: Line, first: Arc, second: Line, third: Line, c: Complexes, f: Complexes
) -> Line:
    """Return how a plate lies after one correction, two of its points on guides."""
    b = first.centre + first.radius * lies.at
    off = vector(line_off(b + c * lies.along, second), line_off(b + f * lies.along, third))
    return corrected(lies, first.radius, c, f, off, second.along * 1j, third.along * 1j)


class Square(NamedTuple):
    """Two plates about pivots with two links that join them: what is known of them before they are laid.

    ``to``, ``at``: the pivots; from these, in the plates' own axes, the pins of the links (``b`` from ``to``,
    ``c`` from ``at``); ``l``: how long the links are. Of a `Line` ``at`` is the direction of the plate about
    ``to``, ``along`` that of the one about ``at``.
    """

    to: Point
    at: Point
    b1: Complexes
    b2: Complexes
    c1: Complexes
    c2: Complexes
    l1: Reals
    l2: Reals


def first_joined(square: Square, lies: Line) -> Arc:
    """Return the arc of the first link about its pin on the plate about ``to``."""
    return Arc(square.to + square.b1 * lies.at, square.l1)


def second_joined(square: Square, lies: Line) -> Arc:
    """Return the arc of the second link about its pin on the plate about ``to``."""
    return Arc(square.to + square.b2 * lies.at, square.l2)


def square_off(square: Square, lies: Line) -> Complexes:
    """Return how far the pins of the plate about ``at`` are outside the arcs of both links."""
    at_c1, at_c2 = square.at + square.c1 * lies.along, square.at + square.c2 * lies.along
    return vector(
        arc_off(at_c1, first_joined(square, lies)), arc_off(at_c2, second_joined(square, lies))
    )


def grows(pins: Complexes, others: Complexes, along_it: Complexes) -> Complexes:
    """Return how a link would grow as the plate about ``to`` turns; imaginary, as that about ``at`` does."""
    return vector(-along(pins * 1j, along_it), along(others * 1j, along_it))


def first_grows(square: Square, lies: Line) -> Complexes:
    """Return how the first link would grow as the plates turn, see `grows`."""
    c1 = square.c1 * lies.along
    way = arc_normal(square.at + c1, first_joined(square, lies))
    return grows(square.b1 * lies.at, c1, way)


def second_grows(square: Square, lies: Line) -> Complexes:
    """Return how the second link would grow as the plates turn, see `grows`."""
    c2 = square.c2 * lies.along
    way = arc_normal(square.at + c2, second_joined(square, lies))
    return grows(square.b2 * lies.at, c2, way)


def square_held(square: Square, lies: Line) -> Reals:
    """Return how well the plates are held, per area: 0 where they can move."""
    return wedge(first_grows(square, lies), second_grows(square, lies))


def on_links(lies: Line, square: Square) -> Line:
    """Return how two plates lie after one correction, joined by two links."""
    one, two = first_grows(square, lies), second_grows(square, lies)
    off = square_off(square, lies)
    return _both_turned(lies, off, one.real, one.imag, two.real, two.imag)


def square_size(square: Square) -> Reals:
    """Return the lengths of which the plates may be off by a share."""
    return np.abs(square.c1) + np.abs(square.c2) + np.abs(square.b1) + np.abs(square.b2)


def pricked(
    start: Complexes, size: Reals, lies: Line, near: Line, off: Complexes, alike: Reals
) -> Line:
    """Return the plate's own line; NaN where its points are off their loci, or it went to another place.

    ``alike``: less than 0 where it is held there the other way round than near the place.
    """
    there = (
        (np.abs(off) <= OFF * size)
        & (alike >= 0.0)
        & (along(lies.at, near.at) > FAR)
        & (along(lies.along, near.along) > FAR)
    )
    plate = pick(there, lies.along, lies.along * np.nan)
    return Line(start, plate)


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
    lies = on_arcs(near, first, second, third, c, f)
    lies = on_arcs(lies, first, second, third, c, f)
    lies = on_arcs(lies, first, second, third, c, f)
    lies = on_arcs(lies, first, second, third, c, f)
    lies = on_arcs(lies, first, second, third, c, f)
    lies = on_arcs(lies, first, second, third, c, f)
    b = first.centre + first.radius * lies.at
    at_c, at_f = b + c * lies.along, b + f * lies.along
    off = vector(arc_off(at_c, second), arc_off(at_f, third))
    there = held(lies, c, f, arc_normal(at_c, second), arc_normal(at_f, third))
    begun = first.centre + first.radius * near.at
    second_normal = arc_normal(begun + c * near.along, second)
    third_normal = arc_normal(begun + f * near.along, third)
    alike = there * held(near, c, f, second_normal, third_normal)
    return pricked(b, first.radius + np.abs(c) + np.abs(f), lies, near, off, alike)


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
    lies = on_guide(near, first, second, third, c, f)
    lies = on_guide(lies, first, second, third, c, f)
    lies = on_guide(lies, first, second, third, c, f)
    lies = on_guide(lies, first, second, third, c, f)
    lies = on_guide(lies, first, second, third, c, f)
    lies = on_guide(lies, first, second, third, c, f)
    b = first.centre + first.radius * lies.at
    at_c, way = b + c * lies.along, third.along * 1j
    off = vector(arc_off(at_c, second), line_off(b + f * lies.along, third))
    there = held(lies, c, f, arc_normal(at_c, second), way)
    begun = first.centre + first.radius * near.at
    alike = there * held(near, c, f, arc_normal(begun + c * near.along, second), way)
    return pricked(b, first.radius + np.abs(c) + np.abs(f), lies, near, off, alike)


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
    lies = on_guides(near, first, second, third, c, f)
    lies = on_guides(lies, first, second, third, c, f)
    lies = on_guides(lies, first, second, third, c, f)
    lies = on_guides(lies, first, second, third, c, f)
    lies = on_guides(lies, first, second, third, c, f)
    lies = on_guides(lies, first, second, third, c, f)
    b = first.centre + first.radius * lies.at
    off = vector(line_off(b + c * lies.along, second), line_off(b + f * lies.along, third))
    second_normal, third_normal = second.along * 1j, third.along * 1j
    there = held(lies, c, f, second_normal, third_normal)
    alike = there * held(near, c, f, second_normal, third_normal)
    return pricked(b, first.radius + np.abs(c) + np.abs(f), lies, near, off, alike)


@operation(
    symbol="2P1 + 4P2 + 4R1 + 2R2",
    fails="the two plates cannot be laid so that both links join them",
    why=said(
        "Each plate turns about its own pivot and both links are rigid, so the plates are where both fit at "
        "once; of the places where they do it is the one next to that of the neighbouring position."
    ),
)
def trace_joined(
    to: Point,
    at: Point,
    b: Length,
    bx: Length,
    by: Length,
    c: Length,
    cx: Length,
    cy: Length,
    first: Length,
    second: Length,
    other: Angle,
    plate: Angle,
) -> Line:
    """Fit tracings ({b}; {bx}, {by}) at {to} and ({c}; {cx}, {cy}) at {at} to {first} and {second}; prick {it}.

    ``b``, ``c``: where the first link joins the plates, along their lines from the pivots; ``bx`` and so on:
    where the second does, along and to the left. The line pricked through is that of the plate about ``at``.
    """
    square = Square(
        to,
        at,
        vector(b, 0.0 * b),
        vector(bx, by),
        vector(c, 0.0 * c),
        vector(cx, cy),
        first,
        second,
    )
    near = Line(cis(other), cis(plate))
    lies = on_links(near, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    alike = square_held(square, lies) * square_held(square, near)
    off = square_off(square, lies)
    return pricked(at + 0.0 * lies.along, square_size(square), lies, near, off, alike)


@operation(symbol=FREE, why=said("The first of the three points stands where the line begins."))
def prick(line: Line) -> Point:
    """Where {line} begins, prick {it} through."""
    return Point(line.at + 0.0 * line.along)
