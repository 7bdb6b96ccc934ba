"""What views take and sheets offer: the box of a view, the room of a sheet, whether it holds what it shall."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Stroke, Within
from graphic_tmm.paper.shapes import corners, outline

GAP = 7.0
"""Clear space between views, and between a view and the frame, mm."""

Box = tuple[float, float, float, float]


class Room(NamedTuple):
    """Where views may stand on a sheet: the inner frame and the boxes taken of it."""

    inner: Box
    occupied: tuple[Box, ...]

    @property
    def area(self) -> float:
        """What is free, mm²."""
        left, bottom, right, top = self.inner
        taken = sum((box[2] - box[0]) * (box[3] - box[1]) for box in self.occupied)
        return (right - left) * (top - bottom) - taken

    @property
    def within(self) -> Within:
        """What the sheet offers a view while nothing else stands on it."""
        return Within(tuple((f[2] - f[0], f[3] - f[1]) for f in free(self)))


def bounds(drawing: Drawing) -> Box:
    """Return the cell of a drawing, or the box of its ink, mm: strokes without their width, letters with it.

    Raises SheetError if nothing of it can be drawn.
    """
    if drawing.cell is not None:
        return drawing.cell
    x, y = list[float](), list[float]()
    for stroke in drawing.strokes:
        if isinstance(stroke, Stroke) and not any([bulge for _, _, bulge in stroke.path]):
            x += [vertex[0] for vertex in stroke.path]
            y += [vertex[1] for vertex in stroke.path]
        else:
            spots = outline(stroke)
            x += [spot.real for spot in spots]
            y += [spot.imag for spot in spots]
    for label in drawing.labels:
        spots = corners(label)
        x += [spot.real for spot in spots]
        y += [spot.imag for spot in spots]
    if not x:
        raise SheetError(
            said("nothing of the view '{title}' can be drawn: change its data", title=drawing.title)
        )
    return min(x), min(y), max(x), max(y)


def share(view: Drawing, within: Within) -> float:
    """Return how many times larger a view may be on a sheet of its own; below 1 it does not fit."""
    left, low, right, top = bounds(view)
    return within.share(right - left, top - low) * (1 + 1e-12)


def holds(within: Within, *views: Drawing) -> bool:
    """Whether a sheet holds each of the views, by itself."""
    return all(share(view, within) >= 1.0 for view in views)


def in_pieces(view: Drawing, within: Within) -> list[Drawing]:
    """Return a view as it is where an empty sheet holds it, else what it comes apart into."""
    if view.apart is None or holds(within, view):
        return [view]
    parts = [part for one in view.apart(within) for part in in_pieces(one, within)]
    return [one if one.stand.kind else one._replace(stand=view.stand) for one in parts]


def free(room: Room) -> list[Box]:
    """Return the largest free rectangles of an empty sheet, a gap away from all that is taken."""
    left, bottom, right, top = room.inner
    found = [(left + GAP, bottom + GAP, right - GAP, top - GAP)]
    for taken in room.occupied:
        found = without(found, (taken[0] - GAP, taken[1] - GAP, taken[2] + GAP, taken[3] + GAP))
    return found


def without(free: Sequence[Box], taken: Box) -> list[Box]:
    """Return the maximal free rectangles that are left when a box is taken."""
    left: list[Box] = []
    for f in free:
        if taken[0] >= f[2] or taken[2] <= f[0] or taken[1] >= f[3] or taken[3] <= f[1]:
            left.append(f)
            continue
        parts = (
            (f[0], f[1], taken[0], f[3]),
            (taken[2], f[1], f[2], f[3]),
            (f[0], f[1], f[2], taken[1]),
            (f[0], taken[3], f[2], f[3]),
        )
        left += [p for p in parts if p[2] - p[0] > 1.0 and p[3] - p[1] > 1.0]
    return [
        f
        for k, f in enumerate(left)
        if not any(_inside(f, g) and (f != g or j < k) for j, g in enumerate(left) if j != k)
    ]


def _inside(f: Box, g: Box) -> bool:
    return g[0] <= f[0] and g[1] <= f[1] and g[2] >= f[2] and g[3] >= f[3]
