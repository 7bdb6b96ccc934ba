"""Cuts made exact: what each part takes, and the room that is left put into the gaps, evenly.

A gap grows to 25 mm; what is more stands on both sides, so that what a cell holds is in its middle. What stands
in a row has its lower edges, and so its captions, on one line; a sheet of one column has one axis.
Coordinates: mm from the upper left corner of what views may fill, downward.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.paper.compose.slicing import GRID, Leaf, Tree
from graphic_tmm.paper.compose.units import PAIRED, WIDEST, Shape, Unit, high, split

NEAR = 50.0
"""A cell that leaves no more than this, mm, of the height next to it stands at the upper edge."""

Spots = Iterator[tuple[int, float, float]]
"""Boxes by their index, each with its left and upper edge."""


class Need(NamedTuple):
    """What a part of a sheet takes at the least gap, mm; how many boxes stand in it across and down.

    ``cut``: None for a unit, else whether its parts stand side by side. ``last``: it ends in the corner.
    """

    width: float
    height: float
    across: int
    down: int
    last: bool
    cut: bool | None = None
    parts: tuple[Need, ...] = ()
    unit: Unit = Unit((), ())
    shape: Shape = Shape(0.0, 0.0, ())


def need(
    tree: Tree,
    units: Sequence[Unit],
    ways: Sequence[Sequence[Shape]],
    gap: float,
    grid: float = GRID,
) -> Need | None:
    """Return what cut units take, each in the shape that fills its cell best; None if one has no shape."""
    if isinstance(tree, Leaf):
        unit, cell = units[tree.place], (tree.width * grid - gap, tree.height * grid - gap)
        fitting = [
            s for s in ways[tree.place] if s.width <= cell[0] + 1e-6 and s.height <= cell[1] + 1e-6
        ]
        if not fitting:
            return None
        shape = min(fitting, key=lambda s: _unfilled(s, cell))
        across, down = max(shape.rows), len(shape.rows)
        last = not unit.members
        return Need(shape.width, shape.height, across, down, last, unit=unit, shape=shape)
    found = [need(part, units, ways, gap, grid) for part in tree.parts]
    parts = tuple(part for part in found if part is not None)
    if len(parts) < len(found):
        return None
    wide, high = max(parts, key=lambda p: p.width), max(parts, key=lambda p: p.height)
    gaps = gap * (len(parts) - 1)
    if tree.across:
        size = (sum(p.width for p in parts) + gaps, high.height)
        counts = (sum(p.across for p in parts), high.down)
    else:
        size = (wide.width, sum(p.height for p in parts) + gaps)
        counts = (wide.across, sum(p.down for p in parts))
    return Need(*size, *counts, parts[-1].last, tree.across, parts)


def _unfilled(shape: Shape, cell: tuple[float, float]) -> float:
    """Return the wider of the gaps across and down with which a shape fills a cell."""
    across = (cell[0] - shape.width) / (max(shape.rows) + 1)
    return max(across, (cell[1] - shape.height) / (len(shape.rows) + 1))


def grown(least: float, count: int, room: float, gap: float, most: float = WIDEST) -> float:
    """Return the gap with which a number of parts fill a room, at most the widest gap."""
    if count < 2:
        return gap
    return max(gap, min(most, gap + (room - least) / (count - 1)))


def spread(
    part: Need, x: float, y: float, width: float, height: float, gap: float, *, whole: bool = False
) -> Spots:
    """Yield where the boxes of a part stand in a cell; ``whole``: it is all that is on a sheet."""
    if part.cut is None:
        yield from _unit(part, x, y, width, height, gap)
    elif part.cut:
        yield from _row(part, x, y, width, height, gap)
    else:
        axis = x + width / 2 if whole and _single_column(part) else None
        for k, left, top in _column(part, x, y, width, height, gap):
            yield k, (left if axis is None else max(left, axis - _wide(part, k) / 2)), top


def _single_column(part: Need) -> bool:
    """Whether a part is a single column."""
    if part.cut is None:
        return max(part.shape.rows, default=1) == 1
    return not part.cut and all(map(_single_column, part.parts))


def _wide(part: Need, box: int) -> float:
    """Return how wide a box is that stands in a part."""
    if part.cut is None:
        members = part.unit.members
        return part.unit.sizes[members.index(box)][0] if box in members else 0.0
    return max(_wide(one, box) for one in part.parts)


def _row(part: Need, x: float, y: float, width: float, height: float, gap: float) -> Spots:
    wide = grown(part.width, part.across, width, gap)
    sizes = [one.width + (one.across - 1) * (wide - gap) for one in part.parts]
    left = width - sum(sizes) - wide * (len(sizes) - 1)
    x += left / 2
    line = _line(part, height)
    for one, size in zip(part.parts, sizes, strict=True):
        if one.last:
            x += left / 2
        top, high = line if _single(one) else (0.0, height)
        yield from spread(one, x, y + top, size, high, gap)
        x += size + wide


def _single(part: Need) -> bool:
    """Whether a part is one row of boxes that may stand at any height of its cell; what leads stands above."""
    leads = part.unit.stand.kind == "lead"
    return part.cut is None and part.down == 1 and bool(part.unit.members) and not leads


def _line(part: Need, height: float) -> tuple[float, float]:
    """Return top and height of the cell in which the single rows that stand side by side end on one line.

    It stands at the upper edge, like the columns next to it, if little is left below it; else in the middle.
    """
    most = max((one.height for one in part.parts if _single(one)), default=height)
    columns = any(one.cut is not None or one.down > 1 for one in part.parts)
    left = height - most
    return (0.0 if columns and left <= NEAR else left / 2), most


def _column(part: Need, x: float, y: float, width: float, height: float, gap: float) -> Spots:
    high, end = grown(part.height, part.down, height, gap), y + height
    sizes = [one.height + (one.down - 1) * (high - gap) for one in part.parts]
    left = height - sum(sizes) - high * (len(sizes) - 1)
    y += 0.0 if part.parts[0].unit.stand.kind == "lead" else left / 2
    for one, size in zip(part.parts, sizes, strict=True):
        if one.last:
            y = end - size
        yield from spread(one, x, y, width, size, gap)
        y += size + high


def _unit(part: Need, x: float, y: float, width: float, height: float, gap: float) -> Spots:
    unit, shape = part.unit, part.shape
    if not unit.members:
        return
    most = PAIRED if unit.stand.kind == "pair" else WIDEST
    gap = min(gap, most)
    x, y = x + shape.free[0], y + shape.free[1]
    width, height = width - shape.free[0], height - shape.free[1]
    lines = split(unit.sizes, shape.rows)
    least = sum(map(high, lines)) + gap * (len(lines) - 1)
    deep = grown(least, len(lines), height, gap, most)
    if unit.stand.kind == "lead":
        pass
    elif len(lines) == 1:
        y += height - least
    else:
        y += (height - least - (deep - gap) * (len(lines) - 1)) / 2
    members = iter(unit.members)
    for line in lines:
        taken = sum(w for w, _, _ in line) + gap * (len(line) - 1)
        wide = grown(taken, len(line), width, gap, most)
        at = x + (width - taken - (wide - gap) * (len(line) - 1)) / 2
        if unit.stand.kind == "lead":
            at = x
        base = y + max(h - foot for _, h, foot in line)
        for w, h, foot in line:
            yield next(members), at, base - (h - foot)
            at += w + wide
        y += high(line) + deep
