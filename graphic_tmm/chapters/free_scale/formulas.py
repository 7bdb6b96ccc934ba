"""The scale of a plan whose first vector was chosen freely."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said


@formula(
    holds="{segment} ≠ 0",
    fails="the crank pin does not move while the other link drives",
    why=said(
        "The crank pin's velocity is known, {speed}, and on the plan it is {segment}: so much does a "
        "millimetre stand for."
    ),
)
def scale_by_speed(speed: Number, segment: Length) -> Number:
    """{speed}/{segment}"""
