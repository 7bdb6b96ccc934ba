"""A set put right when all its sheets are known: what is said of a block goes to where the block stands.

Equations stand where a scene orders them; their plans may stand on another sheet. They go there if that sheet
has room for them and the emptier of the two becomes fuller: a sheet is not emptied for it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from graphic_tmm.paper.compose.search import QUICK, fits
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.packing import Room

NOTE = "note"
"""The kind of what is said of a block."""

Held = tuple[Room, tuple[int, ...]]
"""A sheet: its room, and its boxes by their index among all of the set."""


def homed(boxes: Sequence[Outline], sheets: Iterable[Held], tries: int = QUICK) -> list[Held]:
    """Return the sheets of a set, in order, with notes where their blocks stand."""
    found = list(sheets)
    for here, (_, chosen) in enumerate(tuple(found)):
        for k in chosen:
            there = _home(boxes, k, found) if boxes[k].stand.kind == NOTE else here
            if there != here:
                found = _sent(boxes, found, k, (here, there), tries)
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
    boxes: Sequence[Outline], sheets: list[Held], note: int, way: tuple[int, int], tries: int
) -> list[Held]:
    """Return sheets with a note sent from one to another, if that holds it and the emptier becomes fuller."""
    (left, before), (room, taken) = (sheets[n] for n in way)
    less, more = tuple(k for k in before if k != note), (*taken, note)
    now = min(_fill(boxes, before, left), _fill(boxes, taken, room))
    if min(_fill(boxes, less, left), _fill(boxes, more, room)) <= now:
        return sheets
    if fits([boxes[k] for k in more], room, tries) is None:
        return sheets
    found = list(sheets)
    found[way[0]], found[way[1]] = (left, less), (room, more)
    return found


def _fill(boxes: Sequence[Outline], chosen: Sequence[int], room: Room) -> float:
    return sum(boxes[k].width * boxes[k].height for k in chosen) / room.area
