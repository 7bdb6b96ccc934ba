"""The basic rack that cuts a gear: its rounded tip, the limits it sets to a tooth, the fillet it leaves.

The rack's tooth has the half thickness π·m/4 on its middle line; its straight flanks go down to the depth h,
and the rounding ρ of its tip goes on from there. A contact on the rounding is told by the angle φ of its
normal: from α, the end of the straight flank, to 90°, the bottom of the root.
"""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number


@formula
def rounding(m: Number, ha: Number, c: Number, alpha: Angle) -> Number:
    """{m}·min({c}, (π/4 − ({ha} + {c})·tan {alpha})·cos {alpha})/(1 − sin {alpha})

    The rounding of the rack's tooth begins where the teeth cut need no straight flank, or it is full.
    """


@formula
def straight_depth(ha: Number, c: Number, m: Number, rho: Number, alpha: Angle) -> Number:
    """({ha} + {c})·{m} − {rho}·(1 − sin {alpha})"""


@formula
def rounding_depth(ha: Number, c: Number, x: Number, m: Number, rho: Number) -> Number:
    """({ha} + {c} − {x})·{m} − {rho}"""


@formula
def rounding_offset(m: Number, ha: Number, c: Number, rho: Number, alpha: Angle) -> Number:
    """π·{m}/4 − (({ha} + {c})·{m} − {rho})·tan {alpha} − {rho}/cos {alpha}"""


@formula
def least_shift(h: Number, m: Number, z: Number, alpha: Angle) -> Number:
    """{h}/{m} − {z}·sin² {alpha}/2"""


@formula
def limit_curvature(r: Number, alpha: Angle, h: Number, x: Number, m: Number) -> Number:
    """{r}·sin {alpha} − ({h} − {x}·{m})/sin {alpha}"""


@formula
def lowest_curvature(a_w: Number, alpha_w: Angle, r_b: Number, alpha_a: Angle) -> Number:
    """{a_w}·sin {alpha_w} − {r_b}·tan {alpha_a}"""


@formula
def not_negative(value: Number) -> Number:
    """max({value}, 0)"""


@formula
def ray_of_rounding(alpha: Angle, n: Number, parts: Number) -> Angle:
    """2·arctan((tan({alpha}/2))^(1 − {n}/{parts}))

    From α to 90°, the closer together the flatter the ray: its foot on the pitch line moves fast there.
    """


@formula
def rolled_of_ray(offset: Length, depth: Length, phi: Angle) -> Length:
    """{offset} − {depth}·cos {phi}/sin {phi}"""


@formula
def reach_of_ray(depth: Length, phi: Angle, rho: Length) -> Length:
    """{depth}/sin {phi} + {rho}"""
