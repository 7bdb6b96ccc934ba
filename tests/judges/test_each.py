"""A property of many cases fails with every case that does, and with no other."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest
from support.each import each


def told(error: BaseException) -> list[str]:
    """The notes of all that was raised, inner groups too."""
    inner = [note for one in getattr(error, "exceptions", ()) for note in told(one)]
    return [*inner, *getattr(error, "__notes__", ())]


def test_all_that_fail_are_told() -> None:
    seen = []

    @each("k", range(10))
    def check(k: int) -> None:
        seen.append(k)
        assert k % 3

    with pytest.raises(ExceptionGroup, match="4 of 10 fail: k: 0; k: 3; k: 6; k: 9") as failed:
        check()
    assert seen == list(range(10))
    assert told(failed.value) == ["k: 0", "k: 3", "k: 6", "k: 9"]


def test_all_that_hold_tell_nothing() -> None:
    @each("one, other", [(1, 2), (2, 3)])
    def check(one: int, other: int) -> None:
        assert one < other

    check()


def test_several_stand_above_each_other() -> None:
    seen = []

    @each("letter", "ab")
    @each("k", (1, 2))
    def check(k: int, letter: str) -> None:
        seen.append((letter, k))
        assert (letter, k) != ("b", 2)

    with pytest.raises(ExceptionGroup) as failed:
        check()
    assert seen == list(product("ab", (1, 2)))
    assert told(failed.value) == ["k: 2", "letter: b"]


@each("name", ["a", "b"])
def test_every_case_has_an_empty_folder_and_other_fixtures_are_kept(
    name: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "file").write_text(name)
    assert request.node.name.startswith("test_every_case")


def test_no_case_at_all_is_a_mistake() -> None:
    with pytest.raises(AssertionError, match="no case"):
        each("k", [])
