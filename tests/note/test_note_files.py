"""The files of a note, read back by others' readers: DOCX, HTML, PDF, Markdown; the same bytes each time."""

from __future__ import annotations

import io
import re
from html.parser import HTMLParser

import pypdfium2
import pytest
from docx import Document as read_docx
from pdfminer.pdfdocument import PDFDocument
from pdfminer.pdfparser import PDFParser
from pdfminer.pdftypes import resolve1
from support.notes import document_of, file_of, noted, parts

from graphic_tmm.note.document import Heading, Picture, Table, walk
from graphic_tmm.note.formats import files
from graphic_tmm.note.pandoc import formulas

NAME = "slider-diagrams"
M = "{http://schemas.openxmlformats.org/officeDocument/2006/math}"
FORMS = ["pdf", "html", "docx", "md"]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.slow
def test_the_same_note_has_the_same_bytes(form: str) -> None:
    again = files(noted(NAME), "note", (form,))[f"note.{form}"]
    told = again.encode("utf-8") if isinstance(again, str) else again
    assert told == file_of(NAME, form)


# DOCX


def test_formulas_of_a_docx_are_formulas_of_a_word_processor() -> None:
    found = list(document_of(file_of(NAME, "docx")).iter(f"{M}oMath"))
    assert len(found) == formulas(noted(NAME), parted=True)


def test_a_docx_is_read_back() -> None:
    found = read_docx(io.BytesIO(file_of(NAME, "docx")))
    blocks = list(walk(noted(NAME).blocks))
    heads = [p for p in found.paragraphs if p.style.name.lower().startswith("heading")]
    assert len(heads) == sum(isinstance(block, Heading) for block in blocks)
    assert len(found.tables) == sum(isinstance(block, Table) for block in blocks)
    assert len(found.inline_shapes) == sum(isinstance(block, Picture) for block in blocks)
    page = found.sections[0]
    sizes = (page.left_margin, page.right_margin, page.top_margin, page.bottom_margin)
    assert [round(size.mm) for size in sizes] == [30, 15, 20, 20]
    assert (round(page.page_width.mm), round(page.page_height.mm)) == (210, 297)
    body = found.styles["Body Text"]
    assert body.font.size.pt == 12
    assert body.paragraph_format.line_spacing == 1.5
    assert found.core_properties.title == noted(NAME).title


def test_a_docx_tells_no_time_and_all_its_pictures() -> None:
    found = parts(file_of(NAME, "docx"))
    assert b"dcterms:created" not in found["docProps/core.xml"]
    told = [name for name in found if name.startswith("word/media/")]
    assert len(told) == sum(isinstance(block, Picture) for block in walk(noted(NAME).blocks))
    alts = re.findall(rb'<wp:docPr[^>]*descr="([^"]*)"', found["word/document.xml"])
    assert len(alts) == len(told)
    assert all(alts)


# HTML


class _Page(HTMLParser):
    """What of a page is looked at; elements have to be closed in their order."""

    OPEN = frozenset({"meta", "br", "col", "hr", "img"})

    def __init__(self) -> None:
        super().__init__()
        self.stack: list[str] = []
        self.language = ""
        self.images: list[str] = []
        self.maths = 0
        self.ids: list[str] = []
        self.links: list[str] = []
        self.outside: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        told = dict(attrs)
        if tag == "html":
            self.language = told.get("lang") or ""
        if told.get("role") == "img" and tag == "svg":
            self.images.append(told.get("aria-label") or "")
        self.maths += tag == "math"
        if "id" in told:
            self.ids.append(told["id"] or "")
        if tag == "a":
            self.links.append((told.get("href") or "").lstrip("#"))
        if tag in ("img", "script", "link"):
            self.outside.append(tag)
        if tag not in self.OPEN:
            self.stack.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in self.OPEN:
            self.stack.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.stack.pop() == tag


def test_a_page_is_whole_well_formed_and_told_to_who_does_not_see_it() -> None:
    page = _Page()
    page.feed(file_of(NAME, "html").decode("utf-8"))
    page.close()
    assert page.stack == []
    assert page.language == "ru"
    assert page.outside == []
    assert len(page.images) == sum(isinstance(b, Picture) for b in walk(noted(NAME).blocks))
    assert all(page.images)
    assert page.maths == formulas(noted(NAME))
    assert len(set(page.ids)) == len(page.ids)
    assert set(page.links) <= set(page.ids)


# PDF


def test_a_pdf_is_tagged_and_has_bookmarks_title_and_language() -> None:
    data = file_of(NAME, "pdf")
    catalogue = PDFDocument(PDFParser(io.BytesIO(data))).catalog
    assert resolve1(catalogue["Lang"]) == b"ru"
    assert resolve1(catalogue["MarkInfo"])["Marked"] is True
    assert "StructTreeRoot" in catalogue
    found = pypdfium2.PdfDocument(data)
    assert found.get_metadata_dict()["Title"] == noted(NAME).title
    assert not found.get_metadata_dict()["CreationDate"]
    titles = [mark.get_title() for mark in found.get_toc()]
    heads = sum(isinstance(block, Heading) for block in noted(NAME).blocks)
    assert len(titles) == heads
    found.close()


# Markdown


def test_markdown_names_figures_that_are_written_beside_it() -> None:
    found = files(noted(NAME), "note", ("md",))
    told = str(found["note.md"])
    named = re.findall(r"!\[.*?\]\((\S+?)\)", told)
    assert sorted(named) == sorted(name for name in found if name.endswith(".svg"))
    assert "$" in told


@pytest.mark.slow
def test_the_note_of_the_project_has_the_pages_of_a_course_project() -> None:
    """ГОСТ 7.32: A4, 12 pt, lines one and a half apart; some 25 to 40 pages are asked for."""
    data = file_of("project", "pdf")
    found = pypdfium2.PdfDocument(data)
    pages = len(found)
    width, height = found[0].get_size()
    found.close()
    assert (round(width / 72 * 25.4), round(height / 72 * 25.4)) == (210, 297)
    assert 25 <= pages <= 45


def test_nothing_of_a_page_is_wider_than_its_window() -> None:
    """Every table, and every formula that may be long, moves in a box of its own, which keys can reach."""
    page = file_of("slider-diagrams", "html").decode("utf-8")
    assert page.count('<div class="wide" tabindex="0"><table') == page.count("<table") > 3
    assert ".wide { max-width: 100%; overflow-x: auto;" in page
    for found in re.finditer(r"<math ([^>]*)>(.*?)</math>", page, re.DOTALL):
        seen = re.sub(r"<annotation.*?</annotation>|<[^>]*>|\s", "", found[2], flags=re.DOTALL)
        assert ('class="wide" tabindex="0"' in found[1]) == (len(seen) > 30)


def test_heads_of_rows_that_are_formulas_are_told_aloud() -> None:
    page = file_of("slider-diagrams", "html").decode("utf-8")
    heads = re.findall(r'<th scope="row"[^>]*><math([^>]*)>', page)
    assert heads
    assert all('aria-label="' in head for head in heads)
