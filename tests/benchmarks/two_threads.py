"""What two threads of a compiled log gain by the clock, and what holds them back.

    python tests/benchmarks/two_threads.py

Of one mechanism after another: results in new memory; in memory that waited for them (`board/room.py`), as in a
series of calls; the loop alone, into memory that was written to before;
few positions at a time, so that all of it stays in cache; and in two processes of their own. Beside it what two
threads gain that only fill memory, new or written to before, and that only calculate, in cache: where these
gain nothing, somebody else has the machine. Calls take turns, and count only while nobody else works.
"""

from __future__ import annotations

import os
import statistics
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import cache
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from clock import Row, show  # first: it finds the tests' other modules

import bare  # isort: skip
import kinematics  # isort: skip

from graphic_tmm.board import room
from graphic_tmm.board.compile import run as compiled

COUNT, PART = 1_000_000, 2_000
ROUNDS, PATIENCE = 12, 120.0
"""Calls that count, and seconds that are waited for them."""
CORES = os.cpu_count() or 1
STAT = Path("/proc/stat")
TICK = 1.0 / os.sysconf("SC_CLK_TCK") if STAT.exists() else 0.0
BYTES = 128 << 20
HALVES = 10
"""Halves that a process works at a time."""
POOL = ThreadPoolExecutor(1)
Work = Callable[[int, int], None]


def quiet(calls: dict[str, Callable[[], object]]) -> dict[str, float]:
    """Return the median seconds by the clock of calls that take turns, while nobody else worked; else NaN."""
    found: dict[str, list[float]] = {name: [] for name in calls}
    end = time.perf_counter() + PATIENCE
    while min(map(len, found.values())) < ROUNDS and time.perf_counter() < end:
        if others(lambda: time.sleep(0.05))[1]:
            continue
        for name, call in calls.items():
            seconds, disturbed = others(call)
            if not disturbed:
                found[name].append(seconds)
    return {name: statistics.median(each or [np.nan]) for name, each in found.items()}


def others(call: Callable[[], object]) -> tuple[float, bool]:
    """Call; return the seconds by the clock, and whether others had a tenth of the processors or more."""
    worked, own, start = _worked(), time.process_time(), time.perf_counter()
    call()
    seconds = time.perf_counter() - start
    worked, own = _worked() - worked, time.process_time() - own
    return seconds, worked - own > 0.1 * CORES * seconds + TICK


def _worked() -> float:
    """Return the seconds that all processors have worked; 0 where nobody tells."""
    if not STAT.exists():
        return 0.0
    ticks = [int(word) for word in STAT.read_text().split("\n", 1)[0].split()[1:]]
    return TICK * (sum(ticks) - ticks[3] - ticks[4])


def halves(work: Work, count: int) -> Callable[[], object]:
    """Return a call by which two threads do the two halves of a work."""

    def both() -> None:
        other = POOL.submit(work, count // 2, count)
        work(0, count // 2)
        other.result()

    return both


def over_and_over(work: Work) -> Work:
    """Return a work that does its first positions again and again, as many in all."""

    def again(start: int, stop: int) -> None:
        for _ in range((stop - start) // PART):
            work(start, start + PART)

    return again


def anew(one: kinematics.Case, fast: Any, threads: int) -> None:
    """Run a log whose results get memory that nothing was written to."""
    room.WAITING.clear()
    one.log(fast, threads=threads)


def work_of(one: kinematics.Case, fast: Any) -> tuple[Work, object]:
    """Return what a compiled log does with its positions once its results have room, and the results."""
    caught: list[Work] = []
    real = compiled.shared

    def catch(work: Work, count: int, fewest: int, threads: int | None) -> None:
        caught.append(work)
        real(work, count, fewest, threads)

    compiled.shared = catch
    try:
        found = one.log(fast, threads=1)
    finally:
        compiled.shared = real
    return caught[0], found


@cache
def half(k: int) -> kinematics.Case:
    """Return a mechanism at half of the positions."""
    return kinematics.case(bare.BARE[k], COUNT // 2)


def spell(k: int, times: int) -> tuple[float, float]:
    """Work the half several times in this process; return when it began and ended."""
    one = half(k)
    fast = one.program.compiled()
    one.log(fast)
    start = time.perf_counter()
    for _ in range(times):
        one.log(fast)
    return start, time.perf_counter()


def by_processes(k: int) -> float:
    """Return how many times as fast two processes work two halves as one works both."""
    gains = []
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        list(pool.map(spell, [k, k], [1, 1]))
        for _ in range(5):
            (alone,) = pool.map(spell, [k], [2 * HALVES])
            pair = list(pool.map(spell, [k, k], [HALVES, HALVES]))
            together = max(end for _, end in pair) - min(start for start, _ in pair)
            gains.append((alone[1] - alone[0]) / together)
    return max(gains)


def gained(name: str, one: float, two: float) -> Row:
    """Return a row of a gain."""
    if one != one or two != two:
        return Row(name, "others were at work all the time")
    return Row(name, f"{1e3 * one:.1f} ms, {1e3 * two:.1f} by two: {one / two:.2f}")


def of_mechanisms() -> Iterator[Row]:
    """Yield the rows of each mechanism."""
    for k, form in enumerate(bare.BARE):
        one = kinematics.case(form)
        fast = one.program.compiled()
        work, results = work_of(one, fast)
        again = over_and_over(work)
        found = quiet(
            {
                "new memory": lambda one=one, fast=fast: anew(one, fast, 1),
                "new memory, two": lambda one=one, fast=fast: anew(one, fast, 2),
                "memory that waited": lambda one=one, fast=fast: one.log(fast, threads=1),
                "memory that waited, two": lambda one=one, fast=fast: one.log(fast, threads=2),
                "memory written to before": lambda work=work: work(0, COUNT),
                "memory written to before, two": halves(work, COUNT),
                "in cache": lambda again=again: again(0, COUNT),
                "in cache, two": halves(again, COUNT),
            }
        )
        for name in ("new memory", "memory that waited", "memory written to before", "in cache"):
            yield gained(f"{form.name}: {name}", found[name], found[f"{name}, two"])
        yield Row(f"{form.name}: memory that waited, two processes", f"{by_processes(k):.2f}")
        del results


def of_memory() -> Iterator[Row]:
    """Yield the rows of memory alone, and of arithmetic alone."""
    count = BYTES // 8
    kept, angles = np.ones(count), np.linspace(0.0, 9.0, 4096)

    def filled(array: Any) -> Work:
        return lambda start, stop: array[start:stop].fill(1.0)

    def sines(start: int, stop: int) -> None:
        for _ in range(start, stop):
            np.sin(angles)

    found = quiet(
        {
            "new": lambda: filled(np.empty(count))(0, count),
            "new, two": lambda: halves(filled(np.empty(count)), count)(),
            "old": lambda: filled(kept)(0, count),
            "old, two": halves(filled(kept), count),
            "sines": lambda: sines(0, 400),
            "sines, two": halves(sines, 400),
        }
    )
    size = f"{BYTES >> 20} MB"
    yield gained(f"{size} of new memory filled", found["new"], found["new, two"])
    yield gained(f"{size} written to before filled", found["old"], found["old, two"])
    yield gained("sines by numpy, in cache", found["sines"], found["sines, two"])


def main() -> None:
    """Print the table."""
    show("two threads, by the clock", [*of_memory(), *of_mechanisms()])


if __name__ == "__main__":
    main()
