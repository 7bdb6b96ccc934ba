"""The log as loops over positions: its formulas taken down once, worked as machine code.

A log is a straight-line program, so its operations noted on a tape (`traced`) are the whole calculation, each
intermediate once. What cannot be noted (curves, searches) runs by numpy, between two loops (`loop_parts`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import Calls, Values, in_blocks, run
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.loop_parts import Part, part_of_loop
from graphic_tmm.board.loop_passes import WIDTH
from graphic_tmm.board.room import Room
from graphic_tmm.board.sources import RULER
from graphic_tmm.board.threads import shared


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


def _fill(part: Part, values: Values, count: int, hand: Hand, threads: int | None) -> None:
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
