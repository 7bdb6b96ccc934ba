"""Tables that a sheet does not hold whole: broken into even blocks, head and title repeated."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import bounds, holds
from graphic_tmm.paper.ruled import TITLE_GAP, Grid, measured, ruled_table
from graphic_tmm.paper.views import stacked, wrapped

CROWNED = 1.8
"""Room for the title above a block in addition to the gap below it, in heights of its capitals."""
OVERHANG, SHARES = 1.3, (0.5, 0.6, 0.75)
"""A title 1.3 times as wide as its table is set in two lines; the first takes one of these shares at most."""


def breakable(
    name: str,
    title: str,
    columns: Sequence[str],
    rows: Sequence[Sequence[str]],
    *,
    again: str,
    lead: int = 0,
    over: int = 0,
    size: float = 3.5,
    title_size: float = 5.0,
    align: Sequence[str] | None = None,
) -> Drawing:
    """Return a ruled table that comes apart into as few even blocks as a sheet holds; see `table`.

    Each block repeats the head, the first ``lead`` columns and the first ``over`` rows; those after the first
    bear the title with ``again`` behind it. Columns are parted only where there are ``lead`` ones to repeat.
    """

    def block(k: int, across: range, down: range) -> Drawing:
        kept = [*range(lead), *across]
        cells = [[row[j] for j in kept] for row in (*rows[:over], *(rows[i] for i in down))]
        ways = [align[j] for j in kept] if align else None
        told, own = (f"{title} ({again})", f"{name}-{k + 1}") if k else (title, name)
        heads = [columns[j] for j in kept]
        return ruled_table(own, told, heads, cells, size=size, title_size=title_size, align=ways)

    def apart(within: Within) -> list[Drawing]:
        crown = TITLE_GAP + CROWNED * title_size
        rooms = [(wide, high - crown) for wide, high in within.sizes]
        _, _, across, down = min(_parts(grid, lead, over, room) for room in rooms)
        runs = [
            (a, d) for d in _runs(over, len(rows), down) for a in _runs(lead, len(columns), across)
        ]
        return piled([block(k, *run) for k, run in enumerate(runs)], within)

    grid = measured(name, columns, rows, size=size, head_size=size, align=align)
    head = _folded(title, max(size, title_size), sum(grid.widths))
    whole = ruled_table(name, head, columns, rows, size=size, title_size=title_size, align=align)
    return whole._replace(cell=bounds(whole), apart=apart)


def _folded(title: str, size: float, width: float) -> str:
    """Return a title in two lines if it is much wider than its table, and two are less so."""
    if letter(title, size=size).width <= OVERHANG * width:
        return title
    for share in SHARES:
        lines = wrapped(title, size, max(width, share * letter(title, size=size).width))
        if len(lines) == 2:
            return "\n".join(lines)
    return title


def piled(blocks: Sequence[Drawing], within: Within) -> list[Drawing]:
    """Return blocks in order, one below the other as many as a sheet holds."""
    piles: list[list[Drawing]] = []
    for view in blocks:
        if piles and holds(within, stacked("", [*piles[-1], view])):
            piles[-1].append(view)
        else:
            piles.append([view])
    return [stacked(pile[0].name, pile)._replace(title=pile[0].title, apart=None) for pile in piles]


def _parts(
    grid: Grid, lead: int, over: int, room: tuple[float, float]
) -> tuple[bool, int, int, int]:
    """Return whether columns are too wide for a room, how many blocks it takes, in how many runs each way.

    ``room``: its width, and its height less that of the title, mm.
    """
    widths, count = grid.widths, len(grid.widths)

    def widest(parts: int) -> float:
        return max(sum(widths[k] for k in run) for run in _runs(lead, count, parts))

    most = room[0] - sum(widths[:lead])
    runs = range(1, max(count - lead, 1) + 1 if lead else 2)
    across = next((parts for parts in runs if widest(parts) <= most), runs[-1])
    rows, high = len(grid.body[0]) - over, room[1] - grid.head[0]
    down = max(math.ceil(rows / max(math.floor(high / grid.row[0]) - over, 1)), 1)
    return widest(across) > most, across * down, across, down


def fewest(within: Within, *ways: list[Drawing]) -> list[Drawing]:
    """Return of several ways to break a table one that fits, of the fewest views, of the least area."""
    return min(ways, key=lambda found: (not holds(within, *found), len(found), _area(found)))


def _area(views: Sequence[Drawing]) -> float:
    boxes = [bounds(view) for view in views]
    return sum((right - left) * (top - low) for left, low, right, top in boxes)


def _runs(first: int, end: int, parts: int) -> list[range]:
    """Return the indices from ``first`` to ``end`` in runs that are as even as they can be."""
    ends = [first + (end - first) * k // parts for k in range(parts + 1)]
    return [range(a, b) for a, b in pairwise(ends)]
