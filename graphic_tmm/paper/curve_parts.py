"""Parts of a smooth curve in ink: cut where a construction says that it begins and ends."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

Controls = tuple[complex, ...]
_SAMPLES = 16
"""Places of an arc that are tried before the best of them is narrowed; chosen by eye."""
_NARROWINGS = 60
"""Each leaves two thirds: 60 leave 3·10⁻¹¹ of an arc, far below what ink shows."""
_THIRD = 1.0 / 3.0


def at(controls: Sequence[complex], u: float) -> complex:
    """Return the point of a chain of cubic arcs at ``u``, 0 … the number of arcs."""
    k = min(int(u), len(controls) // 3 - 1)
    t = u - k
    return _blossom(controls[3 * k : 3 * k + 4], t, t, t)


def nearest(controls: Sequence[complex], spot: complex) -> float:
    """Return where on a chain of cubic arcs the point nearest to ``spot`` stands."""
    arcs = len(controls) // 3
    tried = [k / _SAMPLES for k in range(arcs * _SAMPLES + 1)]
    best = min(tried, key=lambda u: abs(at(controls, u) - spot))
    low, high = max(0.0, best - 1 / _SAMPLES), min(float(arcs), best + 1 / _SAMPLES)
    for _ in range(_NARROWINGS):
        u, v = low + _THIRD * (high - low), high - _THIRD * (high - low)
        if abs(at(controls, u) - spot) <= abs(at(controls, v) - spot):
            high = v
        else:
            low = u
    return (low + high) / 2


def cut(controls: Sequence[complex], start: float, end: float) -> Controls:
    """Return the part of a chain of cubic arcs between two of its places, run from ``start`` to ``end``."""
    if start > end:
        return cut(controls, end, start)[::-1]
    made: list[complex] = []
    for k in range(int(start), min(math.ceil(end), len(controls) // 3)):
        arc, u, v = controls[3 * k : 3 * k + 4], max(start - k, 0.0), min(end - k, 1.0)
        part = [_blossom(arc, *knots) for knots in ((u, u, u), (u, u, v), (u, v, v), (v, v, v))]
        made += part if not made else part[1:]
    return tuple(made)


def points(controls: Sequence[complex], count: int) -> np.ndarray:
    """Return ``count`` points along a chain of cubic arcs, evenly by its arcs."""
    return np.array([at(controls, u) for u in np.linspace(0.0, len(controls) // 3, count)])


def _blossom(arc: Sequence[complex], r: float, s: float, t: float) -> complex:
    """Return the point that de Casteljau's three rounds of shares leave of an arc."""
    a, b, c, d = arc
    a, b, c = a + r * (b - a), b + r * (c - b), c + r * (d - c)
    a, b = a + s * (b - a), b + s * (c - b)
    return a + t * (b - a)
