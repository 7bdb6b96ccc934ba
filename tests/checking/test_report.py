"""Reports of a check: read back by parsers of their own; text of others is data in every form."""

from __future__ import annotations

import doctest
import io
import json
import math
import os
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from html.parser import HTMLParser
from string import Formatter
from typing import Any
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from rich.console import Console

from graphic_tmm.checking import report_rows, report_text, report_words
from graphic_tmm.checking.records import (
    DOUBTFUL,
    FINE,
    VERDICTS,
    WRONG,
    Judged,
    Likely,
    Report,
    Taken,
)
from graphic_tmm.checking.report_chart import COLOURS, SHAPES, axis, chart
from graphic_tmm.checking.report_html import html_report
from graphic_tmm.checking.report_json import json_report
from graphic_tmm.checking.report_rows import grids, notes, runs, summary, title, who
from graphic_tmm.checking.report_text import LISTED, markdown_report, text_report
from graphic_tmm.checking.report_words import WORDS, shown

LANGUAGES = ("ru", "en")
HOSTILE = [
    "<script>alert(1)</script>",
    "</title></style><svg onload=x>",
    "a & b &lt; &#60; &amp;",
    "\"' onmouseover='x'",
    "a|b||c\\|d\\",
    "`code` *b* _i_ ~~s~~ [x](http://e.org) ![i](j) <http://e.org> http://e.org www.e.org",
    "# head",
    "1. one",
    "- item",
    "--- \n\n***",
    "\x1b[31mred\x1b]0;x\a\x9b2J",
    "\x00\x7f\u202egnp.exe\u2028\udcff",
    "[red]r[/red] :smile: {0} {title} %s $x$",
    "Ж" * 500,
    "",
]
# the document's table (A2): published readings; what they ought to be follows from r, l and ω
PUBLISHED = {
    "pb": [0, 44, 65, 60, 39, 17, 0, 17, 39, 60, 65, 44],
    "ps2": [40, 49, 60, 60, 51, 44, 40, 44, 51, 60, 60, 49],
    "ab": [60, 52, 31, 0, 31, 52, 60, 52, 31, 0, 31, 52],
}


def due(segment: str, k: int) -> float:
    """Return a segment of the engine's velocity plan by the vector loop, mm; pa = OA = 60 mm, AB = 128 mm."""
    r, rod, phi = 60.0, 128.0, math.radians(30 * k)
    beam = math.sqrt(rod * rod - (r * math.sin(phi)) ** 2)
    turn = -r * math.cos(phi) / beam  # of the rod, for a crank of ω = 1
    a = complex(-r * math.sin(phi), r * math.cos(phi))
    ab = turn * complex(r * math.sin(phi), beam)
    return abs({"pb": a + ab, "ps2": a + 44 / 128 * ab, "ab": ab}[segment])


def judged(segment: str = "pb", position: str = "1", found: float = 17.0, **more: Any) -> Judged:
    taken = Taken("velocities", position, segment, mm=found, line=more.pop("line", 2))
    at = {"due": 17.47, "percent": 0.7, "quantile": 0.6, "verdict": FINE} | more
    return Judged(taken, found, deviation=found - at["due"], **at)


def report(*readings: Judged, language: str = "en", mistakes: Any = (), notes: Any = ()) -> Report:
    return Report("engine", "Engine", language, "student", readings, tuple(mistakes), tuple(notes))


def engine(language: str = "en") -> Report:
    """The published readings of the engine, judged by shares of the plan alone."""
    longest = max(due(s, k) for s in PUBLISHED for k in range(12))
    made = []
    for segment, row in PUBLISHED.items():
        for k, mm in enumerate(row):
            off = abs(mm - due(segment, k)) / longest * 100
            verdict = FINE if off < 2.5 else DOUBTFUL
            more = {"due": due(segment, k), "percent": off, "verdict": verdict}
            made.append(judged(segment, str(k + 1), float(mm), line=len(made) + 2, **more))
    return report(*made, language=language)


def hostile(text: str, language: str = "en") -> Report:
    """A report that has one text wherever the text of others can stand."""
    taken = Taken(text, text, text, value=1.0, unit=text, line=2)
    bad = Judged(taken, 1.0, 2.0, -1.0, 50.0, 0.0, WRONG, unit=text, step=text, own=-1.0)
    more = (bad, bad._replace(taken=taken._replace(line=3), verdict=FINE))
    mistake = Likely(text, text, (2,), 1, 0.1, (text, text))
    return Report(text, text, language, text, more, (mistake,), (text,))


