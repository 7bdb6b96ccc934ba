"""The basic rack that cuts a gear: its rounded tip, the limits it sets to a tooth, the fillet it leaves.

The rack's tooth has the half thickness π·m/4 on its middle line; its straight flanks go down to the depth h,
and the rounding ρ of its tip goes on from there. A contact on the rounding is told by the angle φ of its
normal: from α, the end of the straight flank, to 90°, the bottom of the root.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said


@dataclass(frozen=True)
class RackSizes:
    """The basic rack (Number, m): ha, c (of the module), rounding ρ, depth h and offset of its centre."""

    ha: Mark
    c: Mark
    rounding: Mark
    straight: Mark
    offset: Mark


@formula(
    why=said(
        "The largest rounding that the tip of the rack has room for, at most that of the clearance."
    )
)
def rounding(m: Number, ha: Number, c: Number, alpha: Angle) -> Number:
    """{m}·min({c}, (π/4 − ({ha} + {c})·tan {alpha})·cos {alpha})/(1 − sin {alpha})

    The rounding of the rack's tooth begins where the teeth cut need no straight flank, or it is full.
    """


@formula(why=said("Above the rounding the rack's flank is straight: so deep it cuts an involute."))
def straight_depth(ha: Number, c: Number, m: Number, rho: Number, alpha: Angle) -> Number:
    """({ha} + {c})·{m} − {rho}·(1 − sin {alpha})"""


@formula(why=said("So far below the pitch line the centre of the rounding stands."))
def rounding_depth(ha: Number, c: Number, x: Number, m: Number, rho: Number) -> Number:
    """({ha} + {c} − {x})·{m} − {rho}"""


@formula(why=said("So far beside the middle of the space the centre of the rounding stands."))
def rounding_offset(m: Number, ha: Number, c: Number, rho: Number, alpha: Angle) -> Number:
    """π·{m}/4 − (({ha} + {c})·{m} − {rho})·tan {alpha} − {rho}/cos {alpha}"""


@formula(
    why=said(
        "With a smaller shift the rack would cut below the base circle and undercut the tooth."
    )
)
def least_shift(h: Number, m: Number, z: Number, alpha: Angle) -> Number:
    """{h}/{m} − {z}·sin² {alpha}/2"""


@formula(why=said("With fewer teeth the rack would cut below the base circle."))
def least_teeth(h: Number, m: Number, x: Number, alpha: Angle) -> Number:
    """2·({h}/{m} − {x})/sin² {alpha}"""


@formula(
    why=said(
        "Where the straight flank of the rack ends the involute ends too: its radius of curvature there is "
        "the distance along the line of action."
    )
)
def limit_curvature(r: Number, alpha: Angle, h: Number, x: Number, m: Number) -> Number:
    """{r}·sin {alpha} − ({h} − {x}·{m})/sin {alpha}"""


@formula(why=said("The tip of the other wheel reaches down to this point of the flank."))
def lowest_curvature(a_w: Number, alpha_w: Angle, r_b: Number, alpha_a: Angle) -> Number:
    """{a_w}·sin {alpha_w} − {r_b}·tan {alpha_a}"""


@formula(
    why=said("There is no involute below the base circle: its radius of curvature begins with 0.")
)
def not_negative(value: Number) -> Number:
    """max({value}, 0)"""


@formula(
    why=said(
        "The rounding of the tool is followed point by point, closer together where the fillet bends more."
    )
)
def ray_of_rounding(alpha: Angle, n: Number, parts: Number) -> Angle:
    """2·arctan((tan({alpha}/2))^(1 − {n}/{parts}))

    From α to 90°, the closer together the flatter the ray: its foot on the pitch line moves fast there.
    """


@formula(
    why=said(
        "A point of the rounding cuts where its normal goes through the pitch point: so far the wheel has "
        "rolled then."
    )
)
def rolled_of_ray(offset: Length, depth: Length, phi: Angle) -> Length:
    """{offset} − {depth}·cos {phi}/sin {phi}"""


@formula(
    why=said(
        "From the pitch point to the cutting point there is the way to the centre of the rounding and its "
        "radius."
    )
)
def reach_of_ray(depth: Length, phi: Angle, rho: Length) -> Length:
    """{depth}/sin {phi} + {rho}"""
