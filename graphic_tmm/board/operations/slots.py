"""The plate on tracing paper, where guides of its own pass by points that stand already.

A stone about such a point slides along the guide, or the plate through it: from the point to the guide it is
always as far. So the guide is one more locus, drawn on the tracing paper and not on the board.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.geometry import cis, vector, wedge
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.operations.tracing import (
    Fit,
    TracedPlate,
    arc_fit,
    corrected,
    first_pin,
    line_fit,
    pricked_plate,
)
from graphic_tmm.board.values import Angle, Arc, Complexes, Length, Line, Point, Reals
from graphic_tmm.language.said import said

_FAILS = (
    "the plate cannot be laid on the loci of its points with its guides where they have to pass"
)
_SYMBOL = "3P1 + 3P2 + 4R1 + 2R2"
_WHY = said(
    "What slides along a guide of the plate turns about a point that stands already, so the guide passes "
    "it at one distance; of the places where all fits at once it is that next to the position before."
)


class Slot(NamedTuple):
    """A guide of a plate that passes a point.

    ``way``: its direction in the plate's own axes; ``height``: how far the point is to the left of the line
    that goes that way through the plate's first point.
    """

    way: Complexes
    height: Reals


def slot_fit(pivot: Point, slot: Slot, b: Complexes, lies: Line) -> Fit:
    """Return how a guide of a plate, whose first point is at ``b``, passes a point."""
    way, far = slot.way * lies.along, pivot - b
    return Fit(
        far * np.conj(lies.along), slot.height - wedge(way, far), way * 1j, np.abs(slot.height), 0.0
    )


def _on_slot(
    lies: Line, first: Arc, second: Arc, third: Point, c: Complexes, slot: Slot
) -> TracedPlate:
    """Return a plate as it lies, two of its points on arcs, its guide at a point."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, arc_fit(second, c, b, lies), slot_fit(third, slot, b, lies)
    )


def _on_guide_and_slot(
    lies: Line, first: Arc, second: Line, third: Point, c: Complexes, slot: Slot
) -> TracedPlate:
    """Return a plate as it lies, a point on an arc, one on a guide, its own guide at a point."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, line_fit(second, c, b, lies), slot_fit(third, slot, b, lies)
    )


def _on_slots(
    lies: Line, first: Arc, second: Point, third: Point, one: Slot, two: Slot
) -> TracedPlate:
    """Return a plate as it lies, a point on an arc, two guides of its own at points."""
    b = first_pin(first, lies)
    return TracedPlate(
        lies, first.radius, b, slot_fit(second, one, b, lies), slot_fit(third, two, b, lies)
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace_past(
    first: Arc,
    second: Arc,
    third: Point,
    apart: Length,
    h: Length,
    bend: Angle,
    leg: Angle,
    plate: Angle,
) -> Line:
    """Lay a tracing of the plate ({apart}) on {first} and {second}, guide ({bend}; {h}) at {third}; prick {it}.

    ``apart``: its second point from the first along its line; ``bend``: the angle from that to the guide;
    ``h``: how far ``third`` is to the left of a parallel to the guide through the first point.
    """
    c, slot = vector(apart, 0.0 * apart), Slot(cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = corrected(_on_slot(near, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_slot(lies, first, second, third, c, slot))
    return pricked_plate(
        _on_slot(lies, first, second, third, c, slot), _on_slot(near, first, second, third, c, slot)
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace_on_guide_past(
    first: Arc,
    second: Line,
    third: Point,
    apart: Length,
    h: Length,
    bend: Angle,
    leg: Angle,
    plate: Angle,
) -> Line:
    """Lay a tracing of the plate ({apart}) on {first} and {second}, guide ({bend}; {h}) at {third}; prick {it}.

    ``apart``: its second point from the first along its line; ``bend``: the angle from that to the guide;
    ``h``: how far ``third`` is to the left of a parallel to the guide through the first point.
    """
    c, slot = vector(apart, 0.0 * apart), Slot(cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = corrected(_on_guide_and_slot(near, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    lies = corrected(_on_guide_and_slot(lies, first, second, third, c, slot))
    return pricked_plate(
        _on_guide_and_slot(lies, first, second, third, c, slot),
        _on_guide_and_slot(near, first, second, third, c, slot),
    )


@operation(symbol=_SYMBOL, fails=_FAILS, why=_WHY)
def trace_past_both(
    first: Arc,
    second: Point,
    third: Point,
    apart: Length,
    h: Length,
    bend: Angle,
    leg: Angle,
    plate: Angle,
) -> Line:
    """Lay a tracing of it on {first}, guides ({apart}) at {second} and ({bend}; {h}) at {third}; prick {it}.

    The plate's line goes through its first point along its first guide; ``bend``: the angle from that to the
    second; ``apart``, ``h``: how far the points are to the left of parallels to the guides through the first.
    """
    one, two = Slot(cis(0.0 * bend), apart), Slot(cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = corrected(_on_slots(near, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    lies = corrected(_on_slots(lies, first, second, third, one, two))
    return pricked_plate(
        _on_slots(lies, first, second, third, one, two),
        _on_slots(near, first, second, third, one, two),
    )
