"""Photographs of students' sheets, as `tests/support/photographed` takes them: frames found, points found.

    python tests/benchmarks/photographs.py --count 60 --whole 6

A frame is found if its corners stand within a millimetre of the truth; wrong, if it was taken for sure and they
do not. A point is found if it is given as seen; its error, mm on the sheet, is that of its place from the pole
of its plan, and of its place on the sheet. Counted are points that a line's end, a head, a crossing or a pin
shows, and of these those apart: no end that lies on another line, no vector that should have no length.
``--whole``: so many photographs are also given to the command, alone in a process, for its seconds and memory.
``--failures FILE``: what was not found or is wrong, with the photograph's number.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.photographed.student import SHEETS
from support.photographed.taking import Taken, taken

from graphic_tmm.checking.pencil.points import SEEN, UNSURE
from graphic_tmm.checking.photographed import photographed
from graphic_tmm.checking.pictures import laid
from graphic_tmm.errors import SheetError
from graphic_tmm.scene.read import read

NEAR = 1.0
"""mm: so near a frame's corners are found, and no point that is given as seen may be farther off."""
FINE = 0.3
"""mm: wanted of points that are given as seen."""

COUNTED = """
import resource, subprocess, sys, time
start = time.perf_counter()
silent = subprocess.DEVNULL
code = subprocess.run(sys.argv[1:], stdout=silent, stderr=silent).returncode
assert code in (0, 1, 2, 3)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(time.perf_counter() - start, used.ru_utime + used.ru_stime, used.ru_maxrss)
"""
"""The program of the process that starts the command and counts what it took."""


class Outcome(NamedTuple):
    """Of a photograph: how far the frame's corners are off (mm, None if it was not found), and its points.

    ``errors``: of the points given as seen, from the pole and on the sheet, mm; ``unsure``: of those given as
    not sure, from the pole; ``drawn``: how many there are; ``apart``: of them by themselves, and found of
    these; ``extra``: points given as seen that nobody drew.
    """

    number: int
    name: str
    corners: float | None
    errors: tuple[tuple[float, float], ...] = ()
    unsure: tuple[float, ...] = ()
    drawn: int = 0
    apart: tuple[int, int] = (0, 0)
    extra: int = 0
    seconds: tuple[float, float] = (0.0, 0.0)


def outcome(number: int, folder: Path, points: bool, failures: list[str]) -> Outcome:
    """Return what is found of a photograph."""
    shown = taken(number)
    file = folder / f"{number}.jpg"
    file.write_bytes(shown.jpeg)
    scene = read(SHEETS / shown.name / "scene.toml")
    start = time.process_time()
    try:
        sheet = laid(scene, str(file), "", shown.number)
    except SheetError as error:
        failures.append(f"{number} {shown.name}: {error}")
        return Outcome(number, shown.name, None)
    middle = time.process_time()
    off = float(abs(sheet.flat.corners - shown.corners).max() / _dots(shown))
    if off > NEAR:
        failures.append(f"{number} {shown.name}: the frame is {off:.1f} mm off")
    if not points or off > NEAR:
        return Outcome(number, shown.name, off, seconds=(middle - start, 0.0))
    found = photographed(sheet, {}, "student")
    seconds = middle - start, time.process_time() - middle
    seen: list[tuple[float, float]] = []
    unsure: list[float] = []
    extra = apart = 0
    for one in found.found.points if found is not None else ():
        due = shown.points.get((one.name[0], one.name[1], one.name[2]))
        if due is None or not due.drawn:
            extra += one.how == SEEN
            continue
        error = abs(one.spot - due.spot)
        if one.how == SEEN:
            seen.append((error, abs(one.at - due.sheet)))
            apart += due.apart
        elif one.how == UNSURE:
            unsure.append(error)
        if one.how == SEEN and error > NEAR:
            failures.append(f"{number} {shown.name}: {' '.join(one.name)} is {error:.2f} mm off")
    there = [one for one in shown.points.values() if one.drawn]
    alone = sum(one.apart for one in there), apart
    return Outcome(
        number, shown.name, off, tuple(seen), tuple(unsure), len(there), alone, extra, seconds
    )


