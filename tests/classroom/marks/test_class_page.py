"""The summary as a page in a browser: it shows itself, asks for nothing, sorts by a click."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from support.browser import Opened

from graphic_tmm.classroom.marks.marking import Entry, Marked
from graphic_tmm.classroom.marks.names import HandIn, Skipped
from graphic_tmm.classroom.marks.row import Row
from graphic_tmm.classroom.marks.rule import FIVE, Mark
from graphic_tmm.classroom.marks.summary import summary_html

if TYPE_CHECKING:
    from playwright.sync_api import Browser

EVIL = '<img src="http://x/"><script>alert(1)</script>'


def marked(*points: int) -> Marked:
    entries = tuple(
        Entry(
            HandIn(f"{EVIL} {k}", "", "", (), (), f"f{k} #?%"),
            Row(fine=one),
            Mark(str(one // 20), Fraction(one)),
            None,
        )
        for k, one in enumerate(points)
    )
    return Marked(EVIL, "en", FIVE, (), entries, (), (Skipped(EVIL, EVIL),))


@pytest.mark.slow
def test_the_page_sorts_and_does_nothing_else(browser: Browser, tmp_path: Path) -> None:
    file = tmp_path / "summary.html"
    file.write_text(summary_html(marked(9, 100, 55, 70)), "utf-8")
    opened = Opened(browser, file)
    column = opened.page.locator("td.points")
    assert column.all_text_contents() == ["9", "100", "55", "70"]
    head = opened.page.locator("th button", has_text="points")
    head.click()
    assert column.all_text_contents() == ["9", "55", "70", "100"]
    head.click()
    assert column.all_text_contents() == ["100", "70", "55", "9"]
    assert opened.page.locator("td.name a").first.get_attribute("href") == (
        "reports/f1%20%23%3F%25.html"
    )
    assert opened.settle() == []
    opened.close()
