"""Tests of one scene run in one worker: they are known by the name in their brackets; cases take turns."""

from __future__ import annotations

import pytest
from support.groups import group_of
from support.turns import Wanted, in_turn


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
