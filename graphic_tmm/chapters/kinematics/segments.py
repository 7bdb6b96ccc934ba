"""The vectors of a plan, and what each is called by the letters at its ends: one name on sheet and in table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import lay_off, measure, measure_along
from graphic_tmm.board.record import Construction, Mark, Step


class Vector(NamedTuple):
    """A vector of a plan: its two marks and the segment's letter; ``absolute`` if it starts at the pole.

    ``step``: the one that drew or measured it first.
    """

    start: Mark
    end: Mark
    segment: str
    absolute: bool
    step: Step


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
            found.setdefault((start, end), Vector(start, end, segment, start == view.pole, step))
    return tuple(found.values())


def _ends(step: Step, by_mark: dict[Mark, Step]) -> tuple[Mark, Mark, str] | None:
    if step.op in (measure, measure_along):
        return step.uses[0], step.uses[1], step.it.name
    if step.op is lay_off:
        drawn = by_mark[step.uses[0]]
        return drawn.uses[0], step.it, step.uses[1].name
    return None


def end_letters(construction: Construction, plan: str) -> Mapping[Mark, str]:
    """Return what lengths of a plan are called by the points between which they lie, first end first.

    A component that is calculated or read (n_{ab}) is so a segment of the plan like any other: n₂b.
    """
    found = {}
    for one in vectors(construction, plan):
        length = one.step.uses[1] if one.step.op is lay_off else one.step.it
        found[length] = f"{one.start.name}{one.end.name}"
    return found
