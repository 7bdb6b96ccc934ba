"""How sheets are composed: `python tests/benchmarks/composition.py FILE.svg ...`; see `worst_sheets`, too.

Of each sheet: **fill**, the boxes of its views as a share of what is free (frame less title block); **hole**,
the largest white rectangle 5 mm off all views, as a share of that; **quad**, the share of the emptiest quadrant
that the hulls of views cover; **aligned**, the share of views of which an edge or the upright axis is on one
line (0.6 mm) with another's. No number is safe alone: fill sees small views, hole sees a heap in a corner,
aligned sees scattering.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PIL import Image, ImageDraw
from shapely.geometry import MultiPoint

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.svg_ink import Inked, Point, border, inked

Box = tuple[float, float, float, float]
CLEAR, STEP, LINED = 5, 5, 0.6
"""What is nearer to a view is no hole; the raster of holes; what is on one line: mm."""
BLOCK = 185
"""The width of a title block, mm."""


class Composed(NamedTuple):
    """How a sheet is composed: shares of 1; how many views it has."""

    fill: float
    hole: float
    quad: float
    aligned: float
    views: int


def measured(file: Path) -> Composed:
    """Return how the sheet of an SVG file is composed."""
    sheet = inked(file)
    left, top, right, bottom = sheet.framed()
    shape = (int(sheet.height) + 1, int(sheet.width) + 1)
    free = np.zeros(shape, dtype=bool)
    free[int(top) + 1 : int(bottom), int(left) + 1 : int(right)] = True
    block = np.zeros(shape, dtype=bool)
    x, y = _block(sheet)
    block[int(y) : int(bottom), int(x) : int(right)] = True
    free &= ~block
    views = _views(sheet)
    hulls = [MultiPoint(points).convex_hull for points in views.values()]
    hulls = [hull if hull.geom_type == "Polygon" else hull.buffer(1) for hull in hulls]
    covered = _raster(hulls, shape) & free
    boxes = [hull.bounds for hull in hulls]
    white = ~_grown(covered | block, CLEAR) & free
    middle = int((left + right) / 2), int((top + bottom) / 2)
    return Composed(
        sum((b[2] - b[0]) * (b[3] - b[1]) for b in boxes) / free.sum(),
        _largest(white[::STEP, ::STEP]) * STEP * STEP / free.sum(),
        min(_quarters(covered, free, middle)),
        lined(boxes),
        len(boxes),
    )


def _views(sheet: Inked) -> dict[str, list[Point]]:
    """Return the points of the views of a sheet."""
    found: dict[str, list[Point]] = {}
    for line in sheet.lines:
        if not border(line.drawing):
            found.setdefault(line.drawing, []).extend(line.points)
    for label in sheet.labels:
        if not border(label.drawing):
            for stroke in label.strokes:
                found.setdefault(label.drawing, []).extend(stroke)
    return found


def _block(sheet: Inked) -> Point:
    """Return the upper left corner of the title block."""
    left, top, right, bottom = sheet.framed()
    inner = [
        (x, y)
        for line in sheet.lines
        if border(line.drawing) and line.pen == "main"
        for x, y in line.points
        if left + 1 < x <= right + 0.1 and top + 60 < y < bottom - 0.5
    ]
    if not inner:
        return right, bottom
    x = min(*(x for x, _ in inner), right - BLOCK)
    return max(x, left), min(y for _, y in inner)


def _raster(hulls: Sequence[MultiPoint], shape: tuple[int, int]) -> np.ndarray:
    image = Image.new("1", shape[::-1])
    for hull in hulls:
        ImageDraw.Draw(image).polygon(list(hull.exterior.coords), fill=1)
    return np.array(image)


def _grown(inside: np.ndarray, by: int) -> np.ndarray:
    """Return what is no farther than ``by`` cells from what is inside."""
    found = np.zeros_like(inside)
    padded = np.pad(inside, by)
    high, wide = inside.shape
    for dy in range(-by, by + 1):
        reach = int((by * by - dy * dy) ** 0.5)
        rows = padded[by + dy : by + dy + high]
        for dx in range(-reach, reach + 1):
            found |= rows[:, by + dx : by + dx + wide]
    return found


def _largest(white: np.ndarray) -> int:
    """Return how many cells the largest rectangle of a raster has."""
    best, deep = 0, np.zeros(white.shape[1], dtype=int)
    for row in white:
        deep = np.where(row, deep + 1, 0)
        stair: list[tuple[int, int]] = []
        for place, high in enumerate((*deep.tolist(), 0)):
            start = place
            while stair and stair[-1][1] >= high:
                start, top = stair.pop()
                best = max(best, top * (place - start))
            stair.append((start, high))
    return best


def _quarters(covered: np.ndarray, free: np.ndarray, middle: tuple[int, int]) -> Iterator[float]:
    for rows in (slice(None, middle[1]), slice(middle[1], None)):
        for columns in (slice(None, middle[0]), slice(middle[0], None)):
            yield float(covered[rows, columns].sum() / free[rows, columns].sum())


def lined(boxes: Sequence[Box]) -> float:
    """Return the share of boxes that stand on a line with another; one alone is on its own."""

    def on_line(one: Box, other: Box) -> bool:
        axes = (one[0] + one[2]) / 2, (other[0] + other[2]) / 2
        pairs = ((one[0], other[0]), (one[1], other[1]), (one[3], other[3]), axes)
        return any(abs(a - b) < LINED for a, b in pairs)

    there = [any(on_line(a, b) for b in boxes if b is not a) for a in boxes]
    return sum(there) / len(there) if len(there) > 1 else 1.0


def table(named: dict[str, Composed]) -> Iterator[str]:
    """Yield the lines of a table in Markdown, the mean last."""
    yield "| sheet | views | fill | hole, % | emptiest quadrant | aligned |"
    yield "|---|---|---|---|---|---|"
    for name, one in named.items():
        yield (
            f"| {name} | {one.views} | {one.fill:.2f} | {100 * one.hole:.1f} | {one.quad:.2f} "
            f"| {one.aligned:.2f} |"
        )
    rows = list(named.values())
    fill, hole, quad, aligned = (
        statistics.mean(getattr(one, key) for one in rows)
        for key in ("fill", "hole", "quad", "aligned")
    )
    yield f"| mean of {len(rows)} | | {fill:.3f} | {100 * hole:.1f} | {quad:.2f} | {aligned:.2f} |"


def main() -> None:
    """Measure files."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    asked.add_argument("files", nargs="+", type=Path)
    files = asked.parse_args().files
    print("\n".join(table({file.stem: measured(file) for file in files})))


if __name__ == "__main__":
    main()
