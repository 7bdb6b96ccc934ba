"""Pencil is told from squares, shade and stains; a line of it from none."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import Line
from graphic_tmm.checking.pencil.lines import tracks
from graphic_tmm.paper.ruled import Box

DOTS, WIDTH, HEIGHT = 4, 160, 120
DUE = Line(20 + 20j, 130 + 70j, (0, 1))


def paper(seed: int = 1, *, squared: bool = False, shade: float = 0.5) -> np.ndarray:
    """Grey paper with grain: a lamp falls off across it, a stain with a sharp edge lies on it."""
    random = np.random.default_rng(seed)
    x = (np.arange(WIDTH * DOTS) + 0.5) / DOTS
    y = (np.arange(HEIGHT * DOTS)[:, None] + 0.5) / DOTS
    grey = 235.0 * np.linspace(1, shade, x.size) * np.ones_like(y)
    grey[abs(x - 75 + 1j * (y - 70)) < 12] *= 0.8
    if squared:
        ruled = (abs((x + 1.3) % 5 - 2.5) < 0.1) | (abs((y + 3.1) % 5 - 2.5) < 0.1)
        grey = np.where(ruled, grey * 0.8, grey)
    return grey + random.normal(0, 3, grey.shape)


def rubbed(grey: np.ndarray, a: complex, b: complex, *, dashed: bool = False) -> np.ndarray:
    """A line of pencil, 0.4 mm wide, from one place of the sheet to another."""
    x = (np.arange(grey.shape[1]) + 0.5) / DOTS
    y = HEIGHT - (np.arange(grey.shape[0])[:, None] + 0.5) / DOTS
    own = (x + 1j * y - a) / (b - a) * abs(b - a)
    part = np.clip((0.2 - abs(own.imag)) * DOTS + 0.5, 0, 1)
    part = part * ((own.real > 0) & (own.real < abs(b - a)))
    if dashed:
        part = part * (own.real % 5.5 < 4)
    return grey * (1 - 0.5 * part)


def flat(grey: np.ndarray) -> Flat:
    return Flat(np.clip(np.rint(grey), 0, 255).astype(np.uint8), Box(0, 0, WIDTH, HEIGHT), DOTS)


@pytest.mark.parametrize("squared", [False, True])
def test_paper_is_no_pencil(squared: bool) -> None:
    random = np.random.default_rng(7)
    places = random.uniform(5, 150, 4000) + 1j * random.uniform(5, 110, 4000)
    assert flat(paper(squared=squared)).pencil(places).mean() < 0.15
    assert tracks(flat(paper(squared=squared)), DUE, 0j) == ()


@pytest.mark.parametrize("squared", [False, True])
@pytest.mark.parametrize("dashed", [False, True])
@pytest.mark.parametrize(("start", "end"), [(0.0, 0.0), (2.0, -3.0), (-4.0, -4.5)])
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
    due = Line(20 + 40j, 130 + 40j, (0, 1))
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
