"""Several sheets: what one does not hold goes to the next, in order, tables wherever there is room for them.

A row of plans is broken between any two of them; a polygon stays with its group as long as a sheet holds both.
"""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.errors import ViewError
from graphic_tmm.language.said import said
from graphic_tmm.paper.compose import search
from graphic_tmm.paper.compose.search import fits
from graphic_tmm.paper.compose.sheet import Places
from graphic_tmm.paper.compose.units import Outline, units_of
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.packing import GAP, Room, free

Rooms = tuple[Room, Room]
"""The room of a first sheet, and of the sheets that follow it."""


def composed(
    outlines: Sequence[Outline], rooms: Rooms, format: str, *, polished: bool = False
) -> list[Places]:
    """Return where boxes stand, sheet by sheet; fast, or ``polished`` with gaps as equal as they can be.

    A pure function of sizes: what stands on a sheet is the same either way.

    Raises
    ------
    ViewError
        If a view does not fit on an empty sheet; says its size.
    """
    waiting = [k for unit in units_of(outlines, range(len(outlines))) for k in unit.members]
    found: list[Places] = []
    while waiting:
        room = rooms[1 if found else 0]
        taken = _taken(outlines, waiting, room)
        if not taken:
            found.append({waiting[0]: _alone(outlines[waiting[0]], room, format)})
            taken = waiting[:1]
        else:
            place = search.composed if polished else fits
            found.append(_numbered(place([outlines[k] for k in taken], room), taken))
        waiting = [k for k in waiting if k not in set(taken)]
    return found


def _numbered(places: Places | None, chosen: Sequence[int]) -> Places:
    """Return places of some of the boxes, by the index among all."""
    assert places is not None
    return {chosen[k]: at for k, at in places.items()}


def _taken(outlines: Sequence[Outline], waiting: Sequence[int], room: Room) -> list[int]:
    """Return what of the views that wait a sheet holds: as many in order as it can, and tables behind them."""

    def held(chosen: Sequence[int]) -> bool:
        return fits([outlines[k] for k in chosen], room) is not None

    ends = _ends(outlines, waiting)
    low, high = 0, len(ends)
    while low < high:
        middle = (low + high + 1) // 2
        if held(waiting[: ends[middle - 1]]):
            low = middle
        else:
            high = middle - 1
    taken = list(waiting[: ends[low - 1]]) if low else []
    if not taken and ends[0] > 1 and held(waiting[:1]):
        taken = list(waiting[:1])
    for k in waiting[len(taken) :]:
        if taken and outlines[k].stand.kind == "table" and held([*taken, k]):
            taken.append(k)
    return taken


def _ends(outlines: Sequence[Outline], waiting: Sequence[int]) -> list[int]:
    """Return where the views that wait may be broken: behind each unit, and each plan of a row."""
    stands = [outlines[k].stand for k in waiting]
    return [
        n + 1
        for n, stand in enumerate(stands)
        if stand.kind != "pair"
        or n + 1 == len(stands)
        or stands[n + 1].block != stand.block
        or not stand.block
    ]


def _alone(outline: Outline, room: Room, format: str) -> complex:
    """Return where a view stands alone on a sheet, as high up and as far left as it can."""
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
    return ViewError(says, outline.name, (outline.width, outline.height))


def pack(views: Sequence[Drawing], rooms: Rooms, format: str) -> list[list[Drawing]]:
    """Return views moved to where they stand, sheet by sheet; see `composed`."""
    outlines = [Outline.of(view) for view in views]
    return [
        [views[k].moved(at - outlines[k].corner)._replace(apart=None) for k, at in sheet.items()]
        for sheet in composed(outlines, rooms, format, polished=True)
    ]
