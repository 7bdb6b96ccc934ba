"""Curves through the points of a graph: smooth ones, taut ones, ones whose tangents are known.

What a mechanism does (travel, velocity, energy of the links) is smooth, and rises above two equal neighbours
where it turns: a smooth curve has the tangents of a C² spline, and bulges between two points by no more than
a quarter of the lesser of the row's two bends there. What is laid on it (pressures, forces, moments) has
corners and level pieces: a taut curve never leaves the range of two neighbours. What was integrated against a
pole has its rays for tangents: it is drawn by them, and turns between the positions where it should.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from graphic_tmm.board.grammar import CURVE, operation
from graphic_tmm.board.operations.curve import TAUT, bounded, natural, neighbours, periodic
from graphic_tmm.board.operations.graphs import alike, rise_of
from graphic_tmm.board.values import Complexes, Curve, Length, Line, Point, Reals
from graphic_tmm.language.said import said

SMOOTH = 1.0
"""Share of the row's bend by which the tangents of a smooth curve may lie outside those of a taut one.

Measured on accelerations by chords of slider-cranks, shapers and Whitworth mechanisms at 8 … 36 positions: a
taut curve doubles the error of a slider-crank's; the bare spline, which rings by up to 22 % of the largest
acceleration of a quick return, is no nearer; this one stays below 12 %.
"""


@operation(
    symbol=CURVE,
    across=True,
    why=said(
        "What repeats itself turn by turn changes smoothly between the positions that were found."
    ),
)
def closed_graph(through: Point, over: Length, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it}, which repeats itself after {over}.

    Where points are missing, each run of those that are there gets a natural spline of its own.
    """
    return _closed(through, over, row, SMOOTH)


@operation(
    symbol=CURVE,
    across=True,
    why=said(
        "Nothing is known between the positions but that nothing leaps beyond its neighbours there."
    ),
)
def taut_graph(through: Point, over: Length, *, row: int) -> Curve:
    """Through {through} draw the curve {it}, closed over {over}, nowhere outside two neighbours' ordinates.

    It has corners and level pieces where the row has them.
    """
    return _closed(through, over, row, TAUT)


def _closed(through: Complexes, over: Any, row: int, bend: float) -> Curve:
    points, shift = alike(through[:, :row], over[:, :1])
    knots = np.concatenate([points[:, -1:] - shift, points, points[:, :1] + shift], axis=1)
    tangents = np.full_like(knots, np.nan)
    whole = np.isfinite(points).all(axis=1)
    for trial in np.flatnonzero(~whole):
        _in_runs(knots[trial], tangents[trial], bend)
    if whole.any():
        m = periodic(points[whole].imag)
        m = bounded(points[whole].imag, m, bend, closed=True)
        m = np.concatenate([m[:, -1:], m, m[:, :1]], axis=1)
        tangents[whole] = shift[whole] / row + 1j * m
    return Curve(knots, tangents, False)


@operation(
    symbol=f"{CURVE} + K1 + K2",
    across=True,
    why=said("Between the points that were found the graph changes smoothly."),
)
def open_graph(through: Point, end: Point, *, row: int) -> Curve:
    """Through the points {through} and {end} draw the smooth curve {it}.

    Its first two arcs are one cubic, and so are its last two; where points are missing, each run of those
    that are there gets a natural spline of its own.
    """
    return _open(np.concatenate(alike(through[:, :row], end[:, :1]), axis=1))


