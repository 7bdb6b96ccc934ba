"""Parts of a smooth curve in ink: cut where a construction says that it begins and ends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

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
    a, b, c, d = controls[3 * k : 3 * k + 4]
    t = u - k
    s = 1.0 - t
    return complex(s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d))


def nearest(controls: Sequence[complex], spot: complex) -> float:
    """Return where on a chain of cubic arcs the point nearest to ``spot`` stands."""
    arcs = len(controls) // 3
    spots = _sampled(tuple(controls))
    best = int(np.argmin(np.abs(spots - spot))) / _SAMPLES
    low, high = max(0.0, best - 1 / _SAMPLES), min(float(arcs), best + 1 / _SAMPLES)
    for _ in range(_NARROWINGS):
        u, v = low + _THIRD * (high - low), high - _THIRD * (high - low)
        if abs(at(controls, u) - spot) <= abs(at(controls, v) - spot):
            high = v
        else:
            low = u
    return (low + high) / 2


@lru_cache(maxsize=64)
def _sampled(controls: Controls) -> np.ndarray:
    """Return the points of a chain of cubic arcs at which the nearest is looked for first."""
    return points(controls, len(controls) // 3 * _SAMPLES + 1)


def cut(controls: Sequence[complex], start: float, end: float) -> Controls:
    """Return the part of a chain of cubic arcs between two of its places, run from ``start`` to ``end``."""
    if start > end:
        return cut(controls, end, start)[::-1]
    made: list[complex] = []
    for k in range(int(start), min(math.ceil(end), len(controls) // 3)):
        arc, u, v = controls[3 * k : 3 * k + 4], max(start - k, 0.0), min(end - k, 1.0)
        part = [_blossom(arc, knots) for knots in ((u, u, u), (u, u, v), (u, v, v), (v, v, v))]
        made += part if not made else part[1:]
    return tuple(made)


def points(controls: Sequence[complex], count: int) -> np.ndarray:
    """Return ``count`` points along a chain of cubic arcs, evenly by its arcs."""
    chain, arcs = np.asarray(controls), len(controls) // 3
    u = np.linspace(0.0, arcs, count)
    k = np.minimum(u.astype(int), arcs - 1)
    a, b, c, d = (chain[3 * k + n] for n in range(4))
    t = u - k
    s = 1.0 - t
    return s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d)  # type: ignore[no-any-return]


def _blossom(arc: Sequence[complex], knots: tuple[float, float, float]) -> complex:
    spots = list(arc)
    for t in knots:
        spots = [p + t * (q - p) for p, q in pairwise(spots)]
    return complex(spots[0])
