"""Every sheet as two renderers paint it: the PNG by typst, the SVG by resvg, the PDF by pdfium.

typst paints an SVG with a resvg of its own, so the first pair tells whether `export` hands the sheet
over true to size; pdfium, which paints typst's PDF, has nothing in common with resvg.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.gallery import FOLDERS, by_turns, paper

from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Sheet, Stroke, arc, circle, line
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.write import export
from graphic_tmm.paper.write.svg import svg

pytest.importorskip("typst")
image = pytest.importorskip("PIL.Image")
resvg = pytest.importorskip("resvg_py")

DOTS, OTHER = 100.0, 90.0
"""Dots per inch."""
WHOLE = 101.6
"""Dots per inch on which sheets are whole dots, 4 to the mm: pdfium stretches other pages to them."""
UNLIKE, STEPS = 64, 80
"""Of 255: two dots differ if their greys are further apart; in a small square if by more than one step of
resvg's: it paints an edge in four steps, and one flips at the least thing along the whole of a line."""
SHARE = 0.01
"""Dots that may differ, of a sheet and of every square of 5 mm."""


def grey(png: bytes) -> np.ndarray:
    image.MAX_IMAGE_PIXELS = None
    return np.asarray(image.open(io.BytesIO(png)).convert("L"), dtype=np.int16)


def by_resvg(text: str, dots: float = DOTS) -> np.ndarray:
    """Without fonts: the white words below everything must not be seen."""
    return grey(bytes(resvg.svg_to_bytes(svg_string=text, dpi=dots, skip_system_fonts=True)))


def by_typst(sheet: Sheet, dots: float = DOTS) -> np.ndarray:
    return grey(export.png(sheet, ppi=dots))


def unlike(one: np.ndarray, other: np.ndarray, dots: float = DOTS) -> tuple[float, float]:
    """Return the share of the dots that differ: of the sheet, and of its worst 5 mm square."""
    assert one.shape == other.shape
    apart = np.abs(one - other)
    side = round(dots / 5.08)
    edges = [(0, -size % side) for size in apart.shape]
    squares = np.pad(apart > STEPS, edges).reshape(-(-apart.shape[0] // side), side, -1, side)
    return float((apart > UNLIKE).mean()), float(squares.mean((1, 3)).max())


def differing(sheet: Sheet) -> tuple[float, float]:
    """Return the shares of a sheet; lines that lie on each other flip at once: but not at other dots too."""
    found = unlike(by_typst(sheet), by_resvg(svg(sheet)))
    if max(found) < SHARE:
        return found
    return min(found, unlike(by_typst(sheet, OTHER), by_resvg(svg(sheet), OTHER), OTHER), key=max)


@cache
def specimen() -> Sheet:
    """Every pen, straight, round and as a curve, filled and not; lettering at every turn and size."""
    strokes: list[Any] = []
    for k, pen in enumerate(pens("A4")):
        y = 20.3 + 20 * k
        strokes += [
            line(pen, complex(10.2, y), complex(90.4, y + 9.7)),
            circle(pen, complex(110.3, y + 5), 6.7),
            arc(pen, complex(140.1, y), 9.6, 20, 140),
            line(pen, 160.7 + y * 1j, 168 + y * 1j, 165 + (y + 8.2) * 1j, closed=True),
            Bezier(pen, (175 + y * 1j, 180 + (y + 15) * 1j, 190 + (y - 9) * 1j, 200 + y * 1j)),
        ]
    strokes.append(Stroke("main", ((150, 250, 0.6), (180, 262, -0.4), (190, 250, 0)), True, True))
    labels = [Label("v_{BA}^{t}", complex(20 + 14 * k, 260), 5.0, turn=30.0 * k) for k in range(12)]
    labels += [Label("Лист Ωμ", complex(20 + 30 * k, 280), s) for k, s in enumerate((2.5, 5, 7))]
    return Sheet("s", "", "A4", 210, 297, (Drawing("d", "", tuple(strokes), tuple(labels)),))


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_typst_and_resvg_paint_every_sheet_alike(
    folder: Path, many: Callable[[int, int], int]
) -> None:
    """Of every scene one, which it is by turns; all of them when measured."""
    for sheet in by_turns(folder.name, many):
        whole, worst = differing(sheet)
        assert whole < SHARE, sheet.name
        assert worst < SHARE, sheet.name


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("dots", [72.0, 96.0, 100.0, WHOLE, 137.0, 150.0])
def test_every_pen_and_letter_at_any_dots(dots: float) -> None:
    made = specimen()
    whole, worst = unlike(by_typst(made, dots), by_resvg(svg(made), dots), dots)
    assert whole < SHARE
    assert worst < SHARE


CHANGES = {
    "a dash left out": (r' stroke-dasharray="[^"]*"', ""),
    "other dashes": (r'(stroke-dasharray="[\d.]+) [\d.]+', r"\1 1"),
    "a letter left out": (r'(<g aria-label="Лист Ωμ".*? d="M[^M]*)M[^M]*', r"\1"),
    "a finer line": (r'stroke-width="0.3"', 'stroke-width="0.2"'),
    "one row shifted": (r'viewBox="0 0 210', 'viewBox="0 0.25 210'),
}


@pytest.mark.slow
@pytest.mark.parametrize("what", CHANGES)
def test_a_small_change_is_seen(what: str) -> None:
    """Whatever one renderer would paint differently is more than the two may differ."""
    text, painted = svg(specimen()), by_typst(specimen())
    changed, times = re.subn(*CHANGES[what], text, count=1, flags=re.DOTALL)
    assert times == 1
    assert unlike(painted, by_resvg(text))[1] < SHARE
    assert unlike(painted, by_resvg(changed))[1] > SHARE


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("name", ["crank-rocker", "engine"])
def test_pdfium_paints_the_pdf_like_the_svg(name: str) -> None:
    pdfium = pytest.importorskip("pypdfium2")
    drawn = paper(name)[1]
    pages = pdfium.PdfDocument(export.pdf(drawn))
    for page, sheet in zip(pages, drawn, strict=True):
        picture = page.render(scale=WHOLE / 72 * (1 - 2e-6), grayscale=True).to_numpy()
        one = picture.reshape(picture.shape[:2]).astype(np.int16)
        assert unlike(one, by_resvg(svg(sheet), WHOLE), WHOLE)[0] < SHARE
