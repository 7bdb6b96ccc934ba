"""PDF and PNG: pages exactly the size of the sheets, the check line 100.00 mm, the same bytes.

How they look is told by tests/test_renderers.py.
"""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from graphic_tmm.errors import SheetError
from graphic_tmm.paper import export
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

HOME = Path(__file__).parent.parent.parent / "sheets"
MM = 25.4 / 72


@pytest.fixture(scope="module", params=["engine", "crank-rocker"])
def drawn(request):
    return sheets(read(HOME / request.param))[1]


def test_one_page_a_sheet_of_exactly_its_size(drawn) -> None:
    pdfplumber = pytest.importorskip("pdfplumber")
    with pdfplumber.open(io.BytesIO(export.pdf(drawn))) as file:
        assert len(file.pages) == len(drawn)
        for page, sheet in zip(file.pages, drawn, strict=True):
            assert page.width * MM == pytest.approx(sheet.width, abs=0.001)
            assert page.height * MM == pytest.approx(sheet.height, abs=0.001)
            upright = [
                line["height"] * MM for line in page.lines if abs(line["x0"] * MM - 5.5) < 0.01
            ]
            assert any(abs(height - 100.0) < 0.005 for height in upright)
            assert sheet.drawings[-1].title.split()[0] in page.extract_text()


def test_the_same_bytes(drawn) -> None:
    assert export.pdf(drawn) == export.pdf(drawn)


def head(png: bytes) -> tuple[int, int]:
    assert png.startswith(b"\x89PNG")
    width, height = (int.from_bytes(png[k : k + 4], "big") for k in (16, 20))
    return width, height


@pytest.mark.parametrize("ppi", [50.8, 96.0, 100.0, 101.6, 137.0])
def test_a_png_has_the_dots_of_its_size(drawn, ppi: float) -> None:
    for sheet in drawn:
        size = (round(sheet.width * ppi / 25.4), round(sheet.height * ppi / 25.4))
        assert head(export.png(sheet, ppi=ppi)) == size


def test_without_typst_the_remedy_is_told(drawn, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "typst", None)
    with pytest.raises(SheetError, match=r"pip install 'graphic-tmm\[pdf\]'"):
        export.pdf(drawn)
