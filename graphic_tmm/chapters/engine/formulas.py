"""The crank mechanism of an engine: forces of the piston, masses that go to and fro, rotating vectors."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import ANGLE, RAY, WHOLE_ROW, operation
from graphic_tmm.board.values import Angle, Length, Line, Number, Point
from graphic_tmm.language.said import said

KGF = 9.80665
"""A kgf in N."""
_SQUARE = "the rod stands square to the guide"


@operation(
    symbol=f"{ANGLE} + {RAY}",
    why=said(
        "The inertia force of the second order turns as cos 2φ: its vector turns twice as fast as the "
        "crank."
    ),
)
def doubled(through: Point, outward: Line, crank: Line) -> Line:
    """Through {through} draw {it} at twice the angle of the crank {crank} from {outward}."""
    return Line(through, crank.along * crank.along * np.conj(outward.along))


@formula(
    why=said(
        "The rod's mass is shared between its ends as a weight between two supports: in the inverse ratio "
        "of the distances from the mass centre."
    )
)
def split_by_lever(mass: Number, length: Number, whole: Number) -> Number:
    """{mass}·{length}/{whole}"""


@formula(why=said("This share of the rod's mass is thought of as moving with the crosshead."))
def mass_of_share(mass: Number, share: Number) -> Number:
    """{mass}·{share}"""


@formula(
    why=said(
        "The parts together have the mass of the whole; what is not at the one end is at the other."
    )
)
def rest_of(whole: Number, part: Number) -> Number:
    """{whole} − {part}"""


@formula(
    why=said(
        "A lumped mass has about the mass centre the moment of inertia m·l²; the sum shows how far two "
        "masses stand for the rod."
    )
)
def lumped_inertia(first: Number, arm: Number, second: Number, other: Number) -> Number:
    """{first}·{arm}² + {second}·{other}²"""


@formula(
    why=said(
        "The acceleration counts positive towards the crank, so its sign is taken against the outward "
        "direction of the guide."
    )
)
def towards_crank(outward: Number, segment: Length, mu: Number) -> Number:
    """−{outward}·{segment}·{mu}"""


@formula(
    why=said(
        "By d'Alembert's principle the masses that move to and fro add their inertia force, against their "
        "acceleration, to the gas force."
    )
)
def against_acceleration(mass: Number, acceleration: Number) -> Number:
    """−{mass}·{acceleration}"""


@formula(
    why=said(
        "How much the motion of the crosshead differs from a pure cosine hangs on the ratio of crank and "
        "rod."
    )
)
def crank_ratio(crank: Number, rod: Number) -> Number:
    """{crank}/{rod}"""


@formula(
    why=said(
        "The acceleration of the crosshead is R·ω²·(cos φ + λ·cos 2φ); times the mass the first term is a "
        "projected vector of this length."
    )
)
def first_order(mass: Number, omega: Number, radius: Number) -> Number:
    """{mass}·{omega}²·{radius}"""


@formula(why=said("The second term of the acceleration is λ times as large as the first one."))
def second_order(first: Number, ratio: Number) -> Number:
    """{first}·{ratio}"""


@formula(
    why=said(
        "An inertia force of an order is the projection of its turning vector on the line of the cylinder, "
        "against the acceleration."
    )
)
def projected(segment: Length, mu: Number) -> Number:
    """−{segment}·{mu}"""


@formula(
    why=said(
        "The acceleration is the inertia force divided by the mass, with the opposite sign; it is compared "
        "with that of the plan."
    )
)
def per_mass(force: Number, mass: Number) -> Number:
    """−{force}/{mass}"""


@formula(why=said("The task counts forces in kgf: 1 kgf is the weight of 1 kg."))
def in_kgf(force: Number, unit: Number) -> Number:
    """{force}/{unit}"""


@formula(
    why=said(
        "The pressure on the guide and the equal one on the bearing are a couple on the frame; its moment "
        "balances that of the crank."
    )
)
def couple_of(force: Number, distance: Length, mu_l: Number) -> Number:
    """{force}·{distance}·{mu_l}"""


@formula(
    why=said(
        "Q on the crank pin and −Q on the bearing are a couple with the arm R·sin(φ + β), here {arm}: its "
        "moment is that of the tangential force."
    )
)
def moment_of_rod(force: Number, arm: Length, mu_l: Number) -> Number:
    """{force}·{arm}·{mu_l}"""


@formula(
    holds="{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "N = P′·tan β acts on the arm OB = OA·cos φ + AB·cos β. As OA·sin φ = AB·sin β, that is OB = R·sin(φ + "
        "β)/sin β, so M′ = N·OB = P′·R·sin(φ + β)/cos β; formula (344). It is M: both couples are equal."
    ),
)
def tipping_couple(force: Number, arm: Length, rod: Length, along: Length, mu_l: Number) -> Number:
    """{force}·{arm}·{rod}/{along}·{mu_l}"""


@formula(why=said("A mass in kg weighs as many kgf; divided by g it is the mass in kgf·s²/m."))
def mass_by_weight(mass: Number, g: Number) -> Number:
    """{mass}/{g}"""


@operation(
    symbol="N1",
    across=True,
    fails=WHOLE_ROW,
    why=said("The intervals are equal, so the mean of the turn is that of their means."),
)
def mean_of_row(values: Number, *, row: int) -> Number:
    """Find the mean {it} of {values} over the turn."""
    return Number(np.mean(values[:, :row], axis=1, keepdims=True))


@formula(
    holds="{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "The crank pin stands {height} off the guide's line and {along} along it from the crosshead: their "
        "ratio is tan β."
    ),
)
def slope_of_rod(height: Length, along: Length) -> Angle:
    """arctan({height}/{along})"""


@formula(
    holds="{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "In the triangle at the crosshead N is opposite to β, P′ beside it: N = P′·tan β, and tan β is "
        "{height}/{along}; formula (339)."
    ),
)
def guide_pressure(force: Number, height: Length, along: Length) -> Number:
    """{force}·{height}/{along}"""


@formula(
    holds="{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "Q is the longest side of the triangle at the crosshead: Q = P′/cos β, and cos β is {along}/{rod}; "
        "formula (340)."
    ),
)
def rod_force(force: Number, rod: Length, along: Length) -> Number:
    """{force}·{rod}/{along}"""


@formula(
    holds="{crank}·{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "The rod makes the angle φ + β with the crank, an outer angle of the triangle OAB. T = "
        "P′·sin(φ + β)/cos β is the part of Q square to the crank, and sin(φ + β) is {arm}/{crank}; "
        "formula (341)."
    ),
)
def tangential_force(
    force: Number, arm: Length, crank: Length, rod: Length, along: Length
) -> Number:
    """{force}·{arm}/{crank}·{rod}/{along}"""


@formula(
    holds="{crank}·{along} ≠ 0",
    fails=_SQUARE,
    why=said(
        "K = P′·cos(φ + β)/cos β is the part of Q along the crank, and cos(φ + β) is {part}/{crank}; "
        "formula (342)."
    ),
)
def radial_force(force: Number, part: Length, crank: Length, rod: Length, along: Length) -> Number:
    """{force}·{part}/{crank}·{rod}/{along}"""


@formula(why=said("The mean moment times the angle of a turn, 2π, is the work of the turn."))
def work_of_turn(moment: Number) -> Number:
    """2π·{moment}"""


@formula(
    why=said(
        "The mean pressure is what, constant over one stroke, does the work of the whole turn: times the "
        "area it is a force, times the stroke that work. The sign tells whether the gas drives or resists."
    )
)
def work_of_gas(sign: Number, pressure: Number, area: Number, stroke: Number) -> Number:
    """{sign}·{pressure}·{area}·{stroke}"""


@formula(
    holds="{due} ≠ 0",
    fails="the gas does no work",
    why=said("So much of the steam's work does the work of the tangential force differ from it."),
)
def works_apart(found: Number, due: Number) -> Number:
    """100·({found} − {due})/{due}"""
