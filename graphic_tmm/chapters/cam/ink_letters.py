"""Letters and axes of a cam's views: numbers of positions, grouped where they coincide; directions; an axis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.paper.drawing import Ink, Wanted, line
from graphic_tmm.paper.finish import Named, shared
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 9.0
"""How far an axis goes on behind what stands on it, mm."""


def directions(spots: Complexes) -> Complexes:
    """Return the directions of complex numbers; NaN where there is none."""
    size = np.abs(spots)
    there = size > 0.0
    return np.asarray(np.where(there, spots / np.where(there, size, 1.0), np.nan))


def arrow_axis(start: complex, end: complex) -> list[Ink]:
    """Return an axis with its arrow at ``end``."""
    return [line("thin", start, end), *arrowhead(end, end - start, pen="thin")]


def numbered(
    ink: CamInk,
    names: Sequence[str],
    mark: Mark,
    spots: Complexes,
    toward: Complexes,
    *,
    radius: float = 0.8,
) -> list[Wanted]:
    """Return the numbers of positions at their points; positions that coincide share one label.

    ``mark``: of the point that is numbered; ``spots``: where its numbers stand, ``toward``: on which side.
    """
    ways = np.broadcast_to(toward, spots.shape)
    named, aim = [], dict[complex, complex]()
    for k, (name, spot, way) in enumerate(zip(names, spots, ways, strict=True)):
        at = complex(spot)
        named.append(Named(at, name, (mark.slot,), k))
        aim.setdefault(at, complex(way))
    return [
        Wanted(one.text, one.at, ink.heights.number, radius, aim[one.at], one.of, one.position)
        for one in shared(named)
    ]
