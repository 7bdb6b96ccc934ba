"""How much of a plan with the pivots held is added so that the last link closes."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Length
from graphic_tmm.language.said import said


@formula(
    holds="{parting} ≠ 0",
    fails="the last joining link is square to how its ends part",
    why=said(
        "With the pivots held the ends part by {parting} along the link while this vector is {own}; the gap "
        "{gap} is closed by as many times that."
    ),
)
def closing_part(gap: Length, parting: Length, own: Length) -> Length:
    """−{own}·{gap}/{parting}"""


@formula(
    holds="{parting} ≠ 0",
    fails="the last joining link is square to how its ends part",
    why=said("To what it is with ε = 0 of the first plate is added what closes the gap {gap}."),
)
def with_closing_part(before: Length, gap: Length, parting: Length, own: Length) -> Length:
    """{before} − {own}·{gap}/{parting}"""
