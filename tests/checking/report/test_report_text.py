"""Reports as Markdown, read back by a parser of CommonMark, and on a terminal of any width."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from support.each import each
from support.reports import (
    HOSTILE,
    LANGUAGES,
    engine,
    explaining,
    hostile,
    judged,
    loaded,
    printed,
    report,
)

from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG
from graphic_tmm.checking.report.findings import finding_rows, headline, summary
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.parts import (
    doubtful_parts,
    fine_grids,
    fine_ones,
    grids,
    legend,
    wrong_parts,
)
from graphic_tmm.checking.report.rows import SIGNS, WORDS, notes, title, who
from graphic_tmm.checking.report.text import LISTED

READER = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"])
BLOCKS = {"heading", "paragraph", "table", "thead", "tbody", "tr", "th", "td"}
BLOCKS |= {"bullet_list", "list_item", "inline", "html_block"}
WORDS_ONLY = {"text", "text_special", "strong_open", "strong_close"}
FOLD = re.compile(r"<details><summary>(. [\w ]+: \d+)</summary>\n|</details>\n")
"""What of HTML may stand in a Markdown text beside small plans: what is fine, folded."""


def spoken(text: str) -> list[tuple[str, str]]:
    """Return the blocks of a Markdown text: kind of the block, its words; nothing but words may be in it."""
    tokens, found, open_ = READER.parse(text), [], [""]
    for token in tokens:
        assert re.sub("_(open|close)$", "", token.type) in BLOCKS, token
        if token.type.endswith("_open"):
            open_.append(token.type.removesuffix("_open"))
        elif token.type.endswith("_close"):
            open_.pop()
        elif token.type == "html_block":
            fold = FOLD.fullmatch(token.content)
            assert fold is not None, token
            found += [("fold", fold[1])] if fold[1] else []
        else:
            pieces = token.children or []
            assert {piece.type for piece in pieces} <= WORDS_ONLY, pieces
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
    wrong, doubtful = wrong_parts(made), doubtful_parts(made)
    signed = [f"{SIGNS[WRONG]} {part.heading}" for part in wrong]
    signed += [f"{SIGNS[DOUBTFUL]} {part.heading}" for part in doubtful]
    folded = [grid.title for grid in fine_grids(made)]
    headings = [title(made), *signed, *folded, words["notes"]]
    assert [said for kind, said in blocks if kind == "heading"] == [h.strip() for h in headings]
    assert [said for kind, said in blocks if kind == "fold"] == [f"{SIGNS[FINE]} {fine_ones(made)}"]
    spoken_of = [headline(made), *finding_rows(made), summary(made), who(made)]
    spoken_of += [text for part in (*wrong, *doubtful) for text in part.told]
    spoken_of += [legend(made, grids(made)), *notes(made)]
    assert [s for k, s in blocks if k == "paragraph"] == [s.strip() for s in spoken_of if s]


@each("text", ["- a", "+ a", "1. a", "2) a", "# a", "> a", "---", "***", "_", "="])
def test_what_would_open_a_block_is_a_note(text: str) -> None:
    blocks = spoken(markdown_report(report(notes=[text])))
    assert blocks[-1] == ("paragraph", text)


@pytest.mark.parametrize("width", [40, 60, 80, 220])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_terminal_shows_every_sign_however_narrow_it_is(language: str, width: int) -> None:
    made = engine(language)
    slip = judged(found=60.0, verdict=WRONG, step="10 'b'", own=11.7, line=99)
    made = made._replace(readings=(*made.readings, slip), mistakes=(explaining(99),))
    text = Counter(re.sub(r"[\s─]", "", printed(made, width)))
    words, tables = WORDS[language], []
    meant = [title(made), headline(made), *finding_rows(made), summary(made), who(made), "•"]
    for verdict, parts in ((WRONG, wrong_parts(made)), (DOUBTFUL, doubtful_parts(made))):
        for part in parts:
            meant += [SIGNS[verdict], part.heading, *part.told]
            tables += [part.grid] if part.grid is not None else []
    for grid in tables:
        meant += [words[key] for key in grid.columns]
        meant += [cell for row in grid.rows for cell in row]
    meant += [SIGNS[FINE], fine_ones(made), legend(made, tables)]
    assert text == Counter(re.sub(r"\s", "", "".join(meant)))


def test_figures_are_whole_on_a_terminal_of_80() -> None:
    for language in LANGUAGES:
        made = engine(language)
        made = made._replace(readings=[one._replace(verdict=DOUBTFUL) for one in made.readings])
        lines = printed(made, 80).splitlines()
        for row in grids(made)[0].rows:
            assert any(all(cell in line for cell in row) for line in lines), row


@each("text", HOSTILE)
def test_text_does_nothing_to_a_terminal(text: str) -> None:
    made = hostile(text)
    assert all(line.isprintable() for line in printed(made, 100).split("\n"))
    coloured = printed(made, 100, colours=True)
    plain = re.sub(r"\x1b\[[\d;]*m", "", coloured)
    assert all(line.isprintable() for line in plain.split("\n"))
    assert printed(hostile("[red]r[/red] :smile:"), 200).count("[red]r[/red] :smile:") > 5


@pytest.mark.slow
def test_of_very_many_readings_a_terminal_lists_some_and_says_how_many_are_left() -> None:
    readings = [judged(line=k + 2, verdict=WRONG) for k in range(LISTED + 100)]
    made = report(*readings, judged(line=1))
    text = printed(made, 100)
    assert len(re.findall(r"^ *\d+ 1 +pb", text, re.MULTILINE)) == LISTED
    assert "100 more are not listed here" in text
    assert html_report(made).count("<tr class=") == LISTED + 101
    assert len(loaded(json_report(made))["readings"]) == LISTED + 101


def test_what_is_fine_is_folded_and_on_a_terminal_only_counted() -> None:
    made = report(judged(line=7), judged(line=8), judged(line=9, found=1.25, verdict=DOUBTFUL))
    text = printed(made, 100)
    assert "● Fine: 2" in text
    assert "1.25" in text
    assert "17.00" not in text
    for whole in (markdown_report(made), html_report(made)):
        fold = whole[whole.index("<details>") : whole.index("</details>")]
        assert fold.count("17.00") == 2
        assert "17.00" not in whole.replace(fold, "")
        assert "1.25" in whole.replace(fold, "")
