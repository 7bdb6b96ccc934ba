"""A cluster does the same as processes do: the same files, the same ends."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from support.batches import (
    bringing,
    dies,
    dies_once,
    due,
    files_of,
    hangs,
    raises,
    refused,
    sums,
    work,
)
from support.cluster import cluster

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.errors import SheetError

pytest.importorskip("distributed")
pytestmark = pytest.mark.filterwarnings("default")  # its own
OLD = 2.5
"""s: a worker that ends within its first second or so is taken, on a busy machine, for one that cannot begin,
and no other is begun for it."""


def test_all_is_made_once(scheduler: str, tmp_path: Path) -> None:
    log = tmp_path / "log"
    ran = run(sums(12, log), tmp_path / "out", executor=scheduler)
    assert ran.made == tuple(map(str, range(12)))
    assert files_of(tmp_path / "out") == due(12)
    assert len(log.read_text().split()) == 12
    assert run(sums(12, log), tmp_path / "out", executor=2).made == ()


def test_errors_are_told_as_those_of_processes(scheduler: str, tmp_path: Path) -> None:
    works = [
        *sums(3),
        work(raises, "bad", str(tmp_path / "raised")),
        work(refused, "wrong", str(tmp_path / "refused")),
    ]
    there = run(works, tmp_path / "there", executor=scheduler)
    here = run(works, tmp_path / "here", executor=1)
    assert there == here
    assert list(there.failed) == ["bad", "wrong"]


@pytest.mark.turns(2, "ends")
@pytest.mark.slow
def test_what_kills_its_worker_fails_and_no_more(scheduler: str, tmp_path: Path) -> None:
    once = work(dies_once, "once", str(tmp_path / "once"))
    works = [*sums(6), work(dies, "deadly", f"{OLD}"), once]
    ran = run(works, tmp_path / "out", executor=scheduler)
    assert list(ran.failed) == ["deadly"]
    assert "died" in ran.failed["deadly"]
    assert len(ran.made) == 7


@pytest.mark.turns(2, "ends")
@pytest.mark.slow
def test_what_never_ends_is_broken_off(scheduler: str, tmp_path: Path) -> None:
    """Asleep: a loop of machine code keeps the answers that its worker holds (`test_limits.py`)."""
    works = [*sums(6), work(hangs, "endless", "")]
    ran = run(works, tmp_path / "out", executor=scheduler, limit=OLD)
    assert list(ran.failed) == ["endless"]
    assert f"took longer than {OLD:g} s" in ran.failed["endless"]
    assert files_of(tmp_path / "out") == due(6)
    assert run(sums(8), tmp_path / "out", executor=scheduler).made == ("6", "7")


def test_files_travel_as_they_are(scheduler: str, tmp_path: Path) -> None:
    large, small = tmp_path / "large.jpg", tmp_path / "small.jpg"
    large.write_bytes(bytes(range(256)) * 50_000)
    small.write_bytes(b"small")
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # of what is large, too
        run([bringing(large, small)], tmp_path / "out", executor=scheduler)
    whole = large.read_bytes() + b"small"
    assert files_of(tmp_path / "out") == {"2.bin": whole}


@pytest.mark.turns(2, "ends")
@pytest.mark.slow
def test_a_cluster_without_workers_is_not_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("graphic_tmm.classroom.batch.rounds.LONELY", 1.0)
    with cluster(workers=0) as address, pytest.raises(SheetError, match="has no workers"):
        run(sums(3), tmp_path / "out", executor=address)


@pytest.mark.turns(2, "ends")
@pytest.mark.slow
def test_no_scheduler_is_one_message(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("graphic_tmm.classroom.batch.executors.PATIENCE", 1)
    for address in ("tcp://127.0.0.1:9", "nonsense", "zzz://x", "tcp://"):
        with pytest.raises(SheetError, match="no scheduler answers"):
            run(sums(1), tmp_path / "out", executor=address)
