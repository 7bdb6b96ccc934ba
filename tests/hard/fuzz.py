"""Files and command lines changed at random: each is drawn, or refused with one message; nothing else.

    python tests/hard/fuzz.py 20000 [--seed 0] [--first 0] [--jobs 2]

A case is told by the seed and its number alone: ``--only N`` runs it again and prints its file.
"""

from __future__ import annotations

import argparse
import json
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import chdir, contextmanager
from functools import cache, partial
from multiprocessing import Pool
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

from click.testing import CliRunner, Result
from fuzz_options import CSV, FOLDER, MINUTES, OUT, PHOTO, SCENE
from fuzz_tasks import Task, task, unchanged

from graphic_tmm.__main__ import main

LONG = 10.0
"""Seconds a command may add to what the scene takes unchanged: more is a hang."""
HANG, ASLEEP = 30, 600
"""Seconds after which a command is broken off: of the processor, and of the day (it waits for something)."""
MEMORY = 2 << 30
"""Bytes that a process may take (not with ``--only``): more is a fault, not a machine that swaps."""


class Case(NamedTuple):
    """What came of one changed scene: its number, scene, command, exit status, seconds, what is wrong."""

    number: int
    scene: str
    command: str
    status: int
    seconds: float
    fault: str


# ---------------------------------------------------------------- one case


class _Hang(BaseException):
    """A command was broken off."""


@contextmanager
def _clock(seconds: int) -> Iterator[None]:
    def ring(*_: Any) -> None:
        raise _Hang

    before = [signal.signal(one, ring) for one in (signal.SIGALRM, signal.SIGVTALRM)]
    signal.alarm(ASLEEP)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        for one, old in zip((signal.SIGALRM, signal.SIGVTALRM), before, strict=True):
            signal.signal(one, old)


def arguments(one: Task, files: dict[str, Path]) -> list[str]:
    """Return a command line, its files named."""
    line = list(one.line)
    for mark, path in files.items():
        line = [word.replace(mark, str(path)) for word in line]
    return line


def _whole(out: Path) -> str:
    """Return what is wrong with the files written."""
    for path in out.rglob("*") if out.exists() else ():
        if path.name.endswith(".part"):
            return f"left {path.name}"
        if path.suffix == ".svg":
            try:
                ElementTree.parse(path)
            except ElementTree.ParseError as error:
                return f"{path.name} is not whole: {error}"
    return ""


def _told(line: tuple[str, ...], text: str) -> str:
    """Return what is wrong with a text printed for machines."""
    if "json" not in line[line.index("-f") :][1:2] if "-f" in line else True:
        return ""
    if line.count("-f") != 1 or text.startswith("Usage:") or {"template", "--template"} & {*line}:
        return ""
    try:
        json.loads(text, parse_constant=_no_number)
    except ValueError as error:
        return f"no JSON: {error}"
    return ""


def _no_number(text: str) -> float:
    raise ValueError(f"{text} in it")


def run(one: Task, folder: Path) -> tuple[int, float, str]:
    """Run a task in a folder; return its status, seconds, and what is wrong."""
    files = {
        SCENE: folder / "scene.toml",
        CSV: folder / "readings.csv",
        MINUTES: folder / "minutes.toml",
        PHOTO: folder / "photo.jpg",
    }
    out = folder / "out"
    given = {
        SCENE: one.text.encode("utf-8", "surrogatepass"),
        CSV: one.readings,
        MINUTES: one.minutes,
        PHOTO: one.photo,
    }
    for mark, data in given.items():
        if data is not None:
            files[mark].write_bytes(data)
    for name, data in one.files:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)
    before = _stands(folder, out)
    start = time.process_time()
    try:
        with _clock(HANG), chdir(folder), warnings.catch_warnings(action="error"):
            result = CliRunner().invoke(main, arguments(one, {**files, OUT: out, FOLDER: folder}))
    except _Hang:
        return -1, float(HANG), f"hangs for {HANG} s"
    seconds = time.process_time() - start
    if isinstance(result.exception, _Hang):
        return -1, seconds, f"hangs for {HANG} s"
    return result.exit_code, seconds, _fault(one, result, out, before, _stands(folder, out))


