"""What the follower of a cam given by arcs does step by step: it is on one arc after the other."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.geometry import degrees
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Line, Number, Point
from graphic_tmm.language.said import said

_TOGETHER = said("The follower is on one arc at a time; here they are put together.")


@operation(why=_TOGETHER)
def on_arc(first: Point, second: Point, at: Number) -> Point:
    """Where the follower is on the arc of {first} take that, else {second}; this is {it}."""
    return Point(np.where(at > 0, first, second))


@operation(why=_TOGETHER)
def line_on_arc(first: Line, second: Line, at: Number) -> Line:
    """Where the follower is on the arc of the line {first} take that, else {second}; this is {it}."""
    chosen = at > 0
    return Line(np.where(chosen, first.at, second.at), np.where(chosen, first.along, second.along))


@operation(why=said("The follower is on one arc at a time: what is drawn for an arc holds there."))
def while_on(of: Point, at: Number) -> Point:
    """In the positions in which the follower is on the arc take {of}; this is {it}."""
    return Point(of * np.where(at > 0, 1.0, np.nan))


@operation(
    why=said(
        "Between both places the follower moves: it is at its lowest at the first and at the second."
    )
)
def turn_between(first: Line, second: Line, *, sense: int) -> Angle:
    """Measure the angle {it} from {first} to {second}.

    ``sense``: 1 if it counts counter-clockwise, −1 clockwise; 0 … 360°.
    """
    return Angle(np.mod(sense * degrees(second.along * np.conj(first.along)), 360.0))
