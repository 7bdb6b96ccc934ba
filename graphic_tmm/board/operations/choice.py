"""The choice of a scale factor: what it has to be at least, the next standard value, or the author's own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.scales import nearest, standard, standard_length
from graphic_tmm.board.values import Length, Number, Reals
from graphic_tmm.language.said import said

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


@operation(why=_STANDARD)
def next_standard(exact: Number) -> Number:
    """Take for {it} the next standard value that is no smaller than {exact}."""
    return Number(_each(standard, exact))


@operation(why=_STANDARD)
def next_standard_length(exact: Number) -> Number:
    """Take for {it} the next standard scale that is no smaller than {exact}."""
    return Number(_each(standard_length, exact))


@operation(
    why=said(
        "A standard value makes lengths on the drawing easy to recalculate; the length wanted was only a wish, "
        "so the nearest one is taken and the length follows from it."
    )
)
def nearest_standard(exact: Number) -> Number:
    """Take for {it} the standard value nearest to {exact}."""
    return Number(_each(lambda least, _: nearest(least), exact))


@operation(
    why=said("The task says how large it is drawn, and everything drawn to it follows from that.")
)
def accepted(told: Number) -> Number:
    """Take {told} for {it}."""
    return told


ENLARGED = (10.0, 5.0, 4.0, 2.5, 2.0, 1.0, 0.5, 0.4, 0.25, 0.2, 0.1)
"""How many times a figure may be drawn larger than another, the largest first."""


@formula(
    why=said(
        "On the plan it is so many millimetres long; {room} are meant for it: the ratio is how many times "
        "larger it may be."
    )
)
def times_larger(room: Length, mu: Number, quantity: Number) -> Number:
    """{room}·{mu}/{quantity}"""


@operation(
    why=said(
        "A round ratio is easy to carry over; the next smaller one keeps the figure in its room."
    )
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
