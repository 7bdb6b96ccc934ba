"""Rows of a report: the summary counts, runs of lines read back."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.reports import LANGUAGES, explaining, judged, printed, report

from graphic_tmm.checking.records import DOUBTFUL, WRONG, Likely
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.rows import runs, summary
from graphic_tmm.checking.report.words import WORDS


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_summary_counts_and_names_what_explains(language: str) -> None:
    wrong = [judged(line=k, verdict=WRONG) for k in (2, 3, 7)]
    others = [judged(line=4), judged(line=5, verdict=DOUBTFUL)]

    def told(*mistakes: Likely, readings: Any = (*wrong, *others)) -> str:
        return summary(report(*readings, language=language, mistakes=mistakes))

    words = WORDS[language]
    counted = words["counts"].format(all=5, fine=1, doubtful=1, wrong=3)
    assert told() == f"{counted} {words['unexplained']}"
    assert told(explaining(4, 5)) == f"{counted} {words['unexplained']}"  # none of the wrong ones
    every = told(explaining(2, 3, 5, 7))
    three = "(3 of 3)" if language == "en" else "(3 из 3)"
    assert every.startswith(counted)
    name = "ω/r for ω·r" if language == "en" else "ω/r вместо ω·r"
    assert every.endswith(f"{name} {three}.")
    part = told(explaining(2, like=("slip",)), explaining(3, name="other"))
    one = "(1 of 3)" if language == "en" else "(1 из 3)"
    assert all(text in part for text in (f"other {one}", "slip", words["at lines"].format(lines=7)))
    assert told(readings=others).endswith(words["all right"])
    assert told(readings=()) == words["none"]


def test_the_summary_stands_before_every_reading() -> None:
    made = report(judged(verdict=WRONG), mistakes=[explaining(2)])
    for text in (markdown_report(made), html_report(made), printed(made, 200)):
        assert text.index("Fine 0, doubtful 0, wrong 1. The wrong ones are explained by") < (
            text.index("17.47")
        )


@given(st.lists(st.integers(0, 60)))
def test_runs_of_lines_read_back(lines: list[int]) -> None:
    text = runs(lines)
    back: set[int] = set()
    for piece in text.removesuffix(", …").split(", ") if text else []:
        low, _, high = piece.partition("–")
        back |= set(range(int(low), int(high or low) + 1))
    due = {line for line in lines if line}
    assert back == due if "…" not in text else back < due
