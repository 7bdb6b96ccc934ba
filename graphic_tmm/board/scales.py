"""The scale factor μ: the only door between millimetres of the sheet and SI; choice of a standard one.

μ_l follows from the scales of ГОСТ 2.302 (1:2 is 0.002 m/mm); other plans take the decades of the same figures.
"""

from __future__ import annotations

import math
from typing import NamedTuple

REDUCTIONS = (2, 2.5, 4, 5, 10, 15, 20, 25, 40, 50, 75, 100, 200, 400, 500, 800, 1000)
"""Scales of reduction, 1 : so many (ГОСТ 2.302)."""
ENLARGEMENTS = (2, 2.5, 4, 5, 10, 20, 40, 50, 100)
"""Scales of enlargement, so many : 1 (ГОСТ 2.302)."""
LENGTHS = tuple(
    sorted([0.001 / n for n in ENLARGEMENTS] + [0.001] + [0.001 * n for n in REDUCTIONS])
)
"""μ_l of the standard scales of ГОСТ 2.302, m/mm, in order of size."""
MANTISSAS = (1.0, 1.5, 2.0, 2.5, 4.0, 5.0, 7.5)
"""Mantissas of a standard scale factor: those of the reductions that stand between 1:10 and 1:100."""


PREFERRED = (1.0, 2.0, 2.5, 4.0, 5.0)
"""Mantissas of the scales of ГОСТ 2.302 that go on in every decade."""


class Scale(NamedTuple):
    """A scale factor: its symbol, its value in SI units per mm, its unit."""

    symbol: str
    value: float
    unit: str

    def to_board(self, quantity: float) -> float:
        """Return the length, mm, that stands for a quantity (SI)."""
        return quantity / self.value

    def to_si(self, mm: float) -> float:
        """Return the quantity (SI) that a length in mm stands for."""
        return mm * self.value


def standard(largest: float, room: float) -> float:
    """Return the least μ of the decades of `MANTISSAS` at which ``largest`` (SI) takes ≤ ``room`` mm.

    >>> standard(5.4, 100.0), standard(216.0, 100.0)
    (0.075, 2.5)
    """
    if not (largest > 0 and math.isfinite(largest)):
        return 1.0
    least = largest / room
    decade = math.floor(math.log10(least)) - 1
    tried = (float(f"{m}e{d}") for d in range(decade, decade + 4) for m in MANTISSAS)
    return next(mu for mu in tried if mu >= least * (1 - 1e-12))


def nearest(exact: float) -> float:
    """Return the scale factor of the decades of `PREFERRED` that is nearest to one, by their ratio.

    >>> nearest(0.003), nearest(1.5)
    (0.0025, 2.0)
    """
    if not (exact > 0 and math.isfinite(exact)):
        return 1.0
    decade = math.floor(math.log10(exact))
    tried = [float(f"{m}e{d}") for d in (decade - 1, decade, decade + 1) for m in PREFERRED]
    return min(tried, key=lambda mu: (abs(math.log(mu / exact)), -mu))


def standard_length(largest: float, room: float) -> float:
    """Return the least standard μ_l (m/mm) at which ``largest`` metres take ≤ ``room`` mm.

    Outside the range of ГОСТ 2.302 the decades of `MANTISSAS` go on.

    >>> standard_length(0.9, 250.0)
    0.004
    """
    least = largest / room
    if not LENGTHS[0] <= least * (1 + 1e-12) or least > LENGTHS[-1]:
        return standard(largest, room)
    return next(mu for mu in LENGTHS if mu >= least * (1 - 1e-12))
