"""Graphs on axes: what is read off their curves (ordinates, tangents, areas, extremes), chords in succession.

The base lies along the x axis of the sheet, from left to right; the row of positions divides it evenly, and
what stands at position ``row`` (the end of the base) is a mark of its own. Positions outside the row (extremes,
extra angles) have feet on the base too: a curve can be read there, but no chord begins there.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.geometry import unit, vector
from graphic_tmm.board.grammar import FREE, SLIDE, WHOLE_ROW, operation
from graphic_tmm.board.operations.curve import stationary
from graphic_tmm.board.values import Complexes, Curve, Length, Line, Number, Point, Reals
from graphic_tmm.language.said import said


@operation(
    kept=True,
    across=True,
    why=said("What follows is counted from the zero position."),
)
def at_zero(of: Point) -> Point:
    """Mark {it} where {of} stands in the zero position."""
    return Point(of[:, :1])


@operation(kept=True, across=True, why=said("What goes one way goes as far as the row does."))
def at_end(of: Point, *, row: int) -> Point:
    """Mark {it} where {of} stands in the last position of the row."""
    return Point(of[:, row - 1 : row])


@operation(
    symbol=FREE, across=True, why=said("Its place between two positions of the row is sought.")
)
def standing(of: Point, *, place: int) -> Point:
    """Mark {it}, where {of} stands in that position."""
    return Point(of[:, place : place + 1])


@operation(
    kept=True,
    across=True,
    everywhere=True,
    why=said("An interval of the row lies between a position and the one that follows."),
)
def following(point: Point, end: Point, *, row: int) -> Point:
    """For each interval mark {it}, the point that follows {point}; after the last one comes {end}."""
    point, end = alike(point, end)
    after = np.full_like(point, np.nan)
    after[:, : row - 1] = point[:, 1:row]
    after[:, row - 1] = end[:, 0]
    return Point(after)


def alike(*values: Any) -> Any:
    """Return values with as many trials each."""
    trials = max(value.shape[0] for value in values)
    return [np.broadcast_to(value, (trials, value.shape[1])) for value in values]


@operation(
    symbol="2R1 + R2 + 2C1 + 2C3",
    why=said(
        "What a chord or a rectangle tells is the mean of its interval, so it belongs to the middle."
    ),
)
def halve(start: Point, end: Point) -> Point:
    """Halve {start}{end}; mark {it}."""
    return Point((start + end) / 2.0)


_GAUSS = [half / 4.0 + sign / 48.0**0.5 for half in (1, 3) for sign in (-1, 1)]
"""Shares of an interval whose ordinates have the mean of two cubic arcs, one on either half."""
_OUTSIDE = "no curve stands over the foot"
BEYOND, LEAN = 1.1, 0.055
"""How far beyond an end of its curve a foot still means that end: in mm, and as a share of the ordinates there.

