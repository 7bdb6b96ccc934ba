"""Which way the supports of fixed pivots stand: down, or to a side where no link runs through them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.figures import rigid
from graphic_tmm.paper.symbols.kinematic import (
    FOOT_HEIGHT,
    FOOT_WIDTH,
    GROUND_LENGTH,
    HATCH_DEPTH,
    JOINT_RADIUS,
)

SIDES = (0.0, 180.0, 90.0, -90.0)
"""By how much a support may be turned, degrees: down, up, to the right, to the left; the first free
side is taken."""


def supports(
    figures: Sequence[Figure],
    reading: Reading,
    pivots: Iterable[Mark],
    rails: Sequence[tuple[complex, complex]],
) -> dict[Mark, float]:
    """Return by how much the support of each pivot is turned, degrees.

    It hangs down where no link that turns about the pivot runs through it in any position; else it stands where
    neither links nor ``rails`` do. A crank runs through every side: its support hangs down.
    """
    links = {f.name: f.marks for f in figures if f.kind == "link"}
    swept = {name: _swept(figures, reading, name) for name in links}
    fixed = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in rails]
    everything = [*fixed, *(shape for shapes in swept.values() for shape in shapes)]
    found = {}
    for pivot in pivots:
        at = complex(reading[pivot][0, 0])
        own = [shape for name, marks in links.items() if pivot in marks for shape in swept[name]]
        down, *turned = SIDES
        free = [down] if _free(at, down, own) else [k for k in turned if _free(at, k, everything)]
        found[pivot] = free[0] if free else down
    return found


def _swept(figures: Sequence[Figure], reading: Reading, name: str) -> Sequence[shapely.Geometry]:
    """Return what a link covers in each position: all between its points and what slides on it."""
    stones = [f.marks[0] for f in figures if f.name == name and f.kind == "guide"]
    rows = [reading[mark][0] for mark in dict.fromkeys((*rigid(figures, name), *stones))]
    spots = np.stack(np.broadcast_arrays(*rows), axis=1)
    there = spots[np.isfinite(spots).all(axis=1)]
    points = shapely.multipoints(shapely.points(there.real, there.imag))
    return list(np.atleast_1d(shapely.convex_hull(points)))


def _free(at: complex, angle: float, shapes: Sequence[shapely.Geometry]) -> bool:
    """Whether a support turned by an angle (degrees) at a pivot covers none of these shapes."""
    neck = FOOT_WIDTH / 2 * JOINT_RADIUS / FOOT_HEIGHT
    half, low = GROUND_LENGTH / 2, -FOOT_HEIGHT - HATCH_DEPTH
    corners = [complex(-half, low), complex(half, low), complex(half, -FOOT_HEIGHT)]
    corners += [
        complex(neck, -JOINT_RADIUS),
        complex(-neck, -JOINT_RADIUS),
        complex(-half, -FOOT_HEIGHT),
    ]
    turn = np.exp(1j * np.radians(angle))
    foot = shapely.Polygon([(z.real, z.imag) for z in (at + turn * corner for corner in corners)])
    return not bool(np.any(shapely.intersects(np.array(shapes, dtype=object), foot)))
