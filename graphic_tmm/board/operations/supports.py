"""Figures as a whole: the farthest of points, how far a line has swung, supporting lines, an area enclosed."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import along, cis, degrees, wedge
from graphic_tmm.board.grammar import ANGLE, SUPPORT, WHOLE_ROW, operation
from graphic_tmm.board.operations.curve import stationary
from graphic_tmm.board.values import Angle, Complexes, Curve, Line, Number, Point, Reals
from graphic_tmm.language.said import said

_ON = ("from above", "from below")


_BEFORE = 45.0
"""The protractor is laid on so that it reads so many degrees before its beginning."""


@operation(
    symbol=ANGLE,
    fails="the two points coincide",
    why=said("The angle between both lines tells the swing."),
)
def swung(first: Point, last: Point, start: Point, end: Point, *, sense: int) -> Angle:
    """With the protractor measure {it}, by which {start}{end} is turned from {first}{last}."""
    turned = sense * degrees((end - start) * np.conj(last - first))
    return Angle(np.where(turned < -_BEFORE, turned + 360.0, turned))


@operation(
    symbol="2C1",
    kept=True,
    across=True,
    fails=WHOLE_ROW,
    why=said("The stroke ends where the point is farthest from its beginning."),
)
def farthest(start: Point, points: Point, *, row: int) -> Point:
    """Find the point of {points} that is farthest from {start}; mark {it}."""
    inside = points[:, :row]
    reach = np.abs(inside - start[:, :1])
    at = np.argmax(np.nan_to_num(reach, nan=-1.0), axis=1)[:, None]
    whole = np.isfinite(inside).all(axis=1, keepdims=True)
    return Point(np.where(whole, np.take_along_axis(inside, at, axis=1), np.nan + np.nan * 1j))


@operation(
    symbol=SUPPORT,
    across=True,
    fails=WHOLE_ROW,
    sides=_ON,
    why=said("The line has the asked direction and leaves all points on one side."),
)
def supporting(points: Point, angle: Angle, *, row: int, above: int) -> Line:
    """At the angle {angle} draw the line {it} that rests on the points {points} {above}.

    ``above``: 1 for the line that leaves all points below it, −1 for the one that leaves them above it.
    """
    inside, way = points[:, :row], cis(angle[:, :1])
    height = above * along(inside, 1j * way)
    at = np.argmax(np.nan_to_num(height, nan=-np.inf), axis=1)[:, None]
    spot = np.take_along_axis(inside, at, axis=1)
    whole = np.isfinite(inside).all(axis=1, keepdims=True)
    return Line(np.where(whole, spot, np.nan), np.broadcast_to(way, spot.shape))


@operation(
    symbol=SUPPORT,
    across=True,
    fails=WHOLE_ROW,
    sides=_ON,
    why=said(
        "The slopes of the greatest and of the least speed bound the curve on its two sides: between these "
        "tangents the speed keeps its limits."
    ),
)
def supporting_curve(curve: Curve, angle: Angle, *, above: int) -> Line:
    """At the angle {angle} draw the tangent {it} that touches the closed curve {curve} {above}.

    ``above``: 1 for the line above the curve, −1 for the one below it.
    """
    way = cis(angle[:, :1])
    p, m = curve.knots, curve.tangents
    turned = above * np.conj(1j * way)
    round_ = np.append(np.arange(p.shape[1]), 0)
    found = stationary(p[:, round_], m[:, round_], turned)
    spots = np.concatenate(np.broadcast_arrays(p, *found), axis=1)
    heights = np.nan_to_num((spots * turned).real, nan=-np.inf)
    best = np.take_along_axis(spots, np.argmax(heights, axis=1)[:, None], axis=1)
    whole = (np.isfinite(p) & np.isfinite(m)).all(axis=1, keepdims=True)
    spot = np.where(whole, best, np.nan)
    return Line(spot, np.broadcast_to(way, spot.shape))


@operation(
    symbol="A1 + A2",
    across=True,
    fails=WHOLE_ROW,
    why=said("The area inside an indicator diagram is the work of a turn, to scale."),
)
def planimeter(curve: Curve) -> Number:
    """Go round {curve} with the planimeter; its area, mm², is {it}.

    It has no sign; it is exact for the cubic arcs of a closed curve.
    """
    p, m = curve.knots, curve.tangents
    q, n = np.roll(p, -1, axis=1), np.roll(m, -1, axis=1)
    return Number(np.abs(_sector(p, q, m, n).sum(axis=1, keepdims=True)))


def _sector(p: Complexes, q: Complexes, m: Complexes, n: Complexes) -> Reals:
    """Return ½∮(x dy − y dx) of Hermite arcs."""
    return np.asarray(wedge(p, q) / 2.0 + wedge(q - p, n - m) / 10.0 - wedge(m, n) / 60.0)
