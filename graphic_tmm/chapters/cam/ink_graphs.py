"""What the operations of a cam leave on its diagrams: the semicircles of the laws, and their division."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from graphic_tmm.board.operations.instruments import strike
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.cam import law_formulas as law
from graphic_tmm.chapters.cam.operations import divide_semicircle
from graphic_tmm.paper.drawing import Ink, arc, circle, line
from graphic_tmm.paper.graph_rules import DOT
from graphic_tmm.paper.rules import struck_arc
from graphic_tmm.paper.seen import Rule, Seen, finite

TRACELESS = frozenset({"in_turn"})
"""Operations of a cam that leave no trace on a diagram: what only chooses between two lengths."""


def semicircle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The semicircle that is divided, with its diameter; of one that is halved, the half that is used."""
    division = next((s for s in seen.uses.get(step.it, ()) if s.op is divide_semicircle), None)
    if division is None:
        yield from struck_arc(seen, step, k)
        return
    centre, radius = seen.arc(step.it, k)
    _, way = seen.line(division.uses[1], k)
    if not finite(centre, radius, way):
        return
    sense, by = division.choice["sense"], seen.by_mark[division.uses[2]].op
    start = math.degrees(cmath.phase(way))
    if by is law.half_around_outer:
        yield arc("thin", centre, radius, start, 90.0 * sense)
        return
    start -= 90.0 * sense if by is law.around_outer else 0.0
    yield arc("thin", centre, radius, start, 180.0 * sense)
    end = centre + cmath.rect(radius, math.radians(start))
    yield line("thin", end, 2 * centre - end)


def divided(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A point of the division."""
    if finite(seen.point(step.it, k)):
        yield circle("thin", seen.point(step.it, k), DOT)


RULES: Mapping[str, Rule] = {strike.name: semicircle, divide_semicircle.name: divided}
"""By operation."""
