"""The rows of a report: by whose hand it was judged, in figures that a teacher can choose by."""

from __future__ import annotations

import re

import pytest
from support.reports import LANGUAGES, judged, report

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.records import WRONG
from graphic_tmm.checking.report.rows import own_error, reading_grid, who


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", sorted(HANDS))
def test_how_far_the_hand_is_off_is_told(name: str, language: str) -> None:
    says = who(report(language=language)._replace(hand=name)).replace(",", ".")
    figures = [float(one) for one in re.findall(r"±([\d.]+)", says)]
    assert figures == [HANDS[name].swing, HANDS[name].reading]
    assert ("--hand careful" in says) == (name == "student")


def test_of_a_hand_that_has_no_name_no_figures_are_told() -> None:
    assert who(report()._replace(hand="mine")) == "Scene: engine. Judged by the hand: mine."


def test_an_error_that_is_the_whole_deviation_is_told_once() -> None:
    """Where no earlier reading takes part of it the column has nothing to add, and claims nothing."""
    whole = judged("pc", found=5.8, due=174.1, verdict=WRONG)._replace(own=-168.3)
    part = judged("pe", found=10.0, due=14.0, verdict=WRONG)._replace(own=-1.5)
    assert own_error(whole) is None
    assert "own" not in reading_grid([whole], "en", "").columns
    grid = reading_grid([whole, part], "en", "")
    assert [row[grid.columns.index("own")] for row in grid.rows] == ["", "−1.50"]
