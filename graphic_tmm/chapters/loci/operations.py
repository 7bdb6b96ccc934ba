"""Where a French curve meets what the loosened leg of a plate leaves its pin: an arc, or a guide."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.values import Arc, Complexes, Curve, Line, Point, Reals
from graphic_tmm.language.said import said

PARTS, HALVINGS = 16, 48
"""Parts of a stretch of the curve that are looked through; halvings of the one in which it crosses."""
NEAR = 2.0
"""So many points of the curve a crossing may be from where it is drawn exactly."""
_WHY = said(
    "With its third leg the plate lies where its third pin is on both: there are as many places as crossings."
)
_FAILS = "the curve does not meet it there"


@operation(symbol=FREE, across=True, fails=_FAILS, why=_WHY)
def cross_arc(curve: Curve, arc: Arc, *, after: int, outward: int) -> Point:
    """Where the curve {curve} meets the arc {arc}, mark {it}.

    ``after``: behind which of its points; ``outward``: 1 where it leaves the circle, −1 where it enters.
    """
    centre, radius = arc.centre[:, :1, None], arc.radius[:, :1, None]
    return Point(_crossing(curve, lambda z: np.abs(z - centre) - radius, after, outward))


@operation(symbol=FREE, across=True, fails=_FAILS, why=_WHY)
def cross_guide(curve: Curve, line: Line, *, after: int, outward: int) -> Point:
    """Where the curve {curve} meets the guide {line}, mark {it}.

    ``after``: behind which of its points; ``outward``: 1 where it comes to the left of it, −1 to the right.
    """
    at, along = line.at[:, :1, None], line.along[:, :1, None]
    return Point(_crossing(curve, lambda z: wedge(along, z - at), after, outward))


def _crossing(
    curve: Curve, height: Callable[[Complexes], Reals], after: int, outward: int
) -> Complexes:
    """Return where a closed curve's height changes its sign, next behind one of its points, (trial, 1)."""
    p, m = curve.knots[..., None], curve.tangents[..., None]
    q, n = np.roll(p, -1, axis=1), np.roll(m, -1, axis=1)

    def spot(t: Reals) -> Complexes:
        return np.asarray(p + t * (m + t * (3 * (q - p) - 2 * m - n + t * (2 * (p - q) + m + n))))

    shares = np.linspace(0.0, 1.0, PARTS + 1)
    high = outward * height(spot(shares[None, None, :]))
    changes = (high[..., :-1] < 0.0) & (high[..., 1:] >= 0.0)
    trials, count = changes.shape[:2]
    where = np.arange(count)[:, None] + (shares[:-1] + shares[1:]) / 2.0
    away = np.abs((where - after - 0.5 + count / 2.0) % count - count / 2.0)
    away = np.where(changes, away, np.inf).reshape(trials, -1)
    best = np.argmin(away, axis=1)
    stretch, part = best // PARTS, best % PARTS
    low, top = shares[part], shares[part + 1]
    rows = np.arange(trials)
    for _ in range(HALVINGS):
        middle = (low + top) / 2.0
        below = outward * height(spot(middle[:, None, None]))[rows, stretch, 0] < 0.0
        low, top = np.where(below, middle, low), np.where(below, top, middle)
    found = spot(((low + top) / 2.0)[:, None, None])[rows, stretch, 0]
    return np.where(away[rows, best] <= NEAR, found, np.nan)[:, None]
