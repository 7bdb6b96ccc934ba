"""A digest is the same in every process, and another for whatever is another."""

from __future__ import annotations

import pickle
import subprocess
import sys
from collections import OrderedDict
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from pathlib import Path, PurePosixPath
from types import MappingProxyType
from typing import Any, NamedTuple

import pytest
from hypothesis import given
from hypothesis import strategies as some
from support.batches import bringing, files_of, sums
from support.each import each

from graphic_tmm.classroom.batch.run import run
from graphic_tmm.classroom.batch.work import Done, Work, canonical, digest, done


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


class Pair(NamedTuple):
    one: Any
    two: Any = None


class Other(NamedTuple):
    one: Any
    two: Any = None


class Renamed(NamedTuple):
    one: Any
    three: Any = None


@dataclass(frozen=True)
class Held:
    one: Any


class Colour(Enum):
    RED = 1
    BLUE = 2


PLAIN = some.none() | some.booleans() | some.integers() | some.text() | some.binary()
VALUES = some.recursive(
    PLAIN | some.floats(allow_nan=False),
    lambda of: (
        some.lists(of, max_size=3)
        | some.tuples(of, of)
        | some.builds(Pair, of, of)
        | some.dictionaries(some.text(), of, max_size=3)
    ),
    max_leaves=6,
)


def kinds(one: Any) -> Any:
    """A value with the types of all that is in it, which == leaves out; as nested lists."""
    name = type(one).__name__
    if isinstance(one, dict):
        return [name, sorted(([key, kinds(value)] for key, value in one.items()), key=repr)]
    if isinstance(one, (list, tuple)):
        return [name, [kinds(part) for part in one]]
    return [name, repr(one)]


@given(VALUES, VALUES)
def test_texts_are_equal_as_values_are(one: Any, two: Any) -> None:
    assert (canonical(one) == canonical(two)) == (kinds(one) == kinds(two))


DIFFERENT = [
    1, 1.0, True, "1", b"1", None, (1,), [1], (1, 1), ((1,), 1), (1, (1,)), {1}, {1: 1}, {"1": 1},
    Pair(1), Other(1), Renamed(1), Held(1), Pair(1, 1), Colour.RED, Colour.BLUE, "Colour.RED",
    PurePosixPath("1"), "(1,)", "','", ("", ""), ("','",), -0.0, 0.0, float("inf"), 1j, "a\n", "\ud800",
]  # fmt: skip


def test_no_two_of_these_have_one_text() -> None:
    texts = [canonical(one) for one in DIFFERENT]
    assert len(set(texts)) == len(DIFFERENT)
    assert len({digest(Work("7", "a:b", one)) for one in DIFFERENT}) == len(DIFFERENT)


def test_order_and_kind_of_a_table_are_nothing() -> None:
    table = {"a": 1, "b": {"x", "y"}}
    for same in ({"b": {"y", "x"}, "a": 1}, MappingProxyType(table), OrderedDict(table)):
        assert canonical(same) == canonical(table)


def test_it_hangs_on_the_operation_and_not_on_the_name() -> None:
    assert digest(Work("7", "a:b", 1)) == digest(Work("8", "a:b", 1))
    assert digest(Work("7", "a:b", 1)) != digest(Work("7", "a:c", 1))


def test_another_version_of_the_package_makes_all_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    before = digest(Work("7", "a:b", 1))
    monkeypatch.setattr("graphic_tmm.classroom.batch.work.package", lambda: "999.0")
    assert digest(Work("7", "a:b", 1)) != before


def test_hash_order_is_nothing() -> None:
    code = (
        "from graphic_tmm.classroom.batch.work import canonical;"
        "print(canonical({'sets': frozenset(map(str, range(50))), 'a': 1}))"
    )
    told = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": ":".join(sys.path)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3")
    }
    assert len(told) == 1


@each("one", [object(), Fraction(1, 2), lambda: 1, [object()], {"a": {1: object()}}, int])
def test_what_cannot_be_written_down_is_refused(one: Any) -> None:
    with pytest.raises(TypeError):
        canonical(one)
