"""The French curve: a C² curve through points that are equally spaced in the crank's angle.

Through a closed row it is the periodic cubic spline; where some positions cannot be drawn, each run of
drawable ones gets a natural spline of its own. A path that is an arc is drawn with the compass.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.grammar import CURVE, operation
from graphic_tmm.board.values import Arc, Complexes, Curve, Point, Reals
from graphic_tmm.language.said import said

TAUT = 0.0
"""Of a curve that does not bulge: the share of the row's bend that its tangents may take; see `bounded`."""


@operation(
    symbol=CURVE,
    across=True,
    why=said(
        "The point goes smoothly through the places found in all positions: this is its path over a turn."
    ),
)
def french_curve(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it} with the French curve.

    ``row``: how many positions make the closed row; the positions after them (extremes, extra angles)
    stand outside the curve.
    """
    knots = np.asarray(through[:, :row])
    tangents = np.full_like(knots, np.nan)
    for trial in range(knots.shape[0]):
        points = knots[trial]
        drawn = np.isfinite(points)
        if drawn.all():
            tangents[trial] = periodic(points)
            continue
        for run in neighbours(drawn):
            tangents[trial, run] = natural(points[run])
    return Curve(knots, tangents, True)


@operation(
    symbol=CURVE,
    across=True,
    why=said(
        "The point goes smoothly through the places found in all positions: this is its path, there and back."
    ),
)
def open_curve(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw the smooth curve {it} with the French curve, first to last.

    ``row``: how many positions make the row; those after them stand outside the curve.
    """
    knots = np.asarray(through[:, :row])
    tangents = np.full_like(knots, np.nan)
    for trial in range(knots.shape[0]):
        for run in neighbours(np.isfinite(knots[trial]), closed=False):
            tangents[trial, run] = natural(knots[trial, run])
    return Curve(knots, tangents, False)


@operation(
    symbol="2C1 + C3",
    across=True,
    why=said(
        "The link turns about {centre}: its point {through} keeps its distance from there, its path is an arc."
    ),
)
def arc_through(centre: Point, through: Point, *, turn: int) -> Arc:
    """With the compass at {centre} draw the arc {it} through the points {through}.

    The opening is taken to the first of them that is there. ``turn``: how many positions make the row that
    comes back to where it began; 0 where it does not.
    """
    pivot = centre[:, :1]
    first = np.isfinite(through).argmax(axis=1)[:, None]
    return Arc(pivot, np.abs(np.take_along_axis(through, first, axis=1) - pivot))


@operation(
    symbol="nH1",
    across=True,
    why=said(
        "Valves open and close between the points that were read: the line has no bulge there that nobody "
        "measured."
    ),
)
def taut_curve(through: Point, *, row: int) -> Curve:
    """Through the points {through} draw by hand the closed line {it}, without bulges between them.

    At each point it runs along the chords to its neighbours, along the shorter one the more; where it turns
    back across or down it has its extreme. Where a point is missing there is no line.
    """
    knots = np.asarray(through[:, :row])
    before, after = knots - np.roll(knots, 1, axis=1), np.roll(knots, -1, axis=1) - knots
    short, long = np.abs(before), np.abs(after)
    way = before * (long / np.where(short > 0, short, np.inf))
    way += after * (short / np.where(long > 0, long, np.inf))
    turns = [(b * a <= 0) for b, a in ((before.real, after.real), (before.imag, after.imag))]
    way = np.where(turns[0], 0.0, way.real) + 1j * np.where(turns[1], 0.0, way.imag)
    size = np.abs(way)
    tangents = way / np.where(size > 0, size, 1.0) * np.minimum(short, long)
    tangents.real = bounded(knots.real, tangents.real, TAUT, closed=True)
    tangents.imag = bounded(knots.imag, tangents.imag, TAUT, closed=True)
    whole = np.isfinite(knots).all(axis=1, keepdims=True)
    return Curve(knots, np.where(whole, tangents, np.nan), True)


def bounded(heights: Reals, tangents: Reals, bend: float, *, closed: bool) -> Reals:
    """Return the tangents of a curve, brought so near to its chords that it does not ring.

    ``heights``, ``tangents``: of evenly spaced knots, (..., knot), a tangent as its rise over an interval.
    With ``bend`` 0 a tangent lies between 0 and three times either chord beside it, so that no arc leaves the
    range of its ends (Fritsch–Carlson), and two equal neighbours have a level piece. A ``bend`` b lets it reach
    as far as the chord and b times the lesser of the bends (second differences) at both ends of the arc, where
    these bend to the same side: an arc then bulges by b/4 of that bend at the most. Tangents inside these
    bounds stay as they are.
    """
    count = heights.shape[-1]
    if count < 2:
        return tangents
    rise = np.diff(heights, append=heights[..., :1]) if closed else np.diff(heights)
    first, second = _bends(rise, closed)
    same = np.sign(first) * np.sign(second) > 0.0
    give = bend * np.where(same, np.copysign(np.minimum(np.abs(first), np.abs(second)), first), 0.0)
    for reach, begin in ((rise - give, 0), (rise + give, 1)):
        # what an arc allows its first knot, then its last
        knots = (np.arange(rise.shape[-1]) + begin) % count
        reaches = np.array([np.zeros_like(rise), 3.0 * rise, reach])
        low, high = reaches.min(axis=0), reaches.max(axis=0)
        tangents = np.array(tangents)
        tangents[..., knots] = np.clip(tangents[..., knots], low, high)
    return tangents


