"""Tests of one scene run in one worker: they are known by the name in their brackets; cases take turns."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace

import pytest
from support.groups import group_of
from support.turns import SLOW, Wanted, in_turn, waiting


def test_a_test_belongs_to_the_scene_that_it_names() -> None:
    for scene in ("windrower", "windrower-published", "cam", "crank-rocker", "a rocker"):
        for case in (scene, f"{scene}-velocities", f"0.5-{scene}", f"True-{scene}-1"):
            assert group_of(f"tests/a/test_b.py::test_c[{case}]") == scene, case


def test_tests_that_share_what_is_dear_stand_together() -> None:
    assert group_of("tests/page/browser/test_play.py::test_a") == "windrower"
    for case in ("[windrower]", "[]", ""):
        assert group_of(f"tests/page/practice/test_a.py::test_b{case}") == "tests/page/practice/"


def test_a_test_that_names_no_scene_stands_with_its_file() -> None:
    for test in ("tests/cam/test_cam.py::test_cam", "tests/test_b.py::test_c[camera-lever2]"):
        assert group_of(test) == test.partition("::")[0]


def test_every_case_has_its_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Wanted, "all", False)
    for count in (1, 3, 7, 9):
        turns = [in_turn(range(7), count, turn) for turn in range(7)]
        assert {len(set(some)) for some in turns} == {min(count, 7)}
        assert {case for some in turns for case in some} == set(range(7))


class Case(SimpleNamespace):
    """A test with these marks, as pytest collects them."""

    __hash__ = object.__hash__


def cases(marks: Sequence[pytest.MarkDecorator]) -> list[Case]:
    mark = {one.name: one.mark for one in marks}.get
    return [
        Case(path="a", originalname="test_a", callspec=k, get_closest_marker=mark) for k in range(7)
    ]


@pytest.mark.parametrize(
    ("marks", "run"),
    [
        ([], 7),
        ([pytest.mark.slow], SLOW),
        ([pytest.mark.slow, pytest.mark.every], 7),
        ([pytest.mark.slow, pytest.mark.turns(5)], 5),
        ([pytest.mark.turns(2)], 2),
    ],
)
def test_of_a_slow_test_some_cases_run_unless_it_is_marked(
    marks: Sequence[pytest.MarkDecorator], run: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Wanted, "all", False)
    assert 7 - len(waiting(cases(marks))) == run
