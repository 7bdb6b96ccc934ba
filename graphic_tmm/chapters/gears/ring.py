"""A wheel inside a ring: its dimensions, and whether it runs there without one tooth meeting another.

The flanks of a ring are the same involutes with the material outside. A pinion cutter makes them; its rounded
corners are not known, so they are drawn to the root. Both limits of the line of action lie on one side of the
pitch point: contact goes from the tip circle of the ring, which must not reach beyond N₁, to that of the wheel.

Away from the line of action the tips pass one another: where the tip circles cross, the corner of the wheel has
to be there after that of the ring (trochoid overlap). Put in along the line of centres, the widest place of the
wheel has to go between the tips of the ring (radial assembly).
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.gears.formulas import ratio_of_teeth
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The flanks touch inside as they do outside: teeth and shifts count by their difference."
    )
)
def working_involute_inside(x1: Number, x2: Number, alpha: Angle, z1: Number, z2: Number) -> Number:
    """2·({x2} − {x1})·tan {alpha}/({z2} − {z1}) + inv {alpha}"""


@formula(why=said("What the one leaves of the other."))
def less(whole: Number, part: Number) -> Number:
    """{whole} − {part}"""


@formula(
    why=said(
        "The axes go apart by less than the shifts differ; the teeth become longer by so much, to keep the "
        "clearance."
    )
)
def equalising_shift_inside(x1: Number, x2: Number, y: Number) -> Number:
    """{y} − ({x2} − {x1})"""


@formula(
    why=said("The space of a ring goes outward by the addendum of its mate with the clearance.")
)
def ring_root(r: Number, m: Number, ha: Number, c: Number, x: Number) -> Number:
    """{r} + {m}·({ha} + {c} + {x})"""


@formula(
    why=said("The teeth of a ring reach inward from the pitch circle; a shift moves them outward.")
)
def ring_tip(r: Number, m: Number, ha: Number, x: Number, dy: Number) -> Number:
    """{r} − {m}·({ha} − {x} − {dy})"""


@formula(why=said("The tooth of a ring is the space of a wheel: a shift makes it thinner."))
def ring_thickness(m: Number, x: Number, alpha: Angle) -> Number:
    """{m}·(π/2 − 2·{x}·tan {alpha})"""


@formula(
    why=said(
        "Between two circles the flanks of a ring come nearer inward, as a wheel's do outward."
    )
)
def ring_thickness_at(r_a: Number, s: Number, r: Number, alpha: Angle, alpha_a: Angle) -> Number:
    """{r_a}·({s}/{r} + 2·(inv {alpha_a} − inv {alpha}))"""


@formula(
    why=said(
        "Where the flanks of a ring meet its tooth is pointed: inward they come nearer until nothing is left."
    )
)
def pointed_ring_involute(s: Number, r: Number, alpha: Angle) -> Number:
    """−{s}/(2·{r}) + inv {alpha}"""


@formula(why=said("The tip of the ring reaches down to this point of the flank, counted from N₁."))
def lowest_inside(a_w: Number, alpha_w: Angle, r_b: Number, alpha_a: Angle) -> Number:
    """{r_b}·tan {alpha_a} − {a_w}·sin {alpha_w}"""


@formula(why=said("The tip of the wheel reaches out to this point of the ring's flank."))
def farthest_inside(a_w: Number, alpha_w: Angle, r_b: Number, alpha_a: Angle) -> Number:
    """{a_w}·sin {alpha_w} + {r_b}·tan {alpha_a}"""


@formula(why=said("Through N₁ goes the least circle on which the ring's tips may lie."))
def least_tip_radius(r_b: Number, a_w: Number, alpha_w: Angle) -> Number:
    """√({r_b}² + ({a_w}·sin {alpha_w})²)"""


@formula(
    why=said(
        "The path of contact goes from the tip circle of the ring to that of the wheel; divided by the base "
        "pitch it tells how many pairs touch."
    )
)
def contact_ratio_inside(z1: Number, a1: Angle, z2: Number, a2: Angle, alpha_w: Angle) -> Number:
    """({z1}·(tan {a1} − tan {alpha_w}) − {z2}·(tan {a2} − tan {alpha_w}))/(2·π)"""


@formula(
    why=said(
        "Both wheels turn the same way: along the line of action both flanks are equally fast."
    )
)
def sliding_velocity_inside(omega1: Number, omega2: Number, x: Number, pole: Number) -> Number:
    """({omega1} − {omega2})·({x} − {pole})"""


@formula(why=said("Between the circles of the ring and of the wheel there is what the axes leave."))
def clearance_inside(a_w: Number, outer: Number, inner: Number) -> Number:
    """{outer} − {a_w} − {inner}"""


@formula(why=said("There the tip circles cross, seen from the wheel's centre."))
def crossing_of_wheel(a_w: Number, r_a1: Number, r_a2: Number) -> Angle:
    """arccos(max(−1, min(1, ({r_a2}² − {a_w}² − {r_a1}²)/(2·{a_w}·{r_a1}))))"""


@formula(why=said("There the tip circles cross, seen from the ring's centre."))
def crossing_of_ring(a_w: Number, r_a1: Number, r_a2: Number) -> Angle:
    """arccos(max(−1, min(1, ({a_w}² + {r_a2}² − {r_a1}²)/(2·{a_w}·{r_a2}))))"""


@formula(
    why=said("So far the wheel's widest place stands from the line of centres when it is put in.")
)
def entry_of_wheel(a1: Angle, a2: Angle, z1: Number, z2: Number) -> Angle:
    """arcsin(√(max(0, min(1, (1 − (cos {a1}/cos {a2})²)/(1 − ({z1}/{z2})²)))))"""


@formula(why=said("So far the ring's corner stands there from the line of centres."))
def entry_of_ring(a1: Angle, a2: Angle, z1: Number, z2: Number) -> Angle:
    """arcsin(√(max(0, min(1, ((cos {a2}/cos {a1})² − 1)/(({z2}/{z1})² − 1)))))"""


@formula(
    why=said(
        "Both corners are brought there by turning from the pitch point; what is left between them along the "
        "ring's tip circle keeps them apart."
    )
)
def gap_of_corners(
    r_a: Number, u: Number, t1: Angle, a1: Angle, t2: Angle, a2: Angle, alpha_w: Angle
) -> Number:
    """{r_a}·(({t1}·π/180° + inv {a1} − inv {alpha_w})/{u} − ({t2}·π/180° + inv {a2} − inv {alpha_w}))"""


@dataclass(frozen=True)
class Ring:
    """What is asked of a ring about a wheel only (m).

    The least tip radius; what is left between corners where the tip circles cross, and when the wheel is put in
    along the line of centres. ``uncut``: the contact ratio to the tip circle, where that reaches beyond N1.
    """

    least_tip: Mark
    overlap: Mark
    assembly: Mark
    uncut: Mark | None


def check_ring(
    draft: Draft,
    axes: tuple[Mark, Mark],
    z: tuple[Mark, ...],
    tips: tuple[tuple[Mark, Mark], ...],
    r_b: Mark,
    beyond: bool,
) -> Ring:
    """Calculate what is asked of a ring only; ``axes``: a_w, α_w; ``tips``: radius and profile angle."""
    (a_w, alpha_w), ((r_a1, a1), (r_a2, a2)) = axes, tips
    least = draft.draw(least_tip_radius, "r_{l2}", r_b, a_w, alpha_w, unit="m")
    u = draft.draw(ratio_of_teeth, "z_{2}/z_{1}", z[1], z[0])
    gaps = []
    for name, ops, own in (
        ("θ", (crossing_of_wheel, crossing_of_ring), (a_w, r_a1, r_a2)),
        ("ψ", (entry_of_wheel, entry_of_ring), (a1, a2, *z)),
    ):
        t1, t2 = (draft.draw(op, f"{name}_{{{i}}}", *own) for i, op in enumerate(ops, 1))
        corners = (r_a2, u, t1, a1, t2, a2, alpha_w)
        gaps.append(draft.draw(gap_of_corners, f"δ_{{{name}}}", *corners, unit="m"))
    uncut = None
    if beyond:
        uncut = draft.draw(contact_ratio_inside, "[ε_{α}]", z[0], a1, z[1], a2, alpha_w)
    return Ring(least, gaps[0], gaps[1], uncut)