def _bends(rise: Reals, closed: bool) -> tuple[Reals, Reals]:
    """Return the second differences at both ends of every arc; an open row's end bends as its neighbour."""
    if closed:
        turn = rise - np.roll(rise, 1, axis=-1)
        return turn, np.roll(turn, -1, axis=-1)
    turn = np.diff(rise)
    if not turn.size:
        return np.zeros_like(rise), np.zeros_like(rise)
    turn = np.concatenate([turn[..., :1], turn, turn[..., -1:]], axis=-1)
    return turn[..., :-1], turn[..., 1:]


def bezier(curve: Curve, trial: int = 0) -> list[Complexes]:
    """Return the curve as runs of 3n + 1 control points (complex, mm), in the order of the row."""
    knots, tangents = curve.knots[trial], curve.tangents[trial]
    drawn = np.isfinite(knots) & np.isfinite(tangents)
    if drawn.all():
        runs = [np.append(np.arange(knots.size), 0)] if curve.closed else [np.arange(knots.size)]
    else:
        runs = neighbours(drawn, closed=curve.closed)
    found = []
    for run in runs:
        p, m = knots[run], tangents[run] / 3
        controls = np.empty(3 * len(run) - 2, dtype=np.complex128)
        controls[0::3], controls[1::3], controls[2::3] = p, p[:-1] + m[:-1], p[1:] - m[1:]
        found.append(controls)
    return found


def neighbours(drawn: np.ndarray, *, closed: bool = True) -> list[np.ndarray]:
    """Return the runs (at least two long) of neighbouring positions of a row that can be drawn.

    In a closed row the last position is a neighbour of the first.
    """
    if not drawn.any():
        return []
    start = int(np.argmin(drawn)) if closed else 0
    order = (np.arange(drawn.size) + start) % drawn.size
    cuts = np.flatnonzero(~drawn[order])
    return [run[drawn[run]] for run in np.split(order, cuts) if drawn[run].sum() > 1]


def periodic(points: NDArray[Any]) -> NDArray[Any]:
    """Return the tangents of periodic cubic splines through evenly spaced points, (..., point)."""
    n = points.shape[-1]
    if n < 3:
        return np.zeros_like(points)
    right = 3.0 * (np.roll(points, -1, axis=-1) - np.roll(points, 1, axis=-1))
    found = np.fft.ifft(np.fft.fft(right) / (4.0 + 2.0 * np.cos(2.0 * np.pi * np.arange(n) / n)))
    return np.asarray(found if np.iscomplexobj(points) else found.real)


def natural(points: Complexes) -> Complexes:
    """Return the tangents of the natural cubic spline through evenly spaced points."""
    right = np.empty_like(points)
    right[1:-1] = 3.0 * (points[2:] - points[:-2])
    right[0], right[-1] = 3.0 * (points[1] - points[0]), 3.0 * (points[-1] - points[-2])
    main = np.full(points.size, 4.0)
    main[0] = main[-1] = 2.0
    for k in range(1, points.size):
        main[k] -= 1.0 / main[k - 1]
        right[k] -= right[k - 1] / main[k - 1]
    for k in range(points.size - 1, -1, -1):
        after = right[k + 1] if k + 1 < points.size else 0.0
        right[k] = (right[k] - after) / main[k]
    return np.asarray(right)


def stationary(p: Complexes, m: Complexes, turned: complex | Complexes) -> list[Complexes]:
    """Return the points of each arc of an open curve where its height Re(z·``turned``) is stationary.

    ``p``, ``m``: knots and tangents, (..., knot). Two arrays (..., arc), NaN where an arc has no such point.
    """
    p, q, m, n = p[..., :-1], p[..., 1:], m[..., :-1], m[..., 1:]
    h0, h1, g0, g1 = ((z * turned).real for z in (p, q, m, n))
    a, b, c = 6 * (h0 - h1) + 3 * (g0 + g1), 6 * (h1 - h0) - 4 * g0 - 2 * g1, g0
    inside: Reals = b * b - 4 * a * c
    root = np.sqrt(np.where(inside >= 0, inside, np.nan))
    half = -(b + np.copysign(root, b)) / 2
    shares = (half / np.where(a == 0, np.nan, a), c / np.where(half == 0, np.nan, half))
    return [_on_arc(p, q, m, n, np.where((u >= 0) & (u <= 1), u, np.nan)) for u in shares]


def _on_arc(p: Complexes, q: Complexes, m: Complexes, n: Complexes, t: Reals) -> Complexes:
    """Return places on cubic arcs between ends p and q with tangents m and n."""
    return p + t * (m + t * (3 * (q - p) - 2 * m - n + t * (2 * (p - q) + m + n)))
