"""One sheet: where boxes stand that are cut into it in a given order, with gaps as equal as they can be."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.paper.compose.slicing import curve, curves, steps, tree
from graphic_tmm.paper.compose.spread import grown, need, spread
from graphic_tmm.paper.compose.units import Outline, Shape, Size, Unit, shapes
from graphic_tmm.paper.packing import GAP, Room

GAPS = (25.0, 20.0, 16.0, 13.0, 11.0, 9.0, GAP)
"""Gaps that are tried, mm, the widest first."""

Places = dict[int, complex]
"""Where boxes stand, by their index: the lower left corner in sheet coordinates (complex, mm)."""


def placed(
    units: Sequence[Unit], outlines: Sequence[Outline], room: Room, gap: float
) -> Places | None:
    """Return where boxes stand, cut into a sheet with gaps no narrower; None if it does not hold them."""
    left, bottom, right, top = room.inner
    head, foot, aside = _corners(room, gap)
    right -= aside
    width, height = right - left - 2 * gap, top - bottom - 2 * gap
    area = sum((o.width + gap) * (o.height + gap) for o in outlines)
    if area > (width + gap) * (height + gap):
        return None
    there = [*units, Unit((), ((*foot, 0.0),))] if min(foot) > 0.0 else list(units)
    ways: list[Sequence[Shape]] = [shapes(unit.sizes, gap) for unit in there]
    ways[0] = _below(ways[0], head, gap)
    below = [(j, k) for k, unit in enumerate(units) for j in range(k) if _under(unit, units[j])]
    across, down = steps(width + gap), steps(height + gap)
    leaves = [curve([(s.width + gap, s.height + gap) for s in way], across, down) for way in ways]
    found = curves(leaves, down, below)
    for shorter in (0, 1):
        cuts = tree(found, across - shorter, down - shorter)
        least = cuts and need(cuts, there, ways, gap)
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
    x, y = left + gap + (width - size[0]) / 2, top - gap - (height - size[1]) / 2
    return {
        k: complex(x + at, y - below_ - outlines[k].height)
        for k, at, below_ in spread(least, 0.0, 0.0, *size, gap)
    }


def _under(unit: Unit, other: Unit) -> bool:
    """Whether a unit has to stand below another one: said so, or the rest of its rows."""
    one, two = unit.stand, other.stand
    return bool(two.block) and (one.below == two.block or one.block == two.block)


def _below(ways: Sequence[Shape], head: Size, gap: float) -> list[Shape]:
    """Return shapes that leave a corner free: they stand below what is there, or right of it."""
    if min(head) <= 0.0:
        return list(ways)
    wide, high = head[0] + gap, head[1] + gap
    return [
        found
        for s in ways
        for found in (
            Shape(max(s.width, wide), s.height + high, s.rows, (0.0, high)),
            Shape(s.width + wide, max(s.height, high), s.rows, (wide, 0.0)),
        )
    ]


def _corners(room: Room, gap: float) -> tuple[Size, Size, float]:
    """Return what is taken of a sheet, beyond the margin: upper left, lower right, and all along the right."""
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
    width = right - left - aside - 2 * gap
    if foot[0]:
        foot = (max(min(foot[0] - aside - gap, width), 0.0), max(foot[1] - gap, 0.0))
    if head[0]:
        head = (max(min(head[0] - gap, width), 0.0), max(head[1] - gap, 0.0))
    return head, foot, aside
