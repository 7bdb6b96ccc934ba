"""The plans of the replacing linkage in ink: vectors from a common pole in the positions asked for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, Plans, Vectors
from graphic_tmm.paper.drawing import Drawing, Ink
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.symbols.kinematic import pole

SHORTEST = 0.5
"""A shorter vector is a point, mm."""
CLOSE = 2.0
"""Images nearer than this, mm, share one label."""


def draw_plan(on: Subject, view: str, plans: Plans, at: Sequence[int], mu: float) -> Drawing:
    """Return a plan in some positions (indices); ``mu``: m/mm, told to a page that reads the sheet.

    At a change of arcs what belongs to the arc behind it bears a +.
    """
    seen, which = on.seen((view,), at), int(view == ACCELERATIONS)
    traces = figure(seen, showing({}))
    start = plans.poles[which]
    strokes = list(body(pole(seen.fixed_place(start)), "pole", [start]))
    named = [Named(seen.fixed_place(start), start.name, (start.slot,))]
    for k in at:
        name = plans.names[k]
        for one in plans.linkages.values():
            vectors = one.accelerations if which else one.velocities
            if finite(seen.point(vectors.end, k)):
                strokes += _vectors(seen, start, vectors, k, mu)
                named += _points(seen, vectors, k, name)
                name += "+" if which else ""
    ends = shared(named, CLOSE)
    middle = complex(np.mean([one.at for one in ends]))
    wanted = lettered(ends, on.heights.number, away_from=middle)
    numbers = [(k, plans.names[k]) for k in at]
    return traces.drawing(on, strokes, wanted, (), numbers)


def _vectors(seen: Seen, start: Mark, one: Vectors, k: int, mu: float) -> Iterator[Ink]:
    """Yield what leads from the pole by the crank, and by the follower, to the end; heavy what is sought."""
    runs = [(start, one.crank, "medium"), (one.crank, one.own or one.end, "medium")]
    runs += [(one.own, one.end, "medium")] if one.own else []
    runs += [(start, one.lever, "medium"), (one.lever, one.end, "medium")] if one.lever else []
    for a, b, pen in (*runs, (start, one.end, "main")):
        first, last = seen.point(a, k), seen.point(b, k)
        if finite(first, last) and abs(last - first) >= SHORTEST:
            name = f"{a.name}{b.name}"
            yield from body(told_arrow(first, last, pen, name, mu, "m"), "vector", [a, b], k)


def _points(seen: Seen, one: Vectors, k: int, name: str) -> Iterator[Named]:
    for mark, letter in zip(one[:4], one.letters, strict=True):
        if mark is not None:
            text = letter if mark is one.crank and one.fixed else markup(letter, name)
            yield Named(seen.point(mark, k), text, (mark.slot,), k)