def explaining(*lines: int, name: str = "ω/r for ω·r", like: tuple[str, ...] = ()) -> Likely:
    return Likely(name, "the speed was divided", lines, 3, 0.04, like)


# the summary


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
    assert every.endswith(f"ω/r for ω·r {three}.")
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


# JSON

KEYS = ["plan", "position", "segment", "mm", "due_mm", "deviation_mm"]
KEYS += ["percent_of_plan", "verdict", "step"]


def loaded(text: str) -> dict[str, Any]:
    def refuse(name: str) -> None:
        raise AssertionError(name)

    return dict(json.loads(text, parse_constant=refuse))


def test_json_holds_the_engines_36_readings_as_the_vector_loop_has_them() -> None:
    rows = loaded(json_report(engine()))["readings"]
    assert len(rows) == 36
    longest = max(due(s, k) for s in PUBLISHED for k in range(12))
    for row in rows:
        k = int(row["position"]) - 1
        mm, ought = PUBLISHED[row["segment"]][k], due(row["segment"], k)
        assert list(row)[:9] == KEYS
        # 12 significant digits of figures below 100 mm: half a unit of the last is 5e-11
        assert row["mm"] == mm
        assert row["due_mm"] == pytest.approx(ought, abs=5e-11)
        assert row["deviation_mm"] == pytest.approx(mm - ought, abs=5e-11)
        assert row["percent_of_plan"] == pytest.approx(100 * abs(mm - ought) / longest, abs=5e-11)
    worst = max(abs(row["deviation_mm"]) for row in rows)
    assert round(worst, 2) == 1.83  # as published


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_json_has_null_where_there_is_no_finite_figure(value: float) -> None:
    bad = judged()._replace(
        found=value, due=value, deviation=value, percent=value, quantile=value, own=value
    )
    (row,) = loaded(json_report(report(bad, mistakes=[explaining(2)._replace(rest=value)])))[
        "readings"
    ]
    null = {key for key, cell in row.items() if cell is None}
    assert null == {*KEYS[3:7], "quantile", "own_error_mm"}
    for text in (markdown_report(report(bad)), html_report(report(bad)), printed(report(bad), 80)):
        assert not re.search(r"\b(nan|inf)\b", text)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_json_has_twelve_digits_and_no_minus_zero(value: float) -> None:
    (row,) = loaded(json_report(report(judged(found=value, due=0.0))))["readings"]
    assert row["mm"] == float(f"{value:.11e}")
    assert math.copysign(1, row["mm"]) > 0 or row["mm"] < 0


def test_json_has_values_where_nothing_is_drawn_and_points_where_points_were_read() -> None:
    mass = Judged(Taken("results", "", "J_fly", value=1.77, unit="kg*m^2"), 1.77, 1.5, 0.27, 18.0, 0.1,
                  DOUBTFUL, unit="kg·m²")  # fmt: skip
    point = Judged(Taken("velocities", "2", "b", x=3.0, y=-4.0, line=9), 5.0, 5.5, -0.5, 1.0, 0.4, FINE,
                   step="10", own=0.25)  # fmt: skip
    rows = loaded(json_report(report(mass, point)))["readings"]
    assert [rows[0][key] for key in KEYS[3:6]] == [None] * 3
    assert (rows[0]["value"], rows[0]["due_value"], rows[0]["unit"]) == (1.77, 1.5, "kg·m²")
    assert "line" not in rows[0]
    assert "value" not in rows[1]
    assert (rows[1]["x"], rows[1]["y"], rows[1]["own_error_mm"], rows[1]["line"]) == (
        3,
        -4,
        0.25,
        9,
    )


@given(st.text() | st.sampled_from(HOSTILE))
def test_json_loses_nothing_of_a_text_and_does_nothing_to_a_terminal(text: str) -> None:
    out = json_report(hostile(text))
    found = loaded(out)
    assert all(line.isprintable() for line in out.split("\n"))
    assert found["scene"] == found["title"] == found["hand"] == text
    assert {found["readings"][0][key] for key in ("plan", "position", "unit", "step")} == {text}
    assert found["mistakes"][0]["like"] == [text, text]
    assert found["notes"] == [text]


