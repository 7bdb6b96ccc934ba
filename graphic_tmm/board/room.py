"""Memory for results: taken in large pieces, and used again when nobody has the results any more.

To touch memory for the first time costs more than to fill it: the system makes every page empty before. So a
large piece that is let go waits for the next results. The system may take it back while it waits.
"""

from __future__ import annotations

import ctypes
import sys
import weakref
from collections import deque
from typing import Any

import numpy as np
from numpy.typing import NDArray

LARGE, ALIGNED, PIECE = 1 << 20, 64, 8
"""Bytes of a result for which pages matter, its alignment, the most results in one piece."""
MOST = 1 << 28
"""Bytes that wait at most."""
WAITING: deque[NDArray[np.uint8]] = deque()
"""Pieces that nobody has, the oldest first. Its ends are taken and added to at one stroke, by any thread."""
_FREE, _PAGE = 8, 4096
"""Linux: these pages may be taken back when memory is wanted elsewhere, and are kept if they are written to."""


class Room:
    """Room for so many results, taken in large pieces: the system gives those in huge pages, quickly."""

    def __init__(self, results: int) -> None:
        self._rest, self._left = np.empty(0, np.uint8), results

    def empty(self, shape: tuple[int, int], dtype: Any) -> NDArray[Any]:
        """Return an array that holds nothing yet."""
        size = shape[0] * shape[1] * np.dtype(dtype).itemsize
        self._left -= 1
        if size < LARGE:
            return np.empty(shape, dtype)
        taken = -(-size // ALIGNED) * ALIGNED
        if taken > self._rest.size:
            # what is never written to takes no memory
            self._rest = piece(min(PIECE, max(self._left, 0) + 1) * taken)
        mine, self._rest = self._rest[:size], self._rest[taken:]
        found: NDArray[Any] = mine.view(dtype).reshape(shape)
        return found


def piece(size: int) -> NDArray[np.uint8]:
    """Return memory of so many bytes or some more, that holds anything."""
    if _offer is None:
        return np.empty(size, np.uint8)
    memory = _waiting(size)
    if memory is None:
        memory = np.empty(size, np.uint8)
    # every array of this memory has the holder: it goes with the last of them
    holder = (ctypes.c_char * memory.nbytes).from_buffer(memory)  # type: ignore[arg-type]
    weakref.finalize(holder, _let_go, memory).atexit = False
    return np.ndarray((memory.nbytes,), np.uint8, holder)  # type: ignore[arg-type]


def _waiting(size: int) -> NDArray[np.uint8] | None:
    """Return a piece that waits and is large enough, but not twice as large; it waits no longer."""
    others: list[NDArray[np.uint8]] = []
    found = None
    while found is None and WAITING:
        try:
            memory = WAITING.pop()
        except IndexError:
            break
        if size <= memory.nbytes < 2 * size:
            found = memory
        else:
            others.append(memory)
    WAITING.extend(reversed(others))
    return found


def _let_go(memory: NDArray[np.uint8]) -> None:
    """Let a piece wait that nobody has any more, if it is not too large; the oldest go for it."""
    if memory.nbytes > MOST or _offer is None:
        return
    first = memory.ctypes.data
    begin, end = -(-first // _PAGE) * _PAGE, (first + memory.nbytes) // _PAGE * _PAGE
    _offer(begin, end - begin, _FREE)
    WAITING.append(memory)
    try:
        while sum(one.nbytes for one in tuple(WAITING)) > MOST:
            WAITING.popleft()
    except IndexError:
        pass


def _offering() -> Any:
    """Return what offers memory to the system; None where memory does not wait."""
    if not sys.platform.startswith("linux"):
        return None
    found = getattr(ctypes.CDLL(None), "madvise", None)
    if found is not None:
        found.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int]
    return found


_offer = _offering()
