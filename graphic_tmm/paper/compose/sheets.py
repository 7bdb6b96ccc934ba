"""Several sheets: what one does not hold goes to the next, in order; a set is put right afterwards.

A row of plans is broken between any two of them; a group, its polygon and its equations stay together as long
as a sheet holds them, else the equations stay with the group.
What is left over of an order stands on a sheet of its own only if no other sheet of the set has room for it,
first of all one where the rest of its block stands; an order that takes several sheets fills them evenly.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from graphic_tmm.errors import ViewError
from graphic_tmm.language.said import said
from graphic_tmm.paper.compose import search
from graphic_tmm.paper.compose.homes import SMALL, homed, spared
from graphic_tmm.paper.compose.search import FEW, TRIES, fits
from graphic_tmm.paper.compose.sheet import Places
from graphic_tmm.paper.compose.units import Outline, units_of
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.packing import GAP, Room, free

Rooms = tuple[Room, Room]
"""The room of a first sheet, and of the sheets that follow it."""
FULL = 0.8
"""What fills more of the sheets than this will not stand on fewer."""
UNEVEN = (1.1, 1.2, 1.3)
"""None of several sheets should be filled by so much more than their mean: the first that needs no more."""


class Order(NamedTuple):
    """What a sheet, and those that follow it, shall show: boxes, the rooms, the format.

    ``spared``: whether there may be no such sheet where one small table is all that is left to show.
    """

    outlines: tuple[Outline, ...]
    rooms: Rooms
    format: str
    spared: bool = False


class Shared(NamedTuple):
    """A sheet of a set: the index of its order, its room, and its boxes by their index among all of the set.

    ``alone``: its only box fills it so much that nothing is cut.
    """

    order: int
    room: Room
    boxes: tuple[int, ...]
    alone: bool = False


def composed(orders: Sequence[Order]) -> list[tuple[Shared, Places]]:
    """Return the sheets of a set, each with where its boxes stand, its gaps made equal.

    A pure function of sizes. Boxes are counted through all orders.

    Raises
    ------
    ViewError
        If a view does not fit on an empty sheet; says its size.
    """
    boxes = [outline for order in orders for outline in order.outlines]
    found = []
    there = shared(orders)
    homes = homed(boxes, ((sheet.room, sheet.boxes) for sheet in there))
    homes = spared(boxes, homes, [orders[sheet.order].spared for sheet in there])
    for sheet in (one._replace(boxes=own) for one, (_, own) in zip(there, homes, strict=True)):
        if not sheet.boxes:
            continue
        some = [boxes[k] for k in sheet.boxes]
        places = search.composed(some, sheet.room)
        if sheet.alone or places is None:
            places = {0: _alone(some[0], sheet.room, orders[sheet.order].format)}
        found.append((sheet, {sheet.boxes[k]: _written_place(at) for k, at in places.items()}))
    return found


def _written_place(at: complex) -> complex:
    """Return a place rounded as it is written: a composition read back is the one that was drawn."""
    return complex(round(at.real, 2), round(at.imag, 2))


def shared(orders: Sequence[Order], enough: float = 0.0, *, even: bool = True) -> list[Shared]:
    """Return which boxes stand on which sheet; the number of sheets shows whether sizes fit. See `composed`.

    What a sheet leaves to the next may save one: where sheets are not `FULL`, and more than would be
    ``enough``, that is tried too. Not ``even``: for their number, which is the same if they are about as full.
    """
    found = _shared(orders, even=even)
    if len(found) <= enough:
        return found
    full = sum(_area(order.outlines, range(len(order.outlines))) for order in orders)
    room = sum(sheet.room.area for sheet in found) - max((s.room.area for s in found), default=0.0)
    if len(found) > len(orders) and full < FULL * room:
        other = _shared(orders, shy=True, even=even)
        found = other if len(other) < len(found) else found
    return found


def _shared(orders: Sequence[Order], shy: bool = False, *, even: bool) -> list[Shared]:
    """Return what stands on which sheet; ``shy``: on the first of an order one part less than it holds."""
    boxes = [outline for order in orders for outline in order.outlines]
    sheets: list[Shared] = []
    first = 0
    for index, order in enumerate(orders):
        own = range(first, first + len(order.outlines))
        sheets += _filled(boxes, own, index, order, shy=shy)
        first += len(order.outlines)
    sheets = _gathered(boxes, sheets)
    if not even:
        return sheets
    return [
        sheet
        for index, order in enumerate(orders)
        for sheet in _evenly(boxes, [s for s in sheets if s.order == index], index, order)
    ]


def _evenly(
    boxes: Sequence[Outline], sheets: list[Shared], index: int, order: Order
) -> list[Shared]:
    """Return the sheets of an order, of several all about equally full if that takes no more of them."""
    if len(sheets) < 2:
        return sheets
    mean = sum(_area(boxes, one.boxes) for one in sheets) / len(sheets)
    own = [k for one in sheets for k in one.boxes]
    tried = (_filled(boxes, own, index, order, most * mean) for most in UNEVEN)
    return next((even for even in tried if len(even) == len(sheets)), sheets)


def _filled(
    boxes: Sequence[Outline],
    own: Sequence[int],
    index: int,
    order: Order,
    most: float | None = None,
    shy: bool = False,
) -> list[Shared]:
    """Return the sheets of an order, each as full as it can be, or as full as ``most`` (mm²)."""
    waiting = [k for unit in units_of(boxes, own) for k in unit.members]
    found: list[Shared] = []
    while waiting:
        room = order.rooms[1 if found else 0]
        taken = _taken(boxes, waiting, room, most)
        if shy and not found and len(taken) < len(waiting):
            taken = _less(boxes, taken)
        if not taken:
            _alone(boxes[waiting[0]], room, order.format)
        found.append(Shared(index, room, tuple(taken or waiting[:1]), not taken))
        waiting = [k for k in waiting if k not in found[-1].boxes]
    return found


def _taken(
    boxes: Sequence[Outline], waiting: Sequence[int], room: Room, most: float | None
) -> list[int]:
    """Return which of the waiting boxes a sheet holds: as many in order as fit, and tables behind them."""
    ends = _ends([boxes[k] for k in waiting])

    def held(chosen: Sequence[int], tried: int = FEW) -> bool:
        if most is not None and len(chosen) > ends[0] and _area(boxes, chosen) > most:
            return False
        return fits([boxes[k] for k in chosen], room, tried) is not None

    if held(waiting, TRIES):
        return list(waiting)
    low, high = 0, len(ends) - 1
    while low < high:
        middle = (low + high + 1) // 2
        if held(waiting[: ends[middle - 1]]):
            low = middle
        else:
            high = middle - 1
    while low < len(ends) - 1 and held(waiting[: ends[low]], TRIES):
        low += 1
    if not low and not held(waiting[:1]):
        return []
    taken = list(waiting[: ends[low - 1] if low else 1])
    tables = [k for k in waiting[len(taken) :] if boxes[k].stand.kind == "table"]
    # of a unit that is too large the equations go with the group sooner than the polygon
    for k in (*(() if low else reversed(waiting[1 : ends[0]])), *tables):
        taken += [k] if held([*taken, k]) else []
    return taken


def _less(boxes: Sequence[Outline], taken: list[int]) -> list[int]:
    """Return what a sheet takes without the last that can be parted from it, if that is not all of it."""
    ends = _ends([boxes[k] for k in taken])
    return taken[: ends[-2]] if len(ends) > 1 else taken


def _ends(waiting: Sequence[Outline]) -> list[int]:
    """Return where the boxes that wait may be parted: not between a group and its polygon."""
    stands = [one.stand for one in waiting]
    return [
        n + 1
        for n, stand in enumerate(stands)
        if stand.kind != "pair" or n + 1 == len(stands) or stands[n + 1].block != stand.block
    ]


def _gathered(boxes: Sequence[Outline], sheets: list[Shared]) -> list[Shared]:
    """Return the sheets without those that hold little which has room on others."""
    for one in sorted(sheets, key=lambda sheet: _area(boxes, sheet.boxes)):
        if one not in sheets:  # it has taken up what was left over of another one
            continue
        follows = any(sheet.order == one.order for sheet in sheets[: sheets.index(one)])
        if not follows or _area(boxes, one.boxes) > SMALL * one.room.area:
            continue
        others = _moved(boxes, sheets, sheets.index(one))
        sheets = sheets if others is None else others
    return sheets


def _moved(boxes: Sequence[Outline], sheets: list[Shared], here: int) -> list[Shared] | None:
    """Return the other sheets that have taken up the boxes of one; None if they have no room for all of them.

    Tables and notes go wherever there is room, all others to the sheet before: they stay in order.
    """
    one, others = sheets[here], [*sheets[:here], *sheets[here + 1 :]]
    for unit in units_of(boxes, one.boxes):
        near = sorted(
            range(len(others)), key=lambda n: _strange(boxes, unit.members, one, others[n])
        )
        for place in near if unit.stand.kind in search.LOOSE else [here - 1]:
            sheet = others[place]
            more = (*sheet.boxes, *unit.members)
            more = tuple(sorted(more)) if sheet.order == one.order else more
            held = not sheet.alone and fits([boxes[k] for k in more], sheet.room)
            if held:
                others[place] = sheet._replace(boxes=more)
                break
        else:
            return None
    return others


def _strange(
    boxes: Sequence[Outline], members: Iterable[int], one: Shared, other: Shared
) -> tuple[bool, int]:
    """Return how far from home boxes are on another sheet: none of their block there?, how many orders off."""
    blocks = {boxes[k].stand.block for k in members} - {""}
    there = {boxes[k].stand.block for k in other.boxes}
    return not blocks & there, abs(other.order - one.order)


def _area(boxes: Sequence[Outline], chosen: Iterable[int]) -> float:
    return sum(boxes[k].width * boxes[k].height for k in chosen)


def _alone(outline: Outline, room: Room, format: str) -> complex:
    """Return where a box stands alone on a sheet, as high up and as far left as it can."""
    held = [
        f
        for f in free(room)
        if f[2] - f[0] >= outline.width - 1e-9 and f[3] - f[1] >= outline.height - 1e-9
    ]
    if not held:
        raise too_large(outline, room, format)
    best = min(held, key=lambda f: (-round(f[3], 3), round(f[0], 3)))
    return complex(best[0], best[3] - outline.height)


def too_large(outline: Outline, room: Room, format: str) -> ViewError:
    """Return the error of a view that an empty sheet does not hold."""
    inner = room.inner
    says = said(
        "the view '{name}' is {wide:.0f}×{high:.0f} mm and does not fit on {format} (room "
        "{inner:.0f}×{inner2:.0f} mm)",
        name=outline.title or outline.name,
        wide=outline.width,
        high=outline.height,
        format=format,
        inner=inner[2] - inner[0] - 2 * GAP,
        inner2=inner[3] - inner[1] - 2 * GAP,
    )
    return ViewError(says, outline.name, (outline.width, outline.height), outline.shows)


def pack(views: Sequence[Drawing], rooms: Rooms, format: str) -> list[list[Drawing]]:
    """Return views moved to where they stand, sheet by sheet; see `composed`."""
    order = Order(tuple(Outline.of(view) for view in views), rooms, format)
    return [
        [moved(views[k], order.outlines[k], at) for k, at in sorted(places.items())]
        for _, places in composed([order])
    ]


def moved(view: Drawing, outline: Outline, at: complex) -> Drawing:
    """Return a view with the lower left corner of its box at a place; it does not come apart any more."""
    return view.moved(at - outline.corner)._replace(apart=None)
