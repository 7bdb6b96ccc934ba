"""PDF and PNG: pages exactly the size of the sheets, the check line 100.00 mm, the same bytes.

How they look is told by tests/test_renderers.py.
"""

from __future__ import annotations

import io

import pytest
from support.gallery import paper
from support.turns import in_turn

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Drawing, Sheet, line
from graphic_tmm.paper.write import export

MM = 25.4 / 72


@pytest.fixture(scope="module", params=["engine", "crank-rocker"])
def drawn(request):
    return paper(request.param)[1]


@pytest.mark.turns(1)
@pytest.mark.slow
def test_one_page_a_sheet_of_exactly_its_size(drawn) -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    with pdfplumber.open(io.BytesIO(export.pdf(drawn))) as file:
        assert len(file.pages) == len(drawn)
        for page, sheet in zip(file.pages, drawn, strict=True):
            assert page.width * MM == pytest.approx(sheet.width, abs=0.001)
            assert page.height * MM == pytest.approx(sheet.height, abs=0.001)
            (check,) = [
                s for d in sheet.drawings for s in d.strokes if "check-line" in dict(s.data)
            ]
            x, y = (min(vertex[axis] for vertex in check.path) for axis in (0, 1))
            lengths = [
                (line["width"] + line["height"]) * MM
                for line in page.lines
                if abs(complex(line["x0"] * MM - x, line["y0"] * MM - y)) < 0.01
            ]
            assert any(abs(length - 100.0) < 0.005 for length in lengths)
            assert sheet.drawings[-1].title.split()[0] in page.extract_text()


@pytest.mark.slow
def test_the_same_bytes(drawn) -> None:
    assert export.pdf(drawn) == export.pdf(drawn)


def head(png: bytes) -> tuple[int, int]:
    assert png.startswith(b"\x89PNG")
    width, height = (int.from_bytes(png[k : k + 4], "big") for k in (16, 20))
    return width, height


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("ppi", [50.8, 96.0, 100.0, 101.6, 137.0])
def test_a_png_has_the_dots_of_its_size(drawn, ppi: float) -> None:
    for sheet in in_turn(drawn, 1):
        size = (round(sheet.width * ppi / 25.4), round(sheet.height * ppi / 25.4))
        assert head(export.png(sheet, ppi=ppi)) == size


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("ppi", [96.0, 150.0, 300.0])
def test_a_png_is_printed_as_large_as_its_sheet(drawn, ppi: float) -> None:
    """Half a dot of the width, half a dot to the metre of the chunk: no more can be lost."""
    image = pytest.importorskip("PIL.Image")
    for sheet in in_turn(drawn, 1):
        with image.open(io.BytesIO(export.png(sheet, ppi=ppi))) as opened:
            opened.load()  # every chunk has its sum
            printed = [
                size / dpi * 25.4 for size, dpi in zip(opened.size, opened.info["dpi"], strict=True)
            ]
        for size, due in zip(printed, (sheet.width, sheet.height), strict=True):
            assert abs(size - due) <= 25.4 / ppi / 2 + due * 0.5 * 0.0254 / ppi * 1.001


NASTY = 'Лист "1" \\ #read("/etc/passwd") $x$ \\"'


@pytest.mark.slow
def test_a_pdf_bears_the_title_and_the_language_of_its_sheets(drawn) -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    for title, language in ((drawn[0].title, drawn[0].language), (NASTY, "en"), (NASTY, "ru")):
        named = [sheet._replace(title=title, language=language) for sheet in drawn[:1]]
        with pdfplumber.open(io.BytesIO(export.pdf(named))) as file:
            assert file.metadata["Title"] == title
            assert file.doc.catalog["Lang"] == language.encode()


def bookmarks(file: bytes) -> list[tuple[int, str, int, float, float]]:
    """Level, title, page, and where it leads to on it: mm from its upper left corner."""
    pypdfium2 = pytest.importorskip("pypdfium2")
    document = pypdfium2.PdfDocument(file)
    found = []
    for mark in document.get_toc():
        target = mark.get_dest()
        x, y = target.get_view()[1][:2]
        page = target.get_index()
        down = (document[page].get_height() - y) * MM
        found.append((mark.level, mark.get_title(), page, x * MM, down))
    return found


def boxes(*titles: str) -> tuple[Drawing, ...]:
    """Squares of 10 mm with the upper left corner 100 mm from the left, 47 mm from the top of an A4."""
    square = line("main", 100 + 240j, 110 + 240j, 110 + 250j, 100 + 250j, closed=True)
    frame = Drawing("frame", "Рамка", (square,))
    return frame, *(Drawing(f"v-{k}", title, (square,)) for k, title in enumerate(titles))


def test_every_view_has_a_bookmark_that_leads_to_it() -> None:
    one = Sheet("s", 'Лист "A" *b* #c', "A4", 210, 297, boxes("План", "План\\ $x$ = _1_"), "ru")
    two = one._replace(title="Второй", drawings=(*boxes("Силы"), Drawing("bare", "Пустой")))
    found = bookmarks(export.pdf([one, two]))
    assert [mark[:3] for mark in found] == [
        (0, '1. Лист "A" *b* #c', 0),
        (1, "План", 0),
        (1, "План\\ $x$ = _1_", 0),
        (0, "2. Второй", 1),
        (1, "Силы", 1),
    ]
    for level, _, _, right, down in found:  # typst keeps 10 pt clear above
        assert (right, down) == pytest.approx((100, 47 - 10 * MM) if level else (0, 0), abs=0.01)


def test_a_sheet_that_stands_alone_needs_no_bookmark_of_its_own() -> None:
    alone = Sheet("s", "Лист", "A4", 210, 297, boxes("План", "Силы"))
    assert [mark[:3] for mark in bookmarks(export.pdf([alone]))] == [(0, "План", 0), (0, "Силы", 0)]


@pytest.mark.slow
def test_bookmarks_of_a_scene_are_its_views_and_nothing_of_them_is_found() -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    drawn = paper("crank-rocker")[1]
    made = export.pdf(drawn)
    due = [d.title for sheet in drawn for d in sheet.drawings if d.name != "frame"]
    titles = [title for _, title, *_ in bookmarks(made)]
    assert [title for title in titles if title in due] == due
    assert len(titles) == len(due) + len(drawn)
    other = [
        s._replace(drawings=tuple(d._replace(title="Другое") for d in s.drawings)) for s in drawn
    ]
    with (
        pdfplumber.open(io.BytesIO(export.pdf(other))) as file,
        pdfplumber.open(io.BytesIO(made)) as whole,
    ):
        for bare, page in zip(file.pages, whole.pages, strict=True):
            assert bare.extract_text() == page.extract_text() != ""


def test_without_typst_the_remedy_is_told(drawn, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "typst", None)
    with pytest.raises(SheetError, match=r'pip install "graphic-tmm\[pdf\]"'):
        export.pdf(drawn)
