"""Pencil is told from squares, shade and stains; a line of it from none."""

from __future__ import annotations

import numpy as np
import pytest
from support.each import each
from support.photographed.rubbed import DOTS, flat, paper, rubbed

from graphic_tmm.checking.pencil.expected import ExpectedLine
from graphic_tmm.checking.pencil.lines import tracks

DUE = ExpectedLine(20 + 20j, 130 + 70j, (0, 1))


@pytest.mark.parametrize("squared", [False, True])
def test_paper_is_no_pencil(squared: bool) -> None:
    random = np.random.default_rng(7)
    places = random.uniform(5, 150, 4000) + 1j * random.uniform(5, 110, 4000)
    assert flat(paper(squared=squared)).pencil(places).mean() < 0.15
    assert tracks(flat(paper(squared=squared)), DUE, 0j) == ()


@each("squared", [False, True])
@each("dashed", [False, True])
@each("start, end", [(0.0, 0.0), (2.0, -3.0), (-4.0, -4.5)])
def test_a_line_is_found_within_a_tenth_of_a_millimetre(
    start: float, end: float, dashed: bool, squared: bool
) -> None:
    left = 1j * (DUE.end - DUE.start) / abs(DUE.end - DUE.start)
    grey = rubbed(
        paper(squared=squared), DUE.start + left * start, DUE.end + left * end, dashed=dashed
    )
    found = tracks(flat(grey), DUE, 0j)[0]
    assert abs(found.start - start) < 0.1
    assert abs(found.end - end) < 0.1


def test_a_line_along_the_squares_is_found_beside_them() -> None:
    due = ExpectedLine(20 + 40j, 130 + 40j, (0, 1))
    grey = rubbed(paper(squared=True), 20 + 41.3j, 130 + 41.3j)
    found = tracks(flat(grey), due, 0j)
    assert abs(found[0].start - 1.3) < 0.1
    assert len(found) == 1


def test_blue_squares_are_lighter_than_pencil_as_dark() -> None:
    grey = paper(shade=1.0)
    x = (np.arange(grey.shape[1]) + 0.5) / DOTS
    blue = np.stack([grey, grey, grey], axis=-1)
    blue[:, abs(x - 60) < 0.2] *= np.array([0.5, 0.7, 0.97])
    blue[:, abs(x - 90) < 0.2] *= 0.6
    seen = flat(blue)
    ruling, pencil = (seen.darkness(at + 1j * np.arange(20.0, 100.0)).mean() for at in (60, 90))
    assert pencil > 0.2 > 0.1 > ruling
