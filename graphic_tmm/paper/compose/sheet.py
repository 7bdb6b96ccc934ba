"""One sheet: where boxes stand that are cut into it in a given order, with gaps as equal as they can be."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.paper.compose.slicing import (
    GRID,
    NONE,
    Curves,
    curve,
    curves,
    grid_of,
    steps,
    tree,
)
from graphic_tmm.paper.compose.spread import grown, need, spread
from graphic_tmm.paper.compose.units import Outline, Shape, Size, Unit, boxes_of, ways_of
from graphic_tmm.paper.packing import GAP, Room

GAPS = (25.0, 20.0, 16.0, 13.0, 11.0, 9.0, GAP)
"""Gaps that are tried, mm, the widest first."""

SPARE = 1.2
"""How far above a sheet, as a share, is looked for what is too high for it."""

Places = dict[int, complex]
"""Where boxes stand, by their index: the lower left corner in sheet coordinates (complex, mm)."""


class Cutting(NamedTuple):
    """What is cut into a sheet: where views begin (left, top, mm), their room, the units and their shapes."""

    corner: complex
    size: Size
    units: Sequence[Unit]
    ways: Sequence[Sequence[Shape]]
    gap: float

    @property
    def grid(self) -> float:
        """The grid on which it is cut, mm."""
        return grid_of(len(self.units))

    @property
    def share(self) -> float:
        """What its boxes take of the sheet, each with its gap."""
        gap = self.gap
        taken = sum((w + gap) * (h + gap) for unit in self.units for w, h, _ in unit.sizes)
        return taken / ((self.size[0] + gap) * (self.size[1] + gap))

    def curves(self, share: float = 1.0) -> Curves:
        """Return the curves of all runs of units on a sheet by a ``share`` higher."""
        gap, units, grid = self.gap, self.units, self.grid
        across, down = steps(self.size[0] + gap, grid), steps(share * (self.size[1] + gap), grid)
        below = [(j, k) for k, unit in enumerate(units) for j in range(k) if _under(unit, units[j])]
        leaves = [
            curve([(s.width + gap, s.height + gap) for s in way], across, down, grid)
            for way in self.ways
        ]
        return curves(leaves, down, below)


def cutting(units: Sequence[Unit], room: Room, gap: float) -> Cutting | None:
    """Return what is cut into a sheet with gaps no narrower; None if it is more than the sheet has."""
    left, bottom, right, top = room.inner
    head, foot, aside = _corners(room, gap)
    width, height = right - aside - left - 2 * gap, top - bottom - 2 * gap
    there = [*units, Unit((), ((*foot, 0.0),))] if min(foot) > 0.0 else list(units)
    found = Cutting(complex(left + gap, top - gap), (width, height), there, [], gap)
    if found.share > 1.0:
        return None
    ways: list[Sequence[Shape]] = [ways_of(unit, gap) for unit in there]
    ways[0] = _below(ways[0], head, gap)
    return found._replace(ways=ways)


def excess(units: Sequence[Unit], room: Room, gap: float) -> float:
    """Return by how much, mm, what is cut into a sheet is too high for it; without end if by very much."""
    cut = cutting(units, room, gap)
    if cut is None:
        return math.inf
    least = int(cut.curves(SPARE).heights[len(cut.units), 0, -1])
    over = (least - steps(cut.size[1] + gap, cut.grid)) * cut.grid
    return over if least < NONE else math.inf


def placed(
    units: Sequence[Unit], outlines: Sequence[Outline], room: Room, gap: float
) -> Places | None:
    """Return where boxes stand, cut into a sheet with gaps no narrower; None if it does not hold them."""
    if not units:
        return {}
    cut = cutting(units, room, gap)
    if cut is None:
        return None
    found, (width, height) = cut.curves(), cut.size
    for shorter in (0, 1):
        cuts = tree(found, *(side - 1 - shorter for side in found.row))
        least = cuts and need(cuts, cut.units, cut.ways, gap, cut.grid)
        if least and least.width <= width + 1e-6 and least.height <= height + 1e-6:
            break
    else:
        return None
    wide = grown(least.width, least.across, width, gap)
    high = grown(least.height, least.down, height, gap)
    size = (
        least.width + (least.across - 1) * (wide - gap),
        least.height + (least.down - 1) * (high - gap),
    )
    middle = cut.corner + complex(width - size[0], size[1] - height) / 2
    places = {
        k: middle + complex(at, -down - outlines[k].height)
        for k, at, down in spread(least, 0.0, 0.0, *size, gap, whole=True)
    }
    return _balanced(places, outlines, room)


def _balanced(places: Places, outlines: Sequence[Outline], room: Room) -> Places:
    """Return places moved together up or down, so that as much is left above all of them as below.

    A corner that is kept free for the title block has a gap of its own, which is not seen as one.
    """
    boxes = boxes_of(places, outlines)
    _, bottom, _, top = room.inner
    above = min(top - box[3] for box in boxes)
    below = min(box[1] - bottom for box in boxes)
    for left, base, right, head in room.occupied:
        for first, low, last, high in boxes:
            if first < right + GAP and last > left - GAP:
                above = min(above, base - high if base >= high else math.inf)
                below = min(below, low - head if low >= head else math.inf)
    return {k: z + 0.5j * (above - below) for k, z in places.items()}


def _under(unit: Unit, other: Unit) -> bool:
    """Whether a unit has to stand below another one: said so, or the rest of its rows."""
    one, two = unit.stand, other.stand
    return bool(two.block) and (one.below == two.block or one.block == two.block)


def _below(ways: Sequence[Shape], head: Size, gap: float) -> list[Shape]:
    """Return shapes that leave a corner free: they stand below what is there, or right of it."""
    if min(head) <= 0.0:
        return list(ways)
    wide, high = head
    return [
        found
        for s in ways
        for found in (
            Shape(max(s.width, wide), s.height + high, s.rows, (0.0, s.free[1] + high)),
            Shape(s.width + wide, max(s.height, high), s.rows, (wide, s.free[1])),
        )
    ]


def _corners(room: Room, gap: float) -> tuple[Size, Size, float]:
    """Return what is taken of a sheet, beyond the margin: upper left, lower right, and all along the right.

    Upper left with what is clear of it. What a wide margin would only just pass stands off all the same.
    """
    left, bottom, right, top = room.inner
    head, foot, aside = (0.0, 0.0), (0.0, 0.0), 0.0
    for box in room.occupied:
        wide, high = box[2] - box[0], box[3] - box[1]
        if box[0] <= left + 1e-6 and box[3] >= top - 1e-6:
            head = (wide, high)
        elif box[2] >= right - 1e-6 and box[1] <= bottom + 1e-6:
            foot = (wide, high)
        elif box[2] >= right - 1e-6:
            aside = max(aside, wide)
    # what is as wide as the sheet would leave no step of the grid to spare: nothing stands beside it anyway
    width = right - left - aside - 2 * gap - 2 * GRID
    if foot[0]:
        foot = (min(_beyond(foot[0] - aside, gap), width), _beyond(foot[1], gap))
    if head[0]:
        head = (min(_clear(head[0], gap), width + gap), _clear(head[1], gap))
    return head, foot, aside


def _beyond(side: float, gap: float) -> float:
    """Return how far a side reaches beyond a margin; a little if it ends just before it, 0 if clear of it."""
    return max(side - gap, 0.0 if gap >= side + GAP else GRID / 2)


def _clear(side: float, gap: float) -> float:
    """Return how far beyond a margin what is clear of a side begins: by that gap from it, at least by `GAP`."""
    return side if gap <= side else max(side + GAP - gap, 0.0)
