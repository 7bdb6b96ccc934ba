"""How cost grows: time and memory with positions and trials, writing a sheet with its elements."""

from __future__ import annotations

import os
import re
import resource
import statistics
import subprocess
import sys
import time
import tracemalloc
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from clock import HERE, ROOT, Row, in_turns, show, slope

import bare  # isort: skip
import kinematics  # isort: skip

from graphic_tmm.board import room  # isort: skip
from graphic_tmm.board.execute import prepare  # isort: skip
from graphic_tmm.board.hand import HANDS  # isort: skip
from graphic_tmm.board.values import Number  # isort: skip
from support.boards import drawn_of, recorded
from support.chains import chain

from graphic_tmm.chapters.forces.task import ForcesTask, Load
from graphic_tmm.fitting.compose import compose
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.mechanism.records import Row as RowOfPositions
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read

POSITIONS = tuple(1 << k for k in range(18, 22))
TRIALS = tuple(1000 << k for k in range(6))
COPIES = (1, 2, 4, 8, 16)
DYADS = (2, 5, 10, 20, 40)
STEEPEST = 1.1
ROWS = (12, 48, 180, 720)
COMMANDS = {"table": 1.1, "draw": 1.15}
TABLES = (2000, 10_000)
LONGEST, FLAT = 8.0, 1.1
NEAR = 0.05


def line(what: str, sizes: tuple[int, ...], seconds: dict[str, float]) -> Row:
    """Return the line of a slope."""
    found = slope(sizes, [seconds[str(n)] for n in sizes])
    each = f"{seconds[str(sizes[-1])]:.2f} s for {sizes[-1]}"
    return Row(
        f"time by {what}, {sizes[0]} to {sizes[-1]}: slope in log–log",
        f"{found:.3f} ({each})",
        f"1 ± {NEAR}",
        abs(found - 1.0) <= NEAR,
    )


def positions() -> Row:
    """Return the line of a four-bar by positions."""
    cases = {str(n): kinematics.case(bare.BARE[0], n) for n in POSITIONS}
    calls = {n: partial(one.log, one.program, kinematics.RULER) for n, one in cases.items()}
    return line("positions (four-bar, three plans, readings)", POSITIONS, in_turns(calls))


def trials() -> Row:
    """Return the line of the windrower by trials."""
    made = drawn_of(
        read(ROOT / "sheets" / "windrower").asking(diagrams=None, flywheel=None, forces=None)
    )
    log = made.project.construction
    marks = [step.it for step in log.steps if step.it.view == "accelerations"]
    program = prepare(log, [mark for mark in marks if mark.kind is Number])
    hand = HANDS["student"]
    calls = {str(n): partial(program.run, made.given, hand=hand._replace(trials=n)) for n in TRIALS}
    return line("trials (windrower, student's hand)", TRIALS, in_turns(calls, rounds=5))


