"""The torques on the shafts of a planetary train, and what share of the power it hands on."""

from __future__ import annotations

import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.planetary.dimensions import draw_held
from graphic_tmm.chapters.planetary.motion import Motion
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.chapters.planetary.task import Train
from graphic_tmm.chapters.planetary.tooth_conditions import in_two_rows, member_rates
from graphic_tmm.language.said import said

TORQUES = "planetary-torques"
"""The view of what is calculated of them."""
_NO_TEETH = "a wheel has no teeth"


@formula(
    why=said(
        "With the carrier held both meshes hand on their share of the power, one after the other."
    )
)
def efficiency_held(mesh: Number) -> Number:
    """{mesh}²"""


_LOST = said(
    "With the carrier held power flows from the wheel that drives in this motion to the other, which gets the "
    "share {eta} of it: so are the torques of both."
)


@formula(why=_LOST)
def ratio_of_torques(held: Number, eta: Number) -> Number:
    """{held}·{eta}"""


@formula(holds="{eta} ≠ 0", fails="no power is handed on", why=_LOST)
def ratio_of_torques_back(held: Number, eta: Number) -> Number:
    """{held}/{eta}"""


_BALANCE = said(
    "The torques on the three shafts balance, and the meshes give the ratio of two of them."
)


@formula(why=_BALANCE)
def torque_of_last(first: Number, ratio: Number) -> Number:
    """−{first}·{ratio}"""


@formula(holds="{ratio} ≠ 0", fails=_NO_TEETH, why=_BALANCE)
def torque_of_first(last: Number, ratio: Number) -> Number:
    """−{last}/{ratio}"""


@formula(holds="{ratio} ≠ 1", fails="the train is locked", why=_BALANCE)
def torque_by_carrier(carrier: Number, ratio: Number) -> Number:
    """−{carrier}/(1 − {ratio})"""


@formula(why=_BALANCE)
def third_torque(one: Number, other: Number) -> Number:
    """−({one} + {other})"""


@formula(
    holds="{driving}·{omega} ≠ 0",
    fails="no power is put in",
    why=said("What power the driven shaft gives of that which is put in."),
)
def train_efficiency(
    driven: Number, omega_driven: Number, driving: Number, omega: Number
) -> Number:
    """−{driven}·{omega_driven}/({driving}·{omega})"""


def draw_torques(
    draft: Draft, made: Planetary
) -> tuple[tuple[Mark, ...], dict[str, Mark], Mark | None]:
    """Calculate the torques on the shafts from that on the driving one; the efficiency if one drives."""
    order, motion = made.order, made.motion
    if order.moment is None:
        return (), {}, None
    draft.open(TORQUES)
    first, last = motion.first, motion.last
    given = math.copysign(order.moment, motion.driving[first])
    torques = {first: draft.take(Number, f"M_{first}", given, "N·m")}
    ratio = draw_held(draft, made.train.scheme, made.sizes.teeth, f"U_{{1{last}}}^{{H}}")
    lost = [ratio]
    if order.mesh_efficiency < 1.0:
        mesh = draft.take(Number, "η_m", order.mesh_efficiency)
        held = draft.draw(efficiency_held, "η_0", mesh)
        forward = first_drives(made.train, motion)
        op = ratio_of_torques if forward else ratio_of_torques_back
        ratio = draft.draw(op, "u", ratio, held)
        lost += [held, ratio]
    if first == "H":
        torques["1"] = draft.draw(torque_by_carrier, "M_1", torques["H"], ratio, unit="N·m")
        others = ("H", "1", last)
    else:
        op = torque_of_last if first == "1" else torque_of_first
        other = last if first == "1" else "1"
        torques[other] = draft.draw(op, f"M_{other}", torques[first], ratio, unit="N·m")
        others = (first, other, "H")
    one, two, third = others
    torques[third] = draft.draw(third_torque, f"M_{third}", torques[one], torques[two], unit="N·m")
    if not motion.fixed:
        return tuple(lost), torques, None
    rates = made.rates.values
    share = draft.draw(
        train_efficiency,
        "η",
        torques[motion.driven],
        rates[motion.driven],
        torques[first],
        rates[first],
    )
    return tuple(lost), torques, share


def first_drives(train: Train, motion: Motion) -> bool:
    """Return whether wheel 1 drives while the carrier is held: power flows by it from wheel 1 to the last one.

    The signs of its torque and of its angular velocity seen from the carrier are alike; torques without losses.
    """
    z = in_two_rows(train.scheme, train.teeth)
    u, v = (int(rate[0]) for rate in member_rates(train.scheme, z, "H").values())
    known = dict(motion.driving) | ({motion.fixed: 0.0} if motion.fixed else {})
    if "H" not in known:
        seen = known["1"] - (v * known["1"] - u * known[motion.last]) / (v - u)
    elif "1" in known:
        seen = known["1"] - known["H"]
    else:
        seen = (known[motion.last] - known["H"]) * u / v
    share = {"1": v, motion.last: -u, "H": u - v}[motion.first]
    return motion.driving[motion.first] * share * v * seen >= 0.0
