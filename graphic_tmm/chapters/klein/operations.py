"""What Klein's construction needs besides the instruments: a circle whose opening is taken from the figure."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Arc, Point
from graphic_tmm.language.said import said


@operation(
    symbol="2C1 + C3",
    why=said("The opening is taken from the figure, so it need not be measured."),
)
def circle_through(centre: Point, through: Point) -> Arc:
    """With the compass at {centre} strike the circle {it} through {through}."""
    return Arc(centre, np.abs(through - centre))