@operation(
    symbol=f"{CURVE} + K1 + K2",
    across=True,
    why=said("Chords tell the middles of the intervals; between them the graph changes smoothly."),
)
def open_graph_of_middles(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it} and go on by half an interval at both ends."""
    inner = _open(through[:, :row])
    (first, rise), (last, fall) = (_carried_on(inner, k, u) for k, u in ((0, -1.0), (row - 2, 2.0)))
    knots = np.concatenate([first, inner.knots, last], axis=1)
    return Curve(knots, np.concatenate([rise, inner.tangents, fall], axis=1), False)


def _carried_on(curve: Curve, k: int, u: float) -> tuple[Complexes, Complexes]:
    """Return the place and the tangent at ``u`` of the cubic that arc ``k`` of a curve is, beyond its ends."""
    p, q = curve.knots[:, k : k + 1], curve.knots[:, k + 1 : k + 2]
    m, n = curve.tangents[:, k : k + 1], curve.tangents[:, k + 1 : k + 2]
    bend, twist = 3 * (q - p) - 2 * m - n, 2 * (p - q) + m + n
    return p + u * (m + u * (bend + u * twist)), m + u * (2 * bend + 3 * u * twist)


@operation(
    symbol=CURVE,
    across=True,
    why=said("Within a stretch of one law the graph changes smoothly; at its ends it may leap."),
)
def graph_of_stretch(through: Point, *, first: int, last: int) -> Curve:
    """From one end of the stretch to the other draw the smooth curve {it} through the points {through}.

    Where points are missing, each run of those that are there gets a natural spline of its own.
    """
    return _open(np.asarray(through[:, first : last + 1]))


def _open(knots: Complexes) -> Curve:
    tangents = np.full_like(knots, np.nan)
    whole = np.isfinite(knots).all(axis=1) & (knots.shape[1] > 1)
    for trial in np.flatnonzero(~whole):
        _in_runs(knots[trial], tangents[trial], SMOOTH)
    if whole.any():
        tangents[whole] = _kept(knots[whole], free_ends(knots[whole]), SMOOTH)
    return Curve(knots, tangents, False)


def _in_runs(knots: Complexes, tangents: Complexes, bend: float) -> None:
    """Enter the tangents of a natural spline through each run of knots that are there."""
    for run in neighbours(np.isfinite(knots), closed=False):
        tangents[run] = _kept(knots[run], natural(knots[run]), bend)


def _kept(knots: Complexes, tangents: Complexes, bend: float) -> Complexes:
    return tangents.real + 1j * bounded(knots.imag, tangents.imag, bend, closed=False)


def free_ends(points: Complexes) -> Complexes:
    """Return the tangents of the C² curves whose first two arcs, and last two, are one cubic each.

    ``points``: (..., knot). Of three points those of their parabola, of two those of their chord.
    """
    n = points.shape[-1]
    # x and y by themselves: (..., knot, 2)
    z = np.ascontiguousarray(points)[..., None].view(np.float64)
    if n == 2:
        return _complex(np.repeat(np.diff(z, axis=-2), 2, axis=-2))
    first, second, last = z[..., 0, :], z[..., 1, :], z[..., -1, :]
    if n == 3:
        rise, bend = (last - first) / 2.0, first - 2.0 * second + last
        return _complex(np.stack([rise - bend, rise, rise + bend], axis=-2))
    low, main, high = np.ones(n), np.full(n, 4.0), np.ones(n)
    right = np.empty_like(z)
    right[..., 1:-1, :] = 3.0 * (z[..., 2:, :] - z[..., :-2, :])
    main[0], high[0], low[-1], main[-1] = 1.0, 2.0, 2.0, 1.0
    right[..., 0, :] = (-5.0 * first + 4.0 * second + z[..., 2, :]) / 2.0
    right[..., -1, :] = (5.0 * last - 4.0 * z[..., -2, :] - z[..., -3, :]) / 2.0
    for k in range(1, n):
        share = low[k] / main[k - 1]
        main[k] -= share * high[k - 1]
        right[..., k, :] -= share * right[..., k - 1, :]
    found = right * (1.0 / main)[:, None]
    for k in range(n - 2, -1, -1):
        found[..., k, :] = (right[..., k, :] - high[k] * found[..., k + 1, :]) * (1.0 / main[k])
    return _complex(found)


def _complex(z: Reals) -> Complexes:
    """Return points of their x and y, (..., 2)."""
    return np.ascontiguousarray(z).view(np.complex128)[..., 0]


@operation(
    symbol=f"{CURVE} + nP1 + nP2",
    across=True,
    why=said(
        "The slope of an integral is its integrand: at each point the curve is parallel to the ray of its "
        "ordinate."
    ),
)
def graph_of_rays(
    through: Point, end: Point, pole: Point, ordinates: Point, up: Line, *, row: int
) -> Curve:
    """Through {through} and {end} draw {it}, parallel there to rays from {pole} to {up} as high as {ordinates}.

    The ordinate at the end of the base is that at its beginning. Where a point or its ordinate is missing,
    so is the curve on both sides of it.
    """
    knots = np.concatenate(alike(through[:, :row], end[:, :1]), axis=1)
    rise = (ordinates[:, :row].imag - pole[:, :1].imag) / (up.at[:, :1] - pole[:, :1]).real
    rise = np.concatenate([rise, rise[:, :1]], axis=1)
    return _sloping(knots, rise)


@operation(
    symbol=f"{CURVE} + K1 + K2",
    across=True,
    why=said("At every position the ordinate is the difference of the ordinates of both curves."),
)
def graph_of_differences(
    through: Point, end: Point, first: Curve, second: Curve, *, row: int
) -> Curve:
    """Through {through} and {end} draw the curve {it} of the differences of the curves {first} and {second}.

    Where one of the two is missing, so is the curve.
    """
    knots = np.concatenate(alike(through[:, :row], end[:, :1]), axis=1)
    return _sloping(knots, rise_of(first, knots) - rise_of(second, knots))


@operation(
    symbol=CURVE,
    across=True,
    why=said(
        "Both quantities belong to one angle of the crank; drawn over one another the angle drops out."
    ),
)
def curve_of_two(through: Point, ordinates: Curve, *, row: int) -> Curve:
    """Eliminating the angle, draw the closed curve {it} through {through}; it rises and falls as {ordinates}.

    ``ordinates``: a graph whose knots are the row and the end of the base. Where a point is missing there is
    no curve.
    """
    knots, rise = alike(through[:, :row], ordinates.tangents[:, :row])
    along = periodic(knots.real)
    along = bounded(knots.real, along, SMOOTH, closed=True)
    whole = np.isfinite(knots).all(axis=1, keepdims=True)
    return Curve(np.asarray(knots), np.where(whole, along + 1j * rise.imag, np.nan), True)


def _sloping(knots: Complexes, rise: Any) -> Curve:
    """Return an open curve through knots evenly spaced along the base, which rises by ``rise`` in each."""
    knots, rise = alike(knots, rise)
    whole = (knots[:, -1:] - knots[:, :1]).real / (knots.shape[1] - 1)
    return Curve(np.asarray(knots), whole * (1.0 + 1j * rise), False)
