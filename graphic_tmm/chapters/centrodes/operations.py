"""What the board does for centrodes: points carried by the compass, curves that break where they run away."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import degrees, unit
from graphic_tmm.board.grammar import ANGLE, CURVE, READ, SUPPORT, operation
from graphic_tmm.board.operations.curve import natural, neighbours, periodic
from graphic_tmm.board.values import (
    Angle,
    Complexes,
    Curve,
    Length,
    Line,
    Number,
    Point,
    Reals,
)
from graphic_tmm.language.said import said

_GAUSS = np.polynomial.legendre.leggauss(8)
"""Places and weights by which the length of an arc of a curve is summed up."""
FAINT = 1e-3
"""A link that turns at this share of its usual rate has its centre as good as at infinity."""
_CENTRODE = said(
    "The centres of all positions make the centrode; where the centre runs to infinity between two positions "
    "it goes on in another branch."
)


@operation(
    symbol="6C1 + 2C3",
    why=said(
        "On a rigid link the point keeps its distances from {A} and {B}, and the side of {A}{B}."
    ),
)
def swing_over(first: Point, second: Point, A: Point, B: Point, P: Point) -> Point:
    """From {first} strike {A}{P}, from {second} {B}{P}; where the arcs meet, on the same side, mark {it}."""
    return Point(first + (second - first) * ((P - A) / (B - A)))


@operation(symbol=CURVE, across=True, why=_CENTRODE)
def branched_curve(through: Point, distance: Length, *, row: int, closed: int) -> Curve:
    """Through {through} draw the smooth curve {it}; it breaks where {distance} changes its sign.

    ``distance``: from an evenly driven pin to the centre, which is as 1/ω.
    """
    with np.errstate(all="ignore"):
        return _branches(through, 1.0 / distance, row, closed)


@operation(symbol=CURVE, across=True, why=_CENTRODE)
def branched_by_rate(through: Point, rate: Number, *, row: int, closed: int) -> Curve:
    """Through {through} draw the smooth curve {it}; it breaks where the link turns round, as {rate} tells."""
    return _branches(through, rate, row, closed)


def _branches(through: Complexes, weight: Reals, row: int, closed: int) -> Curve:
    """Return the curve with a knot in every position and one half way behind it, none where it breaks.

    A centre is a fraction: times its ``weight``, ω to any scale, it goes smoothly on even past infinity, where
    that changes its sign. So, where it does, splines of both give its tangents, however far it is.
    """
    through, weight = np.broadcast_arrays(through, weight)
    points, weights = through[:, :row], weight[:, :row]
    usual = np.median(np.nan_to_num(np.abs(weights)), axis=1, keepdims=True)
    points = np.where(np.abs(weights) > FAINT * usual, points, np.nan)
    knots = np.full((points.shape[0], 2 * row), np.nan + 1j * np.nan)
    tangents = knots.copy()
    for trial, (p, w) in enumerate(zip(points, weights, strict=True)):
        goes_on = w * np.roll(w, -1) > 0.0
        goes_on &= np.isfinite(p) & np.isfinite(np.roll(p, -1))
        goes_on[-1] &= bool(closed)
        w = np.where(np.isfinite(p), w, np.nan)
        if goes_on[: row if closed else -1].all():
            w = np.ones(row)
        with np.errstate(all="ignore"):
            top_rate, top_middle, top_slope = _halved(p * w, bool(closed))
            low_rate, low_middle, low_slope = _halved(w + 0j, bool(closed))
            middle = np.where(goes_on, top_middle / low_middle, np.nan)
            knots[trial, ::2], knots[trial, 1::2] = p, middle
            tangents[trial, ::2] = (top_rate - p * low_rate) / w / 2.0
            tangents[trial, 1::2] = (top_slope - middle * low_slope) / low_middle / 2.0
    chords = np.abs(np.roll(knots, -1, axis=1) - knots)
    longest = 3.0 * np.fmin(chords, np.roll(chords, 1, axis=1))
    size = np.abs(tangents)
    shorter = np.where(size > longest, longest / np.where(size > 0.0, size, 1.0), 1.0)
    return Curve(knots, np.where(np.isfinite(longest), tangents * shorter, np.nan), bool(closed))


def _halved(values: Complexes, closed: bool) -> tuple[Complexes, ...]:
    """Return the rates of a smooth quantity by position; it and its rates half way to the next position."""
    rates, there = np.full(values.shape, np.nan + 0j), np.isfinite(values)
    if closed and there.all():
        rates = periodic(values)
    else:
        for run in neighbours(there, closed=closed):
            rates[run] = natural(values[run])
    q, n = np.roll(values, -1), np.roll(rates, -1)
    middle = (values + q) / 2.0 + (rates - n) / 8.0
    return rates, middle, 1.5 * (q - values) - (rates + n) / 4.0


@operation(
    symbol=SUPPORT,
    across=True,
    fails="the curve does not go through this position",
    why=said("Where both centrodes touch they have one tangent."),
)
def curve_tangent(curve: Curve, *, place: int) -> Line:
    """To {curve} draw the tangent {it} in the position in which both centrodes touch."""
    knot = slice(2 * place, 2 * place + 1)
    return Line(curve.knots[:, knot], unit(curve.tangents[:, knot]))


@operation(
    symbol=ANGLE, why=said("Both tangents are one line: the angle shows how well they are drawn.")
)
def between_lines(first: Line, second: Line) -> Angle:
    """With the protractor measure {it}, the angle between {first} and {second}."""
    return Angle(degrees(second.along * np.conj(first.along)))


@operation(
    symbol=f"3C1 + {READ}",
    across=True,
    everywhere=True,
    reads=True,
    fails="the curve has no arc behind this position",
    why=said(
        "The moving centrode rolls on the fixed one without slipping: between two positions both have gone "
        "the same way."
    ),
)
def stepped_off(curve: Curve, through: Point) -> Length:
    """With the dividers step off {curve} from {through} to the next position; its length is {it}."""
    p, m = curve.knots, curve.tangents
    q, n = np.roll(p, -1, axis=1), np.roll(m, -1, axis=1)
    halves = np.zeros(p.shape)
    for t, weight in zip(*_GAUSS, strict=True):
        u = (t + 1.0) / 2.0
        rate = 6.0 * u * (1.0 - u) * (q - p) + (1.0 - u) * (1.0 - 3.0 * u) * m
        halves += weight / 2.0 * np.abs(rate + u * (3.0 * u - 2.0) * n)
    count = p.shape[1] // 2
    found = np.full((max(p.shape[0], through.shape[0]), through.shape[1]), np.nan)
    found[:, :count] = halves[:, ::2] + halves[:, 1::2]
    return Length(found)
