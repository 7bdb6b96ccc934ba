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

EVERY, APART = (1, 2, 5, 10), 1.2
"""Of positions that stand too close every second, fifth … is numbered: their middle way, of the height."""
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

    Where they have no room every second, fifth … is numbered.

    ``mark``: of the point that is numbered; ``spots``: where its numbers stand, ``toward``: on which side.
    """
    ways, every = np.broadcast_to(toward, spots.shape), _every(spots, ink.heights.number)
    named, aim = [], dict[complex, complex]()
    for k, (name, spot, way) in enumerate(zip(names, spots, ways, strict=True)):
        if k % every:
            continue
        at = complex(spot)
        named.append(Named(at, name, (mark.slot,), k))
        aim.setdefault(at, complex(way))
    return [
        Wanted(one.text, one.at, ink.heights.number, radius, aim[one.at], one.of, one.position)
        for one in shared(named)
    ]


def _every(spots: Complexes, height: float) -> int:
    """Return every how many-th position has room for its number."""
    steps = np.abs(np.diff(spots))
    apart = steps[np.isfinite(steps) & (steps > height * 0.1)]
    middle = float(np.median(apart)) if apart.size else height * APART
    return next((n for n in EVERY if n * middle >= APART * height), EVERY[-1])
