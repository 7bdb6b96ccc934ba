"""Columns of a note's tables are as wide as their words, in PDF and DOCX; both have about as many pages."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pdfplumber
import pytest
from docx import Document as read_docx
from PIL import ImageFont
from support.laid_out import case_file, note_of_case
from support.notes import noted

from graphic_tmm.note.columns import LETTER, PAGE, shares, word_width
from graphic_tmm.note.document import Symbol, Table, Text, numbered, walk
from graphic_tmm.note.formats import files
from graphic_tmm.note.widths import width

CASE = "slotting"
W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
MARGIN = 195.5
"""Where the right margin of a page begins, mm, and a little."""
FONT = Path("/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf")
"""A font as wide as that of a DOCX."""
WORDS = [
    "Обозначение",
    "м/с²",
    "−0,885",
    "кг·м²",
    "№",
    "Подвижность",
    "1114,35",
    "(м/с)/мм",
    "Quantity",
]
MM = 25.4 / 72


@pytest.mark.skipif(not FONT.exists(), reason="the font is not there")
@pytest.mark.parametrize("word", WORDS)
def test_words_are_measured_wide_enough(word: str) -> None:
    """No less than they take, and not half as much again."""
    real = ImageFont.truetype(str(FONT), 1000).getlength(word) / 100 * MM
    assert real <= word_width(word) <= 1.5 * real


def test_no_word_of_a_table_is_broken_in_a_docx() -> None:
    """Its columns hold each word of their cells, and are no wider than the page together."""
    found = read_docx(io.BytesIO(case_file(CASE, "docx")))
    ruled = [one for one in found.tables if one.style and one.style.name == "Table"]
    assert len(ruled) == sum(
        isinstance(one, Table) and one.ruled for one in walk(note_of_case(CASE).blocks)
    )
    for table in ruled:
        widths = [int(one.get(f"{W}w")) / 56.6929 for one in table._tbl.iter(f"{W}gridCol")]
        assert sum(widths) <= 165.5
        assert table._tbl.tblPr.find(f"{W}tblLayout").get(f"{W}type") == "fixed"
        for row in table.rows:
            for cell, room in zip(row.cells, widths, strict=True):
                assert all(word_width(word) <= room for word in cell.text.split())


@pytest.mark.slow
def test_no_word_of_a_table_is_broken_in_a_pdf() -> None:
    heads = [
        "".join(run.text for run in cell if isinstance(run, Text))
        for table in walk(note_of_case(CASE).blocks)
        if isinstance(table, Table)
        for cell in table.heads
    ]
    with pdfplumber.open(io.BytesIO(case_file(CASE, "pdf"))) as pdf:
        words = {word["text"] for page in pdf.pages for word in page.extract_words()}
        assert {word for head in heads for word in head.split()} <= words


@pytest.mark.slow
def test_nothing_stands_in_the_margin_of_a_pdf() -> None:
    with pdfplumber.open(io.BytesIO(case_file(CASE, "pdf"))) as pdf:
        right = max(
            char["x1"] for page in pdf.pages for char in page.chars if char["text"].isalnum()
        )
    assert right * MM < MARGIN


def test_a_formula_of_a_docx_begins_with_no_sign_and_has_no_bracket_alone() -> None:
    """A word processor takes a sign at the beginning for one that lacks what stands before it."""
    body = ElementTree.fromstring(read_docx(io.BytesIO(case_file(CASE, "docx"))).element.xml)
    firsts = [next(one.iter(f"{M}r")) for one in body.iter(f"{M}oMath")]
    signs = [one for one in firsts if re.match("[=<>≤≥≠]", _letters(one))]
    assert len(signs) > 20
    assert all(one.find(f"{M}rPr/{M}nor") is not None for one in signs)
    loose = [
        one for one in body.iter(f"{M}r") if _letters(one) in ("(", ")", "[", "]", "|", "*", "∗")
    ]
    assert loose
    assert all(one.find(f"{M}rPr/{M}nor") is not None for one in loose)


def _letters(run: ElementTree.Element) -> str:
    return "".join(text.text or "" for text in run.iter(f"{M}t"))


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("soffice") is None, reason="no word processor is there")
def test_a_docx_has_about_as_many_pages_as_the_pdf(tmp_path: Path) -> None:
    (tmp_path / "note.docx").write_bytes(case_file(CASE, "docx"))
    home = f"-env:UserInstallation=file://{tmp_path}/home"
    told = ["soffice", home, "--headless", "--convert-to", "pdf", "--outdir", str(tmp_path)]
    subprocess.run([*told, "note.docx"], cwd=tmp_path, check=True, capture_output=True)
    with pdfplumber.open(tmp_path / "note.pdf") as shown:
        pages, words = len(shown.pages), "".join(page.extract_text() for page in shown.pages)
    with pdfplumber.open(io.BytesIO(case_file(CASE, "pdf"))) as pdf:
        assert pages == pytest.approx(len(pdf.pages), rel=0.15)
    assert "¿" not in words


def test_a_table_in_parts_has_one_number() -> None:
    """«Таблица 16», then «Продолжение таблицы 16» and no number more, in all formats."""
    document = noted("engine")
    parts = [b for b in document.blocks if isinstance(b, Table) and b.of]
    assert parts
    tables = numbered(document).tables
    assert all(tables[one.id] == tables[one.of] for one in parts)
    assert sorted({*tables.values()}) == list(range(1, len(tables) - len(parts) + 1))
    told = files(document, "note", ("md",))["note.md"]
    assert isinstance(told, str)
    for one in parts:
        assert f"\nПродолжение таблицы {tables[one.id]}\n" in told
    assert "(продолжение)" not in told


def test_a_letter_has_room_for_the_size_in_which_libreoffice_sets_it() -> None:
    """It sets formulas in 12 pt whatever a table says: a cell of 10 pt cut off П_{y1-y1}(3,6)."""
    told = ((Symbol("П_{y1-y1}(3,6)"),), (Text("a"),))
    share, _ = shares(Table("t", (), (), (told,), "cc"), "ru")
    assert share * PAGE >= 1.2 * width(told[0][0]) * LETTER
