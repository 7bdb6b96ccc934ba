"""Tables that a sheet does not hold whole: broken into even blocks, head and title repeated."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.layout import bounds, holds
from graphic_tmm.paper.ruled import table


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
        return table(own, told, [columns[j] for j in kept], cells, size=size, align=ways)

    def blocks(across: int, down: int) -> list[Drawing]:
        runs = [
            (a, d) for d in _runs(over, len(rows), down) for a in _runs(lead, len(columns), across)
        ]
        return [block(k, *run) for k, run in enumerate(runs)]

    def apart(within: Within) -> list[Drawing]:
        most = (max(len(columns) - lead, 1) if lead else 1, max(len(rows) - over, 1))
        return fewest(within, *(_broken(blocks, whole, most, room) for room in within.sizes))

    (whole,) = blocks(1, 1)
    return whole._replace(apart=apart)


def fewest(within: Within, *ways: list[Drawing]) -> list[Drawing]:
    """Return of several ways to break a table one that fits, of the fewest blocks."""
    return min(ways, key=lambda found: (not holds(within, *found), len(found)))


def _broken(
    blocks: Callable[[int, int], list[Drawing]],
    whole: Drawing,
    most: tuple[int, int],
    room: tuple[float, float],
) -> list[Drawing]:
    """Return the fewest blocks of a table that are no wider and no higher than a room, if there are such."""
    parts = [min(most[k], math.ceil(side / room[k] - 1e-9)) for k, side in enumerate(_sides(whole))]
    found = blocks(*parts)
    for k in (0, 1):
        while parts[k] < most[k] and max(_sides(view)[k] for view in found) > room[k]:
            parts[k] += 1
            found = blocks(*parts)
    return found


def _sides(view: Drawing) -> tuple[float, float]:
    left, low, right, top = bounds(view)
    return right - left, top - low


def _runs(first: int, end: int, parts: int) -> list[range]:
    """Return the indices from ``first`` to ``end`` in runs that are as even as they can be."""
    ends = [first + (end - first) * k // parts for k in range(parts + 1)]
    return [range(a, b) for a, b in pairwise(ends)]
