"""Every form of a report: the same words, the same bytes; its rows read back."""

from __future__ import annotations

import doctest
import os
import re
import subprocess
import sys
from string import Formatter
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.gallery import ROOT
from support.reports import FORMS, HOSTILE, LANGUAGES, engine, judged, loaded, report

from graphic_tmm.checking.records import DOUBTFUL, WRONG
from graphic_tmm.checking.report import markdown as report_markdown
from graphic_tmm.checking.report import rows as report_rows
from graphic_tmm.checking.report import rows as report_words
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.parts import grids
from graphic_tmm.checking.report.rows import LEGEND, WORDS, printable_text, runs


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_empty_report_is_told_in_every_form(language: str) -> None:
    made = report(language=language)
    for form in FORMS[:2] + FORMS[3:]:
        assert WORDS[language]["none"] in form(made)
    assert loaded(json_report(made))["readings"] == []


def test_small_shares_large_figures_and_signs() -> None:
    one = judged(found=2e9, quantile=1e-5, verdict=DOUBTFUL, own=0.004)
    (row,) = grids(report(one))[0].rows
    assert "2·10⁹" in row
    assert "+2·10⁹" in row
    assert "< 0.1" in row
    assert row[-1] == "0.00"
    none = grids(report(judged(quantile=0.0)))[0].rows[0]
    assert "0.0" in none


def test_the_languages_have_words_for_the_same_things() -> None:
    for words in (WORDS, LEGEND):
        russian, english = words["ru"], words["en"]
        assert list(russian) == list(english)
        for key, text in english.items():
            assert not re.search("[А-Яа-яё]", text), key
            assert fields(text) == fields(russian[key]), key
    for made in (engine("ru"), report(judged(verdict=WRONG), language="ru")):
        text = markdown_report(made).replace("engine", "").replace("student", "")
        for word in ("fine", "wrong", "doubtful", "plan", "Readings"):
            assert word not in text


def fields(text: str) -> set[str | None]:
    return {name for _, name, _, _ in Formatter().parse(text)} - {None}


@given(st.text() | st.sampled_from(HOSTILE), st.integers(5, 90))
@pytest.mark.slow
def test_what_is_shown_is_short_printable_and_on_one_line(text: str, most: int) -> None:
    out = printable_text(text, most)
    assert len(out) <= most
    assert out.isprintable()
    assert printable_text(out, most) == out
    if text.isprintable() and text == " ".join(text.split()) and len(text) <= most:
        assert out == text


SCRIPT = """
import sys
sys.path[:0] = [{tests!r}, {root!r}]
from support.reports import FORMS, engine, explaining
for form in FORMS:
    made = engine("ru")._replace(mistakes=(explaining(2, 3, 9), explaining(4)), notes=("a", "b"))
    sys.stdout.buffer.write(form(made).encode())
"""


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_run() -> None:
    script = SCRIPT.format(tests=str(ROOT / "tests"), root=str(ROOT))
    runs = [
        subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    ]
    assert runs[0] == runs[1]
    assert len(runs[0]) > 10_000


@pytest.mark.parametrize("module", [report_markdown, report_rows, report_words])
def test_the_examples_of_the_docstrings_hold(module: Any) -> None:
    assert doctest.testmod(module).failed == 0


@given(st.lists(st.integers(0, 60)))
def test_runs_of_lines_read_back(lines: list[int]) -> None:
    text = runs(lines)
    back: set[int] = set()
    for piece in text.removesuffix(", …").split(", ") if text else []:
        low, _, high = piece.partition("–")
        back |= set(range(int(low), int(high or low) + 1))
    due = {line for line in lines if line}
    assert back == due if "…" not in text else back < due
