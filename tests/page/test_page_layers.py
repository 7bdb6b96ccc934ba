"""Every part of which ink is has a word, so that the page can show and hide it."""

from __future__ import annotations

import re

from support.gallery import SHEETS

from graphic_tmm.page.words import PARTS

PART = re.compile(r'data-part="([^"]*)"')


def test_every_part_of_the_packaged_sheets_is_called_something():
    found = {
        part
        for sheet in SHEETS.glob("*/*.svg")
        for part in PART.findall(sheet.read_text(encoding="utf-8"))
    }
    assert found
    assert found - set(PARTS) == set()


def test_no_two_parts_are_called_the_same():
    assert len(set(PARTS.values())) == len(PARTS)
