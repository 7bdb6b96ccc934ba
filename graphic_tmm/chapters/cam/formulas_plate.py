"""Formulas of cams that slide: the base of their diagrams, derivatives by the whole travel."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said


@formula(why=said("The base stands for the whole travel of the cam."))
def scale_of_travel(travel: Number, base: Length) -> Number:
    """{travel}/{base}"""


@formula(
    why=said(
        "The step between two places is taken as a share of the whole travel, which stands for a radian."
    )
)
def share_of_travel(length: Number, parts: Number, travel: Number) -> Angle:
    """180°·{length}/(π·{parts}·{travel})"""


@formula(
    why=said(
        "Were the cam as steep as here all along, the follower would rise by the slope times L."
    )
)
def rise_over_travel(slope: Length, mu: Number, travel: Number, mu_l: Number) -> Length:
    """{slope}·{mu}·{travel}/{mu_l}"""


@formula(
    why=said("By shares of the whole travel, as the slope, the second derivative has L squared.")
)
def second_over_travel(second: Length, mu: Number, travel: Number, mu_l: Number) -> Length:
    """{second}·{mu}·{travel}²/{mu_l}"""
