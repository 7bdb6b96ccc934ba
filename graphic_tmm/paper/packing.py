"""Views onto sheets: each view takes a free rectangle; what is left over goes to the next sheet.

The plan of positions stands at the left, plans in rows from the top, tables along the bottom.

Layout only moves views; nothing is scaled after μ is chosen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import shapely

from graphic_tmm.errors import SheetError, ViewError
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.labels import box, shape

GAP = 7.0
"""Clear space between views, and between a view and the frame, mm."""

Box = tuple[float, float, float, float]


class Room(NamedTuple):
    """Where views may stand on a sheet: the inner frame and the boxes taken of it."""

    inner: Box
    occupied: tuple[Box, ...]

    @property
    def within(self) -> Within:
        """What the sheet offers a view while nothing else stands on it."""
        return Within(tuple((f[2] - f[0], f[3] - f[1]) for f in _free(self)))


def bounds(drawing: Drawing) -> Box:
    """Return the cell of a drawing, or the box of its ink, mm: strokes without their width, letters with it.

    Raises SheetError if nothing of it can be drawn.
    """
    if drawing.cell is not None:
        return drawing.cell
    shapes = [shape(stroke) for stroke in drawing.strokes] + [
        box(label) for label in drawing.labels
    ]
    if not shapes:
        raise SheetError(
            said("nothing of the view '{title}' can be drawn: change its data", title=drawing.title)
        )
    left, bottom, right, top = shapely.total_bounds(shapes)
    return float(left), float(bottom), float(right), float(top)


def share(view: Drawing, within: Within) -> float:
    """Return how many times larger a view may be on a sheet of its own; below 1 it does not fit."""
    left, low, right, top = bounds(view)
    return within.share(right - left, top - low) * (1 + 1e-12)


def holds(within: Within, *views: Drawing) -> bool:
    """Whether a sheet holds each of the views, by itself."""
    return all(share(view, within) >= 1.0 for view in views)


def settled(view: Drawing, within: Within) -> list[Drawing]:
    """Return a view as it is where an empty sheet holds it, else what it comes apart into."""
    if view.apart is None or holds(within, view):
        return [view]
    return [part for one in view.apart(within) for part in settled(one, within)]


def pack(views: Sequence[Drawing], rooms: tuple[Room, Room], format: str) -> list[list[Drawing]]:
    """Return the views placed, sheet by sheet; ``rooms``: of the first sheet, and of those after it.

    Raises
    ------
    ViewError
        If a view does not fit on an empty sheet; says its size.
    """
    sheets: list[list[Drawing]] = []
    free: list[Box] = []
    # measured once: what has been placed takes the box that it was given
    waiting = [(view, bounds(view)) for view in views]
    while waiting:
        room = rooms[1 if sheets else 0]
        free = _free(room)
        placed: list[Drawing] = []
        edge = 0.0
        left: list[tuple[Drawing, Box]] = []
        for view, extent in waiting:
            by = _take(free, view, extent, edge) if not left or _small(view) else None
            if by is None:
                left.append((view, extent))
                continue
            placed.append(view.moved(by)._replace(apart=None))
            if view.leads:
                edge = max(edge, extent[2] + by.real + GAP)
        if not placed:
            raise _too_large(left[0][0], room, format)
        sheets.append(placed)
        waiting = left
    return sheets


def _beside(free: Sequence[Box], edge: float) -> list[Box]:
    """Return what of the free rectangles stands beside what leads, not below it."""
    return [(max(f[0], edge), *f[1:]) for f in free]


def _small(view: Drawing) -> bool:
    """Whether a view may stand before a larger one that has to wait: tables may, plans keep their order."""
    return view.name.startswith("table")


def _free(room: Room) -> list[Box]:
    left, bottom, right, top = room.inner
    free = [(left + GAP, bottom + GAP, right - GAP, top - GAP)]
    for taken in room.occupied:
        free = _without(free, (taken[0] - GAP, taken[1] - GAP, taken[2] + GAP, taken[3] + GAP))
    return free


def _take(free: list[Box], view: Drawing, extent: Box, edge: float) -> complex | None:
    """Return by how much a view moves into a free rectangle that holds it; None if none does."""
    left, bottom, right, top = extent
    width, height = right - left, top - bottom

    def fitting(boxes: Sequence[Box]) -> list[Box]:
        return [f for f in boxes if f[2] - f[0] >= width - 1e-9 and f[3] - f[1] >= height - 1e-9]

    fits = fitting(free)
    if not fits:
        return None
    if view.name.startswith("table"):
        best = min(fits, key=lambda f: (round(f[1], 3), round(f[0], 3)))
        x, y = best[0], best[1]
    else:
        order = (0, 3) if view.leads else (3, 0)
        fits = fitting(_beside(free, edge)) or fits
        best = min(fits, key=lambda f: [round(f[k] if k == 0 else -f[k], 3) for k in order])
        x, y = best[0], best[3] - height
    free[:] = _without(free, (x - GAP, y - GAP, x + width + GAP, y + height + GAP))
    return complex(x - left, y - bottom)


def _without(free: Sequence[Box], taken: Box) -> list[Box]:
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


def _too_large(view: Drawing, room: Room, format: str) -> ViewError:
    left, bottom, right, top = bounds(view)
    wide, high, inner = right - left, top - bottom, room.inner
    says = said(
        "the view '{name}' is {wide:.0f}×{high:.0f} mm and does not fit on {format} (room "
        "{inner:.0f}×{inner2:.0f} mm)",
        name=view.title or view.name,
        wide=wide,
        high=high,
        format=format,
        inner=inner[2] - inner[0] - 2 * GAP,
        inner2=inner[3] - inner[1] - 2 * GAP,
    )
    return ViewError(says, view.name, (wide, high))
