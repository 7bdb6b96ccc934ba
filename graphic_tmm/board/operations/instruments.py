"""The instruments: pencil, square, compass, ruler. One function = geometry + kinds + sentence.

Lines and arcs are met in forms that stay accurate near tangency and near parallel lines (Kahan's form of
Heron's formula, the wedge of unit directions), and each knows its own condition and its own gap.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import (
    PARALLEL,
    along,
    cis,
    degrees,
    pick,
    reverse,
    root,
    some,
    unit,
    vector,
    wedge,
)
from graphic_tmm.board.grammar import ANGLE, FREE, JOIN, RAY, READ, SLIDE, Gap, operation
from graphic_tmm.board.values import Angle, Arc, Length, Line, Point, Reals, Side
from graphic_tmm.language.said import said

_NO_LINE = "the two points coincide"


@operation(symbol=JOIN, fails=_NO_LINE, why=said("A line is fixed by two of its points."))
def join(start: Point, end: Point) -> Line:
    """Draw the line {it} through {start} and {end}."""
    return Line(start, unit(end - start))


@operation(symbol=RAY, swings=True, why=said("A line is fixed by a point of it and its direction."))
def ray(start: Point, angle: Angle) -> Line:
    """From {start} draw the ray {it} at the angle {angle} to the x axis."""
    return Line(start, cis(angle))


@operation(
    symbol=SLIDE,
    swings=True,
    why=said("A line is fixed by a point of it and its direction, here that of {to}."),
)
def parallel(through: Point, to: Line, *, sense: int = 1) -> Line:
    """Through {through} draw {it} parallel to {to}."""
    return Line(through, to.along if sense > 0 else reverse(to.along))


@operation(
    symbol=SLIDE,
    swings=True,
    why=said(
        "A line is fixed by a point of it and its direction, here that of the normal to {to}."
    ),
)
def square(through: Point, to: Line, *, sense: int = 1) -> Line:
    """Through {through} draw {it} square to {to}."""
    return Line(through, to.along * (1j * sense))


@operation(
    symbol=RAY,
    swings=True,
    why=said("A line is fixed by a point of it and its direction, here at a known angle to {to}."),
)
def incline(through: Point, to: Line, by: Angle) -> Line:
    """Through {through} draw {it} at the angle {by} to {to}."""
    return Line(through, to.along * cis(by))


@operation(
    symbol=f"M1 + R1 + M2 + {SLIDE} + {SLIDE}",
    why=said("What keeps its distance {by} from {to} moves along a parallel to it."),
)
def shift(to: Line, by: Length) -> Line:
    """Parallel to {to}, at the distance {by} to its left, draw {it}."""
    return Line(to.at + by * (1j * to.along), to.along)


@operation(
    symbol="M1 + R1 + M2",
    why=said("{it} stands on {on}, and its distance from the beginning is known."),
)
def lay_off(on: Line, length: Length) -> Point:
    """On {on} lay off {length} from its beginning; mark {it}."""
    return Point(on.at + length * on.along)


@operation(
    symbol=f"2M1 + 2R1 + 2M2 + {SLIDE}",
    why=said("{it} is known by its distances along {on} and square to it."),
)
def place(on: Line, x: Length, y: Length) -> Point:
    """On {on} lay off {x} from its beginning and, square to it to the left, {y}; mark {it}."""
    return Point(on.at + vector(x, y) * on.along)


@operation(
    symbol="3C1 + C3",
    why=said("All points at the distance {radius} from {centre} lie on this arc."),
)
def strike(centre: Point, radius: Length) -> Arc:
    """With the compass at {centre} and the opening {radius} strike the arc {it}."""
    return Arc(centre, radius)


def _meet_condition(base: Line, other: Line) -> Reals:
    return np.asarray(1.0 / np.abs(wedge(base.along, other.along)))


@operation(
    symbol=FREE,
    condition=_meet_condition,
    fails="the lines are parallel",
    why=said("{it} has to lie on both lines."),
)
def meet(base: Line, other: Line) -> Point:
    """Where {base} and {other} meet, mark {it}.

    The point is found along the line that begins nearer to it, so that a line that begins in the answer
    gives it exactly.
    """
    between = other.at - base.at
    sine = wedge(base.along, other.along)
    parallel_ = np.abs(sine) <= PARALLEL
    if some(parallel_):
        sine = np.where(parallel_, np.nan, sine)
    # both ways are these by the sine: the shorter shows before
    first, second = wedge(between, other.along), wedge(between, base.along)
    nearer = np.abs(first) <= np.abs(second)
    way = pick(nearer, first, second) / sine
    return Point(pick(nearer, base.at, other.at) + way * pick(nearer, base.along, other.along))


def _cut_gap(line: Line, arc: Arc, side: Side) -> Reals:
    return np.asarray(arc.radius - np.abs(wedge(line.along, arc.centre - line.at)))


def _cut_condition(line: Line, arc: Arc, side: Side) -> Reals:
    height = wedge(line.along, arc.centre - line.at)
    half = np.sqrt(np.maximum((arc.radius - height) * (arc.radius + height), 0.0))
    return np.asarray(arc.radius / half)


@operation(
    symbol=FREE,
    condition=_cut_condition,
    fails="the arc does not reach the line",
    sides=("along it", "back along it"),
    gaps=(Gap(_cut_gap, "the opening of the arc {arc} is too short to reach {line}"),),
    why=said(
        "{it} has to lie on the line and on the arc; of the two points that do it is the one on this side."
    ),
)
def cut(line: Line, arc: Arc, side: Side) -> Point:
    """Where the arc {arc} cuts {line}, {side} from the foot of the arc's centre, mark {it}.

    ``side``: +1 for the point that lies along the line from the foot of the arc's centre.
    """
    to_centre = arc.centre - line.at
    height, foot = np.abs(wedge(line.along, to_centre)), along(to_centre, line.along)
    gap, reach = arc.radius - height, arc.radius + height
    # the line's direction is rounded: the further it begins from the arc, the less is known of the gap
    half = root(gap * reach, gap, reach + np.abs(foot))
    return Point(line.at + (foot + side * half) * line.along)


def _outer_gap(first: Arc, second: Arc, side: Side) -> Reals:
    return np.asarray(first.radius + second.radius - np.abs(second.centre - first.centre))


def _inner_gap(first: Arc, second: Arc, side: Side) -> Reals:
    return np.asarray(np.abs(second.centre - first.centre) - np.abs(first.radius - second.radius))


def _cross_condition(first: Arc, second: Arc, side: Side) -> Reals:
    base = second.centre - first.centre
    at = wedge(base, cross.run(first, second, side) - first.centre)
    return np.asarray(first.radius * second.radius / np.abs(at))


@operation(
    symbol=FREE,
    condition=_cross_condition,
    fails="the arcs do not meet",
    sides=("to the left", "to the right"),
    gaps=(
        Gap(_outer_gap, "the openings of {first} and {second} together are too short"),
        Gap(_inner_gap, "the openings of {first} and {second} differ too much"),
    ),
    why=said("{it} has to lie on both arcs; of the two points that do it is the one on this side."),
)
def cross(first: Arc, second: Arc, side: Side) -> Point:
    """Where the arcs {first} and {second} meet, {side} going from centre to centre, mark {it}.

    ``side``: +1 for the point to the left when one goes from the first centre to the second.
    The height over the base is twice the triangle's area by its base, the area in Kahan's stable form.
    """
    base = second.centre - first.centre
    d, r, s = np.abs(base), first.radius, second.radius
    high, low = np.maximum(r, s), np.minimum(r, s)
    c = np.minimum(low, d)
    a = np.maximum(high, d)
    b = np.maximum(low, np.minimum(high, d))
    between = a - b
    gap = c - between
    area = root((a + (b + c)) * gap * (c + between) * (a + (b - c)), gap, a)
    # foot and height as shares of the base
    square = d * d
    foot = 0.5 + 0.5 * ((r - s) * (r + s)) / square
    return Point(first.centre + base * vector(foot, side * (0.5 * area / square)))


def _near_gap(through: Point, centre: Point, radius: Length, side: Side) -> Reals:
    return np.asarray(np.abs(through - centre) - np.abs(radius))


def _tangent_condition(through: Point, centre: Point, radius: Length, side: Side) -> Reals:
    d = np.abs(through - centre)
    return np.asarray(d / np.sqrt(np.maximum((d - radius) * (d + radius), 0.0)))


@operation(
    symbol="3C1 + C3 + 2R1 + R2",  # the edge is laid to the circle by eye
    swings=True,
    condition=_tangent_condition,
    fails="the point lies inside the circle",
    gaps=(
        Gap(
            _near_gap, "{through} comes nearer to {centre} than the distance {radius} of the guide"
        ),
    ),
    sides=("directed from the centre to the point", "directed from the point to the centre"),
    why=said("The line passes {centre} at the distance {radius}, so it touches that circle."),
)
def tangent(through: Point, centre: Point, radius: Length, side: Side) -> Line:
    """From {through} draw the tangent {it} to the circle of radius {radius} about {centre}, {side}.

    ``radius`` is signed: the point lies that far to the left of the parallel through the centre. ``side``:
    +1 if the line's direction leads from the centre towards the point.
    """
    base = through - centre
    d = np.abs(base)
    gap = d - np.abs(radius)
    half = root(gap * (d + np.abs(radius)), gap, d)
    return Line(through, base * (1.0 / d) * vector(side * half / d, -radius / d))


def _rocker_gap(pivot: Point, stone: Point) -> Reals:
    return np.asarray(np.abs(stone - pivot))


def _rocker_condition(pivot: Point, stone: Point) -> Reals:
    return np.asarray((np.abs(pivot) + np.abs(stone)) / np.abs(stone - pivot))


@operation(
    symbol=JOIN,
    condition=_rocker_condition,
    fails="the stone stands on the rocker's pivot",
    gaps=(Gap(_rocker_gap, "{stone} passes over {pivot}"),),
    why=said(
        "The guide of the rocker goes through its pivot {pivot} and through {stone}, the pin of the stone "
        "that slides in it."
    ),
)
def rocker_line(pivot: Point, stone: Point) -> Line:
    """Through {pivot} and {stone} draw the line of the rocker {it}."""
    return Line(pivot, unit(stone - pivot))


@operation(
    symbol=JOIN,
    condition=_rocker_condition,
    fails="the pin of the piston rod stands on the cylinder's pivot",
    gaps=(Gap(_rocker_gap, "{pin} passes over {pivot}"),),
    why=said(
        "The axis of the cylinder goes through its pivot {pivot} and through {pin}, the pin of the piston "
        "rod, which slides along it."
    ),
)
def cylinder_axis(pivot: Point, pin: Point) -> Line:
    """Through {pivot} and {pin} draw the axis of the cylinder {it}."""
    return Line(pivot, unit(pin - pivot))


@operation(
    symbol=SLIDE,
    swings=True,
    sides=("in its sense", "against its sense"),
    why=said("The link lies along its guide {to}, and its own axis points this way."),
)
def directed(through: Point, to: Line, side: Side) -> Line:
    """Through {through} draw {it} along {to}, {side}."""
    return Line(through, side * to.along)


def _touch_gap(start: Point, arc: Arc, side: Side) -> Reals:
    return np.asarray(np.abs(start - arc.centre) - arc.radius)


@operation(
    symbol=f"{JOIN} + {SLIDE}",  # so too; the square from the centre marks the contact
    sides=("to the left", "to the right"),
    fails="the point lies inside the circle",
    gaps=(Gap(_touch_gap, "{start} lies inside the circle {arc}"),),
    why=said("A tangent is square to the radius of its contact."),
)
def touch(start: Point, arc: Arc, side: Side) -> Point:
    """From {start} draw the tangent to the arc {arc}, {side} of the way to its centre; mark the contact {it}.

    ``side``: +1 for the contact to the left when one goes from ``start`` to the centre.
    """
    base = start - arc.centre
    d = np.abs(base)
    gap = d - arc.radius
    half = root(gap * (d + arc.radius), gap, d)
    touching = vector(arc.radius / d, -side * half / d)
    return Point(arc.centre + arc.radius * touching * (base * (1.0 / d)))


@operation(
    symbol=f"2P1 + 2P3 + {RAY} + {RAY}",
    why=said(
        "The vectors between the points of one rigid link are all turned by one angle and scaled by one "
        "factor, so the images of its points form a figure similar to the link; hence the image of any further "
        "point."
    ),
    proportion="{base_a}{it}/{base_a}{base_b} = {A}{S}/{A}{B}",
)
def similar(base_a: Point, base_b: Point, A: Point, B: Point, S: Point) -> Point:
    """On {base_a}{base_b} build the figure similar to {A}{B}{S}, lettered in the same sense; mark {it}."""
    return Point(base_a + (base_b - base_a) * ((S - A) / (B - A)))


@operation(
    symbol=f"{READ} + {READ} + {READ} + N1 + {ANGLE} + {RAY} + M1 + R1 + M2",
    why=said(
        "The vectors between the points of one rigid link are all turned by one angle and scaled by one "
        "factor, and links that turn together share both: a segment of the plan is to its segment of the link "
        "as {a}{b} is to {A}{B}."
    ),
    proportion="{start}{it}/{a}{b} = {Q}{E}/{A}{B}",
)
def homologous(start: Point, a: Point, b: Point, A: Point, B: Point, Q: Point, E: Point) -> Point:
    """From {start} draw the segment that is to {Q}{E} as {a}{b} is to {A}{B}, turned alike; mark {it}."""
    return Point(start + (b - a) * ((E - Q) / (B - A)))


@operation(
    kept=True,
    why=said(
        "A link that does not turn carries all its points with one velocity and one acceleration: their images "
        "are one point."
    ),
)
def coincide(image: Point) -> Point:
    """The image {it} falls on {image}: the link does not turn."""
    return Point(image)


@operation(
    reads=True,
    why=said("The length on the drawing, times the scale factor, is the quantity that it shows."),
)
def measure(start: Point, end: Point) -> Length:
    """Measure {start}{end}."""
    return Length(np.abs(end - start))


@operation(
    reads=True,
    why=said(
        "The length, times the scale factor, is the quantity; its sign tells the sense along {on}."
    ),
)
def measure_along(start: Point, end: Point, on: Line) -> Length:
    """Measure {start}{end} along {on}, with its sign."""
    return Length(along(end - start, on.along))


@operation(symbol=ANGLE, why=said("The angle sought is that of a line which is drawn now."))
def bearing(start: Point, end: Point) -> Angle:
    """Find the angle of {start}{end} from the x axis."""
    return Angle(degrees(end - start))
