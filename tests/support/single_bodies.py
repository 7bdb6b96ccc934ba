"""Mechanisms as single bodies, moved by the constraints of their pairs.

A body is (x, y, θ); a turning pair makes two of its points one, a sliding pair keeps a point on a line and an
angle. Nothing is known here of groups, arcs or special points.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

Reals = np.ndarray


class Pin(NamedTuple):
    """A turning pair: points of two bodies, in their own axes, are one."""

    first: int
    a: complex
    second: int
    b: complex


class Guide(NamedTuple):
    """A sliding pair: a point of the first body keeps to a line of the second, the angle between both stays."""

    first: int
    a: complex
    second: int
    through: complex
    angle: float


@dataclass
class Bodies:
    """Bodies (the frame is 0, the crank 1) with their pairs; poses (complex place, angle) by number."""

    pins: list[Pin] = field(default_factory=list)
    guides: list[Guide] = field(default_factory=list)
    poses: dict[int, tuple[complex, float]] = field(default_factory=dict)

    def place(self, q: Reals, body: int, own: complex) -> complex:
        """Return where a point of a body stands."""
        z, angle = self._pose(q, body)
        return z + own * cmath.exp(1j * angle)

    def _pose(self, q: Reals, body: int) -> tuple[complex, float]:
        if body == 0:
            return 0j, 0.0
        x, y, angle = q[3 * body - 3 : 3 * body]
        return complex(x, y), float(angle)

    def start(self) -> Reals:
        """Return the poses as one row of numbers."""
        return np.array([part for k in sorted(self.poses) for part in self._row(k)])

    def _row(self, k: int) -> tuple[float, float, float]:
        z, angle = self.poses[k]
        return z.real, z.imag, angle

    def equations(self, q: Reals, phi: float) -> tuple[Reals, Reals]:
        """Return what should be zero, and its derivatives."""
        rows: list[float] = []
        slopes: list[Reals] = []

        def note(value: float, *parts: tuple[int, complex, complex, complex]) -> None:
            # parts: body, own point turned, the direction that counts, sign
            row = np.zeros(q.size)
            for body, arm, way, sign in parts:
                if body:
                    at = 3 * body - 3
                    row[at] += (way.conjugate() * sign).real
                    row[at + 1] += (way.conjugate() * 1j * sign).real
                    row[at + 2] += (way.conjugate() * 1j * arm * sign).real
            rows.append(value)
            slopes.append(row)

        for pin in self.pins:
            arms = [
                own * cmath.exp(1j * self._pose(q, k)[1])
                for k, own in ((pin.first, pin.a), (pin.second, pin.b))
            ]
            gap = self.place(q, pin.first, pin.a) - self.place(q, pin.second, pin.b)
            for way in (1 + 0j, 1j):
                value = (way.conjugate() * gap).real
                note(value, (pin.first, arms[0], way, 1), (pin.second, arms[1], way, -1))
        for one in self.guides:
            (z1, t1), (z2, t2) = (self._pose(q, k) for k in (one.first, one.second))
            normal = 1j * cmath.exp(1j * (t2 + one.angle))
            arm, through = one.a * cmath.exp(1j * t1), one.through * cmath.exp(1j * t2)
            gap = z1 + arm - z2 - through
            value = (normal.conjugate() * gap).real
            note(value, (one.first, arm, normal, 1), (one.second, through + gap, normal, -1))
            turned = np.zeros(q.size)
            for body, sign in ((one.first, 1.0), (one.second, -1.0)):
                if body:
                    turned[3 * body - 1] = sign
            rows.append(t1 - t2 - self._angle(one))
            slopes.append(turned)
        drive = np.zeros(q.size)
        drive[2] = 1.0
        rows.append(float(q[2]) - phi)
        slopes.append(drive)
        return np.array(rows), np.array(slopes)

    def _angle(self, one: Guide) -> float:
        first, second = (self.poses[k][1] if k else 0.0 for k in (one.first, one.second))
        return first - second

    def settle(self, q: Reals, phi: float) -> Reals | None:
        """Return the poses at an angle of the crank, from near ones; None if there are none."""
        for _ in range(25):
            value, slope = self.equations(q, phi)
            try:
                step = np.linalg.solve(slope, value)
            except np.linalg.LinAlgError:
                return None
            q = q - step
            if np.abs(step).max() > 2.0:
                return None
            if np.abs(step).max() < 1e-14:
                break
        value, _ = self.equations(q, phi)
        return q if np.abs(value).max() < 1e-12 else None

    def rates(self, q: Reals, omega: float) -> tuple[Reals, Reals, float]:
        """Return velocities and accelerations of the poses at an even speed, and how badly they hang on it."""
        _, slope = self.equations(q, float(q[2]))
        right = np.zeros(len(slope))
        right[-1] = omega
        first = np.linalg.solve(slope, right)
        second = np.linalg.solve(slope, -self._bent(q, first))
        return first, second, float(np.linalg.cond(slope))

    def _bent(self, q: Reals, v: Reals) -> Reals:
        """Return what each equation gains by the motion alone, with no accelerations."""
        found: list[float] = []

        def pose(body: int) -> tuple[complex, complex, float, float]:
            if body == 0:
                return 0j, 0j, 0.0, 0.0
            at = 3 * body - 3
            place, speed = (complex(*row[at : at + 2]) for row in (q, v))
            return place, speed, float(q[at + 2]), float(v[at + 2])

        for pin in self.pins:
            gain = 0j
            for body, own, sign in ((pin.first, pin.a, 1), (pin.second, pin.b, -1)):
                _, _, angle, omega = pose(body)
                gain -= sign * omega**2 * own * cmath.exp(1j * angle)
            found += [gain.real, gain.imag]
        for one in self.guides:
            z1, v1, t1, w1 = pose(one.first)
            z2, v2, t2, w2 = pose(one.second)
            normal = 1j * cmath.exp(1j * (t2 + one.angle))
            arm, through = one.a * cmath.exp(1j * t1), one.through * cmath.exp(1j * t2)
            gap, speed = z1 + arm - z2 - through, v1 + 1j * w1 * arm - v2 - 1j * w2 * through
            bent = -(w1**2) * arm + w2**2 * through
            turned, twice = 1j * w2 * normal, -(w2**2) * normal
            found.append(
                (
                    twice.conjugate() * gap
                    + 2 * turned.conjugate() * speed
                    + normal.conjugate() * bent
                ).real
            )
            found.append(0.0)
        return np.array([*found, 0.0])
