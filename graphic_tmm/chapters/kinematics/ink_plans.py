"""Plans of velocities and accelerations in ink, each position by itself or all from a common pole.

A vector is what was measured between two points or laid off as a calculated length; a line in which two loci
met goes a little on behind the point. Images that coincide share one label, a vector of no length has no
arrow.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import lay_off, measure, measure_along, meet
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, line
from graphic_tmm.paper.labels import Wanted, interrupt, leaders, place
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.symbols.arrows import told_arrow
from graphic_tmm.paper.symbols.kinematic import pole

BEYOND = 4.0
"""How far a construction line goes on behind the intersection, mm."""
SHORTEST = 0.01
"""A vector below this share of the longest of its plan is a point, and so is one below half a millimetre."""
TOGETHER = 0.35
"""Points nearer than this, mm, share one label."""
SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SMALL = 2.5
"""Letters of a plan, and of one whose positions share a pole, mm."""
MARGIN = 7.0
"""Room that letters and overrunning lines take about a plan, mm."""


class Vector(NamedTuple):
    """A vector of a plan: its two marks and the segment's letter; ``absolute`` if it starts at the pole."""

    start: Mark
    end: Mark
    segment: str
    absolute: bool


def vectors(construction: Construction, plan: str) -> tuple[Vector, ...]:
    """Return the vectors of a plan in the order in which they were drawn or measured."""
    view = construction.view(plan)
    assert view is not None
    by_mark = {step.it: step for step in construction.steps}
    found: dict[tuple[Mark, Mark], Vector] = {}
    for step in construction.steps:
        if step.it.view != plan:
            continue
        ends = _ends(step, by_mark)
        if ends is not None:
            start, end, segment = ends
            found.setdefault((start, end), Vector(start, end, segment, start == view.pole))
    return tuple(found.values())


def _ends(step: Step, by_mark: dict[Mark, Step]) -> tuple[Mark, Mark, str] | None:
    if step.op in (measure, measure_along):
        return step.uses[0], step.uses[1], step.it.name
    if step.op is lay_off:
        drawn = by_mark[step.uses[0]]
        return drawn.uses[0], step.it, step.uses[1].name
    return None


class Place(NamedTuple):
    """A position of a plan: its index in the reading, and the number that its letters bear ("" for none)."""

    at: int
    number: str = ""


def draw_plan(
    construction: Construction,
    reading: Reading,
    plan: str,
    places: Sequence[Place],
    name: str,
    title: str,
    mu: float,
    unit: str,
    *,
    lettered: bool = True,
    upon: Sequence[Stroke] = (),
) -> Drawing:
    """Return a plan in one position, or in several from a common pole: vectors with arrows, lines, letters.

    From a common pole the vectors between images are thin and construction lines are left out. ``mu``
    (SI per mm) and ``unit`` are told to a page that reads the sheet. ``upon``: what is drawn over the plan;
    letters stay clear of it.
    """
    view = construction.view(plan)
    assert view is not None
    assert view.pole is not None
    common = len(places) > 1
    seen = [(place, _Places(reading, place.at)) for place in places]
    drawn = [
        (at, v)
        for _, at in seen
        for v in vectors(construction, plan)
        if at.there(v.start) and at.there(v.end)
    ]
    longest = max((abs(at[v.end] - at[v.start]) for at, v in drawn), default=0.0)
    least = max(SHORTEST * longest, 0.5)
    strokes: list[Stroke | Bezier] = []
    if not common:
        strokes += [line("thin", *ends) for ends in _beyond(construction, plan, seen[0][1], least)]
    for at, vector in drawn:
        a, b = at[vector.start], at[vector.end]
        if abs(b - a) >= least:
            strokes += _vector(vector, a, b, mu, unit, thin=common)
    at = seen[0][1]
    strokes += [*pole(at[view.pole]), *upon]
    if not lettered:
        spots = [there[v.end] for there, v in drawn] + [at[view.pole]]
        x, y = [z.real for z in spots], [z.imag for z in spots]
        m = MARGIN
        return Drawing(name, title, cell=(min(x) - m, min(y) - m, max(x) + m, max(y) + m))
    wanted = list(_letters(construction, plan, seen, view.pole))
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def _vector(
    vector: Vector, a: complex, b: complex, mu: float, unit: str, *, thin: bool
) -> list[Stroke]:
    pen = ("medium" if thin else "main") if vector.absolute else ("thin" if thin else "medium")
    return told_arrow(a, b, pen, vector.segment, mu, unit)


def _beyond(
    construction: Construction, plan: str, at: _Places, least: float
) -> Iterator[tuple[complex, complex]]:
    """Yield the construction lines: from where each began to a little behind where it met the other."""
    by_mark = {step.it: step for step in construction.steps}
    for step in construction.steps:
        if step.it.view != plan or step.op is not meet or not at.there(step.it):
            continue
        end = at[step.it]
        for drawn in (by_mark[mark] for mark in step.uses):
            start = at[drawn.uses[0]] if at.there(drawn.uses[0]) else end
            if abs(end - start) >= least:
                yield start, end + (end - start) / abs(end - start) * BEYOND


class _Places:
    """The points of one position."""

    def __init__(self, reading: Reading, index: int) -> None:
        self.reading, self.index = reading, index

    def __getitem__(self, mark: Mark) -> complex:
        row = self.reading[mark][0]
        return complex(row[self.index if row.size > 1 else 0])

    def there(self, mark: Mark) -> bool:
        """Whether the point can be drawn."""
        return bool(np.isfinite(self[mark]))


def _letters(
    construction: Construction, plan: str, seen: Sequence[tuple[Place, _Places]], pole_mark: Mark
) -> Iterator[Wanted]:
    steps = [s.it for s in construction.steps if s.it.view == plan and s.it.kind is Point]
    spots = [(seen[0][1][pole_mark], markup(pole_mark.name))]
    for stood, at in seen:
        spots += [(at[m], markup(m.name, stood.number)) for m in steps if at.there(m)]
    common = len(seen) > 1
    middle = spots[0][0] if common else complex(np.mean([spot for spot, _ in spots]))
    groups: list[tuple[complex, list[str]]] = []
    for k, (spot, text) in enumerate(spots):
        if common and k and abs(spot - middle) < TOGETHER:
            continue  # an image without velocity lies in the pole
        near = next((names for place_at, names in groups if abs(place_at - spot) < TOGETHER), None)
        if near is None:
            groups.append((spot, [text]))
        else:
            near.append(text)
    for spot, names in groups:
        yield Wanted(", ".join(names), spot, SMALL if common else SIZE, 1.0, spot - middle)
