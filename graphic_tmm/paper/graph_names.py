"""The names of the curves of a graph: each beside its own, where the others are far."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import shapely

from graphic_tmm.board.operations.instruments import join, measure_along
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Curve, Reals
from graphic_tmm.paper.drawing import Wanted
from graphic_tmm.paper.graph_rules import Graph, curve_over_base, ends_of
from graphic_tmm.paper.label_places import polylines
from graphic_tmm.paper.seen import finite
from graphic_tmm.paper.shapes import flat

FAR = 12.0
"""Curves this far apart, mm, are far enough that a name between them is not mistaken."""

INSET = 0.12
"""So far from its ends, of its width, a line is named that has no intervals."""

Lines = tuple[tuple[complex, ...], ...]


def curve_names(graph: Graph, names: Mapping[Mark, str], size: float) -> Iterator[Wanted]:
    """Return the names of curves, by the mark of a curve or that of the readings of its points.

    A name stands at a place of its curve between two positions, so that no ordinate leads to it: where the
    other named curves are farthest, of places where they are far the highest over the base, or the lowest.
    """
    lines = {step.it: _lines(graph, step) for step in graph.steps if step.it in names}
    middles = (np.arange(graph.row) + 0.5) * graph.length / graph.row
    yield from names_beside(lines, names, size, middles)


def names_beside(
    lines: Mapping[Mark, Lines],
    names: Mapping[Mark, str],
    size: float,
    middles: Reals | None = None,
) -> Iterator[Wanted]:
    """Return the names of lines; ``middles``: the abscissae, mm, at which they are named, anywhere if None."""
    for mark, own in lines.items():
        others = tuple(line for other, more in lines.items() if other != mark for line in more)
        found = _place(own, others, middles)
        if found is not None:
            spot, toward, line = found
            of = (mark.slot,)
            yield Wanted(names[mark], spot, size, 1.0, toward, of, line=line, others=others)


def _lines(graph: Graph, step: Step) -> Lines:
    """Return what is drawn of a curve that has a name, its parts, or of the curves through the points read."""
    if step.op is join:
        ends = ends_of(graph, step, 0)
        return (ends,) if finite(*ends) else ()
    steps = [step]
    if step.op is measure_along:
        steps = [s for s in graph.steps if s.it.kind is Curve and s.uses[0] == step.uses[1]]
    pieces = [flat(one.controls) for s in steps for one in curve_over_base(graph, s)]
    return tuple(tuple(complex(z) for z in piece) for piece in pieces)


def _place(
    own: Lines, others: Lines, middles: Reals | None
) -> tuple[complex, complex, tuple[complex, ...]] | None:
    """Return where a curve is named, on which side, and the part of it that stands there; None if nowhere."""
    rivals = polylines(others)
    found = []
    for line in own:
        for spot in _spots(line, middles):
            there = shapely.Point(spot.real, spot.imag)
            away = FAR if rivals.is_empty else min(FAR, shapely.distance(rivals, there))
            found.append((round(away, 6), round(abs(spot.imag), 6), spot, line))
    if not found:
        return None
    away, _, spot, line = max(found, key=lambda one: one[:2])
    if away == FAR:
        return spot, 1j * (spot.imag or 1.0), line
    nearest = shapely.shortest_line(rivals, shapely.Point(spot.real, spot.imag)).coords[0]
    return spot, 1j * ((spot.imag - nearest[1]) or 1.0), line


def _spots(line: Sequence[complex], middles: Reals | None) -> Iterator[complex]:
    """Yield the points of a line over the middles of the intervals; its own middle if it has none there."""
    x, y = np.real(line), np.imag(line)
    if middles is None:
        inset = INSET * np.ptp(x)
        yield from (z for z in line if x.min() + inset <= z.real <= x.max() - inset)
        return
    over = middles[(middles > x[0]) & (middles < x[-1])]
    for at in over if len(over) else [(x[0] + x[-1]) / 2]:
        yield complex(at, np.interp(at, x, y))