def _stands(folder: Path, out: Path) -> dict[str, bytes]:
    """Return what stands in a folder but for the output."""
    return {
        path.name: path.read_bytes() for path in folder.iterdir() if path != out and path.is_file()
    }


def _fault(
    one: Task, result: Result, out: Path, before: dict[str, bytes], after: dict[str, bytes]
) -> str:
    """Return what is wrong with how a command has ended; "" if nothing."""
    status = result.exit_code
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        return f"traceback: {''.join(traceback.format_exception(result.exception)[-3:])}"
    ends = {"check": (0, 1, 2), "batch": (0, 1, 2), "photo": (0, 1, 2, 3)}
    if status not in next((ends[name] for name in one.line if name in ends), (0, 2)):
        return f"exit status {status}: {result.stderr[:300]!r}"
    if status == 2 and not result.stderr.startswith(("graphic-tmm: ", "Usage: ", "Error: ")):
        return f"no message: {result.stderr[:200]!r}"
    if status == 2 and (out.exists() or result.stdout):
        return "refused, but something was written"
    if {name: after.get(name) for name in before} != before:
        return "changed what it was given"
    strange = set(after) - set(before)
    if (status == 2 and strange) or (one.command != "options" and strange):
        return f"wrote beside its folder: {strange}"
    return _whole(out) or (_told(one.line, result.stdout) if status != 2 else "")


@cache
def usual(name: str, command: str) -> float:
    """Return the seconds a command takes on the scene as it comes, the second time."""
    for _ in range(2):
        folder = Path(tempfile.mkdtemp())
        try:
            seconds = run(unchanged(name, command), folder)[1]
        finally:
            shutil.rmtree(folder)
    return seconds


def case(number_: int, seed: int = 0, names: tuple[str, ...] = ()) -> Case:
    """Run one case."""
    return cased(number_, task(seed, number_, names))


def cased(number_: int, one: Task) -> Case:
    """Run the task of a case."""
    folder = Path(tempfile.mkdtemp())
    try:
        status, seconds, fault = run(one, folder)
    finally:
        shutil.rmtree(folder)
    if not fault and seconds > LONG:
        plain = usual(one.scene, one.command) if one.photo is None else 0.0
        fault = f"takes {seconds:.1f} s, unchanged {plain:.1f} s" if seconds > LONG + plain else ""
    return Case(number_, one.scene, one.command, status, seconds, fault)


# ---------------------------------------------------------------- the command


def _only(number_: int, one: Task, work: Callable[[int], Case]) -> int:
    print(*one.line)
    data = one.minutes if one.command == "minutes" else one.readings
    print(data.decode("utf-8", "backslashreplace") if data else one.text)
    print(found := work(number_))
    return int(bool(found.fault))


def _limited() -> None:
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))


def _all(work: Callable[[int], Case], numbers: range, jobs: int) -> int:
    faults: list[Case] = []
    statuses: Counter[int] = Counter()
    longest = Case(-1, "", "", 0, 0.0, "")
    with Pool(jobs, _limited, maxtasksperchild=50) as pool:
        for found in pool.imap_unordered(work, numbers, chunksize=8):
            statuses[found.status] += 1
            longest = max(longest, found, key=lambda one: one.seconds)
            if found.fault:
                faults.append(found)
                print(f"{found.number} {found.scene} {found.command}: {found.fault}", flush=True)
    told = ", ".join(f"{n} with status {status}" for status, n in sorted(statuses.items()))
    most = f"{longest.seconds:.2f} s (number {longest.number}: {longest.command} {longest.scene})"
    print(f"{len(numbers)} files: {told}; the longest took {most}; {len(faults)} at fault")
    return int(bool(faults))


def command(
    what: str, one: Callable[[int, int], Task], work: Callable[..., Case], count: int
) -> int:
    """Run the cases that the command line asks for: ``one`` tells the task of a case, ``work`` runs it."""
    parser = argparse.ArgumentParser(description=what)
    parser.add_argument("count", type=int, nargs="?", default=count)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", type=int)
    asked = parser.parse_args()
    seeded = partial(work, seed=asked.seed)
    if asked.only is not None:
        return _only(asked.only, one(asked.seed, asked.only), seeded)
    return _all(seeded, range(asked.first, asked.first + asked.count), asked.jobs)


if __name__ == "__main__":
    sys.exit(command("Draw scene files changed at random.", task, case, 20000))
