"""How long further drawings of a scene take to check, once the first of them is: the yardstick is kept.

    python tests/benchmarks/yardsticks.py --scenes windrower engine --drawings 6

CPU seconds of the first drawing, and of a further one as its share: with the same figures read, with others
(seven of ten, another choice each time); in mm and with points. The scene is drawn before the clock runs. Each
drawing is an honest one of the hand, read off a ruler of 0.5 mm: some readings are doubtful by chance.
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
from support.trials import FRESH, cells_and_points, readings

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.studio import drawings, make

SHARE, RULER = 0.7, 0.5


def files(made: DrawnScene, count: int, *, pointed: bool) -> Iterator[list[Taken]]:
    """Yield what is read of so many drawings by the hand."""
    figures = cells_and_points if pointed else cells
    due = figures(made)
    for drawn in drawings(made, HANDS["student"]._replace(trials=count, seed=FRESH)):
        rows = readings(figures(drawn), due)
        yield [
            one if one.mm is None else one._replace(mm=RULER * round(one.mm / RULER))
            for one in rows
        ]


def read_off(
    made: DrawnScene, count: int, *, pointed: bool, other: bool
) -> Iterator[tuple[str, Sequence[Taken]]]:
    """Yield readings of drawings: the first of all figures, the others of all or of some."""
    chance = random.Random(1)
    for k, whole in enumerate(files(made, count + 1, pointed=pointed)):
        some = [row for row in whole if chance.random() < SHARE] if other and k else whole
        yield str(k), some


def seconds(name: str, count: int, *, pointed: bool, other: bool) -> tuple[float, float]:
    """Return the CPU seconds of the first drawing, and of a further one (the median)."""
    scene = read(SHEETS / name)
    made = make(scene, exact=True)
    drawn = list(read_off(made, count, pointed=pointed, other=other))
    checker, told = Checker(scene), []
    for source, rows in drawn:
        started = time.process_time()
        checker.of(rows, source)
        told.append(time.process_time() - started)
    return told[0], statistics.median(told[1:])


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