def _dots(shown: Taken) -> float:
    """Return how many dots of the photograph a millimetre of the sheet has where it has most."""
    left, bottom, right, top = shown.paper.frame
    sides = abs(np.roll(shown.corners, -1) - shown.corners)
    return float(max(sides / np.array([right - left, top - bottom] * 2)))


def command(number: int, folder: Path) -> tuple[float, float, float]:
    """Return the seconds that the command takes for a photograph, those of its processors, its megabytes.

    A process between counts its memory: a child of this large one would be told to have been as large.
    """
    shown = taken(number)
    options = (f"{folder / f'{number}.jpg'}", "--sheet", str(shown.number))
    out = ("--overlay", str(folder / "under.svg"))
    line = (sys.executable, "-m", "graphic_tmm", "photo", str(SHEETS / shown.name), *options, *out)
    done = subprocess.run((sys.executable, "-c", COUNTED, *line), check=True, capture_output=True)
    wall, cpu, memory = map(float, done.stdout.split())
    return wall, cpu, memory / 1024


def table(several: list[Outcome]) -> str:
    """Return the figures by scene, and of all."""
    rows = [
        "| scene | photographs | frames found | wrong | points drawn | found | apart | found | "
        "error in 95 %, from the pole | ≤ 0.3 mm | > 1 mm | on the sheet | ≤ 0.3 mm | > 1 mm | "
        "unsure | of these > 1 mm | not drawn but seen |",
        "|---" + 16 * "|---:" + "|",
    ]
    for name in [*dict.fromkeys(one.name for one in several), "all"]:
        some = [one for one in several if name in (one.name, "all")]
        errors = np.array([error for one in some for error in one.errors]).reshape(-1, 2)
        unsure = np.array([error for one in some for error in one.unsure])
        drawn = sum(one.drawn for one in some)
        frames = [one.corners for one in some if one.corners is not None]
        right = sum(off <= NEAR for off in frames)
        apart, of_these = (sum(one.apart[k] for one in some) for k in (0, 1))
        rows.append(
            f"| {name} | {len(some)} | {100 * right / len(some):.0f} % | {len(frames) - right} | {drawn} | "
            f"{100 * len(errors) / max(drawn, 1):.1f} % | {apart} | {100 * of_these / max(apart, 1):.1f} % | "
            f"{_told(errors[:, 0])} | {_told(errors[:, 1])} | "
            f"{unsure.size} | {(unsure > NEAR).sum()} | {sum(one.extra for one in some)} |"
        )
    return "\n".join(rows)


def _told(errors: np.ndarray) -> str:
    """Return three cells: the error in 95 %, the share within `FINE`, how many are wrong."""
    if not errors.size:
        return "– | – | 0"
    wrong = errors > NEAR
    return (
        f"{np.quantile(errors, 0.95):.2f} mm | {100 * np.mean(errors <= FINE):.0f} % | "
        f"{wrong.sum()} ({100 * wrong.mean():.2f} %)"
    )


def main() -> None:
    """Print the table, and how long it takes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--frames", action="store_true", help="frames only, no points")
    parser.add_argument("--whole", type=int, default=0)
    parser.add_argument("--failures", type=Path)
    given = parser.parse_args()
    failures: list[str] = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        several = []
        for number in range(given.first, given.first + given.count):
            several.append(outcome(number, folder, not given.frames, failures))
            if number - given.first < given.whole:
                seconds, cpu, memory = command(number, folder)
                print(
                    f"{several[-1].name} ({number}): {seconds:.1f} s, processors {cpu:.1f} s, {memory:.0f} MB"
                )
            (folder / f"{number}.jpg").unlink()
    print(table(several))
    corners = [one.corners for one in several if one.corners is not None]
    print(f"corners off: {np.median(corners):.2f} mm in the median, {max(corners):.2f} at most")
    cpu = np.array([one.seconds for one in several if one.corners is not None])
    first, second = np.median(cpu, axis=0)
    print(f"CPU: sheet drawn, frame found, flattened {first:.1f} s; points {second:.1f} s")
    if given.failures:
        given.failures.write_text("\n".join(failures) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
