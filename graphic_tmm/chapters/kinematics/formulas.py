"""Formulas of the rows that are asked for by name."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The links turn against each other at the difference of their angular velocities, the sum of their "
        "sizes where they turn in opposite senses; at the pin's surface that is {radius} times as much."
    )
)
def rubbing(radius: Number, omega: Number, other: Number) -> Number:
    """{radius}·|{omega} − {other}|"""


@formula(
    why=said(
        "The other link does not turn: at the pin's surface the speed is {radius} times {omega}."
    )
)
def rubbing_on_fixed(radius: Number, omega: Number) -> Number:
    """{radius}·|{omega}|"""


@formula(
    holds="{normal} ≠ 0",
    fails="the normal acceleration reads 0: the path is straight there, ρ infinite or too large to read",
    why=said(
        "A point that goes along a curve at v has the normal acceleration v²/ρ towards its centre of "
        "curvature, so ρ is the square of {segment}·{mu_v} divided by {normal}·{mu_a}."
    ),
)
def path_radius(segment: Length, mu_v: Number, normal: Length, mu_a: Number) -> Number:
    """({segment}·{mu_v})²/(|{normal}|·{mu_a})"""
