"""The page: read back by a parser of its own; text of others is data."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each
from support.lessons_told import lessons, plan_of_velocities, row
from support.reports import HOSTILE, LANGUAGES, engine, explaining, hostile, judged, report

from graphic_tmm.checking.records import WRONG
from graphic_tmm.checking.report.findings import finding_rows, headline, summary
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.parts import doubtful_parts, fine_grids, grids, wrong_parts
from graphic_tmm.checking.report.rows import notes, printable_text, title, who

TAGS = {"html", "head", "meta", "title", "style", "body", "h1", "h2", "p", "span", "ul", "li"}
TAGS |= {"h3", "section", "details", "summary", "rect", "circle"}
TAGS |= {"table", "thead", "tbody", "tr", "th", "td", "svg", "g", "path", "text"}
NAMES = {"lang", "charset", "content", "http-equiv", "name", "class", "scope", "role", "aria-label"}
NAMES |= {"width", "height", "viewbox", "d", "fill", "stroke", "stroke-width", "x", "y"}
NAMES |= {"font-size", "text-anchor", "stroke-linecap", "stroke-opacity", "cx", "cy", "r"}


class Page(HTMLParser):
    """Reads a page: its elements must be known, closed and in order; its words are kept by element."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.words: list[tuple[str, str]] = []
        self.values: list[str] = []
        self.rows: list[list[str]] = []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag in TAGS, tag
        assert {name for name, _ in attrs} <= NAMES, attrs
        self.values += [value or "" for _, value in attrs]
        if tag != "meta":
            self.open.append(tag)
            self.words.append((tag, ""))
        if tag == "tr":
            self.rows.append([])
        if tag == "td":
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open and self.open[-1] == "td":
            self.rows[-1][-1] += data
        if self.open and self.words[-1][0] == self.open[-1]:
            self.words[-1] = (self.open[-1], self.words[-1][1] + data)

    def handle_comment(self, data: str) -> None:
        raise AssertionError(data)

    def said(self, tag: str) -> list[str]:
        return [words for kind, words in self.words if kind == tag]


@pytest.mark.parametrize("language", LANGUAGES)
@given(text=st.text(max_size=40) | st.sampled_from(HOSTILE))
def test_a_page_reads_back_as_the_words_that_went_in(language: str, text: str) -> None:
    made = hostile(text, language)
    out = html_report(made)
    page = Page(out)
    rows = [list(row) for grid in grids(made) for row in grid.rows]
    assert [row for row in page.rows if row] == rows
    assert page.said("h1") == [title(made)]
    assert page.said("title")[0] == title(made)
    assert page.said("li") == [*finding_rows(made), *notes(made)]
    assert page.said("p")[:3] == [headline(made), summary(made), who(made)]
    parts = [*wrong_parts(made), *doubtful_parts(made)]
    told = [text for part in parts for text in part.told]
    assert len(told) == (
        4 if printable_text(text) else 1
    )  # what is done, why, how it is drawn, the numbers
    assert page.said("p")[3 : 3 + len(told)] == told
    assert [heading[2:] for heading in page.said("h2")[:-1]] == [part.heading for part in parts]
    assert (
        page.said("h3") == [grid.title for grid in fine_grids(made)] * 2
    )  # the readings, their chart
    assert all(line.isprintable() for line in out.split("\n"))
    out.encode("utf-8")


@each("text", ["plain", *HOSTILE])
def test_a_page_names_nothing_outside_itself_and_runs_nothing(text: str) -> None:
    made = hostile(text)
    out = html_report(made)
    page = Page(out)
    style = out[out.index("<style>") : out.index("</style>")]
    assert not re.search(r"url\(|@import|expression|http|//|<(?!style>)", style)
    assert "default-src 'none'" in out
    acting = re.compile(r"^\s*(javascript|https?|data|//)", re.IGNORECASE)
    assert not [value for value in page.values if acting.search(value)]
    if text == "plain":
        assert "http" not in out.replace("http-equiv", "")


def test_a_page_is_for_a4_with_heads_on_every_page() -> None:
    out = html_report(engine())
    assert "@page { size: A4;" in out
    assert "thead { display: table-header-group; }" in out
    assert "print-color-adjust: exact" in out


def test_a_page_with_a_small_plan_names_nothing_outside_itself() -> None:
    due = plan_of_velocities(1)["pb"]
    blamed = row("velocities", "1", "pb", abs(due), "10 pb", mm=33.0)
    out = html_report(report(blamed)._replace(lessons=lessons(blamed)))
    assert out.count('<svg class="plan"') == 1
    page = Page(out)
    assert "http" not in out.replace("http-equiv", "")
    assert page.rows[-1][:2] == ["2", "1"]  # its reading stands below: line and position


@pytest.mark.slow
def test_a_page_is_as_wide_as_a_phone(tmp_path: Path, browser: Any) -> None:
    """A table too wide for it moves within its section, and all of the rest stays where it is."""
    words = row("accelerations", "10", "n3a3", 234.567, "15 n3a3", mm=-123.456)._replace(own=-99.99)
    file = tmp_path / "report.html"
    file.write_text(html_report(report(words, words, language="ru")), "utf-8")
    page = browser.new_page(viewport={"width": 320, "height": 700})
    page.goto(file.as_uri())
    assert page.evaluate("document.documentElement.scrollWidth") == 320
    page.close()


@pytest.mark.parametrize(("count", "folded"), [(12, False), (13, True)])
def test_a_long_table_of_what_follows_from_a_mistake_is_folded(count: int, folded: bool) -> None:
    rows = [judged(line=k, verdict=WRONG) for k in range(2, count + 2)]
    mistake = explaining(*range(2, count + 2))._replace(chance=0.99)
    page = html_report(report(*rows, mistakes=[mistake]))
    assert page.count("<tr class=") == count
    assert (f"<summary>Readings: {count}</summary>\n<table>" in page) == folded
    assert "<summary>Readings" not in html_report(
        report(*rows)
    )  # nobody knows why: each is to be seen
