"""Boxes of views, and the units that they stand in: what a unit needs, and where its boxes stand in a cell."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import NamedTuple

from graphic_tmm.paper.drawing import Drawing, Heading, Stand
from graphic_tmm.paper.headings import boxes, room
from graphic_tmm.paper.packing import Box, bounds

WIDEST = 25.0
"""A wider gap than this between views, mm, reads as scattered."""
PAIRED = 20.0
"""Between what belongs together, mm, there is no wider gap than this: a polygon and its group."""

Size = tuple[float, float]
Sized = tuple[float, float, float]
"""Width and height of a box, and how much of the height is its caption, mm."""


class Outline(NamedTuple):
    """A view as a box, mm, and how it stands; ``foot``: of its height, what its caption takes.

    ``title``: what people call it; ``corner``: where its lower left corner is drawn; ``shows``: see `Drawing`.
    """

    name: str
    width: float
    height: float
    stand: Stand = Stand()
    foot: float = 0.0
    title: str = ""
    corner: complex = 0j
    shows: tuple[str, ...] = ()

    @classmethod
    def of(cls, view: Drawing) -> Outline:
        """Return the outline of a view; raises SheetError if nothing of it can be drawn."""
        left, bottom, right, top = bounds(view)
        corner = complex(left, bottom)
        size = (right - left, top - bottom)
        return cls(view.name, *size, view.stand, view.foot, view.title, corner, view.shows)


class Unit(NamedTuple):
    """Boxes that stand together: their indices in order, their sizes (mm), how they stand."""

    members: tuple[int, ...]
    sizes: tuple[Sized, ...]
    stand: Stand = Stand()


class Shape(NamedTuple):
    """Size of a unit by the number of boxes in a row: width, height and room kept free before them, mm."""

    width: float
    height: float
    rows: tuple[int, ...]
    free: Size = (0.0, 0.0)


def units_of(outlines: Sequence[Outline], chosen: Iterable[int]) -> list[Unit]:
    """Return the units that some of the outlines make: a block stands where its first view does.

    What is drawn position by position comes so, all of one before the next; notes come behind their rows.
    """
    blocks: dict[str, list[int]] = {}
    for k in chosen:
        blocks.setdefault(outlines[k].stand.block or f"\0{k}", []).append(k)
    for members in blocks.values():
        members.sort(key=lambda k: outlines[k].stand.kind == "note")
    units = [
        Unit(
            tuple(members),
            tuple((o.width, o.height, o.foot) for o in (outlines[k] for k in members)),
            outlines[members[0]].stand,
        )
        for members in blocks.values()
    ]
    pairs = [unit for unit in units if unit.stand.kind == "pair"]
    turns = iter(sorted(pairs, key=lambda unit: unit.stand.position))
    return [next(turns) if unit.stand.kind == "pair" else unit for unit in units]


def ways_of(unit: Unit, gap: float) -> Sequence[Shape]:
    """Return the ways to set the boxes of a unit in rows, with room for the heading above the first."""
    return _ways(unit.sizes, unit.stand.heading, gap)


@lru_cache(maxsize=4096)
def _ways(sizes: tuple[Sized, ...], heading: Heading | None, gap: float) -> Sequence[Shape]:
    found = shapes(sizes, gap)
    if heading is None:
        return found
    made = list[Shape]()
    for shape in found:
        first = sum(width for width, _, _ in sizes[: shape.rows[0]]) + gap * (shape.rows[0] - 1)
        wide, high = room(heading, first)
        made.append(Shape(max(shape.width, wide), shape.height + high, shape.rows, (0.0, high)))
    return made


def boxes_of(places: Mapping[int, complex], outlines: Sequence[Outline]) -> list[Box]:
    """Return what outlines take that stand at places, and the headings above their rows."""
    there = []
    for k in sorted(places):
        at, (_, width, height, stand, foot, *_) = places[k], outlines[k]
        box = (at.real, at.imag, at.real + width, at.imag + height)
        there.append((stand, box, at.imag + foot))
    return [box for _, box, _ in there] + [box for _, _, box in boxes(there)]


def shapes(sizes: tuple[Sized, ...], gap: float) -> tuple[Shape, ...]:
    """Return the ways to set boxes in rows that are worth it, the widest first: in order, as even as can be."""
    found: list[Shape] = []
    limit = sum(width for width, _, _ in sizes) + gap * len(sizes)
    while True:
        rows = _filled(sizes, limit, gap)
        if rows is None:
            return tuple(found)
        shape = measured(sizes, _even(sizes, rows, gap), gap)
        while found and shape.height <= found[-1].height:
            found.pop()
        found.append(shape)
        limit = shape.width - 1e-6


def measured(sizes: Sequence[Sized], rows: tuple[int, ...], gap: float) -> Shape:
    """Return the size of boxes set in rows of a given number."""
    lines = split(sizes, rows)
    height = sum(map(high, lines)) + gap * (len(lines) - 1)
    return Shape(_widest(lines, gap), height, rows)


def _widest(lines: Sequence[Sequence[Sized]], gap: float) -> float:
    return max(sum([w for w, _, _ in line]) + gap * (len(line) - 1) for line in lines)


def high(line: Sequence[Sized]) -> float:
    """Return how high a row of boxes is whose captions begin on one line."""
    return max(h - foot for _, h, foot in line) + max(foot for _, _, foot in line)


def split(sizes: Sequence[Sized], rows: tuple[int, ...]) -> list[Sequence[Sized]]:
    """Return boxes by rows."""
    ends = [0, *accumulate(rows)]
    return [sizes[a:b] for a, b in pairwise(ends)]


def _filled(sizes: Sequence[Sized], limit: float, gap: float) -> tuple[int, ...] | None:
    """Return how many boxes stand in each row if every row takes what it holds; None if one box is wider."""
    rows, used = [0], 0.0
    for width, _, _ in sizes:
        if width > limit:
            return None
        more = used + width + (gap if used else 0.0)
        if more > limit:
            rows.append(0)
            more = width
        rows[-1] += 1
        used = more
    return tuple(rows)


def _even(sizes: Sequence[Sized], rows: tuple[int, ...], gap: float) -> tuple[int, ...]:
    """Return as many rows whose widest is as narrow as can be."""
    if len(rows) == 1:
        return rows
    low, high = max([width for width, _, _ in sizes]), _widest(split(sizes, rows), gap)
    best = rows
    for _ in range(12):
        middle = (low + high) / 2
        found = _filled(sizes, middle, gap)
        if found is not None and len(found) <= len(rows):
            best, high = found, middle
        else:
            low = middle
    return best
