"""A hodograph in ink: vectors from the pole, the curve through their ends, its tangents where they are held."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board.record import Step
from graphic_tmm.chapters.hodograph.operations import equal_vector
from graphic_tmm.chapters.hodograph.record import Hodograph
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.symbols.kinematic import pole

LEAST = 1.0
"""A vector that is shorter is a point, mm; ends nearer to each other share one number."""
TANGENT = 14.0
"""Half the length of a tangent, mm."""


def draw_hodograph(
    on: Subject, made: Hodograph, names: Sequence[str], places: Sequence[int], held: Sequence[int],
    mu: float, unit: str,
) -> Drawing:  # fmt: skip
    """Return a hodograph at the ``places`` (indices) that are drawn; at those ``held`` with its tangent.

    ``mu`` (SI per mm) and ``unit`` are told to a page that reads the sheet.
    """
    seen = on.seen((made.view,), places)

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        start, end = seen.point(made.pole, k), seen.point(step.it, k)
        if finite(end) and abs(end - start) >= LEAST:
            yield from told_arrow(start, end, "thin", f"{made.pole.name}{step.it.name}", mu, unit)

    manner = Manner(
        {equal_vector.name: vector}, lambda seen, step: True, {made.curve: curve("main")}
    )
    traces = figure(seen, manner)
    strokes = [*traces.staying, *_tangents(seen, made, held)]
    strokes += body(pole(seen.point(made.pole, 0)), "pole", [made.pole])
    numbers = [(k, names[k]) for k in places]
    return traces.drawing(on, strokes, _letters(on, seen, made, names), positions=numbers)


def _tangents(seen: Seen, made: Hodograph, held: Sequence[int]) -> Iterator[Ink]:
    """The tangents at the ends where they are held against the accelerations."""
    drawn = seen.reading[made.curve]
    for k in held if made.angle is not None else ():
        if k < drawn.tangents.shape[1]:
            at, way = complex(drawn.knots[0, k]), complex(drawn.tangents[0, k])
            if finite(at, way) and abs(way) > 0.0:
                along = TANGENT * way / abs(way)
                yield from body([line("thin", at - along, at + along)], "tangent", [made.curve], k)


def _letters(on: Subject, seen: Seen, made: Hodograph, names: Sequence[str]) -> list[Wanted]:
    at = seen.point(made.pole, 0)
    spots = [(k, seen.point(made.end, k)) for k in seen.positions]
    ends = [Named(z, escape(names[k]), (made.end.slot,), k) for k, z in spots if finite(z)]
    near = [one for one in ends if abs(one.at - at) < LEAST]
    far = [one for one in ends if one not in near]
    pole_ = [Named(at, made.pole.name, (made.pole.slot,)), *near]
    return lettered([*shared(pole_, LEAST), *shared(far, LEAST)], on.heights.number, away_from=at)
