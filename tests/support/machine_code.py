"""Tapes of numbers worked as machine code, without a log."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.compile.llvm import loop_of
from graphic_tmm.board.compile.machine import function_of
from graphic_tmm.board.compile.tape import Tape
from graphic_tmm.board.compile.trace import Value


def worked(
    tape: Tape,
    found: Sequence[Value],
    rows: Sequence[NDArray[np.float64]],
    cuts: Sequence[int] = (),
) -> list[NDArray[Any]]:
    """Work numbers at all positions of the inputs ``rows``, cut into parts; one of one number is no row."""
    leaves = [
        tuple(tape.plain(part) for part in ((one.re, one.im) if one.im is not None else (one.re,)))
        for one in found
    ]
    loop = loop_of(tape, leaves)
    count = max((row.shape[1] for row in rows), default=8)
    out: list[NDArray[Any]] = [
        np.empty(
            (1, count if leaf.varies else 1),
            np.float64 if len(leaf.parts) == 1 else np.complex128,
        )
        for leaf in loop.leaves
    ]
    still = np.array([rows[k].item() for k in loop.still])
    table = [row.ctypes.data for row in (*(rows[k] for k in loop.rows), *out)]
    ends = [0, *cuts, count]
    run = function_of(loop.text)
    for start, stop in pairwise(ends):
        frame = np.array([start, stop, still.ctypes.data, *table], np.int64)
        run.call(frame.ctypes.data, 0)
    return out
