"""Formulas of planetary trains: radii and axes, the ratio by Willis, the conditions on tooth numbers."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import WHOLE_ROW, operation
from graphic_tmm.board.values import Angle, Length, Number, Point, Reals

_NO_TEETH = "a wheel has no teeth"
_STANDS = "the driven shaft stands"
_NO_SATELLITES = "there are no satellites"


def _divisor(value: Reals) -> Reals:
    """Return a divisor, NaN where it is 0."""
    return np.asarray(np.where(value == 0.0, np.nan, value))


@operation(formula=True)
def axes_outside(m: Number, first: Number, second: Number) -> Number:
    """{m}·({first} + {second})/2"""
    return Number(m * (first + second) / 2.0)


@operation(formula=True)
def axes_inside(m: Number, ring: Number, wheel: Number) -> Number:
    """{m}·({ring} − {wheel})/2"""
    return Number(m * (ring - wheel) / 2.0)


@operation(formula=True)
def tip_diameter(m: Number, z: Number, ha: Number) -> Number:
    """{m}·({z} + 2·{ha})"""
    return Number(m * (z + 2.0 * ha))


@operation(formula=True)
def tooth_difference(ring: Number, wheel: Number) -> Number:
    """{ring} − {wheel}"""
    return Number(ring - wheel)


@operation(formula=True, fails=_NO_SATELLITES)
def neighbouring_axes(axes: Number, k: Number) -> Number:
    """2·{axes}·sin(180°/{k})"""
    return Number(2.0 * axes * np.sin(np.pi / _divisor(k)))


@operation(formula=True, fails=_NO_TEETH)
def ratio_of_row(z1: Number, z3: Number) -> Number:
    """1 + {z3}/{z1}"""
    return Number(1.0 + z3 / _divisor(z1))


@operation(formula=True, fails=_NO_TEETH)
def ratio_opposed(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """1 + {z2}·{z4}/({z1}·{z3})"""
    return Number(1.0 + z2 * z4 / _divisor(z1 * z3))


@operation(formula=True, fails=_NO_TEETH)
def ratio_alike(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """1 − {z2}·{z4}/({z1}·{z3})"""
    below = _divisor(z1 * z3)
    return Number((below - z2 * z4) / below)


@operation(formula=True, fails=_STANDS)
def inverse_ratio(ratio: Number) -> Number:
    """1/{ratio}"""
    return Number(1.0 / _divisor(ratio))


@operation(formula=True, fails=_NO_TEETH)
def overall_ratio(ratio: Number, driven: Number, driving: Number) -> Number:
    """{ratio}·{driven}/{driving}"""
    return Number(ratio * driven / _divisor(driving))


@operation(formula=True)
def common_divisor(z2: Number, z3: Number) -> Number:
    """gcd({z2}, {z3})"""
    whole = np.gcd(np.rint(z2).astype(np.int64), np.rint(z3).astype(np.int64))
    return Number(whole + 0.0 * (z2 + z3))


@operation(formula=True, fails=_NO_SATELLITES)
def assembly_of_row(z1: Number, z3: Number, k: Number) -> Number:
    """({z1} + {z3})/{k}"""
    return Number((z1 + z3) / _divisor(k))


@operation(formula=True, fails=_NO_SATELLITES)
def assembly_opposed(
    z1: Number, z2: Number, z3: Number, z4: Number, k: Number, g: Number
) -> Number:
    """({z1}·{z3} + {z2}·{z4})/({k}·{g})"""
    return Number((z1 * z3 + z2 * z4) / _divisor(k * g))


@operation(formula=True, fails=_NO_SATELLITES)
def assembly_alike(z1: Number, z2: Number, z3: Number, z4: Number, k: Number, g: Number) -> Number:
    """({z1}·{z3} − {z2}·{z4})/({k}·{g})"""
    return Number((z1 * z3 - z2 * z4) / _divisor(k * g))


@operation(
    formula=True,
    fails=("no ring is clear of so few teeth", "при таком числе зубьев заклинивает любой венец"),
)
def least_ring(z: Number, alpha: Angle, ha: Number) -> Number:
    """({z}²·sin²{alpha} − 4·{ha}²)/(2·{z}·sin²{alpha} − 4·{ha})"""
    s = np.sin(np.radians(alpha)) ** 2
    below = 2.0 * z * s - 4.0 * ha
    return Number((z * z * s - 4.0 * ha * ha) / np.where(below > 0.0, below, np.nan))


@operation(formula=True, fails=_STANDS)
def ratio_of_segments(driving: Length, driven: Length) -> Number:
    """{driving}/{driven}"""
    return Number(driving / _divisor(driven))


@operation(formula=True, fails=("there is no ratio to compare with", "не с чем сравнивать"))
def miss_of_ratio(found: Number, due: Number) -> Number:
    """100·|{found} − {due}|/|{due}|"""
    return Number(100.0 * np.abs(found - due) / _divisor(np.abs(due)))


@operation(
    across=True,
    fails=WHOLE_ROW,
)
def next_satellite(axis: Point, *, row: int) -> Point:
    """Mark {it}, the axis of the satellite that follows {axis}."""
    after = np.full_like(axis, np.nan)
    after[:, :row] = np.roll(axis[:, :row], -1, axis=1)
    return Point(after)
