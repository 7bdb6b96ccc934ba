"""Velocities added up in ink: what each drive gives a point, end to end, and the velocity that comes of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board.record import Step
from graphic_tmm.chapters.kinematics.by_drive import Summed, added_vector
from graphic_tmm.chapters.kinematics.ink_plans import CLOSE
from graphic_tmm.chapters.kinematics.task import BY_DRIVE
from graphic_tmm.paper.drawing import Drawing, Ink
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import pole

LEAST = 0.5
"""A part that is shorter, mm, is none: where one drive alone moves a point there is nothing to add."""


def draw_sums_ink(on: Subject, summed: Sequence[Summed], index: int) -> Drawing:
    """Return the sums of one position: parts thin, end to end, what they come to thick from the pole."""
    seen = on.seen((BY_DRIVE,), [index])
    shown = [one for one in summed if _adds(seen, one, index)]
    parts = {end: start for one in shown for start, end in one.parts}
    sums = {one.ends[-1]: one.pole for one in shown}

    def part(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        for pen, starts in (("thin", parts), ("main", sums)):
            if step.it in starts:
                yield from arrow(seen.point(starts[step.it], k), seen.point(step.it, k), pen)

    traces = figure(seen, Manner({added_vector.name: part}, lambda seen, step: step.it in parts))
    origin = summed[0].pole
    spot = seen.point(origin, index)
    strokes = body(pole(spot), "pole", [origin])
    marks = [origin, *parts]
    named = [Named(seen.point(m, index), markup(m.name), (m.slot,), index) for m in marks]
    wanted = lettered(shared(named, CLOSE), on.heights.point, away_from=spot)
    return traces.drawing(on, (*traces.staying, *strokes), wanted)._replace(position=index)


def _adds(seen: Seen, one: Summed, k: int) -> bool:
    """Whether several drives move a point."""
    ends = [[seen.point(mark, k) for mark in part] for part in one.parts]
    return all(finite(a, b) and abs(b - a) >= LEAST for a, b in ends)
