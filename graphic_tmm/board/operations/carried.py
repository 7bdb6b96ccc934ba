"""Points carried over to a figure of another scale."""

from __future__ import annotations

from graphic_tmm.board.grammar import READ, SLIDE, operation
from graphic_tmm.board.values import Number, Point
from graphic_tmm.language.said import said


@operation(
    symbol=f"{READ} + N1 + {SLIDE} + M1 + R1 + M2",
    why=said("The figure has a scale of its own, so that points far off find room."),
)
def carry_over(point: Point, mu_l: Number, mu: Number) -> Point:
    """Carry {point} over to this figure, which has a scale {mu} of its own: mark {it}."""
    return Point(point * (mu_l / mu))
