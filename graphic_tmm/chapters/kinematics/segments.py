"""The vectors of a plan, and what each is called by the letters at its ends: one name on sheet and in table."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
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


def component(draft: Draft, segment: Mark, part: str, *images: str) -> None:
    """Tell which component of an acceleration a segment is: normal, tangential, Coriolis (k), relative (r).

    ``images``: the letters of the point that it is of, and of the one it is about.
    """
    draft.figure(roles.COMPONENT, f"a_{{{''.join(images).upper()}}}^{{{part}}}", segment)
