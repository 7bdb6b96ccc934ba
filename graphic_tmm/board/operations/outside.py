"""Positions outside a row: the drive stands there at a coordinate of its own."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.language.said import said


@operation(
    kept=True,
    why=said(
        "A position outside the row is drawn as those of the row are, only at an angle of its own."
    ),
)
def stand(regular: Angle, extreme: Angle, at: Number) -> Angle:
    """At the position outside the row the crank's angle {it} is {extreme}, at those of the row {regular}."""
    return Angle(np.where(at > 0, extreme, regular))


@operation(
    kept=True,
    why=said(
        "A position outside the row is drawn as those of the row are, only at a length of its own."
    ),
)
def stand_out(regular: Number, extreme: Number, at: Number) -> Number:
    """At the position outside the row {it} is {extreme}, at those of the row {regular}."""
    return Number(np.where(at > 0, extreme, regular))