def elements() -> Row:
    """Return the line of writing a sheet on which everything stands several times."""
    made = fitted(read(ROOT / "sheets" / "windrower"))
    sheet = compose(made.scene, (made,))[0]
    sheets = {n: sheet._replace(drawings=sheet.drawings * n) for n in COPIES}
    counts = {n: svg(one).count("<") // 2 for n, one in sheets.items()}
    seconds = in_turns({str(counts[n]): partial(svg, one) for n, one in sheets.items()}, rounds=7)
    return line("elements of a sheet (written as SVG)", tuple(counts.values()), seconds)


def links() -> Row:
    """Return the line of recording chains of dyads: all plans, forces with weights and inertia; CPU seconds."""
    order = ForcesTask(("all",), (Load(3, None, 10.0, 0.0),), gravity=True, inertia=True)
    row = RowOfPositions(accelerations=("all",))
    sizes = tuple(2 * n + 1 for n in DYADS)
    times: dict[int, list[float]] = {n: [] for n in sizes}
    for _ in range(10):
        for dyads, n in zip(DYADS, sizes, strict=True):
            start = time.process_time()
            recorded(chain(dyads), row, forces=order)
            times[n].append(time.process_time() - start)
    medians = [statistics.median(each[1:]) for each in times.values()]
    found = slope(sizes, medians)
    return Row(
        f"recording by links, {sizes[0]} to {sizes[-1]} (dissected, all plans, forces): slope in log–log",
        f"{found:.3f} ({1e3 * medians[-1]:.0f} ms for {sizes[-1]} links)",
        f"≤ {STEEPEST}",
        found <= STEEPEST,
    )


def tables() -> list[Row]:
    """Return the lines of `table --trials`: CPU seconds and the most memory of processes of their own."""
    held, spent = [], 0.0
    for trials in TABLES:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        # what a process has held stands in its own status: there its end is awaited
        code = (
            "import sys; from graphic_tmm.__main__ import main\n"
            f"sys.argv = ['graphic-tmm', 'table', 'windrower', '--hand', 'student', '--trials', '{trials}']\n"
            "try: main()\n"
            "except SystemExit: pass\n"
            "print(open('/proc/self/status').read().split('VmHWM:')[1].split()[0], file=sys.stderr)"
        )
        out = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        held.append(float(out.stderr.split()[-1]) / 1024)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    told = " and ".join(f"{mb:.0f} MB for {n}" for n, mb in zip(TABLES, held, strict=True))
    flat = held[1] <= FLAT * held[0]
    return [
        Row(
            f"`table windrower --trials {TABLES[-1]}`, student's hand, CPU seconds",
            f"{spent:.1f}",
            f"≤ {LONGEST}",
            spent <= LONGEST,
        ),
        Row("the most memory of such a table", told, "flat", flat),
    ]


def commands() -> list[Row]:
    """Return the lines of commands by positions: CPU seconds of processes that find nothing kept."""
    found = []
    scene = (ROOT / "sheets" / "windrower" / "scene.toml").read_text(encoding="utf-8")
    # diagrams to fixed scale factors fit no sheet at so many positions
    text = re.sub(r"(?ms)^\[(diagrams|flywheel)\].*?(?=^\[)", "", scene)
    text = text.replace('["diagrams", "flywheel"]', '["structure"]')
    text = text.replace('"equations", "structure"]', '"equations"]')
    for command, steepest in COMMANDS.items():
        spent = []
        for count in ROWS:
            with TemporaryDirectory() as folder:
                file = Path(folder, "scene.toml")
                file.write_text(re.sub(r"(?m)^(positions +=) 12", rf"\1 {count}", text), "utf-8")
                line = [sys.executable, "-m", "graphic_tmm", command, str(file)]
                line += ["-o", str(Path(folder, "out"))] if command == "draw" else []
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                there = {**os.environ, "XDG_CACHE_HOME": folder}
                subprocess.run(line, env=there, capture_output=True, check=True)
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                spent.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        steep = slope(ROWS, spent)
        each = ", ".join(f"{seconds:.1f}" for seconds in spent)
        found.append(
            Row(
                f"`{command}` of the windrower by positions, {ROWS[0]} to {ROWS[-1]}: slope in log–log",
                f"{steep:.2f} ({each} s)",
                f"≤ {steepest}",
                steep <= steepest,
            )
        )
    return found


def beyond(count: int) -> float:
    """Return the most MB held at once beyond what is given and the results, by a run at many positions.

    Pieces of results are reserved whole and used as far as needed: what is reserved is not held.
    """
    one = kinematics.case(bare.BARE[0], count)
    one.log(one.program, kinematics.RULER)  # the first run writes the line, which then is kept
    reserved = 0
    taken = room.piece

    def noted(size: int) -> Any:
        nonlocal reserved
        found = taken(size)
        reserved += found.nbytes
        return found

    # what waits of the first run was not traced
    room.WAITING.clear()
    room.piece = noted
    tracemalloc.start()
    try:
        reading = one.log(one.program, kinematics.RULER)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
        room.piece = taken
    assert reading.positions == count
    return (peak - reserved) / 1e6


def peak_of_million(count: int = 1_000_000) -> float:
    """Return the most memory, MB, that a process of its own has held which runs many positions."""
    code = (
        f"import sys; sys.path[:0] = [{str(HERE)!r}]; import clock, bare, kinematics, growth;"
        f"one = kinematics.case(bare.BARE[0], {count}); one.log(one.program); print(growth.most_held())"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return float(out.stdout)


def most_held() -> float:
    """Return the most memory this process has held, MB.

    Not ru_maxrss where there is better: a process starts with that of the one that started it.
    """
    status = Path("/proc/self/status")
    if status.exists():
        words = next(line for line in status.read_text().splitlines() if "VmHWM" in line).split()
        return int(words[1]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def memory() -> list[Row]:
    """Return the lines of memory."""
    sizes = POSITIONS[0], POSITIONS[-1]
    held = [beyond(n) for n in sizes]
    flat = held[-1] < 1.1 * held[0]
    told = " and ".join(f"{mb:.1f} MB at {n} positions" for n, mb in zip(sizes, held, strict=True))
    return [
        Row("memory held at once beyond the results, in blocks", told, "flat", flat),
        Row(
            "most memory of a process that runs 1 000 000 positions", f"{peak_of_million():.0f} MB"
        ),
    ]


def main() -> None:
    """Print the table."""
    show("growth", [positions(), trials(), elements(), links(), *commands(), *tables(), *memory()])


if __name__ == "__main__":
    main()
