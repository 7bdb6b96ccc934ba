"""A polygon of vectors in ink: sides with arrows, the one that closes it, its vertices."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.operations.instruments import lay_off, measure
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.rotors.polygon import Polygon
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted
from graphic_tmm.paper.figure import Manner, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow

LEAST = 0.3
"""A side that is shorter is a point, mm."""


class _Sides:
    """The sides of a polygon by the steps that drew them."""

    def __init__(self, polygon: Polygon, mu: float) -> None:
        self.polygon, self.mu = polygon, mu
        self.unit = polygon.mu.unit.removesuffix("/mm").strip("()")
        self.by_head = {side.head: side for side in polygon.sides}

    def laid(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A vector, laid off."""
        side = self.by_head[step.it]
        yield from self.arrow(seen, (side.letter, seen.point(side.tail, k), step.it), "medium")

    def closing(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The side that was missing, as measured."""
        side = self.polygon.closing
        yield from self.arrow(seen, (side.letter, seen.point(side.tail, k), side.head), "main")

    def arrow(self, seen: Seen, side: tuple[str, complex, object], pen: str) -> Iterator[Ink]:
        letter, a, head = side
        b = seen.point(head, 0)  # type: ignore[arg-type]
        if finite(a, b) and abs(b - a) >= LEAST:
            yield from told_arrow(a, b, pen, letter, self.mu, self.unit)


def draw_polygon_ink(on: Subject, polygon: Polygon, mu: float) -> Drawing:
    """Return a polygon; ``mu``: what a mm of it stands for."""
    seen, high = on.seen((polygon.view,), [0]), on.heights
    sides = _Sides(polygon, mu)
    rules = {lay_off.name: sides.laid, measure.name: sides.closing}
    traces = figure(seen, Manner(rules, lambda seen, step: step.op in (lay_off, measure)))
    corners = [seen.point(side.tail, 0) for side in (*polygon.sides, polygon.closing)]
    middle = complex(np.mean(corners))
    wanted = []
    for side in (*polygon.sides, polygon.closing):
        a, b = seen.point(side.tail, 0), seen.point(side.head, 0)
        if abs(b - a) < LEAST:
            continue
        out = 1j * (b - a) / abs(b - a)
        if (((a + b) / 2 - middle) * out.conjugate()).real < 0:
            out = -out
        of = (polygon.length,) if side is polygon.closing else (side.tail, side.head)
        letter = symbol(side.letter, on.language)
        wanted.append(
            Wanted(
                f"\\bar{{{letter[0]}}}{letter[1:]}", (a + b) / 2, high.point, 1.0, out,
                tuple(mark.slot for mark in of),
            )
        )  # fmt: skip
    vertices = dict.fromkeys(mark for side in polygon.sides for mark in side[1:])
    points = [Named(seen.point(mark, 0), mark.name, (mark.slot,)) for mark in vertices]
    wanted += lettered(shared(points, LEAST), high.number, away_from=middle)
    return traces.drawing(on, traces.staying, wanted)
