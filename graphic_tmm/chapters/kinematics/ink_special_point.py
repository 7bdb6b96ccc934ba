"""Special points in ink: the mechanism in one position, the lines of two legs that cross in the point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import (
    ClosingLeg,
    PinLeg,
    SpecialClosing,
    with_plates,
)
from graphic_tmm.chapters.kinematics.ink_positions import PAIR, PositionsInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.special_point import SpecialPoint, drawn_point
from graphic_tmm.chapters.kinematics.task import SPECIAL_POINTS
from graphic_tmm.paper.drawing import Drawing, Ink, Stroke, circle, line
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.labels import Named, lettered
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject

POINT = 0.9
"""The radius of the circle that marks a special point, mm."""
BEYOND = 6.0
"""A line goes on so far behind the special point, mm."""


def draw_special_points(
    on: Subject, reaches: Mapping[Figure, Reach], positions: Positions, index: int
) -> Drawing:
    """Return the mechanism in one position with the special points of its plates."""
    ink = PositionsInk(on.construction, on.reading, reaches, [index])
    traces = figure(ink.seen, Manner(stays=lambda _, step: False))
    strokes: list[Ink] = [*ink.guides(), *ink.heavy(index)]
    letters = ink.letters((ink.frame.name, *ink.names), index, on.heights.point)
    for closing in with_plates(positions.closings, SPECIAL_POINTS):
        special = drawn_point(on.construction, closing)
        at = ink.at(special.point, index)
        strokes += _lines(ink, closing, special, index)
        strokes.append(circle("thin", at, POINT)._replace(of=(special.point.slot,)))
        named = Named(at, markup(special.point.name), (special.point.slot,), index)
        letters += lettered(
            [named, *_normals(ink, closing, special, index)], on.heights.point, PAIR
        )
    return traces.drawing(on, strokes, letters)


def _lines(
    ink: PositionsInk, closing: SpecialClosing, special: SpecialPoint, index: int
) -> Iterator[Stroke]:
    """Yield the lines that cross, from their pins on, and those that join the point to others of its plates."""
    at = ink.at(special.point, index)
    for leg, of in zip(closing.crossing, special.lines, strict=True):
        ends = [ink.at(mark, index) for mark in _ends(closing, leg)]
        far = max(ends, key=lambda z: abs(z - at))
        way = (at - far) / (abs(at - far) or 1.0)
        yield line("thin", far, at + BEYOND * way)._replace(of=(of.slot,))
    for held in special.legs:
        other = closing.point if held.pivot == special.point else held.pivot
        yield line("dashed", at, ink.at(other, index))._replace(of=(held.line.slot,))


def _normals(
    ink: PositionsInk, closing: SpecialClosing, special: SpecialPoint, index: int
) -> Iterator[Named]:
    """Yield the letters of normals to guides, beyond the pin or beyond the point, where equations name them."""
    at = ink.at(special.point, index)
    for leg, of in zip(closing.crossing, special.lines, strict=True):
        if not isinstance(leg, PinLeg):
            spot = (at + ink.at(closing.pin(leg), index)) / 2.0
            yield Named(spot, markup(of.name.strip("()")), (of.slot,), index)


def _ends(closing: SpecialClosing, leg: ClosingLeg) -> Sequence[Mark]:
    """Return the marks of a leg's line: its pivot and pin, or the pin that slides."""
    pin = closing.pin(leg)
    return [leg.pivot, pin] if isinstance(leg, PinLeg) else [pin]
