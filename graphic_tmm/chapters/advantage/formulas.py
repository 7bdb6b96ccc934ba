"""Formulas of forces by centres: loads at what drives, by arms and ratios; mechanical advantages."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length, Number
from graphic_tmm.language.said import said

_STANDS = "the load does not move: nothing at the drive balances it"


@formula(
    holds="{first} ≠ 0",
    fails="what drives stands",
    why=said("How fast the link turns while what drives goes by one unit."),
)
def rate_per_drive(omega: Number, first: Number) -> Number:
    """{omega}/{first}"""


@formula(
    why=said(
        "The link turns about its centre: the power of the force is its moment about that centre times ω of "
        "the link. At what drives the same power is this much."
    ),
)
def load_at_drive(force: Number, arm_: Length, mu: Number, ratio: Number) -> Number:
    """{force}·{arm_}·{mu}·{ratio}"""


@formula(
    why=said(
        "The power of a couple is its moment times ω of the link; at what drives it is this much."
    ),
)
def couple_at_drive(couple: Number, ratio: Number) -> Number:
    """{couple}·{ratio}"""


@formula(
    holds="{arm_}·{ratio} ≠ 0",
    fails=_STANDS,
    why=said(
        "The powers of all forces come to 0: the unknown force has that of all others, reversed, by its own "
        "arm and ratio."
    ),
)
def unknown_by_centres(total: Number, arm_: Length, mu: Number, ratio: Number) -> Number:
    """−{total}/({arm_}·{mu}·{ratio})"""


@formula(
    holds="{arm_}·{ratio} ≠ 0",
    fails=_STANDS,
    why=said(
        "Without losses both powers are equal: the forces are inversely as the velocities, ω times the radius, "
        "of the points where they act."
    ),
)
def advantage_of_pin(radius: Length, arm_: Length, ratio: Number) -> Number:
    """{radius}/|{arm_}·{ratio}|"""


@formula(
    holds="{arm_}·{ratio} ≠ 0",
    fails=_STANDS,
    why=said(
        "Without losses both powers are equal: the forces are inversely as the velocities of the points where "
        "they act."
    ),
)
def advantage_of_slide(arm_: Length, mu: Number, ratio: Number) -> Number:
    """1/|{arm_}·{mu}·{ratio}|"""


@formula(
    holds="{ratio} ≠ 0",
    fails=_STANDS,
    why=said(
        "Without losses both powers are equal: the moments are inversely as ω of their links."
    ),
)
def advantage_of_moment(ratio: Number) -> Number:
    """1/|{ratio}|"""
