"""How a sheet is composed, by the boxes of its views alone: one number, the less the better."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from graphic_tmm.paper.compose.units import Outline, boxes_of
from graphic_tmm.paper.packing import Box, Room

CELL, CLEAR = 8.0, 5.0
"""The raster on which white is looked for, mm; what is nearer to a box is no hole."""
QUADRANT, ALIGNED = 0.25, 0.8
"""What a quadrant should be filled by, and the share of boxes that should stand on a line with another."""
LINED = 0.6
"""Edges and axes that are no farther apart, mm, are on one line."""


def judged(places: Mapping[int, complex], outlines: Sequence[Outline], room: Room) -> float:
    """Return the largest hole as a share of the sheet, and what quadrants and lines lack to be good."""
    boxes = boxes_of(places, outlines)
    area = room.area
    lacking = max(0.0, QUADRANT - _emptiest(boxes, room))
    ragged = max(0.0, ALIGNED - lined(boxes))
    return hole(boxes, room) / area + 0.4 * lacking + 0.1 * ragged


def hole(boxes: Sequence[Box], room: Room) -> float:
    """Return the area of the largest white rectangle between boxes, mm², on a raster."""
    left, bottom, right, top = room.inner
    white = np.ones((int((top - bottom) / CELL), int((right - left) / CELL)), dtype=bool)
    for box in (*boxes, *room.occupied):
        low, high = (box[1] - CLEAR - bottom) / CELL, (box[3] + CLEAR - bottom) / CELL
        first, last = (box[0] - CLEAR - left) / CELL, (box[2] + CLEAR - left) / CELL
        rows = slice(max(int(low), 0), max(math.ceil(high), 0))
        white[rows, max(int(first), 0) : max(math.ceil(last), 0)] = False
    return _largest(white) * CELL * CELL


def _largest(white: np.ndarray) -> int:
    """Return how many cells the largest rectangle of a raster has: from each row down, the longest runs.

    Rows and columns that are alike are taken together, as often as they are there.
    """
    rows, columns = _changes(white), _changes(white.T)
    high = np.diff(rows, append=white.shape[0])
    along = np.cumsum(np.diff(columns, append=white.shape[1]))
    some, best = white[np.ix_(rows, columns)], 0
    for first in range(len(rows)):
        down = np.logical_and.accumulate(some[first:], axis=0)
        runs = along - np.maximum.accumulate(np.where(down, 0, along), axis=1)
        best = max(best, int((runs.max(axis=1) * np.cumsum(high[first:])).max()))
    return best


def _changes(white: np.ndarray) -> np.ndarray:
    """Return the first of all rows that are alike one below the other."""
    alike = (white[1:] == white[:-1]).all(axis=1)
    return np.flatnonzero(np.concatenate([[True], ~alike]))


def _emptiest(boxes: Sequence[Box], room: Room) -> float:
    """Return the share of the emptiest quadrant of a sheet that boxes fill; what is taken does not count."""
    left, bottom, right, top = room.inner
    x, y, least = (left + right) / 2, (bottom + top) / 2, 1.0
    for quarter in (
        (left, bottom, x, y),
        (x, bottom, right, y),
        (left, y, x, top),
        (x, y, right, top),
    ):
        free = (quarter[2] - quarter[0]) * (quarter[3] - quarter[1])
        free -= sum(_common(quarter, box) for box in room.occupied)
        least = min(least, sum(_common(quarter, box) for box in boxes) / free)
    return least


def _common(one: Box, other: Box) -> float:
    wide = min(one[2], other[2]) - max(one[0], other[0])
    high = min(one[3], other[3]) - max(one[1], other[1])
    return wide * high if wide > 0.0 and high > 0.0 else 0.0


def lined(boxes: Sequence[Box]) -> float:
    """Return the share of boxes of which an edge or the upright axis is on one line with another's."""
    if len(boxes) < 2:
        return 1.0
    table = np.array([(b[0], b[1], b[3], (b[0] + b[2]) / 2) for b in boxes])
    near = (np.abs(table[:, None] - table[None]) < LINED).any(axis=2)
    return float(((near.sum(axis=1) - 1) > 0).mean())
