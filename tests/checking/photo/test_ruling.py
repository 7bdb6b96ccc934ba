"""What is ruled on an empty sheet, read off the sheet itself."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.photo.quadrilaterals import ruled
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.sheet_frame import frame

FORM_1 = 185.0, 55.0
"""The title block of ГОСТ 2.104, mm; ISO 7200's is 180 mm wide."""


def empty(size: str, language: str, first: bool = True) -> Sheet:
    drawn = frame(size, language=language, first=first, number=1, count=1, fields={})
    return Sheet("x", "x", size, *size_of(size), (drawn,), language)


@pytest.mark.parametrize(
    ("size", "language", "margins"),
    [
        ("A1", "ru", (20, 5, 5, 5)),
        ("A4", "ru", (20, 5, 5, 5)),
        ("A2", "en", (20, 10, 10, 10)),
        ("A4", "en", (20, 10, 10, 10)),
    ],
)
def test_frame_and_title_block_are_told(
    size: str, language: str, margins: tuple[float, ...]
) -> None:
    found = ruled(empty(size, language), first=True)
    width, height = size_of(size)
    left, bottom, right, top = margins
    assert found.frame == (left, bottom, width - right, height - top)
    assert found.paper == (0, 0, width, height)
    x, y = found.lines.real, found.lines.imag
    assert (x > 0).all()
    assert (x < width).all()
    assert (y > 0).all()
    assert (y < height).all()
    inside = found.lines[(x > left).any(axis=1)]
    assert abs(np.ptp(inside.real[inside.imag.max(axis=1) < bottom + FORM_1[1] + 1])) >= 179
    on_edge = [
        np.all(np.isclose(part, edge), axis=1)
        for part, edges in ((x, (left, width - right)), (y, (bottom, height - top)))
        for edge in edges
    ]
    assert not np.any(on_edge)
    assert (abs(np.diff(found.lines, axis=1)) >= 4).all()


def test_a_further_sheet_has_another_form() -> None:
    first, further = (ruled(empty("A1", "ru", first), first) for first in (True, False))
    assert len(further.lines) < len(first.lines)


def test_a_sheet_without_a_frame_has_nothing_ruled() -> None:
    bare = empty("A3", "ru")._replace(drawings=())
    assert ruled(bare, first=True).lines.shape == (0, 2)
