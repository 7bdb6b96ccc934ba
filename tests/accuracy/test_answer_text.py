"""The answer as it is printed: sentences first, a bar that is as long as its shares, a short table."""

from __future__ import annotations

import re
from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console
from support import gallery
from support.tasks import answered

from graphic_tmm.accuracy.answer import Answer, answer
from graphic_tmm.accuracy.answer_text import BAR, WIDTH, answer_text, bars, parts, sentences
from graphic_tmm.accuracy.cost_figure import figures
from graphic_tmm.accuracy.sources import Sources
from graphic_tmm.accuracy.words import WORDS

NAMES = [
    "slider-diagrams",
    *(pytest.param(one, marks=pytest.mark.slow) for one in ("crank-rocker", "cam")),
]


def printed(own: Answer) -> list[str]:
    out = StringIO()
    console = Console(file=out, width=WIDTH)
    for part in answer_text(own):
        console.print(part)
    return out.getvalue().splitlines()


@pytest.mark.parametrize("language", ["ru", "en"])
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.slow
def test_sentences_come_first_then_bars_then_a_table_of_twelve_rows_at_most(
    name: str, language: str
) -> None:
    own = answered(name)
    own = replace(own, scene=replace(own.scene, language=language))
    lines = printed(own)
    assert max(map(len, lines)) <= WIDTH
    text = " ".join(" ".join(lines).split())
    places = [text.index(line) for line in sentences(own)]
    assert places == sorted(places)
    first = next(line for line in lines if re.match(r"[●◆]+ +\d", line))
    rows = [line for line in lines if re.fullmatch(r"[●◆ ]{0,3} +\d+ .*\d", line)]
    assert lines.index(first) > next(k for k, line in enumerate(lines) if "█" in line)
    assert len(rows) == len(own.rows) <= 12
    assert not re.search(r"[{}]|nan", text)
    if language == "en":
        assert not re.search("[а-я]", " ".join(sentences(own)))


def test_letters_that_the_table_uses_are_explained_below_it() -> None:
    for language in ("ru", "en"):
        below = WORDS[language]["answer letters"]
        assert all(mark in below for mark in ("●", "◆", "×", WORDS[language]["minutes"]))


@pytest.mark.parametrize("name", NAMES)
def test_a_bar_is_as_long_as_its_shares(name: str) -> None:
    own = answered(name)
    origin = own.origins[0]
    named = parts(origin.of[own.worst])
    assert sum(share for _, share in named) == pytest.approx(1.0)
    line = next(bars(own))
    bar = line[: line.rindex(" ")]
    lengths = [len(run.group()) for run in re.finditer(r"(.)\1*", bar)]
    assert sum(lengths) == BAR
    drawn = [share for _, share in named if share >= 1.0 / BAR]
    for length, share in zip(lengths, drawn, strict=False):
        assert abs(length - BAR * share) <= 1.0


def test_what_sources_bring_together_is_told_only_where_it_is_known() -> None:
    little, much = Sources(1.0, {"swing": 0.98}, ()), Sources(1.0, {"swing": 0.8}, ())
    assert [name for name, _ in parts(little)] == ["swing"]
    assert dict(parts(much)) == {"swing": pytest.approx(0.8), "together": pytest.approx(0.2)}


@pytest.mark.slow
def test_a_drawing_that_is_exact_is_told_so_in_one_sentence() -> None:
    own = answer(replace(gallery.scene("crank-rocker"), hand="exact", ruler=None), literal=True)
    assert [*sentences(own)] == [WORDS["en"]["answer exact"]]
    assert not any("●" in line for line in printed(own))
    assert figures(own)["png"]
