"""Whether times can be believed under load: `python tests/benchmarks/times_under_load.py [SCENE ...]`.

`accuracy` runs three times, each time afresh, beside as many other processes as the machine has cores, which
count and move memory. What is told of the same thing without a mark should be the same within 1.5 times.
Then 10,000 drawings against ten times 1000.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import combinations
from typing import Any

from clock import ROOT, Row, show

BUSY = """
import numpy
row = numpy.arange(1e6)
while True:
    sum(k * k for k in range(100_000))
    row = row[::-1] + 1.0
"""
SAME = 1.5
"""Times of the same thing, without a mark, differ by no more."""


@contextmanager
def beside(processes: int) -> Iterator[None]:
    """Keep so many processes busy."""
    others = [subprocess.Popen([sys.executable, "-c", BUSY]) for _ in range(processes)]
    try:
        yield
    finally:
        for one in others:
            one.kill()
            one.wait()


def told(scene: str) -> dict[str, Any]:
    """Return what the command tells of a scene, in a process of its own."""
    command = f"-m graphic_tmm accuracy {scene} --format json --trials 20".split()
    done = subprocess.run([sys.executable, *command], check=True, capture_output=True, cwd=ROOT)
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def seconds(found: dict[str, Any]) -> dict[tuple[object, ...], tuple[float, bool]]:
    """Return every time by what was timed, and whether it is marked."""
    keys = ("quantity", "axis", "value", "hand")
    runs = {tuple(one[key] for key in keys): one for one in found["runs"] if "seconds" in one}
    asked = {(one["what"], one["positions"]): one for one in found["machine"]}
    return {
        key: (one["seconds"], one["seconds_doubtful"]) for key, one in {**runs, **asked}.items()
    }


def compared(scene: str, several: Sequence[dict[str, Any]]) -> Row:
    """Return by how much times differ that are not marked, of any two of several runs."""
    rows = [seconds(found) for found in several]
    ratios = [
        (max(one[key][0], two[key][0]) / min(one[key][0], two[key][0]), key)
        for one, two in combinations(rows, 2)
        for key in one.keys() & two.keys()
        if not one[key][1] and not two[key][1]
    ]
    most, key = max(ratios, key=lambda one: one[0])
    marked = [sum(doubtful for _, doubtful in row.values()) for row in rows]
    busy = [found["load"]["busy"] for found in several]
    text = f"{most:.2f} times at most ({'/'.join(map(str, key))}) in {len(ratios)} pairs"
    text += f"; marked {marked} of {len(rows[0])}; said to be busy: {busy}"
    return Row(scene, text, f"at most {SAME}", most <= SAME and all(busy))


def scaled(scene: str) -> Row:
    """Return what 10,000 drawings take, as a share of ten times 1000."""
    from support.gallery import scene as read
    from support.tasks import drawing

    from graphic_tmm.accuracy.machine_times import DRAWN, SCALED
    from graphic_tmm.accuracy.quantities import quantities
    from graphic_tmm.accuracy.settings import hand_named
    from graphic_tmm.board.execute import prepare

    drawn, each = drawing(scene), []
    program = prepare(drawn.construction, [m for q in quantities(drawn) for m in q.marks])
    for trials in (DRAWN, SCALED):
        hand, taken = hand_named("student", read(scene), trials), []
        run = partial(program.run, drawn.given, hand=hand)
        for _ in range(4):
            start = time.process_time()
            run()
            taken.append(time.process_time() - start)
        each.append(min(taken[1:]))
    share = each[1] / each[0] / (SCALED / DRAWN)
    return Row(f"{scene}: {SCALED} drawings", f"{share:.2f} of ten times {DRAWN}", "0.85 to 1.15")


def main() -> None:
    """Print the table."""
    asked = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    asked.add_argument("scenes", nargs="*", default=["windrower", "slider-diagrams"])
    asked.add_argument("--runs", type=int, default=3)
    given = asked.parse_args()
    rows = []
    with beside(os.cpu_count() or 2):
        for scene in given.scenes:
            rows.append(compared(scene, [told(scene) for _ in range(given.runs)]))
    show("times", [*rows, *(scaled(scene) for scene in given.scenes)])


if __name__ == "__main__":
    main()
