"""A plate without its third leg, a four-bar or a slider-crank: where its first pin can be, calculated aside."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.values import Arc, Complexes, Line, Reals

ROW = 36
"""So many places of the first pin the curve of the third is drawn by."""
LEAST = 1e-6
"""By so much of the curve's points the sense is looked for in which it crosses."""


class Circuit(NamedTuple):
    """Places of the first pin that one closed curve is drawn by, radians: whole turns, or to and fro.

    ``half``: half of the swing about the ``middle``, 0 where it goes all round; ``side``: on which side the
    second pin is then, of those that go to and fro on both.
    """

    middle: float
    half: float
    side: int

    def at(self, knots: Reals) -> tuple[Reals, Reals]:
        """Return the angle of the first leg, and the side of the second pin, at points of the curve."""
        if not self.half:
            return knots * (math.tau / ROW), np.full_like(knots, float(self.side))
        turned = (knots + 0.5) * (math.tau / ROW)
        side = np.where(np.sin(turned) < 0.0, -1.0, 1.0)
        return self.middle + self.half * np.cos(turned), side

    def knot(self, angle: float, side: float) -> float:
        """Return at which point of the curve the first leg has an angle; NaN where it never has."""
        if not self.half:
            return angle % math.tau * ROW / math.tau if side == self.side else math.nan
        swing = math.remainder(angle - self.middle, math.tau) / self.half
        if abs(swing) > 1.0 + LEAST:
            return math.nan
        turned = math.acos(max(-1.0, min(1.0, swing)))
        return (turned if side > 0.0 else math.tau - turned) * ROW / math.tau - 0.5


@dataclass(frozen=True)
class Loosened:
    """A plate on its first two legs, lengths in m.

    ``first``: the circle of its first pin; ``locus``, ``third``: what the legs leave the second and the third.
    ``apart``: the second pin from the first along the plate's line; ``off``: the third, along and to the left.
    """

    first: Arc
    locus: Arc | Line
    third: Arc | Line
    apart: float
    off: complex

    @property
    def circuits(self) -> Iterator[Circuit]:
        """The curves that the third pin can go on."""
        low, high, way = self._bounds()
        least, most = (math.acos(max(-1.0, min(1.0, one))) for one in (high, low))
        if low <= -1.0 and high >= 1.0:
            yield from (Circuit(0.0, 0.0, side) for side in (1, -1))
        elif high >= 1.0:
            yield Circuit(way, most, 0)
        elif low <= -1.0:
            yield Circuit(way + math.pi, math.pi - least, 0)
        else:
            for sign in (1, -1):
                yield Circuit(way + sign * (least + most) / 2.0, (most - least) / 2.0, 0)

    def _bounds(self) -> tuple[float, float, float]:
        """Return between what the cosine of the first leg's angle from a direction is, and the direction."""
        a, r = complex(self.first.centre), float(self.first.radius)
        match self.locus:
            case Arc(centre, radius):
                base, s = complex(centre) - a, float(radius)
                share = 2.0 * r * abs(base) or math.inf
                low, high = (
                    (r * r + abs(base) ** 2 - x * x) / share
                    for x in (self.apart + s, self.apart - s)
                )
                return low, high, cmath.phase(base)
            case Line(at, along):
                height = float(wedge(along, np.asarray(a) - at))
                low, high = ((way * self.apart - height) / r for way in (-1.0, 1.0))
                return low, high, cmath.phase(1j * complex(along))

    def pins(self, angle: Reals, side: Reals) -> tuple[Complexes, Complexes, Complexes]:
        """Return the three pins at angles of the first leg."""
        b = self.first.centre + self.first.radius * np.exp(1j * angle)
        match self.locus:
            case Arc(centre, radius):
                base = centre - b
                far = np.abs(base)
                foot = (far**2 + self.apart**2 - radius**2) / (2.0 * far)
                high = np.sqrt(np.maximum(self.apart**2 - foot**2, 0.0))
                c = b + base / far * (foot + 1j * side * high)
            case Line(at, along):
                high = wedge(along, b - at)
                way = np.sqrt(np.maximum(self.apart**2 - high**2, 0.0))
                c = b - 1j * along * high + side * way * along
        return b, c, b + (c - b) / self.apart * self.off

    def side(self, b: complex, c: complex) -> float:
        """Return on which side the second pin is of the two where it can be, seen from the first."""
        return _side(self.locus, b, c)

    def side_of(self, pins: tuple[complex, complex, complex], k: int) -> float:
        """Return on which side the first or the second pin is, seen from the third."""
        return _side((self.first, self.locus)[k], pins[2], pins[k])

    def squarely(self, pins: tuple[complex, complex, complex], k: int) -> float:
        """Return the sine of the angle at which an arc about the third pin crosses what holds another."""
        locus, pin = (self.first, self.locus)[k], pins[k]
        arm = (pin - pins[2]) / (abs(pin - pins[2]) or 1.0)
        match locus:
            case Arc(centre, radius):
                normal = (pin - complex(centre)) / float(radius)
            case Line(_, along):
                normal = 1j * complex(along)
        return abs((arm.conjugate() * normal).imag)

    def outward(self, circuit: Circuit, knot: float) -> int:
        """Return in which sense the curve crosses what the third leg leaves its pin."""
        at = knot + LEAST * np.array([-1.0, 1.0])
        *_, f = self.pins(*circuit.at(at))
        match self.third:
            case Arc(centre, _):
                high = np.abs(f - centre)
            case Line(_, along):
                high = wedge(along, f)
        return 1 if high[1] > high[0] else -1


def _side(locus: Arc | Line, start: complex, pin: complex) -> float:
    """Return on which side a pin is of the two where an arc about a point crosses its locus."""
    match locus:
        case Arc(centre, _):
            base = complex(centre) - start
            return math.copysign(1.0, (base.conjugate() * (pin - start)).imag)
        case Line(_, along):
            return math.copysign(1.0, ((pin - start) * complex(along).conjugate()).real)
