"""The scale factors of the analogues: those of the plans as if ω_1 were 1."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Number
from graphic_tmm.language.said import said


@formula(
    holds="{omega} ≠ 0",
    fails="the crank stands",
    why=said(
        "v = {omega}·dS/dφ: the plan of velocities shows dS/dφ to a scale that is {omega} times finer."
    ),
)
def scale_of_first_analogue(mu: Number, omega: Number) -> Number:
    """{mu}/{omega}"""


@formula(
    holds="{omega} ≠ 0",
    fails="the crank stands",
    why=said(
        "The crank turns evenly, so a = {omega}²·d²S/dφ²: the plan of accelerations shows d²S/dφ² to a scale "
        "that is {omega}² times finer."
    ),
)
def scale_of_second_analogue(mu: Number, omega: Number) -> Number:
    """{mu}/{omega}²"""
