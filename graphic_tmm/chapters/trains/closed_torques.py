"""Torques in a closed differential: on its members, on the shaft that two of them share; power that circulates.

The wheels that close it hand on torque from one member to the shaft of the other. Where one of them takes what
the other gives, power goes round: it loads the wheels and is lost in them, and drives nothing.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import product

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains.motion import Closing, Motion
from graphic_tmm.chapters.trains.plan import Planetary
from graphic_tmm.chapters.trains.task import Train
from graphic_tmm.chapters.trains.tooth_conditions import rates_of
from graphic_tmm.chapters.trains.torques import (
    TORQUES,
    draw_members,
    efficiency_held,
    train_efficiency,
)
from graphic_tmm.language.said import said

_JOINED = said(
    "The wheels that close the train hand on torque as they hand on speed, so that power is kept but for what "
    "their meshes lose."
)


@formula(why=_JOINED)
def torque_joined(own: Number, other: Number, ratio: Number) -> Number:
    """{own} + {other}·{ratio}"""


@formula(why=_JOINED)
def torque_joined_on(own: Number, other: Number, ratio: Number, eta: Number) -> Number:
    """{own} + {other}·{ratio}·{eta}"""


@formula(holds="{eta} ≠ 0", fails="no power is handed on", why=_JOINED)
def torque_joined_back(own: Number, other: Number, ratio: Number, eta: Number) -> Number:
    """{own} + {other}·{ratio}/{eta}"""


@formula(
    holds="{found} ≠ 0",
    fails="the train is locked",
    why=said("All torques grow in proportion: so those of any trial do to those that are sought."),
)
def torque_in_proportion(trial: Number, due: Number, found: Number) -> Number:
    """{trial}·{due}/{found}"""


@formula(why=_JOINED)
def efficiency_of_more(share: Number, mesh: Number) -> Number:
    """{share}·{mesh}"""


@formula(
    why=said("The power that comes in on a shaft is the torque there times the angular velocity.")
)
def power(torque: Number, omega: Number) -> Number:
    """{torque}·{omega}"""


@formula(
    holds="{given} ≠ 0",
    fails="no power is put in",
    why=said(
        "Where of the two members that are joined one takes power and the other gives it back, the lesser of "
        "both goes round through the wheels."
    ),
)
def circulating(one: Number, other: Number, given: Number) -> Number:
    """(|{one}| + |{other}| − |{one} + {other}|)/(2·|{given}|)"""


def draw_closed_torques(
    draft: Draft, made: Planetary, closing: Closing
) -> tuple[tuple[Mark, ...], dict[str, Mark], Mark | None]:
    """Calculate the torques on all members of a closed differential and that on the shaft of two of them.

    Where that shaft drives, all are calculated from any torque on wheel 1 and then grow in proportion.
    """
    first, (joint, other, _), eta = made.motion.first, closing, made.order.mesh_efficiency
    assert made.order.moment is not None
    draft.open(TORQUES)
    given = math.copysign(made.order.moment, made.motion.driving[first])
    meshes = sum(len(row) - 1 for _, row in made.order.closed)
    flow, chain = closed_flows(made.train, made.motion, eta, meshes)
    inside = first == joint
    mark, from_member = ("M′", "1") if inside else ("M", first)
    driving = draft.take(Number, f"{mark}_{from_member}", given, "N·m")
    lost, torques = draw_members(draft, made, from_member, driving, flow)
    own = (torques[joint], torques[other], made.sizes.closing[other])
    if eta < 1.0 and chain:
        mesh = draft.uses(lost[1])[0] if len(lost) > 1 else draft.take(Number, "η_m", eta)
        row = draft.draw(efficiency_held, "η_c", mesh, why=_JOINED)
        for k in range(meshes - 2):
            lost, row = (
                (*lost, row),
                draft.draw(efficiency_of_more, f"η_c{'′' * (k + 1)}", row, mesh),
            )
        op = torque_joined_back if chain > 0 else torque_joined_on
        lost = (*lost, row)
        both = draft.draw(op, f"{mark}_0", *own, row, unit="N·m")
    else:
        both = draft.draw(torque_joined, f"{mark}_0", *own, unit="N·m")
    rates = made.rates.values
    if not inside:
        torques["0"] = both
        share = draft.draw(train_efficiency, "η", both, rates[joint], torques[first], rates[first])
        return lost, torques, share
    trial, driven = [*torques.values(), both], made.motion.driven
    due = draft.take(Number, "M_0", given, "N·m")
    torques = {
        name: draft.draw(torque_in_proportion, f"M_{name}", one, due, both, unit="N·m")
        for name, one in torques.items()
    }
    torques["0"] = due
    share = draft.draw(train_efficiency, "η", torques[driven], rates[driven], due, rates[joint])
    return (*lost, *trial), torques, share


def closed_flows(train: Train, motion: Motion, eta: float, meshes: int) -> tuple[int, int]:
    """Return how power flows in a closed differential: as `mesh_flows` of wheel 1, and in wheels that close it.

    These: +1 where they drive the other member through so many ``meshes``. Of the ways that keep
    themselves up with their losses one that gives power out counts.
    """
    assert motion.closing is not None
    joint, other, ratio = motion.closing
    rates, spin = rates_of(train, motion)
    first, last = motion.first, motion.last
    carrier = motion.driving[first] - spin * rates[first]
    held, turn = rates["1"] / rates[last], spin * rates["1"]
    speed = carrier + spin * rates[other]

    def kept(flow: float, chain: float) -> tuple[int, int, bool]:
        back = held * eta ** (2 * flow)
        torques = {"1": 1.0, last: -back, "H": back - 1.0}
        both = torques[joint] + float(ratio) * torques[other] * eta ** (-meshes * chain)
        drives = (both if joint == first else torques[first]) * motion.driving[first]
        signs = (drives * turn, drives * torques[other] * speed)
        one, two = (math.copysign(1.0, sign) if sign else 0.0 for sign in signs)
        out, at = motion.driven, carrier + spin * rates[motion.driven]
        given = (torques[out] if joint == first else both) * at
        return int(one), int(two), drives * given < 0.0

    ways = sorted(
        (way for way in product((1, -1), repeat=2) if kept(*way)[:2] == way),
        key=lambda way: not kept(*way)[2],
    )
    return ways[0] if ways else kept(0.0, 0.0)[:2]


def draw_powers(
    draft: Draft, made: Planetary, torques: Mapping[str, Mark]
) -> tuple[dict[str, Mark], Mark | None]:
    """Calculate the power that comes in on every member of a closed differential; what share circulates."""
    closing, rates = made.motion.closing, made.rates.values
    if closing is None or not torques:
        return {}, None
    powers = {
        name: draft.draw(power, f"N_{name}", torques[name], rates[name], unit="W")
        for name in made.train.scheme.members
    }
    if (first := made.motion.first) == closing.joint:
        powers["0"] = draft.draw(power, "N_0", torques["0"], rates[first], unit="W")
        first = "0"
    own = (powers[closing.joint], powers[closing.other], powers[first])
    return powers, draft.draw(circulating, "ν", *own)