def test_json_tells_counts_and_what_is_explained() -> None:
    readings = [judged(line=k, verdict=WRONG) for k in (2, 3)] + [judged(line=4)]
    found = loaded(json_report(report(*readings, mistakes=[explaining(3, 4)])))
    assert found["counts"] == {"fine": 1, "doubtful": 0, "wrong": 2}
    assert found["unexplained"] == 1
    assert found["mistakes"][0]["explains"] == 1
    assert found["mistakes"][0]["lines"] == [3, 4]
    assert loaded(json_report(report()))["readings"] == []


# Markdown: read back by the parser of CommonMark, raw HTML and tables switched on

READER = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"])
BLOCKS = {"heading", "paragraph", "table", "thead", "tbody", "tr", "th", "td"}
BLOCKS |= {"bullet_list", "list_item", "inline"}


def spoken(text: str) -> list[tuple[str, str]]:
    """Return the blocks of a Markdown text: kind of the block, its words; nothing but words may be in it."""
    tokens, found, open_ = READER.parse(text), [], [""]
    for token in tokens:
        assert re.sub("_(open|close)$", "", token.type) in BLOCKS, token
        if token.type.endswith("_open"):
            open_.append(token.type.removesuffix("_open"))
        elif token.type.endswith("_close"):
            open_.pop()
        else:
            pieces = token.children or []
            assert {piece.type for piece in pieces} <= {"text", "text_special"}, pieces
            found.append((open_[-1], "".join(piece.content for piece in pieces)))
    return found


@pytest.mark.parametrize("language", LANGUAGES)
@given(text=st.text(max_size=40) | st.sampled_from(HOSTILE))
def test_markdown_reads_back_as_the_words_that_went_in(language: str, text: str) -> None:
    made = hostile(text, language)
    blocks, words = spoken(markdown_report(made)), WORDS[language]
    cells = [cell for grid in grids(made) for row in grid.rows for cell in row]
    heads = [words[key] for grid in grids(made) for key in grid.columns]
    assert [said for kind, said in blocks if kind == "td"] == [cell.strip() for cell in cells]
    assert [said for kind, said in blocks if kind == "th"] == heads
    headings = [title(made), *(grid.title for grid in grids(made)), words["notes"]]
    assert [said for kind, said in blocks if kind == "heading"] == [h.strip() for h in headings]
    spoken_of = [summary(made), who(made), words["legend"], *notes(made)]
    assert [s for k, s in blocks if k == "paragraph"] == [s.strip() for s in spoken_of if s]


@pytest.mark.parametrize(
    "text", ["- a", "+ a", "1. a", "2) a", "# a", "> a", "---", "***", "_", "="]
)
def test_what_would_open_a_block_is_a_note(text: str) -> None:
    blocks = spoken(markdown_report(report(notes=[text])))
    assert blocks[-1] == ("paragraph", text)


# HTML

TAGS = {"html", "head", "meta", "title", "style", "body", "h1", "h2", "p", "span", "ul", "li"}
TAGS |= {"table", "thead", "tbody", "tr", "th", "td", "svg", "g", "path", "text"}
NAMES = {"lang", "charset", "content", "http-equiv", "name", "class", "scope", "role", "aria-label"}
NAMES |= {"width", "height", "viewbox", "d", "fill", "stroke", "stroke-width", "x", "y"}
NAMES |= {"font-size", "text-anchor"}


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
    assert page.said("li") == list(notes(made))
    assert page.said("p")[:2] == [summary(made), who(made)]
    assert all(line.isprintable() for line in out.split("\n"))
    out.encode("utf-8")


@pytest.mark.parametrize("text", ["plain", *HOSTILE])
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


# the chart: read back off its own axis, as a person would


def svg(text: str) -> ElementTree.Element:
    return ElementTree.fromstring(text)


