"""How long further drawings of a scene take to check, once the first of them is: the yardstick is kept.

    python tests/benchmarks/yardsticks.py --scenes windrower engine --drawings 6

CPU seconds of the first drawing, and of a further one as its share: with the same figures read, with others
(seven of ten, another choice each time); in mm and with points. The scene is drawn before the clock runs.
"""

from __future__ import annotations

import argparse
import random
import statistics
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.gallery import SHEETS
from support.trials import cells_and_points, checks, readings

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.records import Taken
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SHARE = 0.7


def drawings(
    whole: Sequence[Taken], count: int, *, other: bool
) -> Iterator[tuple[str, Sequence[Taken]]]:
    """Yield readings of drawings: the first of all figures, the others of all or of some."""
    chance = random.Random(1)
    yield "first", whole
    for k in range(count):
        some = [row for row in whole if chance.random() < SHARE] if other else whole
        yield str(k), some


def seconds(name: str, count: int, *, pointed: bool, other: bool) -> tuple[float, float]:
    """Return the CPU seconds of the first drawing, and of a further one (the median)."""
    scene = read(SHEETS / name)
    made = make(scene, exact=True)
    due = cells_and_points(made) if pointed else cells(made)
    started, told = time.process_time(), []
    make(scene, exact=True)
    drawn = time.process_time() - started
    started = time.process_time()
    for _ in checks(scene, drawings(readings(due, due), count, other=other)):
        told.append(time.process_time() - started)
        started = time.process_time()
    return told[0] - drawn, statistics.median(told[1:])


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", nargs="+", default=["windrower", "engine", "project"])
    parser.add_argument("--drawings", type=int, default=6)
    told = parser.parse_args()
    print("| scene | read | figures | first, s | further, s | share |")
    print("|---|---|---|---:|---:|---:|")
    for name in told.scenes:
        for pointed in (False, True):
            for other in (False, True):
                first, more = seconds(name, told.drawings, pointed=pointed, other=other)
                row = [name, "points" if pointed else "mm", "other" if other else "the same"]
                print("|", " | ".join(row), f"| {first:.2f} | {more:.3f} | {more / first:.0%} |")


if __name__ == "__main__":
    main()
