"""PDF and PNG: pages exactly the size of the sheets, the check line 100.00 mm, the same bytes."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest

from graphic_tmm.errors import SheetError
from graphic_tmm.paper import export
from graphic_tmm.paper.svg import svg
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


def test_a_png_has_the_dots_of_its_size(drawn) -> None:
    head = export.png(drawn[0], ppi=50.8)[:24]
    assert head.startswith(b"\x89PNG")
    width, height = (int.from_bytes(head[k : k + 4], "big") for k in (16, 20))
    assert (width, height) == (round(2 * drawn[0].width), round(2 * drawn[0].height))


def test_without_typst_the_remedy_is_told(drawn, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "typst", None)
    with pytest.raises(SheetError, match=r"pip install 'graphic-tmm\[pdf\]'"):
        export.pdf(drawn)


def test_two_renderers_agree() -> None:
    """On an A1 sheet less than 1 % of the pixels differ by more than 64 of 255: typst, resvg, 4 dots a mm."""
    resvg_py = pytest.importorskip("resvg_py")
    image = pytest.importorskip("PIL.Image")
    image.MAX_IMAGE_PIXELS = None
    sheet = sheets(read(HOME / "engine"))[1][0]
    other = bytes(resvg_py.svg_to_bytes(svg_string=svg(sheet), dpi=101.6))
    pictures = (image.open(io.BytesIO(p)) for p in (export.png(sheet, ppi=101.6), other))
    first, second = (np.asarray(picture.convert("L"), dtype=int) for picture in pictures)
    assert first.shape == second.shape == (4 * 594, 4 * 841)
    assert (np.abs(first - second) > 64).mean() < 0.01
