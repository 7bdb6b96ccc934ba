"""A run makes what is missing, and nothing else; what stands there is known by its bytes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from support.batches import (
    due,
    environment,
    files_of,
    named,
    raises,
    raises_once,
    refused,
    sums,
    work,
)
from support.each import each

from graphic_tmm.classroom.batch import record
from graphic_tmm.classroom.batch.record import locked, place
from graphic_tmm.classroom.batch.run import run
from graphic_tmm.errors import SheetError


def done_of(log: Path) -> list[str]:
    return sorted(log.read_text().split()) if log.exists() else []


@each("executor", [0, 1, 2])
def test_all_is_made_and_told(executor: int, tmp_path: Path) -> None:
    heard: list[tuple[int, int, str]] = []
    tell = lambda *told: heard.append(told)  # noqa: E731
    ran = run(sums(8), tmp_path / "out", executor=executor, tell=tell)
    assert files_of(tmp_path / "out") == due(8)
    assert ran.made == tuple(map(str, range(8)))
    assert (ran.kept, ran.failed, ran.done, ran.of) == ((), {}, 8, 8)
    assert ran.told == {f"{k}": ("added",) for k in range(8)}
    assert [done for done, *_ in heard] == list(range(1, 9))
    assert {of for _, of, _ in heard} == {8}
    assert sorted(name for *_, name in heard) == sorted(ran.made)


def test_a_second_run_makes_nothing_and_tells_the_same(tmp_path: Path) -> None:
    log = tmp_path / "log"
    first = run(sums(5, log), tmp_path / "out", executor=0)
    second = run(sums(5, log), tmp_path / "out", executor=0)
    assert (second.made, second.kept) == ((), first.made)
    assert second.told == first.told
    assert len(done_of(log)) == 5


def test_only_what_is_another_is_made_again(tmp_path: Path) -> None:
    out, log = tmp_path / "out", tmp_path / "log"
    run(sums(5, log), out, executor=0)
    works = sums(7, log)
    works[2] = works[2]._replace(given=works[2].given._replace(numbers=(1, 1)))
    ran = run(works, out, executor=0)
    assert ran.made == ("2", "5", "6")
    assert files_of(out) == due(7)


@each("harm", ["gone", "short", "changed"])
def test_a_file_that_is_not_as_it_was_made_is_made_again(harm: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    run(sums(3), out, executor=0)
    file = out / "1" / "sum.txt"
    if harm == "gone":
        file.unlink()
    else:
        file.write_bytes(b"" if harm == "short" else b"mine\n")
    ran = run(sums(3), out, executor=0)
    assert ran.made == ("1",)
    assert files_of(out) == due(3)
    assert any("1/sum.txt" in line for line in ran.told["1"]) == (harm != "gone")


HOSTILE_RECORDS = [
    b"",
    b"{",
    b"[]",
    b"null",
    b"\xff\xfe",
    b"[" * 100_000,
    b'{"work": "1", "made_of": "", "files": {"../../secret.txt": ""}, "told": []}',
    b'{"work": "1", "made_of": 3, "files": [["a", 1]], "told": [1]}',
    b'{"work": "2", "made_of": "", "files": {}, "told": []}',
]


@each("data", HOSTILE_RECORDS)
def test_a_record_that_cannot_be_believed_is_none(data: bytes, tmp_path: Path) -> None:
    out = tmp_path / "out"
    run(sums(2), out, executor=0)
    secret = tmp_path / "secret.txt"
    secret.write_bytes(b"")
    (out / place("1")).write_bytes(data)
    assert run(sums(2), out, executor=0).made == ("1",)
    assert files_of(out) == due(2)
    assert secret.exists()
    assert run(sums(2), out, executor=0).made == ()


def test_what_is_made_no_more_goes_unless_a_person_changed_it(tmp_path: Path) -> None:
    out = tmp_path / "out"
    run([work(named, "a", ("a/1.svg", "a/2.svg", "b/3.svg", "b/4.svg"))], out, executor=0)
    (out / "b" / "4.svg").write_text("mine")
    ran = run([work(named, "a", ("a/1.svg",))], out, executor=0)
    assert files_of(out) == {"a/1.svg": b"of a/1.svg", "b/4.svg": b"mine"}
    assert len(ran.told["a"]) == 1
    assert "b/4.svg" in ran.told["a"][0]
    run([work(named, "a", ("c/1.svg",))], out, executor=0)
    assert not (out / "a").exists()


def test_an_error_is_tried_once_more_and_a_refusal_is_not(tmp_path: Path) -> None:
    raised, told = tmp_path / "raised", tmp_path / "told"
    works = [
        *sums(3),
        work(raises, "bad", str(raised)),
        work(refused, "wrong", str(told)),
        work(raises_once, "late", str(tmp_path / "late")),
    ]
    ran = run(works, tmp_path / "out", executor=2)
    assert ran.made == ("0", "1", "2", "late")
    assert list(ran.failed) == ["bad", "wrong"]
    assert "RuntimeError: never" in ran.failed["bad"]
    assert ran.failed["wrong"] == "7.toml:3: OA: is too long"
    assert raised.read_text().count("raised") == 2
    assert told.read_text().count("refused") == 1


@each(
    "name",
    [
        *(
            "../x",
            "/x",
            "a/../../x",
            "",
            ".",
            "a//b",
            "a\\..\\b",
            "C:x",
            "a\0b",
            "a\nb",
            "a/",
            "x.",
        ),
        *(".graphic-tmm/lock", ".graphic-tmm/000/a.json", "a" * 300),
    ],
)
def test_a_file_stays_in_its_folder(name: str, tmp_path: Path) -> None:
    works = [work(named, "a", ("fine.txt", name)), *sums(1)]
    ran = run(works, tmp_path / "out", executor=0)
    assert (ran.made, list(ran.failed)) == (("0",), ["a"])
    assert files_of(tmp_path / "out") == due(1)
    assert {path.name for path in tmp_path.iterdir()} == {"out"}


@each("names", [("../a",), ("",), ("a", "a"), ("a", "A"), ("a\n",)])
def test_works_have_names_of_their_own(names: tuple[str, ...], tmp_path: Path) -> None:
    works = [work(named, name, ("x.txt",)) for name in names]
    with pytest.raises(SheetError):
        run(works, tmp_path / "out", executor=0)
    assert not (tmp_path / "out").exists()


def test_two_runs_do_not_write_into_one_folder(tmp_path: Path) -> None:
    out = tmp_path / "out"
    with locked(out), pytest.raises(SheetError, match="another run writes"):
        run(sums(1), out, executor=0)
    assert files_of(out) == {}
    assert run(sums(1), out, executor=0).made == ("0",)


def test_a_run_that_makes_nothing_leaves_nothing(tmp_path: Path) -> None:
    """Refused, in new folders and in one that stands there; what a person put there stays."""
    refuses = [work(refused, "a", ("x",))]
    for out in (tmp_path / "new" / "out", tmp_path / "there"):
        (tmp_path / "there").mkdir(exist_ok=True)
        assert list(run(refuses, out, executor=0).failed) == ["a"]
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["there"]
    (tmp_path / "there" / "mine.txt").write_text("mine")
    run(refuses, tmp_path / "there", executor=0)
    assert files_of(tmp_path / "there") == {"mine.txt": b"mine"}
    with locked(tmp_path / "late"):
        (tmp_path / "late" / ".graphic-tmm" / "record").write_text("")
    assert (tmp_path / "late" / ".graphic-tmm" / "lock").exists()


def test_a_lock_that_was_taken_away_is_nobodys(tmp_path: Path) -> None:
    """Who opened the file of a run that has ended, and left nothing, has no lock by it."""
    out = tmp_path / "out"
    with locked(out), pytest.raises(SheetError, match="another run writes"), locked(out):
        pass
    file = tmp_path / "lock"
    with file.open("ab") as stream:
        assert record._is_at(stream, file)
        file.unlink()
        assert not record._is_at(stream, file)
        file.touch()
        assert not record._is_at(stream, file)


@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")  # later Pythons, of their threads
@pytest.mark.skipif(not hasattr(os, "fork"), reason="a system that forks")
def test_a_folder_is_free_though_a_process_begun_meanwhile_lives_on(tmp_path: Path) -> None:
    """Another thread may be beginning one just then: it has all files until it is another program."""
    out = tmp_path / "out"
    with locked(out):
        end, stays = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(stays)
            os.read(end, 1)
            os._exit(0)
    assert run(sums(1), out, executor=0).made == ("0",)
    os.close(stays)
    os.close(end)
    os.waitpid(child, 0)


def test_a_folder_that_cannot_be_is_told(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("a file")
    with pytest.raises(SheetError, match="cannot write into"):
        run(sums(1), tmp_path / "out", executor=0)


def test_processes_compute_in_one_thread(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
    run([work(environment, "env", names)], tmp_path, executor=1)
    assert (tmp_path / "env.txt").read_text().split() == ["1", "1"]


def test_what_cannot_travel_fails_alone(tmp_path: Path) -> None:
    from graphic_tmm.classroom.batch.rounds import answers
    from graphic_tmm.classroom.batch.work import Work

    works = [*sums(2), Work("f", "support.batches:named", lambda: None), *sums(4)[2:]]
    found = {one.name: got for one, got in answers(1, works, "en", lambda: None)}
    assert isinstance(found.pop("f"), Exception)
    assert all(got.files for got in found.values())  # type: ignore[union-attr]
