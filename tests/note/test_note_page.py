"""What a page tells without a word of its chapter: conclusions of results, one place of the log for all."""

from __future__ import annotations

import pytest
from support.gallery import made

from graphic_tmm.note.document import Number, Table, Text
from graphic_tmm.note.page import RESULTS, Page
from graphic_tmm.note.section_chapter import page_of


class Short(Page[object]):
    tables = (RESULTS,)
    by_results = ("It is {contact_ratio}.", "It is {nothing}.")


@pytest.fixture
def short() -> Short:
    (board,) = made("gear-pair", exact=True).boards
    (gears,) = board.project.chapters
    return Short(board, gears, "en", set())


def test_a_conclusion_is_drawn_where_its_results_are_there(short: Short) -> None:
    ((before, ratio, behind),) = short.concludes()
    assert (before, behind) == (Text("It is "), Text("."))
    assert isinstance(ratio, Number)
    assert ratio.source.name == "contact_ratio"
    assert ratio.value == short.results["contact_ratio"][0][0]


def test_the_tables_are_those_that_a_page_names(short: Short) -> None:
    tables = [one.id for one in short.tabled() if isinstance(one, Table)]
    assert tables == ["table-results-gears"]
    full = page_of(short.drawn, short.chapter, "en")
    assert not list(full.tabled())


def test_names_are_filled_by_what_is_put_marks_words_and_counts(short: Short) -> None:
    mark = short.recorded.sizes.contact_ratio  # type: ignore[attr-defined]
    number = short.number(mark)
    words = ("{word} {count} {mark}", "again {word}")
    told = short.sentence(words, word="two", count=2, mark=mark)
    kept = [one.text if isinstance(one, Text) else one for one in told]
    assert kept == ["two", " ", "2", " ", number, " again ", "two"]
