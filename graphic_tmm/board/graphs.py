"""Graphs on axes: smooth curves over an even base, their ordinates and tangents, chords in succession.

The base lies along the x axis of the sheet, from left to right; the row of positions divides it evenly, and
what stands at position ``row`` (the end of the base) is a mark of its own. Positions outside the row (extremes,
extra angles) have feet on the base too: a curve can be read there, but no chord begins there.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from graphic_tmm.board.curve import natural, neighbours, periodic
from graphic_tmm.board.geometry import unit
from graphic_tmm.board.grammar import WHOLE_ROW, operation
from graphic_tmm.board.values import Complexes, Curve, Length, Line, Point, Reals


@operation("Положение точки {of} в начале отсчёта отметить {it}.", across=True)
def at_zero(of: Point) -> Point:
    """Mark {it} where {of} stands in the zero position."""
    return Point(of[:, :1])


@operation(
    "Для каждого интервала: следующую за {point} точку отметить {it}; за последней следует {end}.",
    across=True,
)
def following(point: Point, end: Point, *, row: int) -> Point:
    """For each interval mark {it}, the point that follows {point}; after the last one comes {end}."""
    point, end = _alike(point, end)
    after = np.full_like(point, np.nan)
    after[:, : row - 1] = point[:, 1:row]
    after[:, row - 1] = end[:, 0]
    return Point(after)


def _alike(*values: Any) -> Any:
    """Return values with as many trials each."""
    trials = max(value.shape[0] for value in values)
    return [np.broadcast_to(value, (trials, value.shape[1])) for value in values]


@operation("Отрезок {start}{end} разделить пополам; отметить {it}.")
def halve(start: Point, end: Point) -> Point:
    """Halve {start}{end}; mark {it}."""
    return Point((start + end) / 2.0)


@operation(
    "Через точки {through} провести по лекалу плавную кривую {it}, замкнутую через {over}.",
    across=True,
)
def closed_graph(through: Point, over: Length, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it}, which repeats itself after {over}.

    Where points are missing, each run of those that are there gets a natural spline of its own.
    """
    points, shift = _alike(through[:, :row], over[:, :1])
    knots = np.concatenate([points[:, -1:] - shift, points, points[:, :1] + shift], axis=1)
    tangents = np.full_like(knots, np.nan)
    for trial, row_of_knots in enumerate(points):
        if np.isfinite(row_of_knots).all():
            m = periodic(row_of_knots.imag) * 1j + shift[trial] / row
            tangents[trial] = np.concatenate([m[-1:], m, m[:1]])
        else:
            _in_runs(knots[trial], tangents[trial])
    return Curve(knots, tangents, False)


@operation(
    "Через точки {through} и {end} провести по лекалу плавную кривую {it}.",
    across=True,
)
def open_graph(through: Point, end: Point, *, row: int) -> Curve:
    """Through the points {through} and {end} draw the smooth curve {it}.

    Its first two arcs are one cubic, and so are its last two; where points are missing, each run of those
    that are there gets a natural spline of its own.
    """
    return _open(np.concatenate(_alike(through[:, :row], end[:, :1]), axis=1))


