"""What the everyday tests see: small faults, each put into a copy of the package, and the tests nearest run.

    python tests/benchmarks/planted_faults.py [--jobs 2] [--only NAME] [--deadline 900]

A fault of the list beside this file is a factor, a sign, a bound, an index, a unit or a comparison; every room
has some, the page's scripts too. The tests nearest are the everyday ones of the room's own folder and of what
uses it; the first that fails ends a run. A line for each fault; one whose tests do not end within the deadline
is missed. Status 1 if fewer than 55 of 60 are seen.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[2]
LIST = Path(__file__).with_suffix(".txt")
SHARE = 55 / 60
"""So many of the faults are to be seen."""
USERS = {"board/operations": ("chapters/kinematics", "chapters/forces"), "page/web": ("page",)}
"""Folders of tests where rooms are proven by what uses them."""


class Fault(NamedTuple):
    """A fault: the file in the package, the words that stand there once, and what stands there instead."""

    file: str
    right: str
    wrong: str

    @property
    def tests(self) -> list[str]:
        """The folders of tests nearest."""
        parts = Path(self.file).parts[:-1]
        depths = (Path("tests", *parts[:n]) for n in range(len(parts), 0, -1))
        own = next(one for one in depths if any((ROOT / one).glob("test_*.py")))
        of = (some for room, some in USERS.items() if self.file.startswith(room))
        return list(dict.fromkeys([str(own), *(f"tests/{one}" for some in of for one in some)]))


def planted() -> list[Fault]:
    """Return the faults of the list.

    Raises
    ------
    SystemExit
        If what is to be changed does not stand in its file once.
    """
    lines = LIST.read_text("utf-8").splitlines()
    found = [Fault(*line.split(" → ")) for line in lines if not line.startswith("#")]
    for fault in found:
        text = (ROOT / "graphic_tmm" / fault.file).read_text("utf-8")
        if text.count(fault.right) != 1:
            raise SystemExit(f"{fault.file}: {fault.right!r} does not stand there once")
    return found


def seen(fault: Fault, deadline: float) -> tuple[str, float]:
    """Return which test saw a fault, "" if none did, and the seconds that it took."""
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as place:
        copy = Path(place)
        for name in ("graphic_tmm", "tests", "sheets", ".ci"):
            without = shutil.ignore_patterns("__pycache__")
            shutil.copytree(ROOT / name, copy / name, symlinks=True, ignore=without)
        for name in ("pyproject.toml", "README.md", "LICENSE"):
            shutil.copy(ROOT / name, copy)
        file = copy / "graphic_tmm" / fault.file
        file.write_text(file.read_text("utf-8").replace(fault.right, fault.wrong), "utf-8")
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-qx",
            "-m",
            "not slow",
            "-p",
            "no:cacheprovider",
        ]
        try:
            ran = subprocess.run(
                [*command, *fault.tests],
                cwd=copy,
                env={**os.environ, "PYTHONPATH": str(copy)},
                timeout=deadline,
                capture_output=True,
                text=True,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return "", deadline
    if ran.returncode == pytest.ExitCode.NO_TESTS_COLLECTED:
        raise SystemExit(f"{fault.file}: no everyday tests in {fault.tests}")
    lines = [line for line in ran.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    told = lines[0].split(" ", 1)[1].split(" - ")[0] if lines else "nothing could be run"
    return told if ran.returncode else "", time.monotonic() - start


def main() -> int:
    """Plant all, print what saw each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="faults of files with this in their names")
    parser.add_argument("--deadline", type=float, default=900.0, help="seconds a fault")
    asked = parser.parse_args()
    some = [one for one in planted() if asked.only in one.file]
    count = 0
    with ThreadPoolExecutor(asked.jobs) as pool:
        ran = pool.map(partial(seen, deadline=asked.deadline), some)
        for fault, (name, seconds) in zip(some, ran, strict=True):
            count += bool(name)
            what = f"{seconds:4.0f} s  {' → '.join(fault)}"
            print(f"{'seen  ' if name else 'MISSED'} {what}  {name}", flush=True)
    print(f"{count} of {len(some)} seen")
    return int(count < SHARE * len(some))


if __name__ == "__main__":
    sys.exit(main())
