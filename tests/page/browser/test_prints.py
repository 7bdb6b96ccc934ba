"""What a page prints: each sheet on its own paper, or in tiles of A4, at true size, and nothing else."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import pytest
from support import pages

MM = 25.4 / 72
ROUNDED = MM / 2 + 25.4 / 600
"""Chromium rounds the sizes of papers to points, and then to 300 an inch: so far off they may be, mm."""
PLACED = 0.2
"""How near lines come to their places, mm."""
SAMPLE = 200
MARGIN, OVERLAP, WIDE, HIGH = 10.0, 10.0, 190.0, 277.0


class Printed(NamedTuple):
    """A page of a PDF: its size, the points of its lines (from the upper left), mm; its words, its colours."""

    width: float
    height: float
    points: Any
    text: str
    colours: set[str]


def printed(tab: Any) -> list[Printed]:
    import pdfplumber

    found = []
    with pdfplumber.open(io.BytesIO(tab.page.pdf(prefer_css_page_size=True))) as pdf:
        for page in pdf.pages:
            drawn = [*page.lines, *page.curves, *page.rects]
            points = MM * np.array([point for one in drawn for point in one["pts"]])
            colours = {
                one[f"{kind}_color"]
                for one in drawn
                for kind in ("non_stroking", "stroking")
                if one["fill" if kind == "non_stroking" else "stroke"]
            }
            text = page.extract_text() or ""
            found.append(
                Printed(
                    MM * page.width, MM * page.height, points, text, {named(c) for c in colours}
                )
            )
    return found


def count(tab: Any) -> int:
    """How many pages a PDF of all has."""
    import pdfplumber

    with pdfplumber.open(io.BytesIO(tab.page.pdf(prefer_css_page_size=True))) as pdf:
        return len(pdf.pages)


def named(colour: Any) -> str:
    """What a colour of a PDF is: grey or red, green, blue."""
    parts = {round(float(part), 3) for part in (colour if isinstance(colour, tuple) else (colour,))}
    return {frozenset({0.0}): "black", frozenset({1.0}): "white"}.get(frozenset(parts), str(colour))


def corners(sheet: Any) -> Any:
    """The ends of the sheet's straight strokes, mm from the upper left, as the record of the sheet has them."""
    found = [
        (x, sheet.height - y)
        for drawing in sheet.drawings
        for stroke in drawing.strokes
        if stroke.pen in ("main", "medium", "thin") and hasattr(stroke, "path")
        for x, y, bulge in stroke.path
        if not any(b for _, _, b in stroke.path)
    ]
    every = max(1, len(set(found)) // SAMPLE)
    return np.array(sorted(set(found))[::every])


def off(points: Any, due: Any) -> Any:
    """How far each point that is due is from the nearest that is there, mm."""
    return np.array([np.hypot(*(points - one).T).min() for one in due])


def assert_paper(page: Printed, width: float, height: float) -> None:
    assert page.width == pytest.approx(width, abs=ROUNDED)
    assert page.height == pytest.approx(height, abs=ROUNDED)


def asked_to_print(tab: Any, button: str) -> None:
    """Press a button of the sheets' printing; the browser's own dialog is left out."""
    tab.page.evaluate("() => { window.asked = 0; window.print = () => { window.asked += 1; }; }")
    tab.page.get_by_text("Print", exact=True).click()
    tab.page.get_by_role("button", name=button).click()
    assert tab.page.evaluate("window.asked") == 1


@pytest.mark.turns(1)
@pytest.mark.parametrize(("name", "scripts"), [("crank-press", True), ("crank-rocker", False)])
def test_all_sheets_are_printed_each_on_its_own_paper(name: str, scripts: bool, opened, files):
    tab = opened(files(name), java_script_enabled=scripts)
    if scripts:
        tab.page.get_by_role("tab").first.wait_for()
    _, sheets = pages.on_sheets(name, pages.language(name))
    found = printed(tab)
    assert len(found) == len(sheets)
    for page, sheet in zip(found, sheets, strict=True):
        assert_paper(page, sheet.width, sheet.height)
        assert off(page.points, corners(sheet)).max() < PLACED
        assert page.text == ""


@pytest.mark.parametrize("theme", ["", "dark"])
def test_paper_is_white_and_ink_black_wherever_one_looks_in_the_dark(theme: str, page_of):
    tab = page_of("crank-rocker", "en", color_scheme="dark")
    tab.page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
    for page in printed(tab):
        assert page.colours == {"black", "white"}


def test_one_sheet_is_printed_on_its_own_paper_and_then_all_again(page_of):
    tab = page_of("crank-press", "en", "#sheets:")
    _, sheets = pages.on_sheets("crank-press", "en")
    number = next(k for k, sheet in enumerate(sheets) if sheet.width != sheets[0].width)
    tab.page.get_by_role("combobox", name="Sheet", exact=True).select_option(str(number))
    asked_to_print(tab, "paper of its size")
    (page,) = printed(tab)
    assert_paper(page, sheets[number].width, sheets[number].height)
    assert off(page.points, corners(sheets[number])).max() < PLACED
    assert count(tab) == len(sheets)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", ["crank-press", "crank-rocker"])
def test_tiles_carry_the_whole_sheet_at_true_size(name: str, page_of):
    tab = page_of(name, "en", "#sheets:")
    sheet = pages.on_sheets(name, "en")[1][0]
    asked_to_print(tab, "A4, to be glued")
    found = printed(tab)
    columns, rows = (
        max(1, math.ceil((whole - OVERLAP) / (room - OVERLAP)))
        for whole, room in ((sheet.width, WIDE), (sheet.height, HIGH))
    )
    assert len(found) == columns * rows
    due = corners(sheet)
    met = np.zeros(len(due), dtype=int)
    for k, page in enumerate(found):
        row, column = divmod(k, columns)
        assert_paper(page, 210.0, 297.0)
        assert f"row {row + 1} of {rows}, column {column + 1} of {columns}" in page.text
        assert "100 mm" in page.text
        assert len(page.text.splitlines()) == 2
        begin = np.array([column * (WIDE - OVERLAP), row * (HIGH - OVERLAP)])
        placed = due - begin
        inside = ((placed >= 0.0) & (placed <= [WIDE, HIGH])).all(axis=1)
        if inside.any():
            assert off(page.points, placed[inside] + MARGIN).max() < PLACED
        met += inside
        assert check_line(page.points) == pytest.approx(100.0, abs=0.05)
        assert_marks(page, sheet, begin)
    assert (met > 0).all()
    assert count(tab) == len(pages.on_sheets(name, "en")[1])


def check_line(points: Any) -> float:
    """How long the line to measure is: the lowest level one below the drawing, mm."""
    low = points[points[:, 1] > 297.0 - MARGIN]
    level = low[np.abs(low[:, 1] - 291.0) < 0.1]
    return float(np.ptp(level[:, 0]))


def assert_marks(page: Printed, sheet: Any, begin: Sequence[float]) -> None:
    """Marks where to cut stand at the corners of the piece, and where the neighbour begins or ends."""
    room = np.minimum([WIDE, HIGH], [sheet.width - begin[0], sheet.height - begin[1]])
    for x in (0.0, OVERLAP, room[0] - OVERLAP, room[0]):
        for y in (-1.0, room[1] + 1.0):
            assert off(page.points, [(MARGIN + x, MARGIN + y)])[0] < PLACED
    for y in (0.0, OVERLAP, room[1] - OVERLAP, room[1]):
        for x in (-1.0, room[0] + 1.0):
            assert off(page.points, [(MARGIN + x, MARGIN + y)])[0] < PLACED
