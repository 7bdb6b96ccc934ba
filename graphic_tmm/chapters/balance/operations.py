"""Formulas of balance: what counterweights take away of the shaking force."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Number
from graphic_tmm.language.said import said


@formula(
    holds="{before} ≠ 0",
    fails="without counterweights nothing shakes: there is nothing to take away",
    why=said(
        "What the counterweights take away is told as a share of what there was without them."
    ),
)
def removed_percent(before: Number, after: Number) -> Number:
    """100·({before} − {after})/{before}"""


@formula(
    holds="{length} ≠ 0",
    fails="both pins of the link stand in one place",
    why=said(
        "Two masses at the pins replace that of the link: their sum is the same, and their common centre "
        "stands where it did, so each is to the whole as the distance of the other pin from it is to the link."
    ),
)
def at_pin(mass: Number, far: Number, length: Number) -> Number:
    """{mass}·{far}/{length}"""


@formula(
    why=said(
        "Of the masses that slide a counterweight on the crank answers this share: along the guide the force "
        "gets less, across it as much comes in."
    )
)
def answered(mass: Number, share: Number) -> Number:
    """{share}·{mass}"""


@formula(
    why=said(
        "What shakes is not the mass alone: it is the static moment, the mass times its distance from the "
        "pivot."
    )
)
def static_moment(mass: Number, radius: Number) -> Number:
    """{mass}·{radius}"""


@formula(
    holds="{radius} ≠ 0",
    fails="a counterweight at the pivot balances nothing",
    why=said("The static moment that is missing, at the radius that is given: the mass follows."),
)
def mass_at(moment: Number, radius: Number) -> Number:
    """{moment}/{radius}"""


@formula(
    holds="{mass} ≠ 0",
    fails="a counterweight without mass balances nothing",
    why=said("The static moment that is missing, with the mass that is given: the radius follows."),
)
def radius_of(moment: Number, mass: Number) -> Number:
    """{moment}/{mass}"""
