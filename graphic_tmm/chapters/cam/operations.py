"""Operations for cams: smooth stretches of a curve, lines that touch them, profiles swept by a follower.

A moving phase is a stretch of the row of positions, evenly divided; ``first`` and ``last`` are its indices. A
law whose acceleration jumps has a stretch on either side of the jump, so that no curve is drawn smooth across
it.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import along, cis, degrees, wedge
from graphic_tmm.board.grammar import ANGLE, CURVE, FREE, RAY, SUPPORT, WHOLE_ROW, operation
from graphic_tmm.board.operations.curve import natural, neighbours, stationary
from graphic_tmm.board.operations.graph_curves import free_ends
from graphic_tmm.board.operations.graphs import EVEN
from graphic_tmm.board.values import Angle, Arc, Complexes, Curve, Length, Line, Number, Point, Side
from graphic_tmm.language.said import said

_MOST = ("highest", "lowest")


@operation(
    symbol=RAY,
    why=said(
        "Equal parts of the angle are equal parts of the semicircle: its points have the heights of the "
        "wave."
    ),
)
def divide_semicircle(arc: Arc, start: Line, by: Angle, *, sense: int) -> Point:
    """On the semicircle {arc} lay off the central angle {by} from {start}; mark {it}.

    ``sense``: 1 counter-clockwise, −1 clockwise.
    """
    return Point(arc.centre + arc.radius * start.along * cis(sense * by))


@operation(
    symbol=RAY,
    why=said(
        "Instead of the cam the frame is turned, the other way: the follower goes round the cam and its "
        "line with it."
    ),
)
def slew(through: Point, to: Line, by: Angle, *, sense: int) -> Line:
    """Through {through} draw {it} at the angle {by} to {to}.

    ``sense``: 1 to lay the angle off counter-clockwise, −1 clockwise.
    """
    return Line(through, to.along * cis(sense * by))


@operation(
    symbol=RAY,
    why=said("The normal of the profile makes the pressure angle with the way of the follower."),
)
def inward_normal(through: Point, to: Line, by: Angle, *, sense: int) -> Line:
    """Through {through} draw the normal {it} into the cam, at the angle {by} to {to}.

    ``to`` is directed out of the cam; ``sense`` as with `slew`.
    """
    return Line(through, -to.along * cis(sense * by))


@operation(
    symbol=ANGLE,
    fails="the two points coincide",
    why=said(
        "The pressure angle is that between the force, along the normal, and the way of the follower."
    ),
)
def slant(start: Point, end: Point, to: Line, *, sense: int) -> Angle:
    """Measure the angle of {start}{end} from {to}.

    ``sense``: 1 if it counts counter-clockwise, −1 clockwise; −180 … 180°.
    """
    return Angle(sense * degrees((end - start) * np.conj(to.along)))


@operation(
    symbol=FREE,
    sides=("along it", "back along it"),
    why=said("The follower's place is where its line cuts the circle."),
)
def cut_or_foot(line: Line, arc: Arc, side: Side) -> Point:
    """Where {arc} cuts {line}, {side} from the foot of its centre, or there if it does not, mark {it}."""
    to_centre = arc.centre - line.at
    height = wedge(line.along, to_centre)
    half = np.sqrt(np.maximum((arc.radius - height) * (arc.radius + height), 0.0))
    return Point(line.at + (along(to_centre, line.along) + side * half) * line.along)


@operation(symbol=FREE, why=said("Each phase has a law of its own; here they are put together."))
def in_turn(first: Length, second: Length, at: Number) -> Length:
    """On the first stretch take {first}, on the others {second}; this is {it}."""
    return Length(np.where(at > 0, first, second))


@operation(
    symbol=FREE,
    across=True,
    why=said("At the boundary of two phases the one law ends and the next begins."),
)
def phase_end(of: Point, *, at: int) -> Point:
    """Of the places of {of} mark the one {it} at the boundary of a phase."""
    return Point(of[:, at : at + 1])


@operation(
    symbol=CURVE,
    across=True,
    why=said("Within a phase the curve changes smoothly."),
)
def smooth_stretch(through: Point, *, first: int, last: int) -> Curve:
    """Through the points {through}, from one end of the stretch to the other, draw the smooth curve {it}.

    Where points are missing, each run of those that are there gets a natural spline of its own.
    """
    knots = np.asarray(through[:, first : last + 1])
    tangents = np.full_like(knots, np.nan)
    whole = np.isfinite(knots).all(axis=1)
    for trial in np.flatnonzero(~whole):
        for run in neighbours(np.isfinite(knots[trial]), closed=False):
            tangents[trial, run] = natural(knots[trial, run])
    if whole.any():
        tangents[whole] = free_ends(knots[whole])
    return Curve(knots, tangents, False)


@operation(
    symbol=CURVE,
    across=True,
    why=said("The profile touches the follower in each of its places: it is the envelope of them."),
)
def swept_profile(
    points: Point, normals: Line, pace: Length, step: Angle, *, first: int, last: int, sense: int
) -> Curve:
    """Through the points {points} draw the smooth profile {it}, square to the normals {normals}.

    ``pace``: how far the point runs along the profile while the cam turns by a radian; ``step``: the cam's
    angle between two points. ``sense``: 1 where the profile runs to the left of its inward normals, −1 to the
    right.
    """
    part = slice(first, last + 1)
    reach = pace[:, part] * np.radians(step[:, part])
    knots, way = np.broadcast_arrays(points[:, part], sense * 1j * normals.along[:, part] * reach)
    return Curve(np.array(knots), np.array(way), False)


@operation(
    symbol=SUPPORT,
    across=True,
    fails=WHOLE_ROW,
    why=said(
        "For a centre on this side of the tangent the pressure angle stays within the allowed one at every "
        "point of the curve; so the tangents at that angle bound the region of the centres."
    ),
)
def touch_curve(curve: Curve, to: Line, by: Angle, *, sense: int, left: int) -> Line:
    """At the angle {by} to {to} draw the line {it} that touches the curve {curve} and leaves it on one side.

    ``sense`` as with `slew`; ``left``: 1 for the line that has the curve on its right, −1 on its left.
    """
    way = to.along[:, :1] * cis(sense * by[:, :1])
    spot = _farthest(curve, left * 1j * way)
    return Line(spot, np.broadcast_to(way, spot.shape))


PASSES = 12
"""How often a ray is laid to the point farthest above it: each pass doubles its digits, from the highest on."""


@operation(
    symbol=SUPPORT,
    across=True,
    fails=WHOLE_ROW,
    why=said("The ray that is steepest touches the curve: all of it lies below."),
)
def steepest_ray(start: Point, curve: Curve) -> Line:
    """Turn the ruler about {start} until it touches the curve {curve} from above; draw the ray {it}."""
    way = np.ones((curve.knots.shape[0], 1), dtype=np.complex128)
    for _ in range(PASSES):
        spot = _farthest(curve, 1j * way)
        way = (spot - start[:, :1]) / np.abs(spot - start[:, :1])
    return Line(np.broadcast_to(start[:, :1], way.shape), way)


@operation(symbol=FREE, why=said("The spring has to hold everywhere: the steeper ray rules."))
def steeper_of_two(first: Line, second: Line) -> Line:
    """Of the rays {first} and {second} keep the steeper one, {it}."""
    steeper = wedge(first.along, second.along) > 0.0
    return Line(first.at, np.where(steeper, second.along, first.along))


@operation(symbol=FREE, why=said("Both bounds have to hold: the outer one rules."))
def outer_parallel(first: Line, second: Line, *, left: int) -> Line:
    """Of the parallels {first} and {second} keep the outer one, {it}.

    ``left``: 1 for the one farther to the left of their direction, −1 to the right.
    """
    farther = left * along(second.at - first.at, 1j * first.along) > 0
    there = np.isfinite(first.at) & np.isfinite(second.at)
    at = np.where(farther, second.at, first.at)
    return Line(np.where(there, at, np.nan), first.along)


@operation(
    symbol="E1 + E2",
    across=True,
    fails=WHOLE_ROW,
    sides=_MOST,
    why=said("The extreme of the curve decides."),
)
def crest_of_curve(curve: Curve, *, above: int) -> Point:
    """On the curve {curve} mark the {above} point {it}.

    ``above``: 1 for the highest, −1 for the lowest.
    """
    return Point(_farthest(curve, np.full((1, 1), above * 1j)))


@operation(
    symbol=FREE,
    sides=_MOST,
    why=said("Both have to hold: the farther one decides."),
)
def extreme_of_two(first: Point, second: Point, *, above: int) -> Point:
    """Of the points {first} and {second} take the {above}; this is {it}.

    ``above``: 1 for the higher, −1 for the lower. Of two that are as high but for rounding it is the first.
    """
    even = EVEN * np.fmax(np.abs(first), np.abs(second))
    there = np.isfinite(first) & np.isfinite(second)
    found = np.where(above * (second - first).imag > even, second, first)
    return Point(np.where(there, found, np.nan))


@operation(symbol=FREE, why=said("A bend to either side counts: the farther point decides."))
def farther_from_axis(first: Point, second: Point) -> Point:
    """Of the points {first} and {second} take the one farther from the axis; this is {it}.

    Of two that are as far but for rounding it is the first.
    """
    there = np.isfinite(first) & np.isfinite(second)
    farther = np.abs(second.imag) > (1.0 + EVEN) * np.abs(first.imag)
    return Point(np.where(there, np.where(farther, second, first), np.nan))


def _farthest(curve: Curve, way: Complexes) -> Complexes:
    """Return the point of an open curve farthest along directions (trial or 1, 1); missing if any of it is.

    Of points that are as far but for rounding it is the first of its knots, else of its crests.
    """
    turned = np.conj(way[:, :1])
    knots = np.broadcast_arrays(curve.knots, turned)[0]
    found = np.concatenate([knots, *stationary(knots, curve.tangents, turned)], axis=1)
    heights = np.nan_to_num((found * turned).real, nan=-np.inf)
    most = heights.max(axis=1, keepdims=True)
    # against the size of the curve: the heights of one that lies on the axis are rounding
    size = np.fmax.reduce(np.abs(knots), axis=1, keepdims=True)
    best = np.argmax(heights >= most - EVEN * np.fmax(size, np.abs(most)), axis=1)
    numbers = np.isfinite(curve.knots) & np.isfinite(curve.tangents)
    whole = np.all(numbers, axis=1, keepdims=True)
    return np.where(whole, np.take_along_axis(found, best[:, None], axis=1), np.nan)
