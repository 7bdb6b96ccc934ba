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
