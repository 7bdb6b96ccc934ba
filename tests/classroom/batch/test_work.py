"""Work travels: it is done by name, and pickled as it is."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
from support.batches import bringing, files_of, sums
from support.each import each

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.classroom.batch.work import Done, Work, done


def doubled(given: int) -> Done:
    return Done({"it.txt": f"{2 * given}"}, ("told",))


def test_work_is_done_by_the_name_of_its_operation() -> None:
    work = Work("one", f"{__name__}:doubled", 21)
    assert done(pickle.loads(pickle.dumps(work))) == Done({"it.txt": "42"}, ("told",))


def test_what_there_is_not_is_an_error() -> None:
    with pytest.raises(AttributeError):
        done(Work("one", f"{__name__}:halved", 21))


@each("executor", [0, 1])
def test_what_a_work_brings_is_read_when_it_is_sent(executor: int, tmp_path: Path) -> None:
    one, two = tmp_path / "one", tmp_path / "two"
    one.write_bytes(b"first")
    two.write_bytes(b"second")
    work = bringing(one, two)
    assert b"first" not in pickle.dumps(work)
    run([work], tmp_path / "out", executor=executor)
    assert files_of(tmp_path / "out") == {"2.bin": b"firstsecond"}


@each("gone", [True, False])
def test_a_file_that_is_another_now_is_refused(gone: bool, tmp_path: Path) -> None:
    one = tmp_path / "one"
    one.write_bytes(b"1")
    work = bringing(one)
    if gone:
        one.unlink()
    else:
        one.write_bytes(b"2")
    ran = run([work, *sums(2)], tmp_path / "out", executor=1)
    assert "one: the file was changed meanwhile" in ran.failed["bytes"]
    assert ran.made == ("0", "1")
