"""What hodographs need besides the instruments: a vector carried, a tangent held against a direction."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import degrees
from graphic_tmm.board.grammar import ANGLE, JOIN, SLIDE, operation
from graphic_tmm.board.values import Angle, Curve, Length, Point
from graphic_tmm.language.said import said


@operation(
    symbol=f"{SLIDE} + M1 + R1 + M2",
    why=said("A vector stays what it is when it is carried, parallel and equal, to another pole."),
)
def equal_vector(pole: Point, start: Point, end: Point, length: Length) -> Point:
    """From {pole} lay off {length} parallel to the vector from {start} to {end}; mark {it}."""
    vector = end - start
    size = np.abs(vector)
    there = size > 0.0
    return Point(pole + vector * np.where(there, np.abs(length) / np.where(there, size, 1.0), 0.0))


@operation(
    symbol=f"{JOIN} + {ANGLE}",
    across=True,
    everywhere=True,
    fails="one of the directions is none",
    why=said(
        "The hodograph's tangent has the direction of the acceleration: what is left of the angle is the error "
        "of both plans and of the curve between the ends."
    ),
)
def off_tangent(curve: Curve, end: Point, start: Point, tip: Point, *, row: int) -> Angle:
    """With the protractor measure {it}, by which {start}{tip} turns from the tangent to {curve} at {end}."""
    ways = (tip - start) + 0.0 * end
    tangents = np.full((max(len(ways), len(curve.tangents)), ways.shape[1]), np.nan + 0j)
    tangents[:, :row] = curve.tangents
    turned = ways * np.conj(tangents)
    return Angle(np.where(turned == 0.0, np.nan, degrees(turned)))
