"""Formulas of cams: scales, angles of the turn, curvature, limits of the roller."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number

_OVERCUT = (
    "the roller is larger than the radius of curvature of the profile",
    "радиус ролика больше радиуса кривизны профиля",
)
_HOLLOW = (
    "a flat face does not reach a hollow profile",
    "плоская тарелка не касается вогнутого профиля",
)
_DIGITS = 1e-9
"""A millimetre that is over by less than this share of one is whole."""


@operation(formula=True)
def radians_of(angle: Angle) -> Number:
    """π·{angle}/180°"""
    return Number(np.pi * angle / 180.0)


@operation(formula=True)
def along_turn(angle: Angle, base: Length) -> Length:
    """{angle}·{base}/360°"""
    return Length(angle * base / 360.0)


@operation(formula=True)
def angle_of_turn(x: Length, base: Length) -> Angle:
    """360°·{x}/{base}"""
    return Angle(360.0 * x / base)


@operation(formula=True)
def angle_of_part(angle: Angle, parts: Number) -> Angle:
    """{angle}/{parts}"""
    return Angle(angle / parts)


@operation(formula=True, fails=("the diagram does not rise", "диаграмма не поднимается"))
def scale_of_stroke(stroke: Number, height: Length) -> Number:
    """{stroke}/{height}"""
    return Number(stroke / np.where(height > 0.0, height, np.nan))


@operation(formula=True)
def swing_of(length: Length, mu: Number) -> Angle:
    """180°·{length}·{mu}/π"""
    return Angle(180.0 * length * mu / np.pi)


@operation(formula=True)
def travel_on_lever(length: Length, mu: Number, lever: Length) -> Length:
    """{length}·{mu}·{lever}"""
    return Length(length * mu * lever)


@operation(formula=True)
def along_path(part: Length, distance: Length, lever: Length) -> Length:
    """{part}·{distance}/{lever}"""
    return Length(part * distance / lever)


@operation(formula=True, fails=("the pole stands in the point", "полюс совпадает с точкой"))
def turning_of_normal(p: Length, q: Length, v: Length, a: Length) -> Number:
    """1 − ({a}·{p} − {q}·{v})/({p}² + {q}²)"""
    return Number(1.0 - (a * p - q * v) / (p**2 + q**2))


@operation(formula=True)
def curvature_of_profile(turning: Number, pace: Length, mu: Number) -> Number:
    """{turning}/({pace}·{mu})"""
    return Number(turning / (pace * mu))


@operation(formula=True, fails=("the profile is convex nowhere", "профиль нигде не выпуклый"))
def least_radius(height: Length, mu: Number) -> Number:
    """1/({height}·{mu})"""
    return Number(1.0 / np.where(height > 0.0, height * mu, np.nan))


@operation(formula=True, fails=_OVERCUT)
def equidistant_pace(pace: Length, roller: Length, turning: Number) -> Length:
    """{pace} − {roller}·{turning}"""
    rest = pace - roller * turning
    return Length(np.where(rest > 0.0, rest, np.nan))


@operation(formula=True)
def flat_radius(r0: Length, displacement: Length, second: Length) -> Length:
    """{r0} + {displacement} + {second}"""
    return Length(r0 + displacement + second)


@operation(formula=True, fails=_HOLLOW)
def convex(radius: Length) -> Length:
    """{radius}"""
    return Length(np.where(radius > 0.0, radius, np.nan))


@operation(formula=True)
def allowed_share(share: Number, whole: Number) -> Number:
    """{share}·{whole}"""
    return Number(share * whole)


@operation(formula=True)
def lesser_radius(first: Number, second: Number) -> Number:
    """min({first}, {second})"""
    return Number(np.minimum(first, second))


@operation(formula=True)
def whole_mm_above(length: Number) -> Number:
    """⌈1000·{length}⌉/1000"""
    return Number(np.ceil(1000.0 * length - _DIGITS) / 1000.0)


@operation(formula=True)
def whole_mm_below(length: Number) -> Number:
    """⌊1000·{length}⌋/1000"""
    return Number(np.floor(1000.0 * length + _DIGITS) / 1000.0)


@operation(formula=True)
def on_protractor(angle: Angle, mu: Number) -> Length:
    """{angle}/{mu}"""
    return Length(angle / mu)


@operation(formula=True)
def off_protractor(length: Length, mu: Number) -> Angle:
    """{length}·{mu}"""
    return Angle(length * mu)
