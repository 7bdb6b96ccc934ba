"""Formulas of cams: the circles that give a law of motion, scales, curvature, limits of the roller."""

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
def sine_radius(height: Length) -> Length:
    """{height}/(2·π)"""
    return Length(height / (2.0 * np.pi))


@operation(formula=True)
def sine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}/({phase}·{mu})"""
    return Length(stroke / (phase * mu))


@operation(formula=True)
def sine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·π·{stroke}/({phase}²·{mu})"""
    return Length(2.0 * np.pi * stroke / (phase**2 * mu))


@operation(formula=True)
def cosine_radius(height: Length) -> Length:
    """{height}/2"""
    return Length(height / 2.0)


@operation(formula=True)
def cosine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """π·{stroke}/(2·{phase}·{mu})"""
    return Length(np.pi * stroke / (2.0 * phase * mu))


@operation(formula=True)
def cosine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """π²·{stroke}/(2·{phase}²·{mu})"""
    return Length(np.pi**2 * stroke / (2.0 * phase**2 * mu))


@operation(formula=True)
def around_outer(share: Number) -> Angle:
    """arcsin(sin(360°·{share}))"""
    return Angle(90.0 - np.abs(np.mod(360.0 * share + 90.0, 360.0) - 180.0))


@operation(formula=True)
def around_lowest(share: Number) -> Angle:
    """arccos(cos(360°·{share}))"""
    return Angle(360.0 * np.minimum(share, 1.0 - share))


@operation(formula=True)
def half_around_outer(share: Number) -> Angle:
    """arcsin(sin(180°·{share}))"""
    return Angle(180.0 * np.minimum(share, 1.0 - share))


@operation(formula=True)
def half_around(share: Number) -> Angle:
    """180°·{share}"""
    return Angle(180.0 * share)


@operation(formula=True)
def even_height(share: Number, height: Length) -> Length:
    """{share}·{height}"""
    return Length(share * height)


@operation(formula=True)
def parabola_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·{stroke}/({phase}·{mu})"""
    return Length(2.0 * stroke / (phase * mu))


@operation(formula=True)
def parabola_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """4·{stroke}/({phase}²·{mu})"""
    return Length(4.0 * stroke / (phase**2 * mu))


@operation(formula=True)
def polynomial_S(share: Number, height: Length) -> Length:
    """{height}·(10·{share}³ − 15·{share}⁴ + 6·{share}⁵)"""
    return Length(height * share**3 * (10.0 + share * (6.0 * share - 15.0)))


@operation(formula=True)
def polynomial_V(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(30·{share}² − 60·{share}³ + 30·{share}⁴)/({phase}·{mu})"""
    return Length(30.0 * stroke * (share * (1.0 - share)) ** 2 / (phase * mu))


@operation(formula=True)
def polynomial_A(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(60·{share} − 180·{share}² + 120·{share}³)/({phase}²·{mu})"""
    shape = 60.0 * share * (1.0 - share) * (1.0 - 2.0 * share)
    return Length(stroke * shape / (phase**2 * mu))


@operation(formula=True)
def on_chord(share: Number, start: Number, end: Number, first: Length, last: Length) -> Length:
    """{first} + ({last} − {first})·({share} − {start})/({end} − {start})"""
    return Length(first + (last - first) * (share - start) / (end - start))


@operation(formula=True)
def rest_of_stroke(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""
    return Length(whole - part)


@operation(formula=True)
def swing_of(length: Length, mu: Number) -> Angle:
    """180°·{length}·{mu}/π"""
    return Angle(180.0 * length * mu / np.pi)


@operation(formula=True)
def on_lever(length: Length, mu: Number, lever: Length) -> Length:
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
def share_of_parts(number: Number, parts: Number) -> Number:
    """{number}/{parts}"""
    return Number(number / parts)


@operation(formula=True)
def on_protractor(angle: Angle, mu: Number) -> Length:
    """{angle}/{mu}"""
    return Length(angle / mu)


@operation(formula=True)
def off_protractor(length: Length, mu: Number) -> Angle:
    """{length}·{mu}"""
    return Angle(length * mu)


@operation(formula=True)
def mean_of_strip(first: Length, middle: Length, last: Length) -> Length:
    """({first} + 4·{middle} + {last})/6"""
    return Length((first + 4.0 * middle + last) / 6.0)
