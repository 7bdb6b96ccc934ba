"""Formulas of laws of motion: the circles that give them, their ordinates, shares of a phase."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number


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
def share_of_parts(number: Number, parts: Number) -> Number:
    """{number}/{parts}"""
    return Number(number / parts)


@operation(formula=True)
def mean_of_strip(first: Length, middle: Length, last: Length) -> Length:
    """({first} + 4·{middle} + {last})/6"""
    return Length((first + 4.0 * middle + last) / 6.0)
