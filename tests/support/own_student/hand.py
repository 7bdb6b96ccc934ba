"""A hand with ruler, compass and square: what it draws and reads is a little off. Lengths in mm."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

RIGHT = 1j
"""Turns a direction by 90° counterclockwise."""
SHEET = 600.0
"""How far lines can be followed, mm."""


class Ruler(NamedTuple):
    """A ruler with its division, mm, and whether the tenths between its lines are written down."""

    division: float
    tenths: bool


class Hand:
    """A hand: rays off by ``swing`` degrees, lengths by ``prick`` mm, readings by ``eye`` mm (each 1 σ)."""

    def __init__(
        self,
        rng: np.random.Generator,
        ruler: Ruler,
        *,
        swing: float = 0.6,
        prick: float = 0.3,
        eye: float = 0.6,
    ) -> None:
        """Take a ruler into a hand."""
        self.rng, self.ruler = rng, ruler
        self.swing, self.prick, self.eye = np.radians(swing), prick, eye

    def ray(self, along: complex) -> complex:
        """Return a direction of length 1 beside ``along``, as it was drawn."""
        unit = along / abs(along) if along else 1.0
        return complex(unit * np.exp(1j * self.rng.normal(0, self.swing)))

    def lay(self, start: complex, along: complex, length: float) -> complex:
        """Return the end of a length in mm, laid off from ``start`` along a direction as it was drawn."""
        if abs(length) < 0.05:
            return start
        return start + self.ray(along) * (length + self.rng.normal(0, self.prick))

    def meet(self, one: complex, along: complex, other: complex, across: complex) -> complex:
        """Return where two rays that were drawn meet; NaN where that is off the sheet."""
        u, v = self.ray(along), self.ray(across)
        square = (u * v.conjugate()).imag
        share = ((other - one) * v.conjugate()).imag / square if square else np.inf
        return complex(one + share * u) if abs(share) < SHEET else complex(np.nan, np.nan)

    def arc(
        self, centre: complex, radius: float, line: complex, along: complex, way: float
    ) -> complex:
        """Return the meeting of an arc with a line; ``way`` 1: the farther one along it, −1: the other."""
        radius += self.rng.normal(0, self.prick)
        along = along / abs(along)
        foot = line + along * ((centre - line) * along.conjugate()).real
        return foot + way * along * np.sqrt(max(radius**2 - abs(centre - foot) ** 2, 0.0))

    def arcs(self, one: complex, r: float, other: complex, s: float, way: float) -> complex:
        """Return the meeting of two arcs, to the left of one-other (``way`` 1) or to its right (−1)."""
        r, s = r + self.rng.normal(0, self.prick), s + self.rng.normal(0, self.prick)
        span = abs(other - one)
        x = (r * r - s * s + span * span) / (2 * span)
        y = np.sqrt(max(r * r - x * x, 0.0))
        return complex(one + (x + 1j * way * y) * (other - one) / span)

    def measure(self, length: float) -> float:
        """Return a length as it is read off the ruler, mm, never less than 0."""
        read = abs(length) + self.rng.normal(0, self.eye)
        return abs(
            round_to(
                max(read, 0.0) if read < 0 else read,
                0.1 if self.ruler.tenths else self.ruler.division,
            )
        )

    def coordinate(self, where: float) -> float:
        """Return a coordinate as it is read, mm."""
        read = where + self.rng.normal(0, self.eye)
        return round_to(read, 0.1 if self.ruler.tenths else self.ruler.division)


class Exact(Hand):
    """A hand that is never off, to prove the constructions by."""

    def __init__(self) -> None:
        """Take a ruler of no division."""
        super().__init__(np.random.default_rng(0), Ruler(1e-9, False), swing=0, prick=0, eye=0)


def round_to(figure: float, step: float) -> float:
    """Return a figure as a multiple of a step."""
    return float(round(figure / step) * step) if np.isfinite(figure) else float(np.nan)


def digits(figure: float, count: int) -> float:
    """Return a figure with so many digits, as it is copied off a calculator."""
    return float(f"{figure:.{count}g}")
