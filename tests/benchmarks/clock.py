"""How long things take: medians of calls that take turns, and a table in Markdown.

The machines are noisy: what is compared runs in turns in one process; trust the ratios, not the seconds.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(ROOT)]


class Row(NamedTuple):
    """A line of the table: what was measured, what came out, what is wanted of it (and whether it holds)."""

    what: str
    found: str
    wanted: str = ""
    holds: bool | None = None


def in_turns(
    calls: Mapping[str, Callable[[], object]], *, rounds: int = 9, least: int = 1
) -> dict[str, float]:
    """Median seconds of calls that take turns, ``least`` at a time; the first round only warms up."""
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds + 1):
        for name, call in calls.items():
            start = time.perf_counter()
            for _ in range(least):
                call()
            times[name].append((time.perf_counter() - start) / least)
    return {name: statistics.median(each[1:]) for name, each in times.items()}


def process(*arguments: str) -> Callable[[], object]:
    """Return a call that runs python afresh."""
    # with the bytecode that an installed package has: the first round writes it
    env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return lambda: subprocess.run(
        [sys.executable, *arguments], check=True, capture_output=True, cwd=ROOT, env=env
    )


def slope(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return the slope of a straight line through the logarithms: 1 where cost grows as size."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def show(title: str, rows: Sequence[Row]) -> None:
    """Print rows as a table in Markdown."""
    print(f"| {title} | measured | wanted |\n|---|---|---|")
    for what, found, wanted, holds in rows:
        told = wanted if holds is None else f"{wanted}: {'yes' if holds else '**no**'}"
        print(f"| {what} | {found} | {told} |", flush=True)
    print()
