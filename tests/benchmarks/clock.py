"""How long things take: medians, in this process and in fresh ones."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable

Row = tuple[str, float, float]
"""What is timed, its seconds, and the seconds it is compared with."""


def median(call: Callable[[], object], seconds: float = 1.0) -> float:
    """Median seconds of a call, warm, repeated for about ``seconds``."""
    call()
    times: list[float] = []
    end = time.perf_counter() + seconds
    while time.perf_counter() < end or len(times) < 5:
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def process(*arguments: str) -> float:
    """Median seconds of a fresh process."""

    def run() -> None:
        subprocess.run([sys.executable, *arguments], check=True, capture_output=True)

    return median(run, 2.0)


def show(rows: list[Row]) -> None:
    """Print rows as a table."""
    for name, seconds, against in rows:
        print(f"{name:<58}{seconds * 1000:>10.3f}{seconds / against:>9.2f}")
