"""A row of positions shared among threads: each works its own part, so their number changes nothing."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise

LEAST = 32_768
"""Positions that pay for a thread."""
_LIMITS = ("NUMBA_NUM_THREADS", "OMP_NUM_THREADS")
"""What people set to tell how many threads a calculation may take."""


def cores() -> int:
    """Return how many threads work at a time: the cores of this process, or fewer if that is asked for."""
    some = hasattr(os, "sched_getaffinity")
    found = len(os.sched_getaffinity(0)) if some else os.cpu_count() or 1
    for name in _LIMITS:
        told = os.environ.get(name, "").strip()
        if told.isdigit() and int(told) > 0:
            found = min(found, int(told))
    return found


def shared(work: Callable[[int, int], None], count: int, least: int, threads: int | None) -> None:
    """Do ``work(start, stop)`` on all of ``count`` positions.

    Parameters
    ----------
    work
        What is done; of its own accord it lets other threads of the program run.
    count
        How many positions there are.
    least
        The fewest positions that it can work at.
    threads
        How many threads at the most; None for `cores` where that pays.
    """
    if threads is None:
        threads = cores() if count >= 2 * LEAST else 1
        threads = min(threads, count // LEAST)
    parts = max(min(threads, count // least), 1)
    if parts == 1:
        work(0, count)
        return
    ends = [count * k // parts for k in range(parts + 1)]
    with ThreadPoolExecutor(parts - 1) as pool:
        others = [pool.submit(work, *pair) for pair in pairwise(ends[1:])]
        work(ends[0], ends[1])
        for other in others:
            other.result()
