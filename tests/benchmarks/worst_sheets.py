"""The worst sheets: `python tests/benchmarks/worst_sheets.py [FOLDER ...] [--random COUNT]`.

Draws the scenes of the gallery, those of folders, and random mechanisms with forces on two sheets A1. Names
each sheet that an examiner would send back: white (`composition`), out of order, its equations elsewhere, a
caption larger than its plan; each scene with a group smaller than its plan, link 1 larger than all groups, a
short crank.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

import numpy as np
from composition import Composed, measured

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.mechanisms import sample
from support.order import faults, forward, kept_apart, parts_of
from support.rewritten import text_of
from support.sheets_of_random import FORCES

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.formats import room_on
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

ROOT = Path(__file__).parents[2]
FILL, HOLE, SHORT = 0.40, 0.12, 15.0
"""What an A1 or A2 is filled at least, its largest hole at most (shares of 1), a crank at least, mm."""
LARGE = 500.0
"""Sheets wider than this are A1 or A2, mm."""
TAIL = """accelerations = [1, 5]
{forces}positions = [1, 5]
[[sheet]]
format = "A1"
place = ["positions", "given", "velocities", "accelerations", "equations"]
[[sheet]]
format = "A1"
place = ["forces", "lever", "force table"]
"""


class Judged(NamedTuple):
    """What is wrong with the sheets of a scene, how they are composed, how many pairs were looked at."""

    wrong: tuple[tuple[str, str], ...]
    sheets: tuple[tuple[Sheet, Composed], ...]
    plans: int


def judged(file: Path, folder: Path) -> Judged:
    """Return what is wrong with the sheets of a scene; ``folder``: where they are written."""
    made, found = composed_sheets(read(file))
    sheets, wrong = list[tuple[Sheet, Composed]](), list[tuple[str, str]]()
    for sheet in found.sheets:
        path = folder / f"{file.parent.name}-{file.stem}-{sheet.name}.svg"
        path.write_text(svg(sheet), encoding="utf-8")
        how = measured(path)
        sheets.append((sheet, how))
        if max(sheet.width, sheet.height) > LARGE and (how.fill < FILL or how.hole > HOLE):
            wrong.append(
                ("white", f"{sheet.name}: fill {how.fill:.2f}, hole {100 * how.hole:.0f} %")
            )
    if made.mechanism is not None:
        wrong += _order(found.sheets, made.mechanism.names)
        wrong += _scales(made.mechanism)
    plans = [view for sheet in found.sheets for view in sheet.drawings if _plan(view)]
    wrong += [("caption", view.name) for view in plans if _caption(view) > _box(view)]
    return Judged(tuple(wrong), tuple(sheets), len(plans))


def _order(sheets: Sequence[Sheet], names: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield what stands where a reader would not look for it."""
    views = [sheet.drawings[1:] for sheet in sheets]
    boxes = [{view.name: bounds(view) for view in own} for own in views]
    feet = {view.name: view.foot for own in views for view in own}
    for sheet, own in zip(sheets, boxes, strict=True):
        bases = {name: box[1] + feet[name] for name, box in own.items()}
        yield from (("order", f"{sheet.name}: {text}") for text in faults(own, bases, names))
    parts = parts_of(boxes, names, feet)
    for one, other in combinations(parts, 2):
        if (one.unit != other.unit or one.sheet == other.sheet) and not forward(one, other):
            yield "order", f"{other.name} before {one.name}"
    rooms = [room_on(s.format, "en", k == 0).within.sizes for k, s in enumerate(sheets)]
    yield from (("equations", name) for name in kept_apart(parts, rooms))


def _scales(drawn: Drawn) -> Iterator[tuple[str, str]]:
    """Yield what is drawn too small or too large, by its scale factor."""
    plan = drawn.scales["positions"].value
    groups = {v: one.value for v, one in drawn.scales.items() if v.startswith("group ")}
    first = groups.pop("group 1", None)
    yield from (("group", f"{v} is smaller") for v, mu in groups.items() if mu > plan * (1 + 1e-9))
    if first is not None and groups and first < min(groups.values()) * (1 - 1e-9):
        yield "link 1", "is larger than all groups"
    made = KINEMATICS_PLAN.on(drawn)
    marks, structure = made.positions.bodies[made.structure.first.link].marks, made.structure
    crank = drawn.reading[marks[structure.first.pin]] - drawn.reading[marks[structure.origin]]
    if (mm := float(np.nanmax(np.abs(crank)))) < SHORT:
        yield "crank", f"is {mm:.1f} mm"


def _plan(view: Drawing) -> bool:
    return view.name.startswith(("velocities-", "accelerations-")) and bool(view.strokes)


def _caption(view: Drawing) -> float:
    """Return the area of the box of the lines of letters below a plan, mm²."""
    low = bounds(view)[1] + view.foot
    below = tuple(label for label in view.labels if label.at.imag < low - 0.1)
    return _area(view._replace(labels=below, strokes=(), cell=None)) if below else 0.0


def _box(view: Drawing) -> float:
    return _area(view._replace(labels=(), cell=None))


def _area(view: Drawing) -> float:
    left, bottom, right, top = bounds(view)
    return (right - left) * (top - bottom)


def scenes(folders: Sequence[Path], count: int, folder: Path) -> Iterator[Path]:
    """Yield the files of scenes; random ones are written into a folder."""
    yield from sorted((ROOT / "sheets").glob("*/scene.toml"))
    for one in folders:
        yield from sorted(one.glob("*.toml"))
    for k, one in enumerate(sample(count, 91, dyads=(1, 3)) if count else ()):
        file = folder / f"random{k}.toml"
        file.write_text(text_of(one.mechanism, one.phi, 12, TAIL.format(forces=FORCES)), "utf-8")
        yield file


def main() -> None:
    """Print what is wrong, then how often."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    asked.add_argument("folders", nargs="*", type=Path)
    asked.add_argument("--random", type=int, default=0)
    given = asked.parse_args()
    large, small, faulty = list[Composed](), list[Composed](), Counter[str]()
    count = plans = refused = 0
    with tempfile.TemporaryDirectory() as name:
        for file in scenes(given.folders, given.random, Path(name)):
            try:
                found = judged(file, Path(name))
            except TmmError as error:
                refused += 1
                print(f"{file.parent.name}/{file.stem}: {str(error)[:100]}")
                continue
            count, plans = count + 1, plans + found.plans
            for sheet, how in found.sheets:
                (large if max(sheet.width, sheet.height) > LARGE else small).append(how)
            for kind, text in found.wrong:
                faulty[kind] += 1
                print(f"{file.parent.name}/{file.stem}: {kind}: {text}", flush=True)
    print(f"{count} scenes, {refused} refused; {len(large)} sheets A1/A2, {len(small)} A3/A4")
    for name, rows in (("A1/A2", large), ("A3/A4", small)):
        if rows:
            fill, hole = (
                statistics.mean(getattr(one, key) for one in rows) for key in ("fill", "hole")
            )
            print(f"{name}: mean fill {fill:.3f}, mean hole {100 * hole:.1f} %")
    white = faulty["white"] / max(len(large), 1)
    print(f"white sheets A1/A2: {faulty['white']} ({100 * white:.1f} %)")
    print(f"captions larger than their plan: {faulty['caption']} of {plans}")
    print(
        "; ".join(f"{k}: {faulty[k]}" for k in ("order", "equations", "group", "link 1", "crank"))
    )


if __name__ == "__main__":
    main()
