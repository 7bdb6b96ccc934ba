"""What lies on the strokes of others: the share of a straight line that is near them, or in what they fill."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
import shapely

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.paper.arithmetic import coordinates
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.paper.expressions import COVERED, Expressions
from graphic_tmm.paper.shapes import shape
from graphic_tmm.paper.traced import Traced, node_of

ON = 1.0
"""What is nearer lies on it, mm."""
PIECES = (np.arange(72) + 0.5) / 72
"""The middles of pieces of a line, shares of it: of each it is found out whether it lies on a stroke."""
MOST = 0.5
"""A line of which more lies on strokes lies on them."""
OPEN, FILLED, ROUND = -1, -2, -3
"""What begins a stroke among the nodes of a ``covered``: a line, an area, a circle by two opposite points."""


class Covering:
    """Strokes and the paper that they cover."""

    def __init__(self, strokes: Iterable[Stroke] = ()) -> None:
        self.strokes = tuple(strokes)
        self.shapes = np.array([shape(one) for one in self.strokes], dtype=object)

    @cached_property
    def areas(self) -> Covering:
        """What covers more than a line."""
        return Covering(one for one in self.strokes if one.filled)

    def covers(self, start: complex, end: complex) -> float:
        """Return whether most of a line lies on the strokes, 1 or 0."""
        found = float(self._share(complex(start), complex(end)) > MOST)
        among = next((one.among for one in (start, end) if isinstance(one, Traced)), None)
        if among is None or not self.strokes:
            return found
        of = [node_of(start, among), node_of(end, among), *_nodes(among, self.strokes)]
        return Traced(found, among, among.node(COVERED, *of))  # type: ignore[return-value]

    def _share(self, start: complex, end: complex) -> float:
        line = shapely.LineString(coordinates([start, end]))
        near = self.shapes[shapely.dwithin(self.shapes, line, ON)]
        if not near.size:
            return 0.0
        spots = start + PIECES * (end - start)
        there = shapely.points(spots.real, spots.imag)
        return float(shapely.dwithin(near[:, None], there, ON).any(axis=0).mean())


def _nodes(among: Expressions, strokes: Sequence[Stroke]) -> list[int]:
    """Return the strokes as nodes: how each begins, its vertices; a closed one ends where it begins."""
    found = list[int]()
    for one in strokes:
        places = [among.place(node_of(x, among), node_of(y, among)) for x, y, _ in one.path]
        if len(places) == 2 and all(bulge == 1.0 for *_, bulge in one.path):
            found += [ROUND, *places]
        else:
            found += [FILLED if one.filled else OPEN, *places, *(places[:1] if one.closed else ())]
    return found


def covered(start: Any, end: Any, strokes: Sequence[tuple[int, Sequence[Any]]]) -> Reals:
    """Return whether most of a line lies on strokes, 1 or 0, in many drawings at once; see `Covering`."""
    spots = np.asarray(start + PIECES[:, None] * (np.asarray(end) - start))
    on = np.zeros(spots.shape, dtype=bool)
    for kind, places in strokes:
        if kind == ROUND:
            middle, radius = (places[0] + places[1]) / 2, np.abs(places[1] - places[0]) / 2
            on |= np.abs(np.abs(spots - middle) - radius) <= ON
            continue
        inside = np.zeros(spots.shape, dtype=bool)
        for a, b in pairwise(places):
            on |= _near(spots, a, b)
            inside ^= _left(spots, a, b)
        on |= inside & (kind == FILLED)
    return np.asarray((on.mean(axis=0) > MOST) * 1.0)


def _near(spots: Complexes, a: Any, b: Any) -> Any:
    """Return which places are near a line between two others."""
    along = b - a
    share = ((spots - a) * np.conj(along)).real / np.maximum(np.abs(along) ** 2, 1e-18)
    return np.abs(spots - a - np.clip(share, 0.0, 1.0) * along) <= ON


def _left(spots: Complexes, a: Any, b: Any) -> Any:
    """Return to the left of which places a side of an area passes at their height."""
    a, b = np.broadcast_arrays(a, b)
    between = (a.imag > spots.imag) != (b.imag > spots.imag)
    level = np.where(b.imag == a.imag, 1.0, b.imag - a.imag)
    return between & (spots.real < a.real + (spots.imag - a.imag) / level * (b.real - a.real))
