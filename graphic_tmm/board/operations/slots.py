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
    arc_normal,
    arc_off,
    corrected,
    held,
    line_off,
    pricked,
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
    """A guide of a plate and the point that it passes.

    ``way``: its direction in the plate's own axes; ``height``: how far the point is to the left of the line
    that goes that way through the plate's first point.
    """

    pivot: Point
    way: Complexes
    height: Reals


def slot_arm(slot: Slot, b: Complexes, lies: Line) -> Complexes:
    """Return where the point that the guide passes is, from the plate's first, in the plate's own axes."""
    return (slot.pivot - b) * np.conj(lies.along)


def slot_off(slot: Slot, b: Complexes, lies: Line) -> Reals:
    """Return how far the guide is to the left of where it would pass the point."""
    return slot.height - wedge(slot.way * lies.along, slot.pivot - b)


def slot_normal(slot: Slot, lies: Line) -> Complexes:
    """Return the direction to the left of the guide."""
    return slot.way * lies.along * 1j


def _on_slot(lies: Line, first: Arc, second: Arc, slot: Slot, c: Complexes) -> Line:
    """Return how a plate lies after one correction, two of its points on arcs, its guide at a point."""
    b = first.centre + first.radius * lies.at
    at_c = b + c * lies.along
    off = vector(arc_off(at_c, second), slot_off(slot, b, lies))
    f, normal = slot_arm(slot, b, lies), slot_normal(slot, lies)
    return corrected(lies, first.radius, c, f, off, arc_normal(at_c, second), normal)


def _on_guide_and_slot(lies: Line, first: Arc, second: Line, slot: Slot, c: Complexes) -> Line:
    """Return how a plate lies after one correction, a point on an arc, one on a guide, its own at a point."""
    b = first.centre + first.radius * lies.at
    off = vector(line_off(b + c * lies.along, second), slot_off(slot, b, lies))
    f, normal = slot_arm(slot, b, lies), slot_normal(slot, lies)
    return corrected(lies, first.radius, c, f, off, second.along * 1j, normal)


def _on_slots(lies: Line, first: Arc, second: Slot, third: Slot) -> Line:
    """Return how a plate lies after one correction, a point on an arc, two guides of its own at points."""
    b = first.centre + first.radius * lies.at
    off = vector(slot_off(second, b, lies), slot_off(third, b, lies))
    c, f = slot_arm(second, b, lies), slot_arm(third, b, lies)
    return corrected(
        lies, first.radius, c, f, off, slot_normal(second, lies), slot_normal(third, lies)
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
    c, slot = vector(apart, 0.0 * apart), Slot(third, cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = _on_slot(near, first, second, slot, c)
    lies = _on_slot(lies, first, second, slot, c)
    lies = _on_slot(lies, first, second, slot, c)
    lies = _on_slot(lies, first, second, slot, c)
    lies = _on_slot(lies, first, second, slot, c)
    lies = _on_slot(lies, first, second, slot, c)
    b = first.centre + first.radius * lies.at
    at_c = b + c * lies.along
    off = vector(arc_off(at_c, second), slot_off(slot, b, lies))
    there = held(
        lies, c, slot_arm(slot, b, lies), arc_normal(at_c, second), slot_normal(slot, lies)
    )
    begun = first.centre + first.radius * near.at
    second_normal = arc_normal(begun + c * near.along, second)
    alike = there * held(
        near, c, slot_arm(slot, begun, near), second_normal, slot_normal(slot, near)
    )
    return pricked(b, first.radius + np.abs(c) + np.abs(h), lies, near, off, alike)


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
    c, slot = vector(apart, 0.0 * apart), Slot(third, cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = _on_guide_and_slot(near, first, second, slot, c)
    lies = _on_guide_and_slot(lies, first, second, slot, c)
    lies = _on_guide_and_slot(lies, first, second, slot, c)
    lies = _on_guide_and_slot(lies, first, second, slot, c)
    lies = _on_guide_and_slot(lies, first, second, slot, c)
    lies = _on_guide_and_slot(lies, first, second, slot, c)
    b, way = first.centre + first.radius * lies.at, second.along * 1j
    off = vector(line_off(b + c * lies.along, second), slot_off(slot, b, lies))
    there = held(lies, c, slot_arm(slot, b, lies), way, slot_normal(slot, lies))
    begun = first.centre + first.radius * near.at
    alike = there * held(near, c, slot_arm(slot, begun, near), way, slot_normal(slot, near))
    return pricked(b, first.radius + np.abs(c) + np.abs(h), lies, near, off, alike)


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
    one, two = Slot(second, cis(0.0 * bend), apart), Slot(third, cis(bend), h)
    near = Line(cis(leg), cis(plate))
    lies = _on_slots(near, first, one, two)
    lies = _on_slots(lies, first, one, two)
    lies = _on_slots(lies, first, one, two)
    lies = _on_slots(lies, first, one, two)
    lies = _on_slots(lies, first, one, two)
    lies = _on_slots(lies, first, one, two)
    b = first.centre + first.radius * lies.at
    off = vector(slot_off(one, b, lies), slot_off(two, b, lies))
    there = held(
        lies,
        slot_arm(one, b, lies),
        slot_arm(two, b, lies),
        slot_normal(one, lies),
        slot_normal(two, lies),
    )
    begun = first.centre + first.radius * near.at
    alike = there * held(
        near,
        slot_arm(one, begun, near),
        slot_arm(two, begun, near),
        slot_normal(one, near),
        slot_normal(two, near),
    )
    return pricked(b, first.radius + np.abs(apart) + np.abs(h), lies, near, off, alike)
