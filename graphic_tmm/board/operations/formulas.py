"""Calculated lengths and quantities: steps too, each with its formula as its sentence.

The formula is the docstring; the names in braces are the operation's arguments, so the same text gives the
letters of the calculation note and, with readings put in, its numbers. Angular quantities follow from
*signed* segments: the sense is the sign.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number

_NO_INTERVALS = ("the base has no intervals", "на основании нет интервалов")
_ZERO_LENGTH = ("the length to divide by is zero", "деление на нулевую длину")


@operation(formula=True, fails=_ZERO_LENGTH)
def to_board(quantity: Number, mu: Number) -> Length:
    """{quantity}/{mu}"""
    return Length(quantity / mu)


@operation(formula=True)
def in_si(length: Length, mu: Number) -> Number:
    """{length}·{mu}"""
    return Number(length * mu)


@operation(formula=True)
def total(first: Length, second: Length) -> Length:
    """{first} + {second}"""
    return Length(first + second)


@operation(formula=True)
def difference(first: Length, second: Length) -> Length:
    """|{first} − {second}|"""
    return Length(np.abs(first - second))


@operation(formula=True)
def advance(zero: Angle, by: Angle) -> Angle:
    """{zero} + {by}"""
    return Angle(zero + by)


@operation(formula=True)
def product(omega: Number, length: Number) -> Number:
    """{omega}·{length}"""
    return Number(omega * length)


@operation(formula=True)
def product_of_squares(omega: Number, length: Number) -> Number:
    """{omega}²·{length}"""
    return Number(omega * omega * length)


@operation(formula=True, fails=_ZERO_LENGTH)
def rate(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """{segment}·{mu}/({link}·{mu_l})"""
    return Number(segment * mu / (link * mu_l))


@operation(formula=True, fails=_ZERO_LENGTH)
def rate_turned(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """−{segment}·{mu}/({link}·{mu_l})"""
    return Number(-segment * mu / (link * mu_l))


@operation(formula=True, fails=_ZERO_LENGTH)
def normal(segment: Length, mu_v: Number, link: Length, mu_l: Number, mu_a: Number) -> Length:
    """({segment}·{mu_v})²/({link}·{mu_l})/{mu_a}"""
    velocity = segment * mu_v
    return Length(velocity * velocity / (link * mu_l) / mu_a)


@operation(formula=True)
def coriolis(omega: Number, segment: Length, mu_v: Number, mu_a: Number) -> Length:
    """2·{omega}·{segment}·{mu_v}/{mu_a}"""
    return Length(2.0 * omega * (segment * mu_v) / mu_a)


@operation(formula=True)
def swing_angle(ratio: Number) -> Angle:
    """180°·({ratio} − 1)/({ratio} + 1)"""
    return Angle(180.0 * (ratio - 1.0) / (ratio + 1.0))


@operation(formula=True)
def sine_of_half(length: Number, angle: Angle) -> Number:
    """{length}·sin({angle}/2)"""
    return Number(length * np.sin(np.radians(angle / 2.0)))


@operation(formula=True)
def half_chord(stroke: Number, angle: Angle) -> Number:
    """{stroke}/(2·sin({angle}/2))"""
    return Number(stroke / (2.0 * np.sin(np.radians(angle / 2.0))))


@operation(formula=True, fails=_NO_INTERVALS)
def abscissa(n: Number, base: Length, intervals: Number) -> Length:
    """{n}·{base}/{intervals}"""
    return Length(n * base / intervals)


@operation(formula=True)
def turn_per_mm(base: Length) -> Number:
    """2π/{base}"""
    return Number(2.0 * np.pi / base)


@operation(formula=True)
def time_per_mm(omega: Number, base: Length) -> Number:
    """2π/({omega}·{base})"""
    return Number(2.0 * np.pi / (np.abs(omega) * base))


@operation(formula=True)
def mm_of_turn(mu: Number) -> Length:
    """2π/{mu}"""
    return Length(2.0 * np.pi / mu)


@operation(formula=True)
def mm_of_time(omega: Number, mu: Number) -> Length:
    """2π/({omega}·{mu})"""
    return Length(2.0 * np.pi / (np.abs(omega) * mu))


@operation(formula=True)
def pole_distance(mu: Number, mu_of_derivative: Number, mu_along: Number) -> Length:
    """{mu}/({mu_of_derivative}·{mu_along})"""
    return Length(mu / (mu_of_derivative * mu_along))


@operation(formula=True)
def scale_of_derivative(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}/({mu_along}·{pole})"""
    return Number(mu / (mu_along * pole))


@operation(formula=True)
def scale_of_integral(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}·{mu_along}·{pole}"""
    return Number(mu * mu_along * pole)


@operation(formula=True)
def rescaled(length: Length, mu: Number, other: Number) -> Length:
    """{length}·{mu}/{other}"""
    return Length(length * mu / other)
