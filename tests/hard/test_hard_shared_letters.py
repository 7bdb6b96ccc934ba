"""Mechanisms whose groups meet in one letter, by every command; more: ``tests/hard/fuzz_mechanisms.py``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from fuzz_mechanisms import case
from support.command import invoke
from support.one_letter import GROUPS, scene
from support.scenes import written


@pytest.mark.parametrize(("first", "usual"), [(3, 1), pytest.param(4, 11, marks=pytest.mark.slow)])
def test_they_are_drawn_or_refused(first: int, usual: int, many: Callable[[int, int], int]) -> None:
    found = [case(number) for number in range(first, first + many(300 if usual > 1 else 1, usual))]
    assert not [one for one in found if one.fault]
    # 1: of readings one in five is wrong
    assert {one.status for one in found} <= {0, 1, 2}


def test_most_of_them_have_links_of_one_point() -> None:
    texts = [scene(number) for number in range(5 * len(GROUPS))]
    lone = [text for text in texts if any(_lone(line) for line in text.splitlines())]
    assert len(lone) > len(texts) / 2
    assert scene(7) == scene(7)


def _lone(line: str) -> bool:
    return line.startswith("points = ") and line.count("[") == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("number", "status"), [(8, 0), (19, 0), (151, 0), (155, 1), (167, 0), (173, 0)]
)
def test_what_was_found_is_drawn(number: int, status: int) -> None:
    """Tasks of what assembles near one position only, or turns about a pin on its own guide; a diagram of what
    is undrawn between positions; an arm without a sure digit; bars longer than a group."""
    found = case(number)
    # 1: it is checked, and of its readings one in five is wrong
    assert (found.status, found.fault) == (status, "")


@pytest.mark.slow
def test_what_only_a_hand_that_slips_draws_too_large_is_drawn_by_the_exact_one(
    tmp_path: Path,
) -> None:
    """Guides that cross at 2°: where a student's lines meet the forces are 300 times the true ones."""
    file, out = written(tmp_path, scene(154)), tmp_path / "out"
    refused = invoke("draw", file, "-o", out)
    assert (refused.exit_code, out.exists()) == (2, False)
    assert "what helps: the exact hand" in refused.stderr
    assert invoke("draw", file, "-o", out, "--hand", "exact").exit_code == 0