def scale(root: ElementTree.Element) -> Callable[[float], float]:
    """Return the deviation at a height, from the figures beside the axis, 0.9 mm below their rules."""
    ruled = {}
    for text in root.iter("text"):
        if (text.text or "").strip() and text.get("x") == "13":
            figure = float(text.text.replace("%", "").replace("−", "-").replace(",", "."))
            ruled[figure] = float(text.attrib["y"]) - 0.9
    top, bottom = max(ruled), min(ruled)
    each = (ruled[top] - ruled[bottom]) / (top - bottom)
    return lambda y: bottom + (y - ruled[bottom]) / each


def marks(root: ElementTree.Element) -> list[tuple[str, float, float, str]]:
    found = []
    for group in root.iter("g"):
        for path in group.findall("path") if group.get("class") else []:
            x, y = re.match(r"M([\d.]+) ([\d.]+)", path.attrib["d"]).groups()
            found.append((group.attrib["class"], float(x), float(y), path.attrib["d"]))
    return found


def test_every_reading_stands_at_its_deviation() -> None:
    made = engine()
    root = svg(chart("velocities", made.readings, "en"))
    at, found = scale(root), marks(root)
    assert len(found) == 36
    due = sorted(made.readings, key=lambda one: (int(one.taken.position), made.readings.index(one)))
    for one, (verdict, _, y, _) in zip(due, sorted(found, key=lambda m: m[1]), strict=True):
        assert verdict == one.verdict
        # heights are written to 0.01 mm and 18 mm stand for at most 6 %: 0.005 mm twice is 0.004 %
        assert at(y) == pytest.approx(math.copysign(one.percent, one.deviation), abs=0.004)


def test_verdicts_have_shapes_and_colours_of_their_own_and_the_far_ones_an_arrow() -> None:
    few = [judged(found=17.9, percent=2.5, verdict=verdict) for verdict in VERDICTS]
    far = judged(found=-80.0, percent=90.0, verdict=WRONG)
    root = svg(chart("velocities", [*few, far], "en"))
    shapes = {verdict: d.split("m", 1)[1] for verdict, _, _, d in marks(root)[:3]}
    assert len(set(shapes.values())) == len(set(SHAPES.values())) == len(set(COLOURS.values())) == 3
    *near, (_, _, y, path) = marks(root)
    assert path.count("M") == 2
    assert [d.count("M") for *_, d in near] == [1, 1, 1]
    assert y == 39.0  # the lower edge of the field
    titles = [t.text for t in root.iter("title")]
    assert titles[-1] == "1 pb: −90.0 %, wrong"


def luminance(colour: str) -> float:
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    r, g, b = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


@pytest.mark.parametrize("colour", COLOURS.values())
def test_colours_stand_out_from_the_paper(colour: str) -> None:
    paper = min(map(luminance, ("#ffffff", "#fdeff0", "#fdf5ea")))
    assert (paper + 0.05) / (luminance(colour) + 0.05) >= 4.5  # WCAG 2, text


@given(st.lists(st.floats(allow_nan=True), min_size=2, max_size=30))
def test_any_deviations_make_a_chart_inside_its_field(percents: list[float]) -> None:
    readings = [judged(percent=p, verdict=VERDICTS[k % 3]) for k, p in enumerate(percents)]
    text = chart("velocities", readings, "ru")
    finite = [p for p in percents if math.isfinite(p)]
    if len(finite) < 2:
        assert text == ""
        return
    assert "nan" not in text
    assert "inf" not in text
    found = marks(svg(text))
    assert len(found) == len(finite)
    assert all(14 <= x <= 178 and 3 <= y <= 39 for _, x, y, _ in found)
    limit, step = axis([one for one in readings if math.isfinite(one.percent)])
    count = limit / step
    assert abs(count - round(count)) < 1e-9
    assert 1 <= round(count) <= 4


def test_results_are_named_under_the_chart_and_one_reading_makes_none() -> None:
    readings = [judged(name, "") for name in ("J_fly", "cd")]
    texts = [t.text for t in svg(chart("results", readings, "en")).iter("text")]
    assert texts[-2:] == ["J_fly", "cd"]
    assert chart("results", readings[:1], "en") == ""


# a terminal


def printed(made: Report, width: int, *, colours: bool = False) -> str:
    out = io.StringIO()
    console = Console(
        file=out, width=width, force_terminal=colours, color_system="truecolor" if colours else None
    )
    for part in text_report(made):
        console.print(part)
    return out.getvalue()


