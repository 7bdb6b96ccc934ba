"""The pages of a note: figures and tables in their sections, what goes on says so, nothing stands alone."""

from __future__ import annotations

import io
import re

import pdfplumber
import pytest
from support.laid_out import PageLine, bytes_of, note_of_case, pages_of

from graphic_tmm.board.formula_text import tree_of
from graphic_tmm.note.document import (
    Block,
    Break,
    Display,
    Document,
    Formula,
    Heading,
    Picture,
    SideBySide,
    Symbol,
    Table,
    Text,
    Tree,
    numbered,
    paragraph,
)
from graphic_tmm.note.figures import drawn_figures
from graphic_tmm.note.widths import broken

CASE = "slotting"
CAPTION = re.compile(r"^(Рисунок|Таблица) (\d+) —")
GOES_ON = re.compile(r"^Продолжение таблицы (\d+)$")
HEADS = ("Обозначение", "№ Построение", "Величина", "Чертёж")
"""How the heads of a table begin."""
WORD = re.compile("[А-Яа-я]{5}")
"""What no index of a formula is."""
TABLE, TEXT = 10.0, 12.0
"""The least sizes of letters, pt."""
FEW = 3
"""No page has fewer lines than these, but the first."""


def _due() -> list[str]:
    """What stands in the note in this order: numbers of headings, figures, tables."""
    document = note_of_case(CASE)
    counted = numbered(document)
    due = []
    for k, block in enumerate(document.blocks):
        if isinstance(block, Heading) and k in counted.headings:
            words = "".join(run.text for run in block.runs if isinstance(run, Text))
            due.append(f"{counted.headings[k]} {words[:20]}")
        elif isinstance(block, Picture | SideBySide):
            due.append(f"Рисунок {counted.figures[block.id]}")
        elif isinstance(block, Table) and block.ruled and not block.of:
            due.append(f"Таблица {counted.tables[block.id]}")
    return due


@pytest.mark.slow
def test_figures_and_tables_stand_in_their_sections() -> None:
    """Each where it is told of, one behind the other, whatever page that is."""
    due = _due()
    heads = [one for one in due if one[0].isdigit()]
    seen = []
    for line in (line for page in pages_of(CASE)[2:] for line in page):
        if caption := CAPTION.match(line.words):
            seen.append(f"{caption[1]} {caption[2]}")
        seen += [head for head in heads if line.words.startswith(head)]
    assert seen == due


@pytest.mark.slow
def test_a_table_that_goes_on_says_so() -> None:
    """A page that begins in a table begins with its number; one that begins otherwise does not."""
    told = [bool(GOES_ON.match(page[0].words)) for page in pages_of(CASE)]
    assert told == [_begins_in_a_table(page) for page in pages_of(CASE)]
    assert sum(told) >= 3
    inside = [GOES_ON.match(line.words) for page in pages_of(CASE) for line in page[1:]]
    document = note_of_case(CASE)
    parts = [b.of for b in document.blocks if isinstance(b, Table) and b.of]
    due = {str(numbered(document).tables[of]) for of in parts}
    assert {found[1] for found in inside if found} <= due, "only a part of a table that is too wide"


def _begins_in_a_table(page: tuple[PageLine, ...]) -> bool:
    first, second = (line.words for line in page[:2])
    return first.startswith(HEADS) or (second.startswith(HEADS) and not CAPTION.match(first))


@pytest.mark.slow
def test_no_page_has_a_line_or_two() -> None:
    assert min(len(page) for page in pages_of(CASE)[1:]) >= FEW


@pytest.mark.slow
def test_letters_are_no_smaller_than_is_due() -> None:
    """Words of a table may have 10 pt, others 12."""
    sizes = {line.size for page in pages_of(CASE) for line in page if WORD.search(line.words)}
    assert min(sizes) == pytest.approx(TABLE, abs=0.1)
    assert not {size for size in sizes if TABLE + 0.1 < size < TEXT - 0.1}


@pytest.mark.slow
def test_what_stands_above_a_table_has_the_size_of_text() -> None:
    for page in pages_of(CASE):
        for line in page:
            if CAPTION.match(line.words) or GOES_ON.match(line.words):
                assert line.size == pytest.approx(TEXT, abs=0.1)


@pytest.mark.parametrize("above", [36, 37, 38, 39])
def test_a_formula_over_several_lines_stands_on_one_page(above: int) -> None:
    """However many lines stand above it."""
    names = "abcdefghijklmnopqrstuvw"
    total = Tree(tree_of("+".join(names), {}), {one: Symbol(f"{one}_{{12345}}") for one in names})
    sums = Display(broken(Formula((Symbol("M"), total, Symbol("0")))))
    assert len(sums.formulas) >= 3
    lines = [paragraph("слово")] * above
    document = Document("title", "ru", (*lines, sums, *lines))
    with pdfplumber.open(io.BytesIO(bytes_of(document, "pdf"))) as pdf:
        inside = [k for k, page in enumerate(pdf.pages) if "12345" in page.extract_text()]
    assert len(inside) == 1


def test_a_sentence_stands_on_the_page_of_the_formula_that_it_leads_to() -> None:
    """Whatever it ends with, and however many lines stand above it."""
    value = Display((Formula((Symbol("M"), Symbol("F_{12345}"))),))
    blocks: list[Block] = [paragraph("начало")]
    for above in range(24, 42):
        blocks += [*[paragraph("слово")] * above, paragraph("приводит это к"), value, Break()]
    with pdfplumber.open(
        io.BytesIO(bytes_of(Document("title", "ru", tuple(blocks)), "pdf"))
    ) as pdf:
        pages = [page.extract_text() for page in pdf.pages]
    assert sum("12345" in page for page in pages) == 18
    assert not [page for page in pages if ("приводит" in page) != ("12345" in page)]


def test_letters_of_figures_can_be_read() -> None:
    """No letter or number is lower than 2.5 mm on the page, nor a shout."""
    sizes = [
        (label.size * figure.width / figure.sheet.width, figure.alt)
        for figure in drawn_figures(note_of_case(CASE)).values()
        for view in figure.sheet.drawings
        for label in view.labels
    ]
    assert len(sizes) > 100
    assert min(sizes)[0] >= 2.45, min(sizes)
    assert max(sizes)[0] <= 8.0, max(sizes)
