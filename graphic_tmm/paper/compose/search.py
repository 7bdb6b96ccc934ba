"""Orders tried for a sheet: rows broken next to the leading view, tables moved among those that come last.

Reading order is a law: what leads comes first, then rows, then pairs in their order; only single views may
change places. Tables stand behind rows and pairs, or under what leads where there are no pairs; notes behind
rows. Each order is composed and judged by the boxes alone (`judged`); a better one is the start of the next
moves. The number of tries is fixed, so the same boxes always make the same sheet.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

from graphic_tmm.paper.compose.judged import hole, judged
from graphic_tmm.paper.compose.sheet import GAPS, Places, cutting, excess, placed
from graphic_tmm.paper.compose.units import Outline, Unit, boxes_of, units_of
from graphic_tmm.paper.drawing import Stand
from graphic_tmm.paper.packing import Room

TRIES = 60
"""How many orders of a sheet are tried."""
FEW = 4
"""How many are tried to find out whether a sheet holds a part of what is ordered."""
FULLEST, MANY = 0.87, 6
"""No order fits boxes that take more of a sheet than this, each with its gap, where there are many units."""
HOPELESS, FAR = 1.02, (0.25, 0.11, 0.03)
"""What a first order is too high by, as a share of the sheet: with what its boxes take no more than the first;
alone, and after one round of moves, after two and all others, no more than these. Of 6,000 sets of boxes that
sheets were tried for, three are given up that would have fitted; it saves two fifths of the time."""
WHITE = 0.12
"""A larger hole, as a share of the sheet, an examiner sends back."""
KEPT = 4096
"""Size of the cache that remembers whether a sheet holds a set of boxes."""
LEAD = "\0lead"
"""The block of what leads: tables may stand below it."""

LOOSE = frozenset({"table", "note"})
"""Kinds that stand where there is room for them."""

Order = tuple[Unit, ...]


def first_order(outlines: Sequence[Outline]) -> Order:
    """Return the units of boxes in the order in which they are read: what leads, rows, all others.

    Tables come last where there are pairs, elsewhere where they came.
    """
    units = units_of(outlines, range(len(outlines)))
    last = any(unit.stand.kind == "pair" for unit in units)
    ranks = {"lead": 0, "row": 1, "table": 3 if last else 2}
    units.sort(key=lambda unit: ranks.get(unit.stand.kind, 2))
    return tuple(
        unit._replace(stand=Stand(LEAD, "lead")) if unit.stand.kind == "lead" else unit
        for unit in units
    )


def fits(outlines: Sequence[Outline], room: Room, tries: int = TRIES) -> Places | None:
    """Return where boxes stand on a sheet at the least gap; None if no order tried fits."""
    found = fitting(outlines, room, tries)
    return found[1] if found is not None else None


def fitting(
    outlines: Sequence[Outline], room: Room, tries: int = TRIES, freedom: int = 2
) -> tuple[Order, Places] | None:
    """Return an order in which a sheet holds boxes, and where they stand then; None if none tried fits.

    Of orders that do not fit, the one least too high starts the next round. Names of boxes and where they were
    drawn play no part: the same boxes are computed once. ``freedom``: see `moves`.
    """
    alike = (one._replace(name="", title="", corner=0j) for one in outlines)
    return _fitting(tuple(alike), room, tries, freedom)


def forget() -> None:
    """Forget which boxes a sheet holds: the next drawing takes as long as that of a scene never seen."""
    _fitting.cache_clear()


@lru_cache(maxsize=KEPT)
def _fitting(
    outlines: tuple[Outline, ...], room: Room, tries: int, freedom: int
) -> tuple[Order, Places] | None:
    gap, best = GAPS[-1], first_order(outlines)
    cut = cutting(best, room, gap)
    if cut is None:
        return None
    over, tried, rounds = excess(best, room, gap), {best}, 0
    found = placed(best, outlines, room, gap) if over <= 0.0 else None
    if found is not None:
        return best, found
    many = len(best) > MANY
    if many and max(cut.share + HOPELESS - FULLEST, cut.share + over / cut.size[1]) > HOPELESS:
        return None
    while len(tried) <= tries:
        if many and over > FAR[min(rounds, len(FAR) - 1)] * cut.size[1]:
            return None
        near = [order for order in moves(best, freedom) if order not in tried][
            : tries + 1 - len(tried)
        ]
        tried |= set(near)
        ranked: list[tuple[float, int]] = []
        for k, order in enumerate(near):
            ranked.append((excess(order, room, gap), k))
            found = placed(order, outlines, room, gap) if ranked[-1][0] <= 0.0 else None
            if found is not None:
                return order, found
        if not ranked or min(ranked)[0] >= over:
            return None
        over, k = min(ranked)
        best, rounds = near[k], rounds + 1
    return None


def composed(outlines: Sequence[Outline], room: Room, tries: int = TRIES) -> Places | None:
    """Return where boxes stand on a sheet, of the orders tried the best; None if none of them fits.

    Single views change places, and then tables come before what they came after, only where the sheet holds
    them no other way, or is left white.
    """
    found: Places | None = None
    for freedom in range(3):
        places = _composed(outlines, room, tries, freedom)
        if places is None:
            continue
        if hole(boxes_of(places, outlines), room) <= WHITE * room.area:
            return places
        found = found or places
    return found


def _composed(outlines: Sequence[Outline], room: Room, tries: int, freedom: int) -> Places | None:
    start = fitting(outlines, room, tries, freedom)
    if start is None:
        return None
    best = start[0]
    found, level = _widest(best, outlines, room, len(GAPS) - 1)
    score = judged(found or {}, outlines, room)
    tried, better = {best}, True
    while better:
        better = False
        for order in moves(best, freedom):
            if order in tried:
                continue
            if len(tried) > tries:
                return found
            tried.add(order)
            places, wide = _widest(order, outlines, room, level)
            less = judged(places, outlines, room) if places is not None else math.inf
            if less < score - 1e-9:
                best, found, score, level, better = order, places, less, wide, True
                break
    return found


def _widest(
    order: Order, outlines: Sequence[Outline], room: Room, level: int
) -> tuple[Places | None, int]:
    """Return where boxes stand at the widest gap, tried from a gap (by its place in `GAPS`) upward."""
    found = placed(order, outlines, room, GAPS[level])
    while found is not None and level > 0:
        wider = placed(order, outlines, room, GAPS[level - 1])
        if wider is None:
            break
        found, level = wider, level - 1
    return found, level


def moves(order: Order, freedom: int) -> Iterator[Order]:
    """Yield the orders one move away: a table elsewhere, rows broken elsewhere, single views exchanged.

    ``freedom``: 0, no view comes before one that it came after; 1, single views may; 2, tables, too.
    """
    yield from _tables(order, freedom)
    yield from _broken(order)
    yield from _exchanged(order, freedom)


def _tables(order: Order, freedom: int) -> Iterator[Order]:
    """Yield orders with a table below what leads or elsewhere behind pairs and rows, a note behind rows."""
    kinds = [unit.stand.kind for unit in order]
    leads = kinds[0] == "lead" and "pair" not in kinds
    for k, unit in enumerate(order):
        if unit.stand.kind not in LOOSE:
            continue
        others = (*order[:k], *order[k + 1 :])
        ahead = ("lead", "row") if unit.stand.kind == "note" else ("lead", "row", "pair")
        first = max((n + 1 for n, one in enumerate(others) if one.stand.kind in ahead), default=0)
        told = any(not one.stand.kind for one in order[:k])
        if leads and unit.stand.below != LEAD and (freedom > 1 or not told):
            under = unit._replace(stand=Stand(kind=unit.stand.kind, below=LEAD))
            yield (order[0], under, *others[1:])
        free = unit._replace(stand=Stand(kind=unit.stand.kind))
        if freedom < 2 and unit.stand.kind == "table":
            first = max(first, k)
        for place in range(first, len(others) + 1):
            yield (*others[:place], free, *others[place:])


def _broken(order: Order) -> Iterator[Order]:
    """Yield orders with a block of rows in one part or in two, the second below the first.

    The last view is a part of its own where something can stand next to it.
    """
    for k, unit in enumerate(order):
        if unit.stand.kind != "row" or len(unit.members) < 3:
            continue
        rest = order[k + 1 :]
        if rest and rest[0].stand == unit.stand:
            unit, rest = _joined(unit, rest[0]), rest[1:]
            yield (*order[:k], unit, *rest)
        last = len(unit.members) - 1
        beside = any(other.stand.kind in LOOSE for other in rest)
        for at in range(2, last + beside):
            yield (*order[:k], _part(unit, 0, at), _part(unit, at, None), *rest)


def _part(unit: Unit, first: int, end: int | None) -> Unit:
    return Unit(unit.members[first:end], unit.sizes[first:end], unit.stand)


def _joined(one: Unit, other: Unit) -> Unit:
    return one._replace(members=one.members + other.members, sizes=one.sizes + other.sizes)


def _exchanged(order: Order, freedom: int) -> Iterator[Order]:
    """Yield orders in which a single view has changed places with the next one or with a table."""
    free = [("table", ""), ("", ""), ("", "table")]
    for k in range(1, len(order) - 1):
        one, other = order[k : k + 2]
        if (one.stand.kind, other.stand.kind) in free[: freedom + 1]:
            yield (*order[:k], other, one, *order[k + 2 :])