@pytest.mark.parametrize("width", [40, 60, 80, 220])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_terminal_shows_every_sign_however_narrow_it_is(language: str, width: int) -> None:
    made = engine(language)
    slip = judged(found=60.0, verdict=WRONG, step="10 'b'", own=11.7, line=99)
    made = made._replace(readings=(*made.readings, slip), mistakes=(explaining(99),))
    text = Counter(re.sub(r"[\s─]", "", printed(made, width)))
    words = WORDS[language]
    meant = [title(made), summary(made), who(made), words["legend"]]
    for grid in grids(made):
        meant += [grid.title, *(words[key] for key in grid.columns)]
        meant += [cell for row in grid.rows for cell in row]
    assert text == Counter(re.sub(r"\s", "", "".join(meant)))


def test_figures_and_verdicts_are_whole_on_a_terminal_of_80() -> None:
    for language in LANGUAGES:
        made = engine(language)
        lines = printed(made, 80).splitlines()
        for row in grids(made)[0].rows:
            assert any(all(cell in line for cell in row) for line in lines), row


@pytest.mark.parametrize("text", HOSTILE)
def test_text_does_nothing_to_a_terminal(text: str) -> None:
    made = hostile(text)
    assert all(line.isprintable() for line in printed(made, 100).split("\n"))
    coloured = printed(made, 100, colours=True)
    plain = re.sub(r"\x1b\[[\d;]*m", "", coloured)
    assert all(line.isprintable() for line in plain.split("\n"))
    assert printed(hostile("[red]r[/red] :smile:"), 200).count("[red]r[/red] :smile:") > 5


def test_of_very_many_readings_a_terminal_lists_the_worst_and_says_how_many_are_left() -> None:
    readings = [judged(line=k + 2) for k in range(LISTED + 100)]
    readings[LISTED + 50] = readings[LISTED + 50]._replace(verdict=WRONG)
    made = report(*readings)
    text = printed(made, 100)
    assert text.count("● fine") == LISTED - 1
    assert text.count("✖ wrong") == 1
    assert "100 more are not listed here" in text
    assert html_report(made).count("<tr class=") == LISTED + 100
    assert len(loaded(json_report(made))["readings"]) == LISTED + 100


# all forms

FORMS = [markdown_report, html_report, json_report, lambda made: printed(made, 100)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_empty_report_is_told_in_every_form(language: str) -> None:
    made = report(language=language)
    for form in FORMS[:2] + FORMS[3:]:
        assert WORDS[language]["none"] in form(made)
    assert loaded(json_report(made))["readings"] == []


def test_small_shares_large_figures_and_signs() -> None:
    one = judged(found=2e9, quantile=1e-5, verdict=WRONG, own=0.004)
    (row,) = grids(report(one))[0].rows
    assert "2·10⁹" in row
    assert "+2·10⁹" in row
    assert "< 0.1" in row
    assert row[-1] == "0.00"
    none = grids(report(judged(quantile=0.0)))[0].rows[0]
    assert "0.0" in none


def test_the_languages_have_words_for_the_same_things() -> None:
    russian, english = WORDS["ru"], WORDS["en"]
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
def test_what_is_shown_is_short_printable_and_on_one_line(text: str, most: int) -> None:
    out = shown(text, most)
    assert len(out) <= most
    assert out.isprintable()
    assert shown(out, most) == out
    if text.isprintable() and text == " ".join(text.split()) and len(text) <= most:
        assert out == text


SCRIPT = """
import sys
sys.path[:0] = [{tests!r}, {root!r}]
from test_report import *
for form in FORMS:
    made = engine("ru")._replace(mistakes=(explaining(2, 3, 9), explaining(4)), notes=("a", "b"))
    sys.stdout.buffer.write(form(made).encode())
"""


def test_bytes_do_not_depend_on_the_run() -> None:
    here = os.path.dirname(os.path.abspath(__file__))
    root = os.path.dirname(os.path.dirname(here))
    script = SCRIPT.format(tests=here, root=root)
    runs = [
        subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": root},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    ]
    assert runs[0] == runs[1]
    assert len(runs[0]) > 10_000


@pytest.mark.parametrize("module", [report_rows, report_text, report_words])
def test_the_examples_of_the_docstrings_hold(module: Any) -> None:
    assert doctest.testmod(module).failed == 0
