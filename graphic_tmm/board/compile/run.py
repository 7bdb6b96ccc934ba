"""The log as loops over positions: its formulas taken down once, worked as machine code, by several threads.

A log is a straight-line program, so its operations noted on a tape (`trace`) are the whole calculation, each
intermediate once. What cannot be noted (curves, searches) runs by numpy, between two loops (`loop`). Each
thread works its own part of the row, so their number changes nothing.

A loop may be bound to all that is the same at every call (`Bound`): rows enter it then, and one piece of memory
holds what it leaves. What can be prepared is: the numbers that do not vary, and for so many positions where
everything stands. A call takes a piece, copies the rows into it, and hands out views. Nothing of a call is
kept, so threads may call at once.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from ctypes import addressof, c_char
from itertools import pairwise
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import Calls, Values, in_blocks, run
from graphic_tmm.board.compile.llvm import WIDTH
from graphic_tmm.board.compile.loop import RULER, LoopOfSteps, part_of_loop
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.room import Room
from graphic_tmm.board.values import Reals, arrays

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


def in_loops(
    calls: Calls,
    values: Values,
    count: int,
    block: int,
    hand: Hand,
    kept: frozenset[int],
    threads: int | None = None,
) -> None:
    """Run pointwise calls at ``count`` positions as `in_blocks` does, in compiled loops where these exist."""
    while calls:
        part = part_of_loop(calls, values, hand, kept)
        if part is None:
            run(calls, values, hand)
            return
        if part.results:
            _fill(part, values, count, hand, threads)
        if part.others:
            in_blocks(part.others, values, count, block, hand, part.left)
        calls = part.rest


def _fill(part: LoopOfSteps, values: Values, count: int, hand: Hand, threads: int | None) -> None:
    """Fill the values that a part leaves behind, for all trials."""
    loop = part.loop
    ruler = np.array([[hand.ruler or 1.0]])
    entering = {
        k: ruler if (feed := part.feeds[k]) is RULER else feed.of(values)
        for k in (*loop.rows, *loop.still)
    }
    trials = max([array.shape[0] for array in entering.values()], default=1)
    by_trial = sum(1 << k for k, array in entering.items() if array.shape[0] > 1)
    stop = count if any(leaf.varies for leaf in loop.leaves) else WIDTH
    wide = max(stop, WIDTH)
    rows = [_row(entering[k], wide) for k in loop.rows]
    room = Room(len(loop.leaves))
    leaving = [
        room.empty(
            (trials if depends & by_trial else 1, wide if leaf.varies else 1),
            np.complex128 if len(leaf.parts) == 2 else np.float64,
        )
        for leaf, depends in zip(loop.leaves, part.depends, strict=True)
    ]
    still = _still([entering[k] for k in loop.still], trials)
    frames = _frames(still, [*rows, *leaving], trials)

    def work(start: int, end: int) -> None:
        mine = frames.copy()
        mine[:, 0], mine[:, 1] = start, end
        first = address(mine)
        for t in range(trials):
            part.run.call(first + t * mine.strides[0], 0)

    shared(work, wide, WIDTH, threads)
    if wide > count:
        leaving = [
            np.ascontiguousarray(array[:, :count]) if leaf.varies else array
            for leaf, array in zip(loop.leaves, leaving, strict=True)
        ]
    for slot, kind, places in part.results:
        found = [leaving[k] for k in places]
        values[slot] = found[0] if kind is np.ndarray else kind(*found)


def _row(array: NDArray[np.float64], wide: int) -> NDArray[np.float64]:
    """Return numbers in rows of at least so many, as they lie in memory."""
    if array.shape[1] < wide:
        array = np.pad(array, ((0, 0), (0, wide - array.shape[1])), mode="edge")
    return np.ascontiguousarray(array, dtype=np.float64)


def _still(numbers: Sequence[NDArray[np.float64]], trials: int) -> NDArray[np.float64]:
    """Return the numbers that do not vary with the position, (trial, input)."""
    if trials == 1:
        return np.array([[array.item() for array in numbers]])
    whole = np.empty((trials, len(numbers)))
    for k, array in enumerate(numbers):
        whole[:, k] = array[:, 0]
    return whole


def address(array: NDArray[Any]) -> int:
    """Return the address of an array."""
    found: int = array.__array_interface__["data"][0]
    return found


def _frames(
    still: NDArray[np.float64], rows: Sequence[NDArray[Any]], trials: int
) -> NDArray[np.int64]:
    """Return the frame of each trial, without where it begins and stops."""
    tables = [still, *rows]
    first = np.array([0, 0, *map(address, tables)], dtype=np.int64)
    step = [0, 0, *(one.strides[0] if one.shape[0] > 1 else 0 for one in tables)]
    return first + np.arange(trials)[:, None] * np.array(step, dtype=np.int64)


LAYOUTS = 64
"""Numbers of positions whose layouts are kept."""
_BYTES = 8
_char_of = c_char.from_buffer


def picked(places: Sequence[int]) -> Callable[[Sequence[Any]], tuple[Any, ...]]:
    """Return what picks things at some places; there are fast ways for none, one and several."""
    if len(places) > 1:
        return itemgetter(*places)
    return lambda things: tuple([things[k] for k in places])


class Layout(NamedTuple):
    """Where everything stands in a room for so many positions, each by its first number of the room.

    ``size``: how many numbers it holds; ``entering``: of each row, and ``ends``: of what repeats its last
    number where there are fewer positions than a loop works in step. ``complex``, ``real``: the shape of all
    results of a kind, and their first byte; ``alone``: the type and the first byte of those that do not vary.
    ``frame``: see `Loop`; ``at``: its address.
    """

    size: int
    entering: tuple[slice, ...]
    ends: tuple[slice, ...]
    complex: tuple[tuple[int, int], int]
    real: tuple[tuple[int, int], int]
    alone: tuple[tuple[type, int], ...]
    frame: NDArray[np.int64]
    at: int


class Bound:
    """A loop, the numbers that do not vary, and which of its results are asked for; ``feeds``: what enters."""

    def __init__(
        self, part: LoopOfSteps, values: Mapping[int, Any], hand: Hand, asked: Sequence[int]
    ) -> None:
        loop, feeds = part.loop, part.feeds
        self.feeds = tuple(feeds[k] for k in loop.rows)
        self._part, self._run = part, part.run.call
        still = [None if feeds[k] is RULER else feeds[k].of(values).item() for k in loop.still]
        self._numbers = np.array([hand.ruler or 1.0 if one is None else one for one in still])
        leaves = [(leaf.varies, len(leaf.parts)) for leaf in loop.leaves]
        self._complex = [k for k, leaf in enumerate(leaves) if leaf == (True, 2)]
        self._real = [k for k, leaf in enumerate(leaves) if leaf == (True, 1)]
        self._alone = {k: parts for k, (varies, parts) in enumerate(leaves) if not varies}
        place = {k: n for n, k in enumerate([*self._complex, *self._real, *self._alone])}
        of = {result.slot: place[result.leaves[0]] for result in part.results}
        self._in_order = picked([of[slot] for slot in asked])
        self._layouts: dict[int, Layout] = {}

    def run(self, count: int, rows: Sequence[Reals]) -> tuple[NDArray[Any], ...]:
        """Return what is asked for at ``count`` positions, (position,), in the order in which it was.

        ``rows``: what enters, by ``feeds``.
        """
        here = self._layouts.get(count) or self._laid_out(count)
        room = np.empty(here.size)
        for part, row in zip(here.entering, rows, strict=True):
            room[part] = row
        for part, row in zip(here.ends, rows, strict=False):
            room[part] = row[-1]
        self._run(here.at, addressof(_char_of(room)))  # type: ignore[arg-type]
        complexes = np.ndarray(here.complex[0], np.complex128, room, here.complex[1])
        reals = np.ndarray(here.real[0], np.float64, room, here.real[1])
        if here.ends:
            complexes, reals = complexes[:, :count], reals[:, :count]
        found: list[NDArray[Any]] = [*complexes, *reals]
        for kind, first in here.alone:
            found.append(np.ndarray((count,), kind, room, first, (0,)))
            found[-1].flags.writeable = False
        return self._in_order(found)

    def _laid_out(self, count: int) -> Layout:
        wide, room = max(count, WIDTH), _Measured()
        rows = [room.take(wide) for _ in self.feeds]
        places = {k: room.take(2 * wide) for k in self._complex}
        places |= {k: room.take(wide) for k in self._real}
        places |= {k: room.take(parts) for k, parts in self._alone.items()}
        first = [_BYTES * places[kind[0]] if kind else 0 for kind in (self._complex, self._real)]
        table = [_BYTES * one for one in (*rows, *(places[k] for k in range(len(places))))]
        frame = np.array([0, wide, address(self._numbers), *table], np.int64)
        made = Layout(
            room.size,
            tuple(slice(one, one + count) for one in rows),
            tuple(slice(one + count, one + wide) for one in rows if count < wide),
            ((len(self._complex), wide), first[0]),
            ((len(self._real), wide), first[1]),
            tuple(
                (np.complex128 if parts == 2 else np.float64, _BYTES * places[k])
                for k, parts in self._alone.items()
            ),
            frame,
            address(frame),
        )
        if len(self._layouts) >= LAYOUTS:
            self._layouts = {}
        self._layouts[count] = made
        return made


class _Measured:
    """A room while it is measured."""

    def __init__(self) -> None:
        self.size = 0

    def take(self, numbers: int) -> int:
        """Return where so many more numbers begin."""
        self.size += numbers
        return self.size - numbers


def bound(
    calls: Calls, values: Mapping[int, Any], hand: Hand, asked: Sequence[int]
) -> Bound | None:
    """Return pointwise calls as one loop, bound to the values that do not vary.

    Parameters
    ----------
    calls
        The calls.
    values
        What enters them, by slot; of what varies at some positions, two or more.
    hand
        Who reads; none that slips.
    asked
        The slots that are asked for.

    Returns
    -------
    Bound or None
        None where the calls are no one loop of one trial, or something is asked for that it does not leave as
        one array.
    """
    if any(array.shape[0] > 1 for value in values.values() for array in arrays(value)):
        return None
    part = part_of_loop(calls, values, hand, frozenset(asked))
    if part is None or part.others or part.rest:
        return None
    plain = {result.slot for result in part.results if result.kind is np.ndarray}
    return Bound(part, values, hand, asked) if plain.issuperset(asked) else None
