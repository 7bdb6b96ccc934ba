"""A process that dies takes nothing with it but the work that killed it."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.batches import dies, dies_once, due, files_of, killed, sums, work
from support.each import each

from graphic_tmm.classroom.batch.run import run


@each("deadly", [dies, killed])
@each("executor", [1, 2])
@pytest.mark.slow
def test_only_the_guilty_fail(deadly: object, executor: int, tmp_path: Path) -> None:
    log, works = tmp_path / "log", sums(12)
    works[3:3] = [work(deadly, "first", "")]
    works[9:9] = [work(deadly, "second", "")]
    heard: list[int] = []
    ran = run(works, tmp_path / "out", executor=executor, tell=lambda done, *_: heard.append(done))
    assert list(ran.failed) == ["first", "second"]
    assert all("died" in message for message in ran.failed.values())
    assert ran.made == tuple(map(str, range(12)))
    assert files_of(tmp_path / "out") == due(12)
    assert heard == list(range(1, 15))
    assert not log.exists()


def test_what_died_once_is_made_in_the_end(tmp_path: Path) -> None:
    works = [work(dies_once, f"w{k}", str(tmp_path / f"w{k}")) for k in range(2)]
    ran = run([*sums(6), *works], tmp_path / "out", executor=2)
    assert ran.failed == {}
    assert ran.done == 8
    found = files_of(tmp_path / "out")
    assert {name: text for name, text in found.items() if name[0] == "w"} == {
        "w0/alive.txt": b"alive",
        "w1/alive.txt": b"alive",
    }


def test_nothing_but_deaths_comes_to_an_end(tmp_path: Path) -> None:
    ran = run([work(dies, f"{k}", "") for k in range(4)], tmp_path, executor=2)
    assert len(ran.failed) == 4
    assert files_of(tmp_path) == {}
