"""What a variant costs and how it fills its sheets: `python tests/benchmarks/variants.py [SCENE ...]`.

Each scene is varied by the lengths that it gives, all of them by up to 8 %, at random. Every variant is
composed twice: searched, and with the composition of the scene to begin with. Told are the CPU time of both
(medians of what is read, drawn, composed and written as SVG), the fill of the sheets (boxes of views as a
share of what is free, the mean over its sheets) and by how much the second is filled less at the worst.
"""

from __future__ import annotations

import argparse
import random
import statistics
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from benchmarks.composition import measured
from support.gallery import SHEETS

from graphic_tmm.classroom.variants.variant import Base, Value, Variant, base, scene_of
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.studio import composed_sheets, files_of


def main() -> None:
    """Print a line a scene."""
    parser = argparse.ArgumentParser()
    parser.add_argument("scenes", nargs="*", default=["windrower", "shaper", "lever"])
    parser.add_argument("--count", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    print(f"{'scene':14} {'searched':>9} {'given':>9} {'fill':>6} {'given':>6} {'worst':>6}")
    for name in asked.scenes:
        told(name, asked.count, random.Random(asked.seed))


def told(name: str, count: int, chance: random.Random) -> None:
    """Print what the variants of a scene cost and how they are filled."""
    of = base(SHEETS / name)
    _, found = composed_sheets(scene_of(of, Variant("0", ())))
    rows: list[tuple[float, float, float, float]] = []
    while len(rows) < count:
        one = varied(of, str(len(rows)), chance)
        try:
            searched, given = drawn(of, one, None), drawn(of, one, found.composition)
        except TmmError:
            continue
        rows.append((*searched, *given))
    seconds, fill, given_seconds, given_fill = zip(*rows, strict=True)
    worst = max(a - b for a, b in zip(fill, given_fill, strict=True))
    print(
        f"{name:14} {1000 * statistics.median(seconds):6.0f} ms "
        f"{1000 * statistics.median(given_seconds):6.0f} ms {statistics.fmean(fill):6.3f} "
        f"{statistics.fmean(given_fill):6.3f} {worst:6.3f}"
    )


def varied(of: Base, name: str, chance: random.Random) -> Variant:
    """Return a variant: every length by name, and each of the task, changed by up to 8 %."""
    values = []
    for section in ("lengths", "task"):
        for key, there in of.doc.get(section, {}).items():
            number, _, unit = str(there).partition(" ")
            try:
                changed = float(number) * chance.uniform(0.92, 1.08)
            except ValueError:
                continue
            if section == "lengths" or unit in ("mm", "m"):
                values.append(Value(f"{section}.{key}", f"{changed:.4g}", unit))
    return Variant(name, tuple(values))


def drawn(of: Base, one: Variant, given: Composition | None) -> tuple[float, float]:
    """Return the CPU seconds of a variant from its text to SVG, and the mean fill of its sheets."""
    begun = time.process_time()
    files = files_of(*composed_sheets(scene_of(of, one), given, near=True), ("svg",))
    seconds = time.process_time() - begun
    with tempfile.TemporaryDirectory() as folder:
        fills = []
        for name, text in files.items():
            file = Path(folder) / name
            file.write_text(str(text), encoding="utf-8")
            fills.append(measured(file).fill)
    return seconds, statistics.fmean(fills)


if __name__ == "__main__":
    main()
