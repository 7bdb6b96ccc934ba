"""The order in which a sheet is read, asked of the places of its views by their names alone.

Written without the package: names as the chapters give them, boxes (left, bottom, right, top) in mm.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

Box = tuple[float, float, float, float]
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
