"""Formulas of laws of motion: the circles that give them, their ordinates, shares of a phase."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number

_PHASE = "{share} ≥ 0, {share} ≤ 1"


@formula
def sine_radius(height: Length) -> Length:
    """{height}/(2·π)"""


@formula
def sine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}/({phase}·{mu})"""


@formula
def sine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·π·{stroke}/({phase}²·{mu})"""


@formula
def cosine_radius(height: Length) -> Length:
    """{height}/2"""


@formula
def cosine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """π·{stroke}/(2·{phase}·{mu})"""


@formula
def cosine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """π²·{stroke}/(2·{phase}²·{mu})"""


@formula(holds=_PHASE)
def around_outer(share: Number) -> Angle:
    """arcsin(sin(360°·{share}))"""
    # arcsin loses half the digits at its ends; here and below the same broken line, by its pieces
    return Angle(90.0 - np.abs(np.mod(360.0 * share + 90.0, 360.0) - 180.0))


@formula(holds=_PHASE)
def around_lowest(share: Number) -> Angle:
    """arccos(cos(360°·{share}))"""
    return Angle(360.0 * np.minimum(share, 1.0 - share))


@formula(holds=_PHASE)
def half_around_outer(share: Number) -> Angle:
    """arcsin(sin(180°·{share}))"""
    return Angle(180.0 * np.minimum(share, 1.0 - share))


@formula
def half_around(share: Number) -> Angle:
    """180°·{share}"""


@formula
def even_height(share: Number, height: Length) -> Length:
    """{share}·{height}"""


@formula
def parabola_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·{stroke}/({phase}·{mu})"""


@formula
def parabola_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """4·{stroke}/({phase}²·{mu})"""


@formula
def polynomial_S(share: Number, height: Length) -> Length:
    """{height}·(10·{share}³ − 15·{share}⁴ + 6·{share}⁵)"""


@formula
def polynomial_V(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(30·{share}² − 60·{share}³ + 30·{share}⁴)/({phase}·{mu})"""
    # the powers of the text cancel towards the end of the phase; here and below they are factors
    return Length(30.0 * stroke * (share * (1.0 - share)) ** 2 / (phase * mu))


@formula
def polynomial_A(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(60·{share} − 180·{share}² + 120·{share}³)/({phase}²·{mu})"""
    shape = 60.0 * share * (1.0 - share) * (1.0 - 2.0 * share)
    return Length(stroke * shape / (phase**2 * mu))


@formula
def on_chord(share: Number, start: Number, end: Number, first: Length, last: Length) -> Length:
    """{first} + ({last} − {first})·({share} − {start})/({end} − {start})"""


@formula
def rest_of_stroke(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""


@formula
def share_of_parts(number: Number, parts: Number) -> Number:
    """{number}/{parts}"""


@formula
def mean_of_strip(first: Length, middle: Length, last: Length) -> Length:
    """({first} + 4·{middle} + {last})/6"""
