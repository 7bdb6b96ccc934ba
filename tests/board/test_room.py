"""Memory of results is used again once nobody has them, and never before."""

from __future__ import annotations

import gc
import random
from collections import deque
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

from graphic_tmm.board import room
from graphic_tmm.board.room import LARGE, Room, piece

WAITS = pytest.mark.skipif(room._offer is None, reason="memory waits on Linux only")
COUNT = LARGE // 8


@pytest.fixture(autouse=True)
def waiting(monkeypatch: pytest.MonkeyPatch) -> deque[Any]:
    """Nothing waits; what does is this test's."""
    mine: deque[Any] = deque()
    monkeypatch.setattr(room, "WAITING", mine)
    return mine


def address(array: np.ndarray) -> int:
    found: int = array.__array_interface__["data"][0]
    return found


@WAITS
def test_a_piece_waits_as_soon_as_the_last_view_of_it_is_gone(waiting: deque[Any]) -> None:
    results = Room(3)
    arrays = [results.empty((1, COUNT), np.complex128) for _ in range(3)]
    at = address(arrays[0])
    view = arrays[1][0].real[5:9]
    kept = memoryview(arrays[2].view(np.float64)[0, 1:3])
    del results, arrays
    assert not waiting
    view[:] = 4.0
    del view
    assert not waiting
    del kept
    gc.collect()
    assert len(waiting) == 1
    again = Room(3).empty((1, COUNT), np.complex128)
    assert address(again) == at
    assert not waiting


@WAITS
def test_a_piece_is_taken_for_what_nearly_fills_it(waiting: deque[Any]) -> None:
    del (one := [piece(8 * LARGE)])[:]
    assert not one
    assert len(waiting) == 1
    small, large = piece(3 * LARGE), piece(9 * LARGE)
    assert len(waiting) == 1
    fits = piece(5 * LARGE)
    assert fits.nbytes == 8 * LARGE
    assert not waiting
    del small, large, fits
    assert sorted(one.nbytes for one in waiting) == [3 * LARGE, 8 * LARGE, 9 * LARGE]


@WAITS
def test_what_waits_is_bounded(waiting: deque[Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room, "MOST", 10 * LARGE)
    pieces = [piece(size * LARGE) for size in (11, 4, 3, 2, 4)]
    while pieces:
        del pieces[0]
        assert sum(one.nbytes for one in waiting) <= 10 * LARGE
    assert [one.nbytes // LARGE for one in waiting] == [3, 2, 4]


@WAITS
def test_small_results_wait_for_nobody(waiting: deque[Any]) -> None:
    array = Room(1).empty((1, 100), np.float64)
    del array
    assert not waiting


def test_threads_share_no_piece() -> None:
    """Each writes its own number all over, and finds it there."""

    def work(k: int) -> bool:
        pick, held = random.Random(k), list[tuple[float, np.ndarray]]()
        for n in range(60):
            array = Room(2).empty((1, COUNT + pick.randrange(COUNT)), np.float64)
            array[:, ::512] = number = 1000.0 * k + n
            held.append((number, array))
            if len(held) > 3:
                held.pop(pick.randrange(4))
            if not all((one[:, ::512] == due).all() for due, one in held):
                return False
        return True

    with ThreadPoolExecutor(6) as pool:
        assert all(pool.map(work, range(12)))


def test_where_memory_does_not_wait_it_is_new(
    waiting: deque[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(room, "_offer", None)
    array = Room(1).empty((1, COUNT), np.float64)
    array[:] = 1.0
    del array
    assert not waiting
