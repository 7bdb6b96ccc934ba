"""The plate on tracing paper: three of its points are laid on three loci, arcs or guides, and it is pricked.

Nothing closed does that: of a plate on three links there are up to six places. Which of them is meant is given
as two angles near it; corrections in straight arithmetic lead to the place itself, or to none. How the plate
lies is kept as a `Line` of two directions: ``at`` that of its first link, ``along`` that of its own line.
"""

from __future__ import annotations

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


def _corrected(
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
    share = 1.0 / (second_swing * third_turn - third_swing * second_turn)
    by_leg = (off.imag * second_turn - off.real * third_turn) * share
    by_plate = (off.real * third_swing - off.imag * second_swing) * share
    return Line(turned_by(lies.at, by_leg), turned_by(lies.along, by_plate))


def on_arcs(lies: Line, first: Arc, second: Arc, third: Arc, c: Complexes, f: Complexes) -> Line:
    """Return how a plate lies after one correction, its points on three arcs."""
    b = first.centre + first.radius * lies.at
    at_c, at_f = b + c * lies.along, b + f * lies.along
    off = vector(arc_off(at_c, second), arc_off(at_f, third))
    at_second, at_third = arc_normal(at_c, second), arc_normal(at_f, third)
    return _corrected(lies, first.radius, c, f, off, at_second, at_third)


def on_guide(lies: Line, first: Arc, second: Arc, third: Line, c: Complexes, f: Complexes) -> Line:
    """Return how a plate lies after one correction, its third point on a guide."""
    b = first.centre + first.radius * lies.at
    at_c, at_f = b + c * lies.along, b + f * lies.along
    off = vector(arc_off(at_c, second), line_off(at_f, third))
    normal = arc_normal(at_c, second)
    return _corrected(lies, first.radius, c, f, off, normal, third.along * 1j)


def on_guides(
    lies: Line, first: Arc, second: Line, third: Line, c: Complexes, f: Complexes
) -> Line:
    """Return how a plate lies after one correction, two of its points on guides."""
    b = first.centre + first.radius * lies.at
    off = vector(line_off(b + c * lies.along, second), line_off(b + f * lies.along, third))
    return _corrected(lies, first.radius, c, f, off, second.along * 1j, third.along * 1j)


def _pricked(
    first: Arc, lies: Line, near: Line, off: Complexes, alike: Reals, c: Complexes, f: Complexes
) -> Line:
    """Return the plate's own line; NaN where its points are off their loci, or it went to another place.

    ``alike``: less than 0 where it is held there the other way round than near the place.
    """
    size = first.radius + np.abs(c) + np.abs(f)
    there = (
        (np.abs(off) <= OFF * size)
        & (alike >= 0.0)
        & (along(lies.at, near.at) > FAR)
        & (along(lies.along, near.along) > FAR)
    )
    plate = pick(there, lies.along, lies.along * np.nan)
    return Line(first.centre + first.radius * lies.at, plate)


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
    return _pricked(first, lies, near, off, alike, c, f)


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
    return _pricked(first, lies, near, off, alike, c, f)


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
    return _pricked(first, lies, near, off, alike, c, f)


@operation(symbol=FREE, why=said("The first of the three points stands where the line begins."))
def prick(line: Line) -> Point:
    """Where {line} begins, prick {it} through."""
    return Point(line.at + 0.0 * line.along)
