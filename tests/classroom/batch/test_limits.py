"""A work that never ends is broken off with its process, named, and nothing else is lost."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from support.batches import due, files_of, hangs, hangs_in_machine_code, hangs_once, sums, work
from support.each import each
from support.gallery import ROOT

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.classroom.batch.work import ending_after

LIMIT = 1.5


@each("endless", [hangs, hangs_in_machine_code])
@each("executor", [1, 2])
@pytest.mark.slow
def test_what_never_ends_is_named_and_the_rest_is_made(
    endless: object, executor: int, tmp_path: Path
) -> None:
    works = sums(8)
    works[3:3] = [work(endless, "endless", "")]
    begun = time.monotonic()
    ran = run(works, tmp_path / "out", executor=executor, limit=LIMIT)
    assert 2 * LIMIT < time.monotonic() - begun < 30.0
    assert list(ran.failed) == ["endless"]
    assert "took longer than 1.5 s and was broken off" in ran.failed["endless"]
    assert ran.made == tuple(map(str, range(8)))
    assert files_of(tmp_path / "out") == due(8)


@pytest.mark.slow
def test_what_was_slow_once_is_made_in_the_end(tmp_path: Path) -> None:
    works = [*sums(3), work(hangs_once, "once", str(tmp_path / "once"))]
    ran = run(works, tmp_path / "out", executor=2, limit=LIMIT)
    assert ran.failed == {}
    assert files_of(tmp_path / "out")["once/ended.txt"] == b"ended"


@pytest.mark.slow
def test_a_limit_is_for_each_work_and_not_for_all(tmp_path: Path) -> None:
    ran = run(sums(6, pause=0.5), tmp_path / "out", executor=1, limit=LIMIT)
    assert (ran.failed, ran.done) == ({}, 6)


def test_nothing_holds_in_the_process_that_asks(tmp_path: Path) -> None:
    ran = run(sums(1, pause=0.4), tmp_path / "out", executor=0, limit=0.1)
    assert ran.made == ("0",)


@each("told", [True, False])
def test_where_it_was_is_told_where_faults_are(told: bool) -> None:
    code = (
        "from graphic_tmm.classroom.batch.work import ending_after\n"
        "def never():\n    sum(range(10**18))\n"
        "with ending_after(0.3):\n    never()\n"
    )
    variable = {"GRAPHIC_TMM_TRACEBACK": "1"} if told else {}
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": str(ROOT), **variable},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert ("in never" in done.stderr) == told


@pytest.mark.slow
def test_what_ends_in_time_is_left_alone() -> None:
    with ending_after(0.2):
        pass
    time.sleep(0.4)  # this process would have ended
    with pytest.raises(ZeroDivisionError), ending_after(0.2):
        raise ZeroDivisionError
    time.sleep(0.4)
