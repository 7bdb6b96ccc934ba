"""Formulas of cams: scales, angles of the turn, curvature, limits of the roller."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number

_OVERCUT = "the roller is larger than the radius of curvature of the profile"
_HOLLOW = "a flat face does not reach a hollow profile"
_DIGITS = 1e-9
"""A millimetre that is over by less than this share of one is whole."""


@formula
def radians_of(angle: Angle) -> Number:
    """π·{angle}/180°"""


@formula
def along_turn(angle: Angle, base: Length) -> Length:
    """{angle}·{base}/360°"""


@formula
def angle_of_turn(x: Length, base: Length) -> Angle:
    """360°·{x}/{base}"""


@formula
def angle_of_part(angle: Angle, parts: Number) -> Angle:
    """{angle}/{parts}"""


@formula(holds="{height} > 0", fails="the diagram does not rise")
def scale_of_stroke(stroke: Number, height: Length) -> Number:
    """{stroke}/{height}"""


@formula
def swing_of(length: Length, mu: Number) -> Angle:
    """180°·{length}·{mu}/π"""


@formula
def travel_on_lever(length: Length, mu: Number, lever: Length) -> Length:
    """{length}·{mu}·{lever}"""


@formula
def along_path(part: Length, distance: Length, lever: Length) -> Length:
    """{part}·{distance}/{lever}"""


@formula(fails="the pole stands in the point")
def turning_of_normal(p: Length, q: Length, v: Length, a: Length) -> Number:
    """1 − ({a}·{p} − {q}·{v})/({p}² + {q}²)"""


@formula
def curvature_of_profile(turning: Number, pace: Length, mu: Number) -> Number:
    """{turning}/({pace}·{mu})"""


@formula(holds="{height} > 0", fails="the profile is convex nowhere")
def least_radius(height: Length, mu: Number) -> Number:
    """1/({height}·{mu})"""


@formula(holds="{pace} > {roller}·{turning}", fails=_OVERCUT)
def equidistant_pace(pace: Length, roller: Length, turning: Number) -> Length:
    """{pace} − {roller}·{turning}"""


@formula
def flat_radius(r0: Length, displacement: Length, second: Length) -> Length:
    """{r0} + {displacement} + {second}"""


@formula(holds="{radius} > 0", fails=_HOLLOW)
def convex(radius: Length) -> Length:
    """{radius}"""


@formula
def allowed_share(share: Number, whole: Number) -> Number:
    """{share}·{whole}"""


@formula
def lesser_radius(first: Number, second: Number) -> Number:
    """min({first}, {second})"""


@formula
def whole_mm_above(length: Number) -> Number:
    """⌈1000·{length}⌉/1000"""
    # a millimetre that rounding carried over a whole one is that one
    return Number(np.ceil(1000.0 * length - _DIGITS) / 1000.0)


@formula
def whole_mm_below(length: Number) -> Number:
    """⌊1000·{length}⌋/1000"""
    # as above
    return Number(np.floor(1000.0 * length + _DIGITS) / 1000.0)


@formula
def on_protractor(angle: Angle, mu: Number) -> Length:
    """{angle}/{mu}"""


@formula
def off_protractor(length: Length, mu: Number) -> Angle:
    """{length}·{mu}"""
