"""Machines of the literature with plates on three legs, as circles and lines that know nothing of the package.

Unknown coordinates in m satisfy polynomials; velocities and accelerations come of their derivatives, which
complex steps give exactly.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Complexes = npt.NDArray[np.complexfloating]
Reals = npt.NDArray[np.floating]
Off = Callable[[Complexes, complex], Complexes]
STEP = 1e-30
NUDGE = 1e-4
"""For accelerations, of the drive: between its two velocities the error is of the order of its square."""


class State(NamedTuple):
    """Unknowns and their derivatives by the drive."""

    q: Reals
    first: Reals
    second: Reals


def square(x: complex, y: complex) -> complex:
    """Return the squared length of a vector, complex where its parts are."""
    return x * x + y * y


class Judge:
    """Equations of a machine: ``off(q, drive)`` vanishes where it is assembled."""

    def __init__(self, off: Off) -> None:
        self.off = off

    def _jacobian(self, q: Reals, at: float) -> Reals:
        steps = 1j * STEP * np.eye(len(q))
        return np.array([self.off(q + step, at).imag / STEP for step in steps]).T

    def settled(self, q: Reals, at: float) -> Reals:
        """Return the unknowns near q by Newton."""
        for _ in range(30):
            q = q - np.linalg.solve(self._jacobian(q, at), self.off(q + 0j, at).real)
        assert np.abs(self.off(q + 0j, at)).max() < 1e-13
        return q

    def _rates(self, q: Reals, at: float) -> Reals:
        right = self.off(q + 0j, at + 1j * STEP).imag / STEP
        return np.linalg.solve(self._jacobian(q, at), -right)

    def state(self, near: Reals, at: float) -> State:
        """Return unknowns near those given, and their derivatives by the drive."""
        q = self.settled(near, at)
        ends = [self._rates(self.settled(q, at + way), at + way) for way in (NUDGE, -NUDGE)]
        return State(q, self._rates(q, at), (ends[0] - ends[1]) / (2 * NUDGE))

    def followed(self, near: Reals, begin: float, places: Reals) -> list[State]:
        """Return states at places of the drive, followed from the first unknowns by small steps."""
        q, at, row = self.settled(near, begin), begin, []
        for place in places:
            for part in np.linspace(at, place, 60)[1:]:
                q = self.settled(q, part)
            at = float(place)
            row.append(self.state(q, at))
        return row


class Gear(NamedTuple):
    """A link motion, m: throw, the other eccentric in the axes of the first, rods, half the link, hanger."""

    throw: float
    other: complex
    rod: float
    half: float
    hanger: float
    pivot: complex


def link(gear: Gear) -> Off:
    """Equations of the expansion link: C and D, the ends of the rods."""

    def off(q: Complexes, phi: complex) -> Complexes:
        cx, cy, dx, dy = q
        cos, sin, x, y = np.cos(phi), np.sin(phi), gear.other.real, gear.other.imag
        return np.array(
            [
                square(cx - gear.throw * cos, cy - gear.throw * sin) - gear.rod**2,
                square(dx - x * cos + y * sin, dy - x * sin - y * cos) - gear.rod**2,
                square(cx - dx, cy - dy) - 4 * gear.half**2,
                square((cx + dx) / 2 - gear.pivot.real, (cy + dy) / 2 - gear.pivot.imag)
                - gear.hanger**2,
            ]
        )

    return off


STEPHENSON = Gear(0.0635, -0.0500387 - 0.0390945j, 1.372, 0.15, 0.45, 1.4 + 0.53j)


def stephenson(q: Complexes, phi: complex) -> Complexes:
    """Return what is off with C, D and k, how far the die is on the link from C as a share of CD."""
    cy, dy, share = q[1], q[3], q[4]
    return np.append(link(STEPHENSON)(q[:4], phi), cy + share * (dy - cy))


ALLAN = Gear(0.06, -0.041680 - 0.043160j, 1.2, 0.15, 0.4, 1.22 + 0.43j)


def allan(q: Complexes, phi: complex) -> Complexes:
    """Return what is off with C, D, the die's share of CD, and the valve's x."""
    cx, cy, dx, dy, share, m = q
    kx, ky = cx + share * (dx - cx), cy + share * (dy - cy)
    rod = square(kx - m, ky) - 1.0
    hung = square((kx + m) / 2 - 1.72, ky / 2 - 0.365) - 0.16
    return np.append(link(ALLAN)(q[:4], phi), [rod, hung])


def hoist(q: Complexes, length: complex) -> Complexes:
    """Return what is off with A and B of Marrel's hoist, its cylinder ``length`` long."""
    ax, ay, bx, by = q
    ux, uy = (bx - ax) / 0.45, (by - ay) / 0.45
    cx, cy = ax + 0.15 * ux + 0.33 * uy, ay + 0.15 * uy - 0.33 * ux
    return np.array(
        [
            square(ax, ay) - 1.32**2 - 0.19**2,
            square(bx - 0.57, by + 0.11) - 1.24**2,
            square(bx - ax, by - ay) - 0.45**2,
            square(cx - 3.1, cy + 0.4) - length**2,
        ]
    )


SIX_PLACES = (
    (-8.715, 12.183, -0.987),
    (-5.495, -13.935, -0.047),
    (-14.894, 1.596, 0.244),
    (-13.417, -6.660, 0.585),
    (14.920, -1.337, 1.001),
    (14.673, -3.013, 2.133),
)
"""x, y of the platform's first pin and its angle, rad, at legs of 14.98, 15.38 and 12.

Zein M., Wenger P., Chablat D., Non-singular assembly-mode changing motions for 3-RPR parallel manipulators,
Mechanism and Machine Theory 43 (2008); the mechanism is that of Innocenti C. and Parenti-Castelli V. (1992).
From memory; with the printed lengths every place closes all legs to what its three decimals leave.
"""
LEGS = (14.98, 15.38, 12.0)
BASE = (0j, 15.91 + 0j, 10j)
SIDES = (17.04, 16.54, 20.84)


def pins(x: float, y: float, angle: float) -> tuple[complex, complex, complex]:
    """Return the platform's pins of a published place."""
    a, b, c = SIDES
    corner = math.acos((a * a + c * c - b * b) / (2 * a * c))
    first = complex(x, y)
    return (
        first,
        first + a * complex(math.cos(angle), math.sin(angle)),
        first + c * complex(math.cos(angle + corner), math.sin(angle + corner)),
    )
