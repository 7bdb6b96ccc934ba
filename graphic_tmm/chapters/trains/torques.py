"""The torques on the shafts of a planetary train, and what share of the power it hands on."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import product

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains.dimensions import draw_held
from graphic_tmm.chapters.trains.motion import Motion
from graphic_tmm.chapters.trains.plan import Planetary
from graphic_tmm.chapters.trains.task import Train
from graphic_tmm.chapters.trains.tooth_conditions import rates_of
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
    holds="{other} ≠ 1",
    fails="the train is locked",
    why=said(
        "The carrier has no torque: those on the three wheels balance, and with the carrier held so does the "
        "power."
    ),
)
def torque_of_driven(driving: Number, one: Number, other: Number) -> Number:
    """−{driving}·(1 − {one})/(1 − {other})"""


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
    if "H" not in made.train.scheme.members:
        return _three_wheels(draft, made, order.moment)
    first = motion.first
    given = math.copysign(order.moment, motion.driving[first])
    driving = draft.take(Number, f"M_{first}", given, "N·m")
    flow = mesh_flows(made.train, motion)["1"]
    lost, torques = draw_members(draft, made, first, driving, flow)
    return lost, torques, _efficiency(draft, made, torques)


def draw_members(
    draft: Draft, made: Planetary, first: str, driving: Mark, flow: int
) -> tuple[tuple[Mark, ...], dict[str, Mark]]:
    """Calculate the torques on all members from that on one; ``flow``: of `mesh_flows`, of wheel 1."""
    last = made.motion.last
    letter = driving.name.partition("_")[0]
    torques = {first: driving}
    ratio = draw_held(draft, made.train.scheme, made.sizes.teeth, "1", last)
    lost = [ratio]
    if made.order.mesh_efficiency < 1.0 and flow:
        mesh = draft.take(Number, "η_m", made.order.mesh_efficiency)
        held = draft.draw(efficiency_held, "η_0", mesh)
        op = ratio_of_torques if flow > 0 else ratio_of_torques_back
        ratio = draft.draw(op, "u", ratio, held)
        lost += [held, ratio]
    if first == "H":
        torques["1"] = draft.draw(torque_by_carrier, f"{letter}_1", driving, ratio, unit="N·m")
        others = ("H", "1", last)
    else:
        op = torque_of_last if first == "1" else torque_of_first
        other = last if first == "1" else "1"
        torques[other] = draft.draw(op, f"{letter}_{other}", driving, ratio, unit="N·m")
        others = (first, other, "H")
    one, two, third = others
    own = torques[one], torques[two]
    torques[third] = draft.draw(third_torque, f"{letter}_{third}", *own, unit="N·m")
    return tuple(lost), torques


def _efficiency(draft: Draft, made: Planetary, torques: Mapping[str, Mark]) -> Mark | None:
    """Calculate the share of the power handed on; None where two shafts drive."""
    motion, rates = made.motion, made.rates.values
    if not motion.fixed:
        return None
    marks = (one[name] for name in (motion.driven, motion.first) for one in (torques, rates))
    return draft.draw(train_efficiency, "η", *marks)


def _three_wheels(
    draft: Draft, made: Planetary, moment: float
) -> tuple[tuple[Mark, ...], dict[str, Mark], Mark | None]:
    """Calculate the torques on three central wheels: they balance, and so does power with the carrier held."""
    motion, scheme, order = made.motion, made.train.scheme, made.order
    first, driven = motion.first, motion.driven
    (third,) = {*scheme.members} - {first, driven}
    flows = mesh_flows(made.train, motion, order.mesh_efficiency)
    given = math.copysign(moment, motion.driving[first])
    torques, lost = {first: draft.take(Number, f"M_{first}", given, "N·m")}, list[Mark]()
    eta = None
    if order.mesh_efficiency < 1.0 and any(flows.values()):
        mesh = draft.take(Number, "η_m", order.mesh_efficiency)
        eta = draft.draw(efficiency_held, "η_0", mesh)
        lost.append(eta)
    ratios = []
    for wheel in (first, driven):
        ratio = draw_held(draft, scheme, made.sizes.teeth, wheel, third)
        lost.append(ratio)
        if eta is not None and flows[wheel] != flows[third]:
            op = ratio_of_torques if flows[wheel] > 0 else ratio_of_torques_back
            ratio = draft.draw(op, f"u_{{{wheel}{third}}}", ratio, eta)
            lost.append(ratio)
        ratios.append(ratio)
    name = f"M_{driven}"
    torques[driven] = draft.draw(torque_of_driven, name, torques[first], *ratios, unit="N·m")
    torques[third] = draft.draw(
        third_torque, f"M_{third}", torques[first], torques[driven], unit="N·m"
    )
    return tuple(lost), torques, _efficiency(draft, made, torques)


def mesh_flows(train: Train, motion: Motion, eta: float = 1.0) -> dict[str, int]:
    """Return how power flows through the meshes, the carrier held: +1 by member where it drives the satellite.

    0 where all turn as one: then no tooth slides.

    The torques balance, and so does the power that the satellite gets: Σ M_i·κ_i·η^±1 = 0, κ_i the angular
    velocity of a member in that motion. Of all flows the one that keeps itself up with its losses counts; that
    without losses where none does.
    """
    names = train.scheme.members
    rates, spin = rates_of(train, motion)
    if spin == 0.0:
        return dict.fromkeys(names, 0)
    due = [math.copysign(1.0, spin * rates[name]) for name in names]

    def flow(lost: Sequence[float]) -> tuple[float, ...]:
        a, b, c = (rates[name] * eta**sign for name, sign in zip(names, lost, strict=True))
        torques = dict(zip(names, (b - c, c - a, a - b), strict=True))
        turned = math.copysign(1.0, torques[motion.first] * motion.driving[motion.first])
        pairs = zip(torques.values(), due, strict=True)
        return tuple(math.copysign(1.0, turned * torque * sign) for torque, sign in pairs)

    ideal = flow((0.0, 0.0, 0.0))
    ways = (ideal, *product((1.0, -1.0), repeat=3))
    kept = next((way for way in ways if flow(way) == way), ideal) if eta < 1.0 else ideal
    return dict(zip(names, map(int, kept), strict=True))
