"""What lengths of Klein's figure stand for: the crank on it is as long as the vectors of its pin."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The triangle over the crank is the plan of velocities, turned by 90°: the crank stands for {omega}·l, "
        "so a millimetre for {omega} times as much as of lengths."
    )
)
def velocities_on_figure(mu: Number, omega: Number) -> Number:
    """{mu}·{omega}"""


@formula(
    why=said(
        "The figure over the crank is the plan of accelerations, turned by 180°: the crank stands for "
        "{omega}²·l, so a millimetre for {omega}² times as much as of lengths."
    )
)
def accelerations_on_figure(mu: Number, omega: Number) -> Number:
    """{mu}·{omega}²"""


@formula(
    holds="{omega} ≠ 0",
    fails="the crank stands",
    why=said(
        "The crank stands for {omega}²·l, the normal acceleration of its pin; the tangential one is "
        "{epsilon}·l, so to the same scale {epsilon}/{omega}² of the crank."
    ),
)
def tangential_on_figure(crank: Length, epsilon: Number, omega: Number) -> Length:
    """{crank}·{epsilon}/{omega}²"""
