"""Formulas of a pair of spur gears with shift: dimensions, limits, contact ratio, specific sliding.

Lengths of the gears are quantities (m); angles are in degrees. inv α = tan α − α is the involute function.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.functions import define
from graphic_tmm.board.values import Angle, Length, Number, Reals

_NO_ANGLE = "no angle has this involute function"
_INSIDE = "the tip circle lies inside the base circle"
_SERIES = (21844 / 6081075, 1382 / 155925, 62 / 2835, 17 / 315, 2 / 15, 1 / 3)
"""The coefficients of tan α − α over α³, the highest power first."""
_NEAR = 0.1
"""Below this angle (radians) the difference tan α − α loses digits and its series is taken."""
_PASSES = 10
"""Newton's steps: each doubles the digits once the root is near."""


def involute_of(angle: Reals) -> Reals:
    """Return tan α − α of an angle in radians, to the last digits for small angles too."""
    series = np.zeros_like(angle)
    for factor in _SERIES:
        series = (series + factor) * (angle * angle if factor != _SERIES[-1] else 1.0)
    return np.where(np.abs(angle) < _NEAR, series * angle**3, np.tan(angle) - angle)


def angle_with(value: Reals) -> Reals:
    """Return the angle (radians) whose involute function is ``value``; NaN where it is negative.

    Both ∛(3v) and arctan(v + π/2) lie above the root and the function is convex: Newton's steps go down to it.
    """
    value = np.where(value >= 0.0, value, np.nan)
    angle = np.minimum(np.cbrt(3.0 * value), np.arctan(value + np.pi / 2.0))
    for _ in range(_PASSES):
        slope = np.where(value > 0.0, np.tan(angle) ** 2, 1.0)
        angle = angle - (involute_of(angle) - value) / slope
    return angle


define("inv", involute_of, of_angle=True)
define("arcinv", angle_with, angle=True)


@formula
def involute(alpha: Angle) -> Number:
    """tan({alpha}) − {alpha}·π/180°"""
    # the terms of the text cancel at small angles
    return Number(involute_of(np.radians(alpha)))


@formula
def working_involute(x1: Number, x2: Number, alpha: Angle, z1: Number, z2: Number) -> Number:
    """2·({x1} + {x2})·tan {alpha}/({z1} + {z2}) + inv {alpha}"""


@formula(fails=_NO_ANGLE)
def angle_of_involute(inv: Number) -> Angle:
    """arcinv({inv})"""


@formula
def working_distance(a: Number, alpha: Angle, alpha_w: Angle) -> Number:
    """{a}·cos {alpha}/cos {alpha_w}"""


@formula
def perceived_shift(a_w: Number, a: Number, m: Number) -> Number:
    """({a_w} − {a})/{m}"""


@formula
def equalising_shift(x1: Number, x2: Number, y: Number) -> Number:
    """{x1} + {x2} − {y}"""


@formula
def times_cosine(length: Number, alpha: Angle) -> Number:
    """{length}·cos {alpha}"""


@formula
def over_cosine(length: Number, alpha: Angle) -> Number:
    """{length}/cos {alpha}"""


@formula
def root_radius(r: Number, m: Number, ha: Number, c: Number, x: Number) -> Number:
    """{r} − {m}·({ha} + {c} − {x})"""


@formula
def tip_radius(r: Number, m: Number, ha: Number, x: Number, dy: Number) -> Number:
    """{r} + {m}·({ha} + {x} − {dy})"""


@formula
def tooth_height(m: Number, ha: Number, c: Number, dy: Number) -> Number:
    """{m}·(2·{ha} + {c} − {dy})"""


@formula
def working_depth(m: Number, ha: Number, dy: Number) -> Number:
    """{m}·(2·{ha} − {dy})"""


@formula
def pitch_of(m: Number) -> Number:
    """π·{m}"""


@formula
def tooth_thickness(m: Number, x: Number, alpha: Angle) -> Number:
    """{m}·(π/2 + 2·{x}·tan {alpha})"""


@formula(fails=_INSIDE)
def tip_angle(r_b: Number, r_a: Number) -> Angle:
    """arccos({r_b}/{r_a})"""


@formula
def tip_thickness(r_a: Number, s: Number, r: Number, alpha: Angle, alpha_a: Angle) -> Number:
    """{r_a}·({s}/{r} + 2·(inv {alpha} − inv {alpha_a}))"""


@formula
def pointed_involute(s: Number, r: Number, alpha: Angle) -> Number:
    """{s}/(2·{r}) + inv {alpha}"""


@formula
def contact_ratio(z1: Number, a1: Angle, z2: Number, a2: Angle, alpha_w: Angle) -> Number:
    """({z1}·(tan {a1} − tan {alpha_w}) + {z2}·(tan {a2} − tan {alpha_w}))/(2·π)"""


@formula
def tip_clearance(a_w: Number, r_a: Number, r_f: Number) -> Number:
    """{a_w} − {r_a} − {r_f}"""


@formula
def angular_pitch(z: Number) -> Angle:
    """360°/{z}"""


@formula
def arc_of_pitch(r: Number, z: Number) -> Number:
    """2·π·{r}/{z}"""


@formula
def half_of(length: Length) -> Length:
    """{length}/2"""


@formula
def part_of(share: Number, length: Length) -> Length:
    """{share}·{length}"""


@formula
def remainder(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""


@formula(fails="the length to divide by is zero")
def ratio_of(part: Length, whole: Length) -> Number:
    """{part}/{whole}"""


@formula
def percent_off(found: Number, due: Number) -> Number:
    """100·({found} − {due})/{due}"""


@formula(
    holds="{near} > 0, {far} ≥ 0",
    fails="the point does not lie between the limits of the line of action",
)
def specific_sliding(own: Number, other: Number, far: Length, near: Length) -> Number:
    """1 − {own}/{other}·{far}/{near}

    ``near``: how far the point is from the limit of the wheel's own base circle, ``far``: from the other's.
    """
