"""Diagrams on two axes of their own in ink: the energy–mass diagram with its rays, the motor, one crossing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.instruments import join, lay_off
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Curve
from graphic_tmm.paper.drawing import Drawing, Wanted
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.graph import names_beside
from graphic_tmm.paper.graph_rules import DOT, OVER, axis, ruled
from graphic_tmm.paper.mark_rules import dotted, leaving
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.shapes import flat

NEAR = 2.5
"""A point nearer than this to one that is named, mm, has no name of its own."""


class Spot(NamedTuple):
    """A point that is lettered: its mark, the position at which it is drawn, its name."""

    mark: Mark
    place: int
    name: str


class Diagram(NamedTuple):
    """What stands on two axes: the lines of these, curves with their names, points, rays that stay."""

    view: str
    along: Mark
    up: Mark
    curves: Sequence[tuple[Mark, str]]
    spots: Sequence[Spot]
    rays: Sequence[Mark] = ()


def draw_diagram(on: Subject, of: Diagram, count: int, axes: tuple[str, str]) -> Drawing:
    """Return a diagram; ``axes``: what ordinates and base are called; ``count``: of the positions."""
    seen = on.seen((of.view,), range(count))
    places = [seen.point(spot.mark, spot.place) for spot in of.spots]
    curves = [
        [z for run in bezier(seen.reading[mark]) for z in flat([complex(one) for one in run])]
        for mark, _ in of.curves
    ]
    reach = [z for z in [0j, *places, *(z for one in curves for z in one)] if finite(z)]
    high, low = max(z.imag for z in reach), min(z.imag for z in reach)
    right = max(z.real for z in reach)
    marks = {
        of.along: leaving(*axis(0j, complex(right + OVER, 0))),
        of.up: leaving(*axis(1j * low, 1j * (high + OVER))),
    }
    kept = {*marks, *(mark for mark, _ in of.curves), *(spot.mark for spot in of.spots), *of.rays}

    def stays(seen: Seen, step: Step) -> bool:
        if step.op is lay_off or step.it.kind is Curve:
            return step.it in kept
        return step.it in kept or usual(seen, step)

    traces = figure(seen, Manner({join.name: ruled, lay_off.name: dotted(DOT)}, stays, marks))
    large, small = on.heights.point, on.heights.number
    wanted = [
        Wanted(axes[0], complex(0, high + OVER), large, 1.5, -1 + 0j),
        Wanted(axes[1], complex(right + OVER, 0), large, 1.5, -1j),
    ]
    named: list[complex] = []
    for spot, place in zip(of.spots, places, strict=True):
        if finite(place) and all(abs(place - other) > NEAR for other in named):
            named.append(place)
            toward = place / abs(place) if abs(place) else 1j
            wanted.append(
                Wanted(spot.name, place, small, 0.8, toward, (spot.mark.slot,), spot.place)
            )
    lines = {
        mark: (tuple(line),)
        for (mark, name), line in zip(of.curves, curves, strict=True)
        if name and line
    }
    wanted += names_beside(lines, dict(of.curves), small)
    return traces.drawing(on, [*traces.staying], wanted)
