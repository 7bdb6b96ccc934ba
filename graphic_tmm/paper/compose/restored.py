"""Boxes put where a composition has them; what does not fit there any more stands as near as it can."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.paper.compose.sheet import Places
from graphic_tmm.paper.compose.sheets import Order, Shared
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.packing import GAP, Box, Room, free, without

NEAR = 0.02
"""Places are written to hundredths of a mm: boxes that overlap by less than this touch."""


class Restored(NamedTuple):
    """Sheets as a composition has them; what was put elsewhere, and what the composition does not name."""

    sheets: tuple[tuple[Shared, Places], ...]
    moved: tuple[int, ...] = ()
    added: tuple[int, ...] = ()


def restored(
    orders: Sequence[Order], wanted: Sequence[tuple[int, Mapping[int, complex]]]
) -> Restored | None:
    """Return sheets as they are ``wanted``: of each the index of its order, and corners of boxes (mm).

    Boxes are counted through all orders. None if a box has no room on any sheet of its order.
    """
    boxes = [outline for order in orders for outline in order.outlines]
    home = [n for n, order in enumerate(orders) for _ in order.outlines]
    rooms = _rooms(orders, [order for order, _ in wanted])
    sheets: list[Places] = []
    loose: list[tuple[int, int | None, complex]] = []
    for n, (_, places) in enumerate(wanted):
        stands: Places = {}
        for k, at in places.items():
            if _clear(_box(boxes[k], at), rooms[n], [_box(boxes[j], stands[j]) for j in stands]):
                stands[k] = at
            else:
                loose.append((k, n, at))
        sheets.append(stands)
    named = {k for _, places in wanted for k in places}
    added = [k for k in range(len(boxes)) if k not in named]
    loose += [(k, None, 0j) for k in added]
    for k, on, at in loose:
        own = [n for n, (order, _) in enumerate(wanted) if order == home[k]]
        for n in dict.fromkeys([*([] if on is None else [on]), *own]):
            spot = _nearest(
                boxes[k], at, rooms[n], [_box(boxes[j], z) for j, z in sheets[n].items()]
            )
            if spot is not None:
                sheets[n][k] = spot
                break
        else:
            return None
    found = tuple(
        (Shared(order, room, tuple(places)), places)
        for (order, _), room, places in zip(wanted, rooms, sheets, strict=True)
    )
    return Restored(found, tuple(k for k, on, _ in loose if on is not None), tuple(added))


def _rooms(orders: Sequence[Order], wanted: Sequence[int]) -> list[Room]:
    """Return the rooms of sheets: that of an order's first sheet, or of those that follow it."""
    return [orders[n].rooms[min(wanted[:k].count(n), 1)] for k, n in enumerate(wanted)]


def _box(outline: Outline, at: complex) -> Box:
    return at.real, at.imag, at.real + outline.width, at.imag + outline.height


def _clear(box: Box, room: Room, others: Sequence[Box]) -> bool:
    """Whether a box stands within the frame, on nothing else."""
    inner = room.inner
    inside = box[0] >= inner[0] - NEAR and box[1] >= inner[1] - NEAR
    inside = inside and box[2] <= inner[2] + NEAR and box[3] <= inner[3] + NEAR
    return inside and not any(
        min(box[2], o[2]) - max(box[0], o[0]) > NEAR
        and min(box[3], o[3]) - max(box[1], o[1]) > NEAR
        for o in (*room.occupied, *others)
    )


def _nearest(outline: Outline, at: complex, room: Room, others: Sequence[Box]) -> complex | None:
    """Return the corner nearest to a place at which a box stands free; None if there is no room for it."""
    white = free(room)
    for box in others:
        white = without(white, (box[0] - GAP, box[1] - GAP, box[2] + GAP, box[3] + GAP))
    spots = [
        complex(
            min(max(at.real, f[0]), f[2] - outline.width),
            min(max(at.imag, f[1]), f[3] - outline.height),
        )
        for f in white
        if f[2] - f[0] >= outline.width and f[3] - f[1] >= outline.height
    ]
    return min(spots, key=lambda z: (round(abs(z - at), 3), z.real, z.imag), default=None)
