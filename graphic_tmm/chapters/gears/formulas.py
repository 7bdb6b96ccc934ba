"""Formulas of a pair of spur gears with shift: dimensions, limits, contact ratio, specific sliding.

Lengths of the gears are quantities (m); angles are in degrees. inv α = tan α − α is the involute function.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number, Reals

_NO_ANGLE = ("no angle has this involute function", "нет угла с такой инволютой")
_INSIDE = ("the tip circle lies inside the base circle", "окружность вершин внутри основной")
_SERIES = (21844 / 6081075, 1382 / 155925, 62 / 2835, 17 / 315, 2 / 15, 1 / 3)
_NEAR = 0.1
"""Below this angle (radians) the difference tan α − α loses digits and its series is taken."""
_PASSES = 10


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


def sin_of(angle: Angle) -> Reals:
    """Return the sine of an angle in degrees."""
    return np.asarray(np.sin(np.radians(angle)))


def cos_of(angle: Angle) -> Reals:
    """Return the cosine of an angle in degrees."""
    return np.asarray(np.cos(np.radians(angle)))


def tan_of(angle: Angle) -> Reals:
    """Return the tangent of an angle in degrees."""
    return np.asarray(np.tan(np.radians(angle)))


@operation(formula=True)
def involute(alpha: Angle) -> Number:
    """tan({alpha}) − {alpha}·π/180°"""
    return Number(involute_of(np.radians(alpha)))


@operation(formula=True)
def working_involute(x1: Number, x2: Number, alpha: Angle, z1: Number, z2: Number) -> Number:
    """2·({x1} + {x2})·tan {alpha}/({z1} + {z2}) + inv {alpha}"""
    return Number(2.0 * (x1 + x2) * tan_of(alpha) / (z1 + z2) + involute_of(np.radians(alpha)))


@operation(formula=True, fails=_NO_ANGLE)
def angle_of_involute(inv: Number) -> Angle:
    """arcinv({inv})"""
    return Angle(np.degrees(angle_with(inv)))


@operation(formula=True)
def pitch_radius(m: Number, z: Number) -> Number:
    """{m}·{z}/2"""
    return Number(m * z / 2.0)


@operation(formula=True)
def working_distance(a: Number, alpha: Angle, alpha_w: Angle) -> Number:
    """{a}·cos {alpha}/cos {alpha_w}"""
    return Number(a * cos_of(alpha) / cos_of(alpha_w))


@operation(formula=True)
def perceived_shift(a_w: Number, a: Number, m: Number) -> Number:
    """({a_w} − {a})/{m}"""
    return Number((a_w - a) / m)


@operation(formula=True)
def equalising_shift(x1: Number, x2: Number, y: Number) -> Number:
    """{x1} + {x2} − {y}"""
    return Number(x1 + x2 - y)


@operation(formula=True)
def times_cosine(length: Number, alpha: Angle) -> Number:
    """{length}·cos {alpha}"""
    return Number(length * cos_of(alpha))


@operation(formula=True)
def over_cosine(length: Number, alpha: Angle) -> Number:
    """{length}/cos {alpha}"""
    return Number(length / cos_of(alpha))


@operation(formula=True)
def root_radius(r: Number, m: Number, ha: Number, c: Number, x: Number) -> Number:
    """{r} − {m}·({ha} + {c} − {x})"""
    return Number(r - m * (ha + c - x))


@operation(formula=True)
def tip_radius(r: Number, m: Number, ha: Number, x: Number, dy: Number) -> Number:
    """{r} + {m}·({ha} + {x} − {dy})"""
    return Number(r + m * (ha + x - dy))


@operation(formula=True)
def tooth_height(m: Number, ha: Number, c: Number, dy: Number) -> Number:
    """{m}·(2·{ha} + {c} − {dy})"""
    return Number(m * (2.0 * ha + c - dy))


@operation(formula=True)
def working_depth(m: Number, ha: Number, dy: Number) -> Number:
    """{m}·(2·{ha} − {dy})"""
    return Number(m * (2.0 * ha - dy))


@operation(formula=True)
def pitch_of(m: Number) -> Number:
    """π·{m}"""
    return Number(np.pi * m)


@operation(formula=True)
def tooth_thickness(m: Number, x: Number, alpha: Angle) -> Number:
    """{m}·(π/2 + 2·{x}·tan {alpha})"""
    return Number(m * (np.pi / 2.0 + 2.0 * x * tan_of(alpha)))


@operation(
    formula=True,
    fails=_INSIDE,
)
def tip_angle(r_b: Number, r_a: Number) -> Angle:
    """arccos({r_b}/{r_a})"""
    return Angle(np.degrees(np.arccos(r_b / r_a)))


@operation(formula=True)
def tip_thickness(r_a: Number, s: Number, r: Number, alpha: Angle, alpha_a: Angle) -> Number:
    """{r_a}·({s}/{r} + 2·(inv {alpha} − inv {alpha_a}))"""
    inv, inv_a = involute_of(np.radians(alpha)), involute_of(np.radians(alpha_a))
    return Number(r_a * (s / r + 2.0 * (inv - inv_a)))


@operation(formula=True)
def pointed_involute(s: Number, r: Number, alpha: Angle) -> Number:
    """{s}/(2·{r}) + inv {alpha}"""
    return Number(s / (2.0 * r) + involute_of(np.radians(alpha)))


@operation(formula=True)
def contact_ratio(z1: Number, a1: Angle, z2: Number, a2: Angle, alpha_w: Angle) -> Number:
    """({z1}·(tan {a1} − tan {alpha_w}) + {z2}·(tan {a2} − tan {alpha_w}))/(2·π)"""
    own, other = tan_of(a1) - tan_of(alpha_w), tan_of(a2) - tan_of(alpha_w)
    return Number((z1 * own + z2 * other) / (2.0 * np.pi))


@operation(formula=True)
def tip_clearance(a_w: Number, r_a: Number, r_f: Number) -> Number:
    """{a_w} − {r_a} − {r_f}"""
    return Number(a_w - r_a - r_f)


@operation(formula=True)
def angular_pitch(z: Number) -> Angle:
    """360°/{z}"""
    return Angle(360.0 / z)


@operation(formula=True)
def arc_of_pitch(r: Number, z: Number) -> Number:
    """2·π·{r}/{z}"""
    return Number(2.0 * np.pi * r / z)


@operation(formula=True)
def half_of(length: Length) -> Length:
    """{length}/2"""
    return Length(length / 2.0)


@operation(formula=True)
def part_of(share: Number, length: Length) -> Length:
    """{share}·{length}"""
    return Length(share * length)


@operation(formula=True)
def remainder(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""
    return Length(whole - part)


@operation(formula=True, fails=("the length to divide by is zero", "деление на нулевую длину"))
def ratio_of(part: Length, whole: Length) -> Number:
    """{part}/{whole}"""
    return Number(part / whole)


@operation(formula=True)
def percent_off(found: Number, due: Number) -> Number:
    """100·({found} − {due})/{due}"""
    return Number(100.0 * (found - due) / due)


@operation(
    formula=True,
    fails=(
        "the point does not lie between the limits of the line of action",
        "точка лежит вне предельных точек линии зацепления",
    ),
)
def specific_sliding(own: Number, other: Number, far: Length, near: Length) -> Number:
    """1 − {own}/{other}·{far}/{near}

    ``near``: how far the point is from the limit of the wheel's own base circle, ``far``: from the other's.
    """
    inside = (near > 0.0) & (far >= 0.0)
    return Number(1.0 - own / other * far / np.where(inside, near, np.nan))
