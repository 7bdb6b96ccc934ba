"""What the board does for centrodes: points carried by the compass, curves that break where they run away."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.geometry import degrees, unit, wedge
from graphic_tmm.board.grammar import ANGLE, CURVE, SLIDE, SUPPORT, operation
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
"""Sine of the angle at which normals meet as good as nowhere: a thousand times as far as they are apart."""
_CENTRODE = said(
    "The centres of all positions make the centrode; where the centre runs to infinity between two positions "
    "it goes on in another branch."
)


@operation(
    symbol="2E1 + 2E2 + 2M1 + 2R1 + 2M2",
    why=said("Centrodes have a scale of their own, so that their far points find room."),
)
def plot_over(point: Point, mu_l: Number, mu: Number) -> Point:
    """Carry {point} over to the drawing of the centrodes, which has the scale {mu}: mark {it}."""
    return Point(point * (mu_l / mu))


@operation(
    symbol=SLIDE,
    swings=True,
    fails="the point stands still for a moment",
    why=said("A point moves square to the line that joins it with the instantaneous centre."),
)
def velocity_normal(point: Point, tail: Point, head: Point) -> Line:
    """Through {point} draw {it} square to the velocity {tail}{head}."""
    along = _directed(head - tail)
    return Line(point + 0.0 * along, 1j * along)


@operation(
    symbol=SLIDE,
    swings=True,
    fails="the point stands still for a moment",
    why=said(
        "The plan of velocities is turned by 90°: its vector lies along the line that joins the point with "
        "the instantaneous centre."
    ),
)
def turned_normal(point: Point, tail: Point, head: Point) -> Line:
    """Through {point} draw {it} parallel to {tail}{head} of the turned plan."""
    along = _directed(head - tail)
    return Line(point + 0.0 * along, along)


def _directed(vector: Complexes) -> Complexes:
    """Return the direction of a vector, NaN of one without length."""
    size = np.abs(vector)
    return np.asarray(vector / np.where(size > 0.0, size, np.nan))


@operation(
    symbol="6C1 + 2C3",
    why=said(
        "On a rigid link the point keeps its distances from {A} and {B}, and the side of {A}{B}."
    ),
)
def swing_over(first: Point, second: Point, A: Point, B: Point, P: Point) -> Point:
    """From {first} strike {A}{P}, from {second} {B}{P}; where the arcs meet, on the same side, mark {it}."""
    return Point(first + (second - first) * ((P - A) / (B - A)))


@formula(why=said("Seen from a link that turns itself the other one turns by the difference."))
def relative_rate(of: Number, on: Number) -> Number:
    """{of} − {on}"""


@operation(symbol=CURVE, across=True, why=_CENTRODE)
def branched_curve(through: Point, first: Line, second: Line, *, row: int, closed: int) -> Curve:
    """Through {through} draw the smooth curve {it}; it breaks where {first} and {second} pass parallel.

    Lines that come to lie on each other, as at a change point, leave the centre between them.
    """
    sine = wedge(first.along, second.along)
    reach = np.sign(wedge(second.at - first.at, second.along))
    return _branches(through, sine, np.sign(sine), reach, row=row, closed=closed)


@operation(symbol=CURVE, across=True, why=_CENTRODE)
def branched_by_rate(
    through: Point, first: Line, second: Line, rate: Number, *, row: int, closed: int
) -> Curve:
    """Through {through}, where {first} and {second} meet, draw {it}; it breaks where {rate} turns round."""
    sine = wedge(first.along, second.along)
    return _branches(through, sine, np.sign(rate), np.ones((1, 1)), row=row, closed=closed)


def _branches(
    through: Complexes, sine: Reals, sides: Reals, reach: Reals, *, row: int, closed: int
) -> Curve:
    """Return the curve with a knot in every position and one half way behind it, none where it breaks.

    It breaks where ``sides`` change their sign and ``reach`` does not, and at a centre as good as at infinity.
    """
    points = np.where(np.abs(sine) > FAINT, through, np.nan)[:, :row]
    trials, row = points.shape
    along = [one[:, :row] if one.shape[1] > 1 else one for one in (sides, reach)]
    sides, reach = (np.broadcast_to(one, (trials, row)) for one in along)
    knots = np.full((trials, 2 * row), np.nan + 1j * np.nan)
    tangents = knots.copy()
    for k in range(trials):
        same = [one[k] * np.roll(one[k], -1) for one in (sides, reach)]
        goes_on = (same[0] > 0.0) | (same[0] * same[1] > 0.0)
        goes_on &= np.isfinite(points[k]) & np.isfinite(np.roll(points[k], -1))
        goes_on[-1] &= bool(closed)
        knots[k, ::2] = points[k]
        if goes_on.all():
            tangents[k, ::2] = periodic(points[k])
        else:
            for run in _runs(goes_on):
                tangents[k, 2 * run] = natural(points[k, run])
        p, m = points[k], tangents[k, ::2]
        q, n = np.roll(p, -1), np.roll(m, -1)
        knots[k, 1::2] = np.where(goes_on, (p + q) / 2.0 + (m - n) / 8.0, np.nan)
        tangents[k, 1::2] = np.where(goes_on, 0.75 * (q - p) - (m + n) / 8.0, np.nan)
    tangents[:, ::2] /= 2.0
    return Curve(knots, tangents, bool(closed))


def _runs(goes_on: np.ndarray) -> list[np.ndarray]:
    """Return the runs of positions that one branch goes through, in order."""
    row = goes_on.size
    there = np.repeat(True, 2 * row)
    there[1::2] = goes_on
    return [run[::2] // 2 for run in neighbours(there)] if row > 1 else []


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
    symbol="nC1 + nC2",
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
