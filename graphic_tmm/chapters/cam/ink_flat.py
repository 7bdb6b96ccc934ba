"""The condition of convexity of a cam with a flat face, in ink: S over d²S/dφ² and the line at 45°."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.cam.centre import VIEW, Convexity
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_rules import (
    OVER,
    POINT,
    CamInk,
    arrow_axis,
    numbered,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, arc, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.mark_rules import curve, reached, straight
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import dimension

LEAST = 0.3
"""What is shorter has no dimension, mm."""
BEYOND = 14.0
"""How far the line at 45° goes on behind its ends, mm."""
ANGLE = 14.0
"""Radius of the arc that shows the 45°, mm."""
ASIDE, APART = 12.0, 9.0
"""From the axis to the dimension of a radius, between two of them, mm."""


def draw_convexity_ink(on: Subject, cam: Cam, names: CentreNames) -> Drawing:
    """Return S over d²S/dφ² with the line at 45° that touches it from below, and the radii cut off."""
    made = cam.centre
    assert isinstance(made, Convexity)
    ink = _Convexity(CamInk(on, cam, VIEW), made)
    traces = figure(ink.on, showing(_rules(ink)))
    radii = list(_dimensions(ink, names))
    strokes = [*traces.staying, *added(_axes(ink), "axis"), *_bodies(ink)]
    strokes += [stroke for found, _ in radii for stroke in found]
    labels = [label for _, label in radii]
    positions = enumerate(names.positions)
    return traces.drawing(on, strokes, _letters(ink, names), labels, positions)


class _Convexity:
    """The places of the diagram, mm; ``centre`` of the cam, as far below the origin as r0 is long."""

    def __init__(self, on: CamInk, made: Convexity) -> None:
        self.on, self.made = on, made
        self.spots = np.full(len(on.positions), np.nan + np.nan * 1j)
        for mark, (_, first, last) in zip(made.points, on.cam.diagrams.stretches, strict=True):
            part, own = slice(first, last + 1), on.all(mark)
            there = np.isfinite(self.spots[part])
            self.spots[part] = np.where(there, self.spots[part], own[part])
        self.left = float(np.nanmin(self.spots.real))
        self.right = float(np.nanmax(self.spots.real))
        self.top = float(np.nanmax(self.spots.imag))
        self.cut = on.fixed_place(made.cut)
        self.low = min(0.0, self.cut.imag) - OVER
        self.centre = complex(0, -on.fixed_number(made.radius))
        self.least = -1j * on.fixed_number(made.least) / on.fixed_number(made.mu)


def _rules(ink: _Convexity) -> dict[Mark, Rule]:
    """What stays of the steps: the curves with what was laid off to them, the line at 45°, where it cuts."""
    made, rules = ink.made, dict[Mark, Rule]()
    for mark, own, (_, first, last) in zip(
        made.points, made.curves, ink.on.cam.diagrams.stretches, strict=True
    ):
        rules |= {mark: _within(first, last), own: curve()}
    if finite(ink.cut):
        spot, way = ink.on.line(made.limit, 0)
        rules[made.limit] = straight("main", spot - BEYOND * way, ink.cut + BEYOND * way)
    return rules


def _within(first: int, last: int) -> Rule:
    """Return the rule of a point that is laid off from the axis in the positions of a stretch."""
    rule = reached(POINT)

    def laid(seen: Seen, step: Step, k: int) -> Iterable[Ink]:
        return rule(seen, step, k) if first <= k <= last else ()

    return laid


def _axes(ink: _Convexity) -> Iterator[Ink]:
    yield from arrow_axis(complex(ink.left - OVER), complex(ink.right + OVER))
    yield from arrow_axis(complex(0, ink.low), complex(0, ink.top + OVER))


def _bodies(ink: _Convexity) -> Iterator[Ink]:
    """The jumps between the stretches, the 45°, the point cut off, the centre of the cam."""
    made = ink.made
    for jump in ink.on.figures("outline"):
        a, b = (ink.on.fixed_place(mark) for mark in jump.marks)
        yield from body(segment("main", a, b), "curve", jump.marks)
    if not finite(ink.cut):
        return
    yield from body([arc("thin", ink.cut, ANGLE, 90.0, 45.0)], "dimension", [made.limit, made.cut])
    yield from body([circle("main", ink.cut, 0.7, filled=True)], "point", [made.cut])
    line_ = line("centre", complex(0, ink.low), ink.centre - 6j)
    yield from body([line_], "axis", [made.radius])
    yield from body([circle("joint", ink.centre, 1.2)], "pivot", [made.radius])


def _dimensions(ink: _Convexity, names: CentreNames) -> Iterator[tuple[tuple[Ink, ...], Label]]:
    """The dimensions of r0 and of the least radius."""
    made = ink.made
    for mark, end, text, offset in (
        (made.radius, ink.centre, names.r0, -(ASIDE + APART)),
        (made.least, ink.least, names.least, -ASIDE),
    ):
        if finite(ink.cut, end) and abs(end) > LEAST:
            size = dimension(end, 0j, offset, text, ink.on.heights.number)
            strokes = tuple(body(size.strokes, "dimension", [mark]))
            yield strokes, size.label._replace(of=(mark.slot,))


def _letters(ink: _Convexity, names: CentreNames) -> Iterator[Wanted]:
    made, point, small = ink.made, ink.on.heights.point, ink.on.heights.number
    yield Wanted(names.up, complex(0, ink.top + OVER), point, 1.5, 1 + 0j)
    yield Wanted(names.out, complex(ink.right + OVER), point, 1.5, -1j)
    if finite(ink.cut):
        way = -0.38 + 0.92j
        yield Wanted(
            "45°", ink.cut + ANGLE * way, small, 0.5, way, (made.limit.slot, made.cut.slot)
        )
        yield Wanted("O", ink.centre, point, 1.8, 1 + 0j, (made.radius.slot,))
    for mark, (_, first, last) in zip(made.points, ink.on.cam.diagrams.stretches, strict=True):
        row = np.arange(len(ink.spots))
        own = np.where((row >= first) & (row <= last), ink.on.all(mark), np.nan)
        toward = own - 0.5j * ink.top
        yield from numbered(ink.on, names.positions, mark, own, toward)
