"""The order in which a sheet is read, asked of the places of its views by their names alone.

Written without the package: names as the chapters give them, boxes (left, bottom, right, top) in mm.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

Box = tuple[float, float, float, float]
Size = tuple[float, float]
NEAR = 25.0
"""A polygon stands no farther than this from its group, mm."""
LINE = 0.05
"""Captions that begin within so many mm stand on one line."""


def faults(
    boxes: Mapping[str, Box], bases: Mapping[str, float], names: Sequence[str]
) -> Iterator[str]:
    """Yield what a reader of a sheet would stumble over.

    ``bases``: the height at which a view ends and its caption begins; ``names``: positions in their order.
    """
    yield from _lead(boxes)
    for plan in ("velocities", "accelerations"):
        row = [view for k in names if (view := f"{plan}-{k}") in boxes]
        yield from _rows(boxes, bases, row)
    yield from _under(boxes)
    yield from _pairs(boxes)


def _lead(boxes: Mapping[str, Box]) -> Iterator[str]:
    if "positions" not in boxes:
        return
    lead = boxes["positions"]
    for name, box in boxes.items():
        beside = box[2] < lead[0] - LINE and box[3] > lead[1] + LINE
        if beside or (box[1] > lead[3] + LINE and box[0] < lead[2]):
            yield f"{name} stands before the plan of positions"


def _rows(
    boxes: Mapping[str, Box], bases: Mapping[str, float], row: Sequence[str]
) -> Iterator[str]:
    """Left to right, top to bottom, captions of a row on one line."""
    for one, two in pairwise(row):
        beside = boxes[two][0] >= boxes[one][2] - LINE
        on_line = abs(bases[one] - bases[two]) <= LINE
        below = boxes[two][3] <= boxes[one][1] + LINE
        if not (below or (beside and on_line)):
            yield f"{two} stands neither beside {one}, on its line, nor below it"


def _under(boxes: Mapping[str, Box]) -> Iterator[str]:
    above = [box for name, box in boxes.items() if re.match("velocities(-|$)", name)]
    for name, box in boxes.items():
        if re.match("accelerations(-|$)", name) and any(box[3] > one[1] + LINE for one in above):
            yield f"{name} stands beside or above a plan of velocities"


def _pairs(boxes: Mapping[str, Box]) -> Iterator[str]:
    for name, box in boxes.items():
        polygon = boxes.get(name.replace("group-", "forces-", 1))
        if name.startswith("group-") and polygon is not None and gap(box, polygon) > NEAR:
            yield f"the polygon of {name} is {gap(box, polygon):.0f} mm off"


def gap(one: Box, other: Box) -> float:
    """Return the way from one box to another, mm."""
    across = max(one[0] - other[2], other[0] - one[2], 0.0)
    down = max(one[1] - other[3], other[1] - one[3], 0.0)
    return max(across, down)


class Part(NamedTuple):
    """A figure, a polygon or equations of a force sheet: unit, name, sheet, box, height of its caption."""

    unit: str
    name: str
    sheet: int
    box: Box
    foot: float = 0.0


PARTS = ("group", "lever", "forces", "equations")
"""What a unit consists of, in order."""
GAP = 7.0
"""Views stand no nearer to one another and to the frame than this, mm."""


def parts_of(
    sheets: Sequence[Mapping[str, Box]],
    names: Sequence[str],
    feet: Mapping[str, float] = MappingProxyType({}),
) -> list[Part]:
    """Return what stands on force sheets as it should be read: by positions, by groups from the last put on.

    ``names``: positions in their order; ``feet``: heights of captions by view, mm. After the groups the crank,
    then the lever; of each its figure, polygon, equations.
    """
    found: list[tuple[tuple[int, ...], Part]] = []
    for n, boxes in enumerate(sheets):
        for name, box in boxes.items():
            told = re.fullmatch(r"(group|forces|equations)-([\d-]+|lever)-([^-]+)", name)
            told = told or re.fullmatch(r"(lever)()-([^-]+)", name)
            if told is None or told[3] not in names:
                continue
            links = [int(k) for k in re.findall(r"\d+", told[2])]
            last = -max(links) if links else 0
            key = (names.index(told[3]), last, PARTS.index(told[1]))
            found.append(
                (key, Part(f"{told[2] or 'lever'}-{told[3]}", name, n, box, feet.get(name, 0.0)))
            )
    return [part for _, part in sorted(found)]


def forward(one: Part, two: Part) -> bool:
    """Whether of two parts the second is read after the first: on a later sheet, or right of or below it."""
    if one.sheet != two.sheet:
        return two.sheet > one.sheet
    return two.box[0] >= one.box[2] - LINE or two.box[3] <= one.box[1] + LINE


def kept_apart(parts: Sequence[Part], rooms: Sequence[Sequence[Size]]) -> list[str]:
    """Return the equations, and polygons, that stand on another sheet than their figure though it holds both.

    ``rooms``: the free rectangles of each sheet, mm. A polygon may leave where a sheet does not hold all three.
    """
    found = []
    for name in dict.fromkeys(part.unit for part in parts):
        unit = [part for part in parts if part.unit == name]
        figure, *others = unit
        for part in others:
            there = [figure, part] if "equations" in part.name else unit
            apart = part.sheet != figure.sheet
            if apart and any(_held(there, size) for size in rooms[figure.sheet]):
                found.append(part.name)
    return found


def _held(parts: Sequence[Part], room: Size) -> bool:
    """Whether a free rectangle holds parts one below the other, or beside one another on one caption line."""
    wide = [part.box[2] - part.box[0] + GAP for part in parts]
    high = [part.box[3] - part.box[1] + GAP for part in parts]
    across, down = room[0] + GAP, room[1] + GAP
    below = max(wide) <= across and sum(high) <= down
    foot = max(part.foot for part in parts)
    line = max(h - part.foot for h, part in zip(high, parts, strict=True)) + foot
    return below or (sum(wide) <= across and line <= down)
