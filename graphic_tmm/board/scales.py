"""The scale factor μ: the only door between millimetres of the sheet and SI; how one is chosen.

μ_l follows from the scales of ГОСТ 2.302 (1:2 is 0.002 m/mm); other plans take the decades of the same figures.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.values import Length, Number, Reals
from graphic_tmm.language.said import said

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
    """A scale factor: its symbol, its value in SI units per mm, its unit.

    ``own``: by position (index) the value of those that are drawn to another.
    """

    symbol: str
    value: float
    unit: str
    own: tuple[tuple[int, float], ...] = ()

    def at(self, place: int) -> Scale:
        """Return the scale factor to which a position (index) is drawn."""
        return self._replace(value=dict(self.own).get(place, self.value), own=())

    def to_board(self, quantity: float) -> float:
        """Return the length, mm, that stands for a quantity (SI)."""
        return quantity / self.value


def common(values: object) -> float:
    """Return the value to which most positions are drawn, of as many the largest.

    >>> common([[4.0, 0.5, 4.0]]), common(2.5), common([4.0, 0.5])
    (4.0, 2.5, 4.0)
    """
    found, counts = np.unique(np.ravel(np.asarray(values)), return_counts=True)
    return float(found[counts == counts.max()][-1])


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


_STANDARD = said(
    "A standard value makes lengths on the drawing easy to recalculate; the next larger one is taken, so that "
    "what is drawn takes no more room than is meant for it."
)


@formula(
    why=said(
        "A turn is 2π rad and a minute 60 s: {turns} turns a minute are π/30 times as many radians a "
        "second."
    )
)
def of_turns(turns: Number) -> Number:
    """π·{turns}/30"""


@formula(
    why=said(
        "A scale factor tells how much of a quantity a millimetre stands for: the quantity divided by the "
        "length that is to show it."
    )
)
def scale_of(quantity: Number, length: Length) -> Number:
    """{quantity}/{length}"""


@formula(
    why=said(
        "The velocity ω·l of the crank pin is drawn as long as the crank itself, so its scale factor is ω "
        "times that of lengths."
    )
)
def scale_by_turning(mu_l: Number, omega: Number) -> Number:
    """{mu_l}·{omega}"""


@operation(looked_up=True, why=_STANDARD)
def next_standard(exact: Number) -> Number:
    """Take for {it} the next standard value that is no smaller than {exact}."""
    return Number(_each(standard, exact))


@operation(looked_up=True, why=_STANDARD)
def next_standard_length(exact: Number) -> Number:
    """Take for {it} the next standard scale that is no smaller than {exact}."""
    return Number(_each(standard_length, exact))


@operation(
    looked_up=True,
    why=said(
        "A standard value makes lengths on the drawing easy to recalculate; the length wanted was only a wish, "
        "so the nearest one is taken and the length follows from it."
    ),
)
def nearest_standard(exact: Number) -> Number:
    """Take for {it} the standard value nearest to {exact}."""
    return Number(_each(lambda least, _: nearest(least), exact))


@operation(
    symbol=FREE,
    why=said("The task says how large it is drawn, and everything drawn to it follows from that."),
)
def accepted(told: Number) -> Number:
    """Take {told} for {it}."""
    return told


ENLARGED = (10.0, 5.0, 4.0, 2.5, 2.0, 1.0, 0.5, 0.4, 0.25, 0.2, 0.1)
"""How many times a figure may be drawn larger than another, the largest first."""


@formula(
    why=said(
        "The room {room} meant for it, divided by its length on the plan, tells how many times larger it may "
        "be drawn."
    )
)
def times_larger(room: Length, mu: Number, quantity: Number) -> Number:
    """{room}·{mu}/{quantity}"""


@operation(
    looked_up=True,
    why=said(
        "A round ratio is easy to carry over; the next smaller one keeps the figure in its room."
    ),
)
def next_ratio(exact: Number) -> Number:
    """Take for {it} the next round ratio that is no larger than {exact}."""
    return Number(_each(lambda most, _: ratio_below(most), exact))


def ratio_below(most: float) -> float:
    """Return the largest of `ENLARGED` that is no larger than ``most``, or else the least of them.

    >>> ratio_below(3.0), ratio_below(0.01)
    (2.5, 0.1)
    """
    return next((k for k in ENLARGED if k <= most * (1 + 1e-12)), ENLARGED[-1])


def _each(rule: Callable[[float, float], float], exact: Reals) -> Reals:
    found = np.vectorize(lambda least: rule(float(least), 1.0), otypes=[np.float64])(exact)
    return np.asarray(found, dtype=np.float64)
