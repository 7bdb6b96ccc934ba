"""Calculated lengths and quantities: steps too, each with its formula as its sentence.

The names in braces are the operation's arguments, so the text that is computed also gives the letters of the
calculation note and, with readings put in, its numbers. Angular quantities follow from
*signed* segments: the sense is the sign.
"""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number

_NO_INTERVALS = "the base has no intervals"
_ZERO_LENGTH = "the length to divide by is zero"


@formula(fails=_ZERO_LENGTH)
def to_board(quantity: Number, mu: Number) -> Length:
    """{quantity}/{mu}"""


@formula
def in_si(length: Length, mu: Number) -> Number:
    """{length}·{mu}"""


@formula
def total(first: Length, second: Length) -> Length:
    """{first} + {second}"""


@formula
def difference(first: Length, second: Length) -> Length:
    """|{first} − {second}|"""


@formula
def advance(zero: Angle, by: Angle) -> Angle:
    """{zero} + {by}"""


@formula
def product(omega: Number, length: Number) -> Number:
    """{omega}·{length}"""


@formula
def product_of_squares(omega: Number, length: Number) -> Number:
    """{omega}²·{length}"""


@formula(fails=_ZERO_LENGTH)
def rate(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """{segment}·{mu}/({link}·{mu_l})"""


@formula(fails=_ZERO_LENGTH)
def rate_turned(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """−{segment}·{mu}/({link}·{mu_l})"""


@formula(fails=_ZERO_LENGTH)
def normal(segment: Length, mu_v: Number, link: Length, mu_l: Number, mu_a: Number) -> Length:
    """({segment}·{mu_v})²/({link}·{mu_l})/{mu_a}"""


@formula
def coriolis(omega: Number, segment: Length, mu_v: Number, mu_a: Number) -> Length:
    """2·{omega}·{segment}·{mu_v}/{mu_a}"""


@formula
def swing_angle(ratio: Number) -> Angle:
    """180°·({ratio} − 1)/({ratio} + 1)"""


@formula
def sine_of_half(length: Number, angle: Angle) -> Number:
    """{length}·sin({angle}/2)"""


@formula
def half_chord(stroke: Number, angle: Angle) -> Number:
    """{stroke}/(2·sin({angle}/2))"""


@formula(fails=_NO_INTERVALS)
def abscissa(n: Number, base: Length, intervals: Number) -> Length:
    """{n}·{base}/{intervals}"""


@formula
def turn_per_mm(base: Length) -> Number:
    """2π/{base}"""


@formula
def time_per_mm(omega: Number, base: Length) -> Number:
    """2π/({omega}·{base})"""


@formula
def mm_of_turn(mu: Number) -> Length:
    """2π/{mu}"""


@formula
def mm_of_time(omega: Number, mu: Number) -> Length:
    """2π/({omega}·{mu})"""


@formula
def pole_distance(mu: Number, mu_of_derivative: Number, mu_along: Number) -> Length:
    """{mu}/({mu_of_derivative}·{mu_along})"""


@formula
def scale_of_derivative(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}/({mu_along}·{pole})"""


@formula
def scale_of_integral(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}·{mu_along}·{pole}"""


@formula
def rescaled(length: Length, mu: Number, other: Number) -> Length:
    """{length}·{mu}/{other}"""


@formula
def pitch_radius(m: Number, z: Number) -> Number:
    """{m}·{z}/2"""
