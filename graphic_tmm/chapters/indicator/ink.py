"""The indicator diagram in ink: the division of its base on a ray, ordinates, curves, the mean pressures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.indicator.diagram import Indicator
from graphic_tmm.paper.axes import largest, number_rows, position_numbers
from graphic_tmm.paper.drawing import GRAPH, Drawing, Ink, Label, Wanted, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.graph import names_beside
from graphic_tmm.paper.graph_rules import OVER, axis, dot, ends_of, ruled
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.mark_rules import leaving
from graphic_tmm.paper.rules import BEYOND, segment
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.shapes import flat

TOGETHER = 1.0
"""Positions whose feet are nearer than this, mm, share a number."""
CLOSE = 2.0
"""Levels nearer than this, mm, share a name."""


def draw_indicator_ink(
    on: Subject,
    pistons: Mapping[str, Indicator],
    names: Sequence[str],
    axes: tuple[str, str] = ("p", "S"),
    means: Mapping[Mark, str] = MappingProxyType({}),
    curves: Mapping[Mark, str] = MappingProxyType({}),
) -> Drawing:
    """Return the indicator diagram with the division of its base.

    ``pistons``: the diagram as each of them has it, by their letters where they are several. ``names``: of the
    positions of the row; ``axes``: what ordinates and base are called. ``means``: what the
    mean pressures are called, by their marks: each is a level under which as much work is done. ``curves``:
    what the curves of the two sides are called, by their marks.
    """
    made = next(iter(pistons.values()))
    seen, heights = on.seen((made.chart.view,), range(len(names))), on.heights
    high = max(largest(on.reading[side.points].imag) for side in made.sides)
    feet = {letter: _feet(seen, one.feet, names) for letter, one in pistons.items()}
    numbers, low = tuple[Label, ...](), 0.0
    if len(pistons) > 1:
        ends = [on.reading[one.divisions].imag for one in pistons.values()]
        numbers = number_rows(feet, heights.number, -largest(-np.concatenate(ends)))
        low = min((number.at.imag for number in numbers), default=0.0)
    traces = figure(seen, _manner(seen, tuple(pistons.values()), high, low))
    end = seen.point(made.end, 0)
    strokes = [*traces.staying]
    wanted = [
        Wanted(axes[0], complex(0, high + OVER), heights.point, 1.5, -1 + 0j),
        Wanted(axes[1], complex(end.real + OVER, 0), heights.point, 1.5, -1j),
    ]
    levels = []
    for mean, text in means.items():
        level = 1j * seen.number(seen.by_mark[mean].uses[0], 0)
        if finite(level):
            strokes += body([line("dashed", level, end + level)], "mean", [mean])
            levels.append(Named(end + level, text, (mean.slot,)))
    wanted += [
        one._replace(toward=1 + 0j) for one in lettered(shared(levels, CLOSE), heights.number, 0.5)
    ]
    lines = {
        mark: tuple(tuple(flat([complex(z) for z in run])) for run in bezier(on.reading[mark]))
        for mark in curves
    }
    wanted += names_beside(lines, curves, heights.number)
    if not numbers:
        every = [one for row in feet.values() for one in row]
        numbers = position_numbers((), every, strokes, heights.number)
    return traces.drawing(on, strokes, wanted, numbers)._replace(role=GRAPH)


def _feet(seen: Seen, feet: Mark, names: Sequence[str]) -> list[Named]:
    """Return the positions of a piston, those in one place as one."""
    places = (Named(seen.point(feet, k), name, (feet.slot,), k) for k, name in enumerate(names))
    return shared(places, TOGETHER)


def _manner(seen: Seen, pistons: Sequence[Indicator], high: float, low: float) -> Manner:
    """Return how the diagram is inked: axes, the ray that divides the base, ordinates with their points."""
    made = pistons[0]
    end = seen.point(made.end, 0)
    marks: dict[Mark, Rule] = {
        seen.by_mark[made.end].uses[0]: leaving(*axis(0j, end + OVER)),
        seen.by_mark[made.sides[0].ordinate].uses[2]: leaving(*axis(0j, 1j * (high + OVER))),
        seen.by_mark[made.divisions].uses[0]: _ray,
    }
    points = {side.points for one in pistons for side in one.sides}

    def laid(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        spot = seen.point(step.it, k)
        if step.it in points:
            yield from segment("thin", seen.line(step.uses[0], k)[0] + 1j * low, spot)
        yield from dot(spot)

    def stays(seen: Seen, step: Step) -> bool:
        if step.op is lay_off:
            return step.it in points
        return step.it in marks or usual(seen, step)

    by_line: dict[str, Rule] = {s.op.name: ruled for s in seen.steps if s.it.kind is Line}
    return Manner({**by_line, lay_off.name: laid}, stays, marks)


def _ray(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The ray that is divided, and a little more of it."""
    start, far = ends_of(seen, step, k)
    way = far - start
    yield from segment("thin", start, far + BEYOND * way / abs(way) if way else far)
