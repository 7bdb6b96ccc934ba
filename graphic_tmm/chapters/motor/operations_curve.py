"""A characteristic as numbers: the moment and its slope at any speed, where a curve of speeds comes to 0."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.values import Curve, Reals

ROUNDS = 12
"""Rounds in which a crossing is sought, by Newton's rule, or the speed with which a cycle begins and ends."""

BEYOND = 1.2
"""A characteristic is drawn so far, of the speed without load: behind it a motor brakes."""

STRAIGHT = 1e-6
"""A characteristic that bends less than this at its end is straight: Kloss's, with s_k = 100, bends by 1e-4."""

CLOSE = 1e-14
"""A crossing that Newton's rule moves by less than this share of an arc is there."""


def single(values: tuple[Any, ...]) -> list[Any]:
    """Return what is one for all positions, (trial, 1)."""
    return [value[:, :1] for value in values]


def _knot(values: Reals, first: np.ndarray) -> Reals:
    """Return the values at knots (trial, place) by their numbers."""
    return np.asarray(values[np.arange(len(values))[:, None], first])


class Motor(NamedTuple):
    """A characteristic in SI: speeds at the knots, moments there, their rise by knot (trial, knot)."""

    omega: Reals
    moment: Reals
    rise: Reals

    def cubic(self, first: np.ndarray) -> tuple[Reals, Reals, Reals, Reals]:
        """Return the coefficients of the arcs that begin at knots, by powers of the share of an arc."""
        p, q = _knot(self.moment, first), _knot(self.moment, first + 1)
        m, n = _knot(self.rise, first), _knot(self.rise, first + 1)
        rise = q - p
        return p, m, 3.0 * rise - 2.0 * m - n, m + n - 2.0 * rise

    def beyond(self, omega: Reals) -> Reals:
        """Return the moment at speeds behind the end of a characteristic, as it goes on there.

        A level one stays level. M = c·s/(s² + k) is both Kloss's formula and, with k → ∞, a straight one: the
        end's height and slope tell k. It ends at the speed without load times `BEYOND`.
        """
        end, y, slope = self.omega[:, -1:], self.moment[:, -1:], self.rise[:, -1:]
        s, last = 1.0 - BEYOND * omega / end, 1.0 - BEYOND
        level = (slope == 0.0) & (self.rise[:, -2:-1] == 0.0)
        # 1/(s² + k) = (1/s − M'/M)/(2·s), nothing where it is straight
        by_slip = -slope / self.omega[:, 1:2] * end / BEYOND
        part = (1.0 / last - by_slip / np.where(level, 1.0, y)) / (2.0 * last)
        part = np.where(np.abs(part) < STRAIGHT, 0.0, part)
        found = y * s / last / (1.0 + part * (s**2 - last**2))
        return np.where(level, y, found)

    def at(self, omega: Reals) -> Reals:
        """Return the moment at speeds (trial, place); a characteristic goes on behind its end."""
        inside = self.inside(omega)
        behind = omega > self.omega[:, -1:]
        return np.where(behind, self.beyond(omega), inside) if behind.any() else inside

    def inside(self, omega: Reals) -> Reals:
        """Return the moment at speeds (trial, place); behind its end that of the end."""
        last = self.omega.shape[1] - 1
        place = np.minimum(np.maximum(omega / self.omega[:, 1:2], 0.0), last)
        first = np.minimum(np.where(np.isnan(place), 0.0, place).astype(int), last - 1)
        u, (p, m, bend, twist) = place - first, self.cubic(first)
        return np.asarray(p + u * (m + u * (bend + u * twist)))


def motor_of(curve: Curve, mu_M: Reals, mu_omega: Reals) -> Motor:
    """Return a characteristic that is drawn, to its scales."""
    mu_M, mu_omega = single((mu_M, mu_omega))
    return Motor(curve.knots.real * mu_omega, curve.knots.imag * mu_M, curve.tangents.imag * mu_M)


def crossed(left: Motor, start: Reals, here: Reals) -> Reals:
    """Return where a curve next comes to 0: upwards of ``start`` where it is positive there, else downwards.

    ``here``: the curve there. NaN where the curve does not come to 0 before its end.
    """
    last, h = left.omega.shape[1] - 1, left.omega[:, 1:2]
    above = (left.omega > start) & (left.moment <= 0.0)
    below = (left.omega < start) & (left.moment >= 0.0)
    faster = here > 0.0
    up, down = above.argmax(axis=1), last - below[:, ::-1].argmax(axis=1)
    knot = np.where(faster[:, 0], np.maximum(up - 1, 0), np.minimum(down, last - 1))[:, None]
    p, m, bend, twist = left.cubic(knot)
    at = np.minimum(np.maximum(start / h - knot, 0.0), 1.0)
    low, high = np.where(faster, at, 0.0), np.where(faster, 1.0, at)
    u = at
    for _ in range(ROUNDS):
        value = p + u * (m + u * (bend + u * twist))
        positive = value > 0.0
        low, high = np.where(positive, u, low), np.where(positive, high, u)
        slope = m + u * (2.0 * bend + 3.0 * u * twist)
        new = u - value / np.where(slope < 0.0, slope, np.nan)
        new = np.where((new >= low) & (new <= high), new, (low + high) / 2.0)
        # a share that no longer changes stays, whatever the other trials need
        new = np.where(np.abs(new - u) <= CLOSE, u, new)
        if (new == u).all():
            break
        u = new
    there = np.where(faster[:, 0], above.any(axis=1), below.any(axis=1) & (down < last))[:, None]
    return np.where((here == 0.0) | ~there, np.where(here == 0.0, start, np.nan), h * (knot + u))