@operation(
    "Через точки {through} провести по лекалу плавную кривую {it} и продолжить её на пол-интервала.",
    across=True,
)
def open_graph_of_middles(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it} and go on by half an interval at both ends."""
    inner = _open(through[:, :row])
    ends = []
    for k, u in ((0, -1.0), (row - 2, 2.0)):
        p, q = inner.knots[:, k : k + 1], inner.knots[:, k + 1 : k + 2]
        m, n = inner.tangents[:, k : k + 1], inner.tangents[:, k + 1 : k + 2]
        bend, twist = 3 * (q - p) - 2 * m - n, 2 * (p - q) + m + n
        ends.append((p + u * (m + u * (bend + u * twist)), m + u * (2 * bend + 3 * u * twist)))
    (first, rise), (last, fall) = ends
    knots = np.concatenate([first, inner.knots, last], axis=1)
    return Curve(knots, np.concatenate([rise, inner.tangents, fall], axis=1), False)


def _open(knots: Complexes) -> Curve:
    tangents = np.full_like(knots, np.nan)
    for trial, row_of_knots in enumerate(knots):
        if np.isfinite(row_of_knots).all() and row_of_knots.size > 3:
            tangents[trial] = not_a_knot(row_of_knots)
        else:
            _in_runs(row_of_knots, tangents[trial])
    return Curve(knots, tangents, False)


def _in_runs(knots: Complexes, tangents: Complexes) -> None:
    """Enter the tangents of a natural spline through each run of knots that are there."""
    drawn = np.isfinite(knots)
    for run in neighbours(drawn, closed=False):
        tangents[run] = natural(knots[run])


def not_a_knot(points: Complexes) -> Complexes:
    """Return the tangents of the C² curve whose first two arcs, and last two, are one cubic each."""
    n = points.size
    low, main, high = np.ones(n), np.full(n, 4.0), np.ones(n)
    right = np.empty_like(points)
    right[1:-1] = 3.0 * (points[2:] - points[:-2])
    main[0], high[0], low[-1], main[-1] = 1.0, 2.0, 2.0, 1.0
    right[0] = (-5.0 * points[0] + 4.0 * points[1] + points[2]) / 2.0
    right[-1] = (5.0 * points[-1] - 4.0 * points[-2] - points[-3]) / 2.0
    for k in range(1, n):
        share = low[k] / main[k - 1]
        main[k] -= share * high[k - 1]
        right[k] -= share * right[k - 1]
    found = np.empty_like(points)
    found[-1] = right[-1] / main[-1]
    for k in range(n - 2, -1, -1):
        found[k] = (right[k] - high[k] * found[k + 1]) / main[k]
    return found


_OUTSIDE = ("no curve stands over the foot", "над основанием нет кривой")


@operation(
    "Из {foot} восставить перпендикуляр к оси до кривой {curve}; отметить {it}.", fails=_OUTSIDE
)
def erect(curve: Curve, foot: Point) -> Point:
    """From {foot} erect the perpendicular to the axis up to the curve {curve}; mark {it}."""
    p, m, u = _arc(curve, foot)
    a, b, c, d = (2 * u + 1) * (u - 1) ** 2, u * (u - 1) ** 2, u**2 * (3 - 2 * u), u**2 * (u - 1)
    y = a * p[0].imag + b * m[0].imag + c * p[1].imag + d * m[1].imag
    return Point(foot.real + 1j * y)


@operation("Над {foot} провести касательную {it} к кривой {curve}.", fails=_OUTSIDE)
def touching(curve: Curve, foot: Point) -> Line:
    """Above {foot} draw the tangent {it} to the curve {curve}."""
    p, m, u = _arc(curve, foot)
    a, b, c = 6 * u * (u - 1), (3 * u - 1) * (u - 1), u * (3 * u - 2)
    along = a * (p[0] - p[1]) + b * m[0] + c * m[1]
    return Line(erect.run(curve, foot), unit(along))


def _arc(
    curve: Curve, foot: Complexes
) -> tuple[tuple[Complexes, Complexes], tuple[Complexes, Complexes], Reals]:
    """Return the ends and end tangents of the arc over each foot, and where on it the foot stands, 0 … 1."""
    knots = np.where(np.isfinite(curve.knots), curve.knots, np.nan + np.nan * 1j)
    x, tangents = _abscissas(curve.knots), curve.tangents
    trials, last = max(knots.shape[0], foot.shape[0]), knots.shape[1] - 2
    found = []
    for k in range(trials):
        own, at = min(k, knots.shape[0] - 1), foot.real[min(k, foot.shape[0] - 1)]
        near = np.clip(np.searchsorted(x[own], at, side="right") - 1, 0, last)
        u = (at - x[own, near]) / (x[own, near + 1] - x[own, near])
        p, m = knots[own], tangents[own]
        found.append((p[near], p[near + 1], m[near], m[near + 1], u))
    p, q, m, n, u = (np.array(rows) for rows in zip(*found, strict=True))
    slack = 1e-9
    return (p, q), (m, n), np.where((u >= -slack) & (u <= 1 + slack), u, np.nan)


def _abscissas(knots: Complexes) -> Reals:
    """Return where the knots stand along the base; a missing knot stands evenly between its neighbours."""
    x = np.array(knots.real)
    if np.isfinite(x).all():
        return x
    for row in x:
        there = np.isfinite(row)
        if 2 <= there.sum() < row.size:
            k = np.arange(row.size)
            even = np.polynomial.polynomial.polyfit(k[there], row[there], 1)
            row[~there] = np.polynomial.polynomial.polyval(k[~there], even)
    return x


@operation(
    "От {start} один за другим провести отрезки, над каждым интервалом параллельно его лучу {rays}; "
    "их начала отметить {it}.",
    across=True,
    fails=WHOLE_ROW,
)
def succession(start: Point, rays: Line, feet: Point, end: Point, *, row: int) -> Point:
    """From {start} draw segments over the intervals, each parallel to its ray {rays}; mark beginnings {it}.

    The intervals are those of ``feet`` and ``end``; each segment begins where the one before it ended.
    """
    rises = _rises(rays, feet, end, row)
    found = np.full(rises.shape[:1] + feet.shape[1:], np.nan + np.nan * 1j)
    y = start[:, :1].imag + np.concatenate([np.zeros_like(rises[:, :1]), rises[:, :-1]], 1).cumsum(
        1
    )
    found[:, :row] = feet[:, :row].real + 1j * y
    return Point(found)


@operation(
    "Конец последнего отрезка {rays} от {start} отметить {it}.", across=True, fails=WHOLE_ROW
)
def arrival(start: Point, rays: Line, feet: Point, end: Point, *, row: int) -> Point:
    """Mark {it} where the last of the segments drawn from {start} parallel to the rays {rays} ends."""
    rises = _rises(rays, feet, end, row)
    return Point(end[:, :1].real + 1j * (start[:, :1].imag + rises.sum(axis=1, keepdims=True)))


def _rises(rays: Line, feet: Point, end: Point, row: int) -> Reals:
    """Return by how much each segment rises over its interval, mm."""
    x = np.concatenate(_alike(feet[:, :row].real, end[:, :1].real), axis=1)
    along = rays.along[:, :row]
    slope = np.where(along.real == 0.0, np.nan, along.imag / along.real)
    return np.asarray(np.diff(x, axis=1) * slope)


@operation("Среди точек {points} найти высшую; отметить {it}.", across=True, fails=WHOLE_ROW)
def highest(points: Point, *, row: int) -> Point:
    """Find the highest of the points {points}; mark {it}."""
    return Point(_extreme(points[:, :row], 1.0))


@operation("Среди точек {points} найти низшую; отметить {it}.", across=True, fails=WHOLE_ROW)
def lowest(points: Point, *, row: int) -> Point:
    """Find the lowest of the points {points}; mark {it}."""
    return Point(_extreme(points[:, :row], -1.0))


def _extreme(points: Complexes, sign: float) -> Complexes:
    """Return the first of the highest (lowest) points; missing if any is missing, for it could be that one."""
    y = sign * points.imag
    best = np.take_along_axis(points, np.argmax(np.nan_to_num(y, nan=-np.inf), 1)[:, None], 1)
    return np.where(np.isfinite(points).all(axis=1, keepdims=True), best, np.nan + np.nan * 1j)
