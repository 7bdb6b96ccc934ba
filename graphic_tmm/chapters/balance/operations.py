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
