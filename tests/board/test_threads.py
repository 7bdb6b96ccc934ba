"""Parts of a row: all positions are worked, none twice, none alone."""

from __future__ import annotations

import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board import threads as module
from graphic_tmm.board.threads import LEAST, cores, shared


@given(count=st.integers(8, 5000), least=st.integers(1, 8), threads=st.integers(1, 9))
def test_every_position_is_worked_once(count: int, least: int, threads: int) -> None:
    parts: list[tuple[int, int]] = []
    shared(lambda start, stop: parts.append((start, stop)), count, least, threads)
    assert sorted(at for part in parts for at in range(*part)) == list(range(count))
    assert len(parts) == min(threads, count // least)
    assert min(stop - start for start, stop in parts) >= least


def test_parts_are_worked_at_the_same_time() -> None:
    meeting = threading.Barrier(3, timeout=30)
    shared(lambda start, stop: meeting.wait() and None, 30, 1, 3)


def test_a_fault_of_a_part_is_told() -> None:
    def work(start: int, stop: int) -> None:
        if start:
            raise ValueError("the second part")

    with pytest.raises(ValueError, match="the second part"):
        shared(work, 30, 1, 2)


def test_few_positions_are_not_shared_by_themselves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "cores", lambda: 4)
    parts: list[tuple[int, int]] = []
    shared(lambda start, stop: parts.append((start, stop)), 2 * LEAST - 1, 8, None)
    assert len(parts) == 1
    shared(lambda start, stop: parts.append((start, stop)), 3 * LEAST, 8, None)
    assert len(parts) == 4


@pytest.mark.parametrize("name", ["NUMBA_NUM_THREADS", "OMP_NUM_THREADS"])
def test_the_environment_limits_the_threads(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for one in ("NUMBA_NUM_THREADS", "OMP_NUM_THREADS"):
        monkeypatch.delenv(one, raising=False)
    free = cores()
    assert free >= 1
    for told, due in (("1", 1), ("100000", free), ("0", free), ("4,2", free), ("", free)):
        monkeypatch.setenv(name, told)
        assert cores() == due
