"""Formulas of a Geneva wheel: the pitch of its slots, the crank that is due, shares and times of its motion."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said


@formula(
    holds="{z} ≠ 0",
    fails="the wheel has no slots",
    why=said(
        "{z} slots divide the wheel evenly; half of a pitch lies on each side of the line of centres."
    ),
)
def half_pitch(z: Number) -> Angle:
    """180°/{z}"""


@formula(why=said("On the other side of the line of centres angles are counted the other way."))
def other_side(half: Angle) -> Angle:
    """−{half}"""


@formula(
    why=said(
        "The pin goes into the slot without a shock where it moves along it: there the crank is square to "
        "the slot."
    )
)
def crank_due(distance: Number, half: Angle) -> Number:
    """{distance}·sin({half})"""


@formula(
    why=said("The slot is deep enough for the pin where this comes nearest to the wheel's centre.")
)
def slot_bottom(distance: Length, crank: Length, pin: Length) -> Length:
    """{distance} − {crank} − {pin}"""


@formula(why=said("A pin is as thick as the slot is wide; drawn it is by its radius."))
def pin_radius(diameter: Number) -> Number:
    """{diameter}/2"""


@formula(why=said("The disc goes free of the pin, and reaches into the hollows of the rim."))
def usual_disc(crank: Number, times: Number, pin: Number) -> Number:
    """{crank} − {times}·{pin}"""


@formula(
    why=said("Each pin turns the wheel while its crank goes through this angle, of a turn of 360°.")
)
def share_of_motion(pins: Number, engaged: Angle) -> Number:
    """{pins}·{engaged}/360°"""


@formula(
    holds="{z} ≠ 0",
    fails="the wheel has no slots",
    why=said("Where crank and slot are square to each other at the entry, 2φ = 180° − 360°/{z}."),
)
def share_by_slots(pins: Number, z: Number) -> Number:
    """{pins}·({z} − 2)/(2·{z})"""


@formula(
    holds="{omega} ≠ 0",
    fails="the crank stands",
    why=said("The crank turns evenly; a pin holds the wheel for this share of a turn."),
)
def time_of_motion(engaged: Angle, omega: Number) -> Number:
    """2π·{engaged}/(360°·{omega})"""


@formula(
    holds="{pins}·{omega} ≠ 0",
    fails="the crank stands",
    why=said("Until the next pin comes the wheel stands, held by the disc."),
)
def time_of_dwell(pins: Number, omega: Number, motion: Number) -> Number:
    """2π/({pins}·{omega}) − {motion}"""


@formula(
    holds="{rest} ≠ 0",
    fails="the pin would reach the wheel's centre",
    why=said(
        "On the line of centres the pin moves square to the slot: the wheel turns fastest, in the ratio of the "
        "distances of the pin from both centres."
    ),
)
def fastest(crank: Length, rest: Length) -> Number:
    """{crank}/{rest}"""
