"""A characteristic as numbers: the moment and its slope at any speed, where a curve of speeds comes to 0."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Curve, Reals

ROUNDS = 12
"""Rounds in which a crossing is sought, by Newton's rule, or the speed with which a cycle begins and ends."""


def single(*values: Any) -> list[Any]:
    """Return what is one for all positions, (trial, 1)."""
    return [value[:, :1] for value in values]


class Motor(NamedTuple):
    """A characteristic in SI: speeds at the knots, moments there, their rise by knot (trial, knot)."""

    omega: Reals
    moment: Reals
    rise: Reals

    def at(self, omega: Reals) -> Reals:
        """Return the moment at speeds (trial, 1); behind its end that of the end."""
        last = self.omega.shape[1] - 1
        place = np.clip(omega / self.omega[:, 1:2], 0.0, last)
        first = np.minimum(np.nan_to_num(np.floor(place)), last - 1).astype(int)
        u = place - first
        p, q = (np.take_along_axis(self.moment, first + k, axis=1) for k in (0, 1))
        m, n = (np.take_along_axis(self.rise, first + k, axis=1) for k in (0, 1))
        rise = q - p
        return np.asarray(p + u * (m + u * (3.0 * rise - 2.0 * m - n + u * (m + n - 2.0 * rise))))

    def slope(self, omega: Reals) -> Reals:
        """Return how much the moment changes with the speed, N·m·s."""
        h = self.omega[:, 1:2] / 2.0
        return np.asarray((self.at(omega + h) - self.at(omega - h)) / (2.0 * h))


def motor_of(curve: Curve, mu_M: Reals, mu_omega: Reals) -> Motor:
    """Return a characteristic that is drawn, to its scales."""
    mu_M, mu_omega = single(mu_M, mu_omega)
    return Motor(curve.knots.real * mu_omega, curve.knots.imag * mu_M, curve.tangents.imag * mu_M)


def crossed(left: Motor, start: Reals, here: Reals) -> Reals:
    """Return where a curve next comes to 0: upwards of ``start`` where it is positive there, else downwards.

    ``here``: the curve there.
    """
    last, h = left.omega.shape[1] - 1, left.omega[:, 1:2]
    above = (left.omega > start) & (left.moment <= 0.0)
    below = (left.omega < start) & (left.moment >= 0.0)
    up, down = np.argmax(above, axis=1), last - np.argmax(below[:, ::-1], axis=1)
    faster = here[:, 0] > 0.0
    knot = np.where(faster, np.maximum(up - 1, 0), np.minimum(down, last - 1))[:, None]
    p, q = (np.take_along_axis(left.moment, knot + k, axis=1) for k in (0, 1))
    m, n = (np.take_along_axis(left.rise, knot + k, axis=1) for k in (0, 1))
    bend, twist = 3.0 * (q - p) - 2.0 * m - n, m + n - 2.0 * (q - p)
    at = np.clip(start / h - knot, 0.0, 1.0)
    low, high = np.where(faster[:, None], at, 0.0), np.where(faster[:, None], 1.0, at)
    u = (low + high) / 2.0
    for _ in range(ROUNDS):
        value = p + u * (m + u * (bend + u * twist))
        low, high = np.where(value > 0.0, u, low), np.where(value > 0.0, high, u)
        slope = m + u * (2.0 * bend + 3.0 * u * twist)
        new = u - value / np.where(slope < 0.0, slope, np.nan)
        u = np.where((new >= low) & (new <= high), new, (low + high) / 2.0)
    there = np.where(faster, above.any(axis=1), below.any(axis=1))[:, None]
    return np.where((here == 0.0) | ~there, np.where(here == 0.0, start, np.nan), h * (knot + u))