A curve ends where its last ordinate was drawn; what else was marked for that ordinate lies beside it by as much
as a hand pricks, and higher up by as much as the square leans: by five times the student's 0.15 mm · √2 and
0.6° at the most.
"""


@operation(
    symbol=SLIDE,
    fails=_OUTSIDE,
    why=said("The ordinate over a point of the base is what the graph shows there."),
)
def erect(curve: Curve, foot: Point) -> Point:
    """From {foot} erect the perpendicular to the axis up to the curve {curve}; mark {it}."""
    p, m, u = _arc(curve, foot)
    a, b, c, d = (2 * u + 1) * (u - 1) ** 2, u * (u - 1) ** 2, u**2 * (3 - 2 * u), u**2 * (u - 1)
    y = a * p[0].imag + b * m[0].imag + c * p[1].imag + d * m[1].imag
    return Point(foot.real + 1j * y)


HALVINGS = 40
"""How often the part of an arc is halved in which a place of it is sought: to 1e-12 of the arc."""
WHOLE = 1e-9
"""A number nearer to a whole one is that of a knot: it is worked out from the turn of the crank."""


@operation(
    symbol=SLIDE,
    why=said("Between two positions the line of the diagram tells what nobody laid off."),
)
def over(curve: Curve, number: Number, foot: Point, *, behind: int) -> Length:
    """Over {foot} read the height {it} of the closed curve {curve}, on its arc {number}.

    A foot beyond both ends of its arc (the piston turns between two positions) has the nearer end's height, and
    a whole number that of its knot: where the curve is upright a foot tells half of the digits. The arc is so
    many ``behind``.
    """
    count = curve.knots.shape[1]
    at, feet, knots, tangents = alike(number - behind, foot.real, curve.knots, curve.tangents)
    first = np.asarray(np.floor(at) % count, dtype=int)
    after = (first + 1) % count
    p, q = (np.take_along_axis(knots, k, axis=1) for k in (first, after))
    m, n = (np.take_along_axis(tangents, k, axis=1) for k in (first, after))
    low, high = np.zeros_like(feet), np.full_like(feet, 1.0)
    rises = np.where(q.real >= p.real, 1.0, -1.0)
    for _ in range(HALVINGS):
        u = (low + high) / 2.0
        before = (_between(p.real, q.real, m.real, n.real, u) - feet) * rises < 0.0
        low, high = np.where(before, u, low), np.where(before, high, u)
    knot = np.rint(at)
    u = np.where(np.abs(at - knot) <= WHOLE, knot - np.floor(at), (low + high) / 2.0)
    return Length(_between(p.imag, q.imag, m.imag, n.imag, u))


def _between(p: Reals, q: Reals, m: Reals, n: Reals, u: Reals) -> Reals:
    """Return a coordinate of cubic arcs between ends p and q with tangents m and n."""
    return np.asarray(
        p * (2 * u + 1) * (u - 1) ** 2
        + m * u * (u - 1) ** 2
        + q * u**2 * (3 - 2 * u)
        + n * u**2 * (u - 1)
    )


@operation(
    symbol=f"{SLIDE} + 2R1 + R2",
    fails=_OUTSIDE,
    why=said("The slope of the tangent is the derivative there."),
)
def touching(curve: Curve, foot: Point) -> Line:
    """Above {foot} draw the tangent {it} to the curve {curve}."""
    rise = rise_of(curve, foot)
    return Line(erect.run(curve, foot), unit(vector(np.full_like(rise, 1.0), rise)))


def rise_of(curve: Curve, foot: Complexes) -> Reals:
    """Return how steep a curve is over feet on the base, mm/mm."""
    p, m, u = _arc(curve, foot)
    a, b, c = 6 * u * (u - 1), (3 * u - 1) * (u - 1), u * (3 * u - 2)
    along = a * (p[0] - p[1]) + b * m[0] + c * m[1]
    # ordinates that lean together fold no curve: it is never steeper than twice what its chord's run tells
    return np.asarray(along.imag / np.maximum(along.real, (p[1] - p[0]).real / 2.0))


@operation(
    symbol=f"{SLIDE} + R2",  # by eye, so that as much is cut off as is added
    fails=_OUTSIDE,
    why=said(
        "The rectangle has the area of the figure: its height is the mean ordinate of the interval."
    ),
)
def level_off(curve: Curve, start: Point, end: Point) -> Point:
    """Over {start}{end} draw a rectangle as large as the figure below {curve}; mark {it}, its upper middle.

    It is exact for a curve whose cubic arcs begin at the ends of the intervals, or in their middles.
    """
    heights = [erect.run(curve, start + share * (end - start)).imag for share in _GAUSS]
    return Point((start.real + end.real) / 2.0 + 0.25j * sum(heights))


def _arc(
    curve: Curve, foot: Complexes
) -> tuple[tuple[Complexes, Complexes], tuple[Complexes, Complexes], Reals]:
    """Return the ends and end tangents of the arc over each foot, and where on it the foot stands, 0 … 1."""
    knots = np.where(np.isfinite(curve.knots), curve.knots, np.nan + np.nan * 1j)
    x = _abscissas(curve.knots)
    at, x, points, tangents = alike(foot.real, x, knots, curve.tangents)
    near = np.clip(knot_before(x, at), 0, knots.shape[1] - 2)
    low, high = (np.take_along_axis(x, k, axis=1) for k in (near, near + 1))
    u = (at - low) / (high - low)
    p, q = (np.take_along_axis(points, k, axis=1) for k in (near, near + 1))
    m, n = (np.take_along_axis(tangents, k, axis=1) for k in (near, near + 1))
    within = np.clip(u, 0.0, 1.0)
    beyond = np.abs(u - within)
    tall = np.max(np.abs([p.imag, q.imag, np.broadcast_to(foot.imag, u.shape)]), axis=0)
    near_enough = beyond * np.abs((q - p).real) <= BEYOND + LEAN * tall
    # rounding is left as it is: an end is what it was
    return (p, q), (m, n), np.where(beyond <= 1e-9, u, np.where(near_enough, within, np.nan))


def knot_before(x: Reals, at: Reals) -> NDArray[np.intp]:
    """Return the last knot that stands at or before each foot, row by row; -1 where none does."""
    found = np.asarray((x[:, None] <= at[:, :, None]).sum(axis=2))
    for k in np.flatnonzero(~(np.diff(x) >= 0.0).all(axis=1)):
        found[k] = np.searchsorted(x[k], at[k], side="right")
    return np.asarray(found - 1)


def _abscissas(knots: Complexes) -> Reals:
    """Return where the knots stand along the base; a missing knot stands evenly between its neighbours."""
    x = np.array(knots.real)
    if np.isfinite(x).all():
        return x
    for row in x:
        there = np.isfinite(row)
        if 2 <= there.sum() < row.size:
            k, count = np.arange(row.size), there.sum()
            middle, level = k[there].sum() / count, row[there].sum() / count
            off = k - middle
            even = (off[there] * row[there]).sum() / (off[there] * off[there]).sum()
            row[~there] = level + even * off[~there]
    return x


@operation(
    symbol="nE1 + nE2 + nR2",
    across=True,
    everywhere=True,
    fails=WHOLE_ROW,
    why=said(
        "Over each interval the integral grows by the interval times the mean ordinate: a segment parallel "
        "to the ray rises by just that, to the scale of the pole distance."
    ),
)
def succession(start: Point, rays: Line, feet: Point, end: Point, *, row: int) -> Point:
    """From {start} draw segments over the intervals, each parallel to its ray {rays}; mark beginnings {it}.

    The intervals are those of ``feet`` and ``end``; each segment begins where the one before it ended.
    """
    rises = _rises(rays, feet, end, row)
    found = np.full((rises.shape[0], feet.shape[1]), np.nan + np.nan * 1j)
    y = start[:, :1].imag + np.concatenate([np.zeros_like(rises[:, :1]), rises[:, :-1]], 1).cumsum(
        1
    )
    found[:, :row] = feet[:, :row].real + 1j * y
    return Point(found)


@operation(
    symbol=FREE,
    across=True,
    fails=WHOLE_ROW,
    why=said("The last segment ends at the integral over the whole turn."),
)
def arrival(start: Point, rays: Line, feet: Point, end: Point, *, row: int) -> Point:
    """Mark {it} where the last of the segments drawn from {start} parallel to the rays {rays} ends."""
    rises = _rises(rays, feet, end, row)
    return Point(end[:, :1].real + 1j * (start[:, :1].imag + rises.sum(axis=1, keepdims=True)))


def _rises(rays: Line, feet: Point, end: Point, row: int) -> Reals:
    """Return by how much each segment rises over its interval, mm."""
    x = np.concatenate(alike(feet[:, :row].real, end[:, :1].real), axis=1)
    along = rays.along[:, :row]
    slope = np.where(along.real == 0.0, np.nan, along.imag / along.real)
    return np.asarray(np.diff(x, axis=1) * slope)


@operation(
    symbol="E1 + E2",
    across=True,
    fails=WHOLE_ROW,
    why=said("Where this energy is greatest the flywheel runs fastest."),
)
def highest(curve: Curve, start: Point, end: Point) -> Point:
    """On the curve {curve}, from {start} to {end}, find the highest point; mark {it}."""
    return Point(_extreme(curve, start, end, 1.0))


@operation(
    symbol="E1 + E2",
    across=True,
    fails=WHOLE_ROW,
    why=said("Where this energy is least the flywheel runs slowest."),
)
def lowest(curve: Curve, start: Point, end: Point) -> Point:
    """On the curve {curve}, from {start} to {end}, find the lowest point; mark {it}."""
    return Point(_extreme(curve, start, end, -1.0))


_NOWHERE = complex(np.nan, np.nan)
EVEN = 1e-9
"""Ordinates that differ by less of the curve's height are as high as one another."""


def _extreme(curve: Curve, start: Complexes, end: Complexes, sign: float) -> Complexes:
    """Return the first of the highest (lowest) points; missing if any of the curve is, for it could be there.

    The first of those that are as high but for rounding, so that this does not choose among them.
    """
    feet = np.concatenate(alike(start[:, :1].real, end[:, :1].real), axis=1)
    knots, tangents, feet = alike(curve.knots, curve.tangents, feet)
    spots = np.concatenate([knots, *stationary(knots, tangents, -1j)], axis=1)
    spots = np.where((spots.real > feet[:, :1]) & (spots.real < feet[:, 1:]), spots, _NOWHERE)
    spots = np.concatenate([erect.run(curve, feet), spots], axis=1)
    heights = np.where(np.isfinite(spots), sign * spots.imag, -np.inf)
    best = heights.max(axis=1, keepdims=True)
    even = EVEN * np.ptp(knots.imag, axis=1, keepdims=True)
    first = np.argmin(np.where(heights >= best - even, spots.real, np.inf), axis=1)[:, None]
    whole = (np.isfinite(knots) & np.isfinite(tangents)).all(axis=1, keepdims=True)
    return np.where(whole, np.take_along_axis(spots, first, axis=1), _NOWHERE)
