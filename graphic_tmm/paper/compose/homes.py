"""A set put right when all its sheets are known: equations go to their plans, a table alone to where room is.

Equations stand where a scene orders them; their plans may stand on another sheet. They go there if that sheet
has room for them and the emptier of the two becomes fuller: a sheet is not emptied for it. Where one small
table is all that is left of a sheet that more was ordered for, it goes to the nearest sheet that holds it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from graphic_tmm.paper.compose.search import LOOSE, fits
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.packing import Room

NOTE = "note"
"""The kind of what is said of a block."""
SMALL = 0.3
"""What fills less of a sheet than this is no sheet of its own if it can stand elsewhere."""

Held = tuple[Room, tuple[int, ...]]
"""A sheet: its room, and its boxes by their index among all of the set."""


def homed(boxes: Sequence[Outline], sheets: Iterable[Held]) -> list[Held]:
    """Return the sheets of a set, in order, with notes where their blocks stand."""
    found = list(sheets)
    for here, (_, chosen) in enumerate(tuple(found)):
        for k in chosen:
            there = _home(boxes, k, found) if boxes[k].stand.kind == NOTE else here
            if there != here:
                found = _sent(boxes, found, k, (here, there))
    return found


def spared(boxes: Sequence[Outline], sheets: Iterable[Held], may: Sequence[bool]) -> list[Held]:
    """Return sheets of which those that ``may`` be spared show nothing if one small table was all of them."""
    found = list(sheets)
    for here, (room, chosen) in enumerate(found):
        alone = len(chosen) == 1 and boxes[chosen[0]].stand.kind in LOOSE
        if not (may[here] and alone and _fill(boxes, chosen, room) < SMALL):
            continue
        for there in sorted(range(len(found)), key=lambda n: abs(n - here)):
            other, taken = found[there]
            more = (*taken, *chosen)
            if there != here and taken and fits([boxes[k] for k in more], other):
                found[here], found[there] = (room, ()), (other, more)
                break
    return found


def _home(boxes: Sequence[Outline], note: int, sheets: Sequence[Held]) -> int:
    """Return on which sheet most of the block of a note stands; its own if any does there, or nowhere."""
    block = boxes[note].stand.block
    counts = [
        sum(k != note and boxes[k].stand.block == block for k in chosen) for _, chosen in sheets
    ]
    own = next(n for n, (_, chosen) in enumerate(sheets) if note in chosen)
    return own if counts[own] or not any(counts) else counts.index(max(counts))


def _sent(
    boxes: Sequence[Outline], sheets: list[Held], note: int, way: tuple[int, int]
) -> list[Held]:
    """Return sheets with a note sent from one to another, if that holds it and the emptier becomes fuller."""
    (left, before), (room, taken) = (sheets[n] for n in way)
    less, more = tuple(k for k in before if k != note), (*taken, note)
    now = min(_fill(boxes, before, left), _fill(boxes, taken, room))
    if min(_fill(boxes, less, left), _fill(boxes, more, room)) <= now:
        return sheets
    if fits([boxes[k] for k in more], room) is None:
        return sheets
    found = list(sheets)
    found[way[0]], found[way[1]] = (left, less), (room, more)
    return found


def _fill(boxes: Sequence[Outline], chosen: Sequence[int], room: Room) -> float:
    return sum(boxes[k].width * boxes[k].height for k in chosen) / room.area
