"""What the operations of a gear pair leave on paper, and how its drawings ink single marks."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.gears.rolling import along_arc, angle_at, measure_arc, smooth_through
from graphic_tmm.paper.drawing import Bezier, Ink, arc, circle
from graphic_tmm.paper.rules import laid_off
from graphic_tmm.paper.seen import Rule, Seen, finite

TRACELESS = frozenset({measure_arc.name, angle_at.name})
"""Operations that leave no trace: what is measured with dividers along an arc, or with the protractor."""


def stepped_off(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The part of the arc along which dividers stepped off a length."""
    start, end = seen.point(step.uses[0], k), seen.point(step.it, k)
    centre, radius = seen.arc(step.uses[1], k)
    if finite(start, end) and abs(end - start) > 1e-9:
        sense = 1 if seen.number(step.uses[2], k) * step.choice["sense"] > 0.0 else -1
        turn = math.degrees(cmath.phase((end - centre) / (start - centre)))
        if turn * sense < 0.0:
            turn += 360.0 * sense
        yield arc("thin", centre, radius, math.degrees(cmath.phase(start - centre)), turn)


def thin_curve(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A curve through points, before what is needed of it is drawn over."""
    for controls in bezier(seen.reading[step.it]):
        yield Bezier("thin", tuple(complex(z) for z in controls), step.it.name)


def dotted(radius: float) -> Rule:
    """Return the rule of a point that is shown."""

    def dot(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        spot = seen.point(step.it, k)
        if finite(spot):
            yield circle("main", spot, radius, filled=True)

    return dot


def reached(radius: float) -> Rule:
    """Return the rule of a point to which a length was laid off from where its line begins: both are shown."""
    dot = dotted(radius)

    def laid(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from laid_off(seen, step, k)
        yield from dot(seen, step, k)

    return laid


RULES: Mapping[str, Rule] = {along_arc.name: stepped_off, smooth_through.name: thin_curve}
"""By operation."""
