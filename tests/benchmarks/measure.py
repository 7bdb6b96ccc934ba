"""How sheets are lettered: `python tests/benchmarks/measure.py FILE.svg ...`, or `--random 24` mechanisms.

Of each sheet: its labels; pairs of them that overlap (ink, or more than 0.5 mm² of their hulls); labels crossed
by a main line and by a thin one (more than 0.25 mm of it); what stands outside the frame.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import shapely
from shapely import union_all
from shapely.geometry import LineString, MultiLineString, Polygon, box

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.svg_ink import Line, border, inked

COMMON, CROSSED, EDGE = 0.5, 0.25, 0.15
"""Hulls that have no more in common do not overlap, mm²; a label that is crossed by no more is not; how far
within its hull a line has to run to cross it, mm."""


class Lettered(NamedTuple):
    """How a sheet is lettered: numbers of labels and of what is wrong with them."""

    labels: int
    overlapping: int
    by_main: int
    by_thin: int
    outside: int


def measured(file: Path) -> Lettered:
    """Return how the sheet of an SVG file is lettered."""
    sheet = inked(file)
    labels = [one for one in sheet.labels if not border(one.drawing) and one.strokes]
    lines = [one for one in sheet.lines if not border(one.drawing)]
    ink = [MultiLineString(one.strokes).buffer(one.width / 2) for one in labels]
    hulls = [one.convex_hull for one in ink]
    first, second = shapely.STRtree(hulls).query(hulls)
    overlapping = sum(
        i < j and (ink[i].intersects(ink[j]) or hulls[i].intersection(hulls[j]).area > COMMON)
        for i, j in zip(first, second, strict=True)
    )
    paths = [LineString(one.points) for one in lines]
    tree = shapely.STRtree(paths)
    crossing = [_crossing(hull, tree, paths, lines) for hull in hulls]
    frame = box(*sheet.framed())
    return Lettered(
        len(labels),
        overlapping,
        crossing.count("main"),
        crossing.count("thin"),
        sum(not frame.contains(one) for one in (*paths, *ink)),
    )


def _crossing(
    hull: shapely.Geometry, tree: shapely.STRtree, paths: list[LineString], lines: list[Line]
) -> str:
    """Return by what a label is crossed: "main", "thin", "" by nothing; what paper covers is not seen."""
    inner = hull.buffer(-EDGE)
    inner = hull if inner.is_empty else inner
    found = ""
    near = [int(k) for k in tree.query(inner)]
    patches = [(k, Polygon(lines[k].points)) for k in near if lines[k].pen == "paper"]
    for k in near:
        seen = inner.difference(union_all([patch for n, patch in patches if n > k]))
        if lines[k].pen == "paper" or not paths[k].intersects(seen):
            continue
        if lines[k].filled or paths[k].intersection(seen).length > CROSSED:
            if lines[k].pen == "main":
                return "main"
            found = "thin"
    return found


def drawn(count: int) -> Iterator[Path]:
    """Yield the sheets of random mechanisms, drawn as they are asked for."""
    from support.sheets_of_random import scenes

    from graphic_tmm.scene.read import read
    from graphic_tmm.studio import sheet_files

    with tempfile.TemporaryDirectory() as folder:
        for k, text in enumerate(scenes(count)):
            file = Path(folder) / f"random{k}.toml"
            file.write_text(text, encoding="utf-8")
            for name, svg in sheet_files(read(file))[1].items():
                sheet = Path(folder) / name
                sheet.write_text(str(svg), encoding="utf-8")
                yield sheet


def main() -> None:
    """Print a table in Markdown, the sum last."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    asked.add_argument("files", nargs="*", type=Path)
    asked.add_argument("--random", type=int, default=0)
    told = asked.parse_args()
    print("| sheet | labels | overlapping | crossed by main lines | by thin ones | outside |")
    print("|---|---|---|---|---|---|")
    rows = []
    for file in chain(told.files, drawn(told.random)):
        rows.append(measured(file))
        print(f"| {file.stem} |", " | ".join(map(str, rows[-1])), "|", flush=True)
    print("| all |", " | ".join(str(sum(column)) for column in zip(*rows, strict=True)), "|")


if __name__ == "__main__":
    main()
