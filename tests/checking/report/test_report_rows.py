"""The rows of a report: by whose hand it was judged, in figures that a teacher can choose by."""

from __future__ import annotations

import re

import pytest
from support.reports import LANGUAGES, report

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.report.rows import who


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", sorted(HANDS))
def test_how_far_the_hand_is_off_is_told(name: str, language: str) -> None:
    says = who(report(language=language)._replace(hand=name)).replace(",", ".")
    figures = [float(one) for one in re.findall(r"±([\d.]+)", says)]
    assert figures == [HANDS[name].swing, HANDS[name].reading]
    assert ("--hand careful" in says) == (name == "student")


def test_of_a_hand_that_has_no_name_no_figures_are_told() -> None:
    assert who(report()._replace(hand="mine")) == "Scene: engine. Judged by the hand: mine."
