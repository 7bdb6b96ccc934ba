"""The basic rack that cuts a gear: its rounded tip, the limits it sets to a tooth, the fillet it leaves.

The rack's tooth has the half thickness π·m/4 on its middle line; its straight flanks go down to the depth h,
and the rounding ρ of its tip goes on from there. A contact on the rounding is told by the angle φ of its
normal: from α, the end of the straight flank, to 90°, the bottom of the root.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.chapters.gears.formulas import cos_of, sin_of, tan_of


@operation(formula=True)
def rounding(m: Number, ha: Number, c: Number, alpha: Angle) -> Number:
    """{m}·min({c}, (π/4 − ({ha} + {c})·tan {alpha})·cos {alpha})/(1 − sin {alpha})

    The rounding of the rack's tooth begins where the teeth cut need no straight flank, or it is full.
    """
    full = (np.pi / 4.0 - (ha + c) * tan_of(alpha)) * cos_of(alpha)
    return Number(m * np.minimum(c, full) / (1.0 - sin_of(alpha)))


@operation(formula=True)
def straight_depth(ha: Number, c: Number, m: Number, rho: Number, alpha: Angle) -> Number:
    """({ha} + {c})·{m} − {rho}·(1 − sin {alpha})"""
    return Number((ha + c) * m - rho * (1.0 - sin_of(alpha)))


@operation(formula=True)
def rounding_depth(ha: Number, c: Number, x: Number, m: Number, rho: Number) -> Number:
    """({ha} + {c} − {x})·{m} − {rho}"""
    return Number((ha + c - x) * m - rho)


@operation(formula=True)
def rounding_offset(m: Number, ha: Number, c: Number, rho: Number, alpha: Angle) -> Number:
    """π·{m}/4 − (({ha} + {c})·{m} − {rho})·tan {alpha} − {rho}/cos {alpha}"""
    depth = (ha + c) * m - rho
    return Number(np.pi * m / 4.0 - depth * tan_of(alpha) - rho / cos_of(alpha))


@operation(formula=True)
def least_shift(h: Number, m: Number, z: Number, alpha: Angle) -> Number:
    """{h}/{m} − {z}·sin² {alpha}/2"""
    return Number(h / m - z * sin_of(alpha) ** 2 / 2.0)


@operation(formula=True)
def limit_curvature(r: Number, alpha: Angle, h: Number, x: Number, m: Number) -> Number:
    """{r}·sin {alpha} − ({h} − {x}·{m})/sin {alpha}"""
    return Number(r * sin_of(alpha) - (h - x * m) / sin_of(alpha))


@operation(formula=True)
def lowest_curvature(a_w: Number, alpha_w: Angle, r_b: Number, alpha_a: Angle) -> Number:
    """{a_w}·sin {alpha_w} − {r_b}·tan {alpha_a}"""
    return Number(a_w * sin_of(alpha_w) - r_b * tan_of(alpha_a))


@operation(formula=True)
def not_negative(value: Number) -> Number:
    """max({value}, 0)"""
    return Number(np.maximum(value, 0.0))


@operation(formula=True)
def ray_of_rounding(alpha: Angle, n: Number, parts: Number) -> Angle:
    """2·arctan((tan({alpha}/2))^(1 − {n}/{parts}))

    From α to 90°, the closer together the flatter the ray: its foot on the pitch line moves fast there.
    """
    return Angle(2.0 * np.degrees(np.arctan(tan_of(Angle(alpha / 2.0)) ** (1.0 - n / parts))))


@operation(formula=True)
def rolled_of_ray(offset: Length, depth: Length, phi: Angle) -> Length:
    """{offset} − {depth}·cos {phi}/sin {phi}"""
    return Length(offset - depth * cos_of(phi) / sin_of(phi))


@operation(formula=True)
def reach_of_ray(depth: Length, phi: Angle, rho: Length) -> Length:
    """{depth}/sin {phi} + {rho}"""
    return Length(depth / sin_of(phi) + rho)
