"""Mechanisms whose groups meet in one letter, by every command; more: ``tests/hard/fuzz_mechanisms.py``."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

import pytest
from fuzz_mechanisms import BLANK, IN_TURN, case, lines_of, told
from fuzz_options import CSV, OUT, SCENE
from support.command import invoke
from support.one_letter import GROUPS, scene
from support.scenes import written


def drawn_or_refused(numbers: Iterable[int]) -> None:
    found = [case(number) for number in numbers]
    assert not [one for one in found if one.fault]
    # 1: of readings one in five is wrong
    assert {one.status for one in found} <= {0, 1, 2}


@pytest.mark.slow
def test_one_is_drawn_or_refused() -> None:
    drawn_or_refused([3])


FEW = (253, 34, 46, 212, 59, 38, 50, 205, 184, 207, 98)
"""Small ones, in two positions: each kind of groups once, and each command once."""


def test_few_meet_every_kind_of_groups_and_every_command() -> None:
    assert {number % len(GROUPS) for number in FEW} == set(range(len(GROUPS)))
    assert len({lines_of(number) for number in FEW}) == len(IN_TURN)


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("turn", range(len(FEW)))
def test_they_are_drawn_or_refused(turn: int, many: Callable[[int, int], int]) -> None:
    drawn_or_refused([FEW[turn], *range(4 + turn, many(304, 0), len(FEW))])


def test_most_of_them_have_links_of_one_point() -> None:
    texts = [scene(number) for number in range(5 * len(GROUPS))]
    lone = [text for text in texts if any(_lone(line) for line in text.splitlines())]
    assert len(lone) > len(texts) / 2
    assert scene(7) == scene(7)


def _lone(line: str) -> bool:
    return line.startswith("points = ") and line.count("[") == 1


POSED = ("task", SCENE, "-o", OUT, "-j", "0", "--keys", "none")
SHEET = '\n[[sheet]]\nformat = "A1"\nplace = {}\n'
FOUND: dict[int, tuple[str, tuple[tuple[str, ...], ...]]] = {
    8: ("", (POSED,)),
    19: (SHEET.format('["diagrams"]'), (("page", SCENE, "-o", OUT),)),
    155: (SHEET.format('["forces", "lever"]'), (BLANK, ("check", SCENE, CSV, "--trials", "20"))),
    167: ("", (("draw", SCENE, "-o", OUT),)),
    173: ("", (POSED,)),
}
"""What was at fault: the sheet that shows it, if not those of the scene, and the commands."""


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("number", FOUND)
def test_what_was_found_is_drawn(number: int, tmp_path: Path) -> None:
    """A task of what assembles near one position only, or turns about a pin on its own guide; a diagram of what
    is undrawn between positions; an arm without a sure digit; bars longer than a group."""
    sheet, lines = FOUND[number]
    text = scene(number).partition("\n[[sheet]]")[0] + sheet if sheet else scene(number)
    found = list(told(text, tmp_path, lines))
    assert not [one for one in found if one.fault]
    # 1: it is checked, and of its readings one in five is wrong
    assert [one.status for one in found] == [0, 1][: len(lines)]


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
