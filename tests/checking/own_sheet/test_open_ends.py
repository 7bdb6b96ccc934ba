"""Points where a line of pencil ends in the open."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.own_sheet.open_ends import with_open_ends
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import ExpectedLine, ExpectedPlace, View
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE, Spot
from graphic_tmm.paper.ruled import Box

DOTS = 8.0
Stroke = tuple[complex, complex]


def flat_of(strokes: list[Stroke], ring: complex | None = None, half: float = 0.2) -> Flat:
    """A paper of 60 × 40 mm with lines of 0.4 mm, and a ring of 0.8 mm about a place; ``half`` a line wide."""
    x, y = np.meshgrid((np.arange(480) + 0.5) / DOTS, 40 - (np.arange(320) + 0.5) / DOTS)
    z = x + 1j * y
    far = np.full(z.shape, np.inf)
    for a, b in strokes:
        along = np.clip(((z - a) / (b - a)).real, 0, 1)
        far = np.minimum(far, abs(z - a - along * (b - a)))
    if ring is not None:
        far = np.minimum(far, abs(abs(z - ring) - 0.8))
    image = np.where(far < half, 90, 230).astype(np.uint8)
    return Flat(np.repeat(image[..., None], 3, axis=2), Box(0.0, 0.0, 60.0, 40.0), DOTS)


def spots_of(flat: Flat, at: complex, pole: Spot) -> tuple[Spot, ...]:
    """The spots of a pole and a point whose line begins at 10 + 20j and should end at 35 + 20j."""
    name = ("velocities", "c", "1")
    places = (ExpectedPlace(10 + 20j, ()), ExpectedPlace(35 + 20j, (name,)))
    line = ExpectedLine(10 + 20j, 35 + 20j, (0, 1))
    no = np.zeros((0, 2), np.complex128)
    poles = {("velocities", "1"): 0}
    view = View("v", places, (line,), poles, (no, no), (None, 0), np.zeros((1, 2), np.complex128))
    return with_open_ends(flat, view, (pole, Spot(at, 0.5, UNSURE)), 10 + 20j)


def ended(flat: Flat, at: complex = 36 + 20j) -> Spot:
    """The spot of the point."""
    return spots_of(flat, at, Spot(10 + 20j, 0.1, SEEN))[1]


@pytest.mark.parametrize("end", [33.0, 36.0, 39.5])
def test_a_line_ends_where_its_pencil_ends(end: float) -> None:
    spot = ended(flat_of([(10 + 20j, end + 20j)]))
    assert (spot.how, spot.at) == (SEEN, pytest.approx(end + 20j, abs=0.3))


def test_a_ring_about_the_end_shows_it_by_its_middle() -> None:
    spot = ended(flat_of([(10 + 20j, 37 + 20j)], 37 + 20j))
    assert (spot.how, spot.at) == (SEEN, pytest.approx(37 + 20j, abs=0.3))


@pytest.mark.parametrize("half", [0.45, 0.6])
def test_the_end_of_a_broad_line_is_no_ring(half: float) -> None:
    spot = ended(flat_of([(10 + 20j, 37 + 20j)], half=half))
    assert (spot.how, spot.at) == (SEEN, pytest.approx(37 + half + 20j, abs=0.2))


def test_nor_is_the_broad_part_of_a_head() -> None:
    wings = [(37 + 20j, 34.5 + side * 0.6 + (20 + side * 0.7) * 1j) for side in (-1, 1)]
    spot = ended(flat_of([(10 + 20j, 37 + 20j), *wings], half=0.25))
    assert (spot.how, spot.at) == (SEEN, pytest.approx(37 + 20j, abs=0.4))


@pytest.mark.parametrize(
    ("error", "how", "at"),
    [
        (0.1, SEEN, 10.8 + 20j),  # its lines cross there
        (0.3, SEEN, 10.4 + 20j),
        (0.1, UNSURE, 10.4 + 20j),
        (0.1, UNSEEN, 10 + 20j),
    ],
)
def test_where_a_pole_is_not_sure_a_click_tells_as_much(
    error: float, how: str, at: complex
) -> None:
    crossed = flat_of([(4 + 20j, 37 + 20j)])
    assert spots_of(crossed, 36 + 20j, Spot(10.8 + 20j, error, how))[0].at == pytest.approx(at)


@pytest.mark.parametrize(
    "more",
    [
        [(36 + 12j, 36 + 28j)],
        [(36 + 20j, 42 + 27j)],
        [(36 + 20j, 59 + 20j)],
        [(36.5 + 18j, 36.5 + 21j)],
    ],
)
def test_an_end_on_another_line_or_no_end_is_none(more: list[Stroke]) -> None:
    assert ended(flat_of([(10 + 20j, 36 + 20j), *more])).how == UNSURE


def test_an_end_farther_than_it_can_be_is_none() -> None:
    assert ended(flat_of([(10 + 20j, 50 + 20j)])).how == UNSURE
