from __future__ import annotations

import itertools

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.each import each
from support.examples import most

from graphic_tmm.checking.photo.perspective import bilinear, homography, ordered, through, vertices
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.ruled import Box

BOX = Box(20.0, 5.0, 836.0, 589.0)
SEEN = np.array([210 + 1290j, 1810 + 1330j, 1650 + 240j, 330 + 180j])
"""Lower left, lower right, upper right, upper left; y downward."""


def pairs(points: np.ndarray) -> np.ndarray:
    return np.stack([points.real, points.imag], axis=-1)


@each("order", list(itertools.permutations(range(4))))
def test_corners_come_in_any_order(order: tuple[int, ...]) -> None:
    assert (ordered(pairs(SEEN)[list(order)]) == SEEN).all()


@pytest.mark.parametrize("turn", [-40, -20, 20, 40])
def test_a_sheet_turned_less_than_an_eighth_keeps_its_corners(turn: float) -> None:
    square = 500 * np.array([-1 + 1j, 1 + 1j, 1 - 1j, -1 - 1j]) * np.exp(1j * np.radians(turn))
    assert (ordered(pairs(square)[::-1]) == square).all()


@each(
    "corners",
    [
        [(0, 0), (100, 0), (200, 0), (100, 100)],
        [(0, 0), (0, 0), (100, 0), (100, 100)],
        [(0, 0), (300, 0), (150, 100), (150, 300)],
        [(0, 0), (10, 0), (10, 10), (0, 10)],
        [(0, 0), (100, 0), (100, 100)],
        [(0, 0), (100, 0), (100, float("nan")), (0, 100)],
        [(0, 0), (100, 0), (100, float("inf")), (0, 100)],
        [(0, 0, 1)] * 4,
        [(0, 0), (1e308, 0), (1e308, 1e308), (0, 1e308)],
        [(0, 0), (1e200, 0), (1e200, 1e200), (0, 1e200)],
        [(0, 0), (100, 0), (100, -1e9), (0, 100)],
        [("a", "b")] * 4,
        [(0, 0), (1,)],
        [],
        None,
    ],
)
def test_what_is_no_convex_quadrilateral_is_refused(corners: object) -> None:
    with pytest.raises(SheetError, match="corners: "):
        ordered(corners)  # type: ignore[arg-type]


def test_a_corner_outside_every_photograph_is_named() -> None:
    with pytest.raises(SheetError, match=r"corners: -1e\+300 lies outside every photograph"):
        ordered([(0, 0), (100, 0), (100, -1e300), (0, 100)])


def direct(box: Box, seen: np.ndarray, point: complex) -> complex:
    """The eight linear equations of a projection, solved with 40 digits."""
    with mpmath.workdps(40):
        rows, right = [], []
        for z, p in zip(vertices(box), seen, strict=True):
            x, y, u, v = map(mpmath.mpf, (z.real, z.imag, p.real, p.imag))
            rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
            right += [u, v]
        h = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix(right))
        x, y = mpmath.mpf(point.real), mpmath.mpf(point.imag)
        w = h[6] * x + h[7] * y + 1
        return complex((h[0] * x + h[1] * y + h[2]) / w, (h[3] * x + h[4] * y + h[5]) / w)


@settings(max_examples=most(40))
@given(
    st.lists(st.floats(-400, 400), min_size=8, max_size=8),
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
)
def test_the_projection_solves_the_eight_equations(
    moves: list[float], across: float, up: float
) -> None:
    square = 1000 * np.array([-1 + 1j, 1 + 1j, 1 - 1j, -1 - 1j]) + 1500 + 1200j
    seen = square + np.array(moves[:4]) + 1j * np.array(moves[4:])
    matrix = homography(BOX, seen)
    # numbers to 3000 px, the denominator no less than 1/10: 1e4 roundings of 3000 * 2e-16 at the most
    assert abs(through(matrix, vertices(BOX)) - seen).max() < 1e-8
    point = complex(20 + 816 * across, 5 + 584 * up)
    assert abs(complex(through(matrix, point)) - direct(BOX, seen, point)) < 1e-8


def test_beyond_the_horizon_nothing_is_seen() -> None:
    seen = np.array([0 + 1000j, 1000 + 1000j, 700 + 500j, 300 + 500j])
    matrix = homography(Box(0, 0, 100, 100), seen)
    # sides through (0, 1000), (300, 500) and (1000, 1000), (700, 500) meet at 500, 1000 / 6
    far = through(matrix, np.array([50 + 1e9j, 50 - 1e9j, 50 - 200j]))
    assert abs(far[0] - (500 + 1000 / 6 * 1j)) < 1e-3
    assert np.isnan(far[1:]).all()


def test_between_dots_the_picture_is_linear() -> None:
    rows, columns = np.indices((5, 7))
    image = np.stack([rows * 10 + columns, rows * 20, columns * 30], axis=-1).astype(np.uint8)
    at = np.array([0, 6 + 4j, 2.25 + 1.5j, 5.5 + 3.75j])
    due = [at.imag * 10 + at.real, at.imag * 20, at.real * 30]
    assert np.allclose(bilinear(image, at), np.stack(due, axis=-1), rtol=0, atol=1e-12)
    outside = np.array([-0.01, 6.01, 2 - 0.01j, 2 + 4.01j, complex(np.nan, 0)])
    assert np.isnan(bilinear(image, outside)).all()
    assert (bilinear(image[:1, :1], np.array([0j])) == 0).all()
