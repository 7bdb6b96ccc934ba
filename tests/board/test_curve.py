"""The French curve against a spline solved in another way, and against circles."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most

from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.curve import arc_through, bezier, french_curve
from graphic_tmm.board.operations.graphs import over
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Curve, Point

POINTS = st.integers(3, 30).flatmap(
    lambda n: st.lists(
        st.builds(complex, *[st.integers(-1000, 1000).map(lambda k: k / 8)] * 2),
        min_size=n,
        max_size=n,
    )
)


def _curve(points: Any, row: int | None = None) -> Curve:
    through = np.atleast_2d(np.asarray(points, dtype=complex))
    made = french_curve.run(through, row=row or through.shape[1])
    assert isinstance(made, Curve)
    return made


def _moments(points: np.ndarray, closed: bool) -> np.ndarray:
    """Second derivatives at the knots of the cubic spline, from the classical moment equations."""
    n = points.size
    matrix, right = np.zeros((n, n)), np.zeros(n, complex)
    for k in range(n):
        if not closed and k in (0, n - 1):
            matrix[k, k] = 1.0
            continue
        before, after = (k - 1) % n, (k + 1) % n
        matrix[k, k] += 4.0
        matrix[k, before] += 1.0
        matrix[k, after] += 1.0
        right[k] = 6.0 * (points[after] - 2.0 * points[k] + points[before])
    return np.linalg.solve(matrix, right)


def _seconds(controls: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Second derivatives at the beginning and the end of every piece."""
    p, a, b, q = controls[:-1:3], controls[1::3], controls[2::3], controls[3::3]
    return 6.0 * (p - 2.0 * a + b), 6.0 * (a - 2.0 * b + q)


@pytest.mark.slow
@settings(max_examples=most(150), deadline=None)
@given(POINTS)
def test_a_closed_row_is_the_periodic_spline(points: list[complex]) -> None:
    knots = np.array(points)
    (controls,) = bezier(_curve(points))
    np.testing.assert_array_equal(controls[0::3], np.append(knots, knots[0]))
    begins, ends = _seconds(controls)
    moments = _moments(knots, closed=True)
    size = 1.0 + np.abs(knots).max()
    np.testing.assert_allclose(begins, moments, rtol=0, atol=1e-11 * size)
    np.testing.assert_allclose(ends, np.roll(moments, -1), rtol=0, atol=1e-11 * size)
    # no corner at a knot: the neighbouring control points lie evenly about it
    np.testing.assert_allclose(
        controls[1::3] - controls[0:-1:3],
        np.roll(controls[3::3] - controls[2::3], 1),
        rtol=0,
        atol=1e-12 * size,
    )


def _error_on_a_circle(count: int) -> float:
    """Largest distance of the curve through ``count`` points of a unit circle from the circle."""
    (controls,) = bezier(_curve(np.exp(2j * np.pi * np.arange(count) / count)))
    t = np.linspace(0.0, 1.0, 41)[:, None]
    p, a, b, q = controls[:-1:3], controls[1::3], controls[2::3], controls[3::3]
    path = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * a + 3 * t**2 * (1 - t) * b + t**3 * q
    return float(np.abs(np.abs(path) - 1.0).max())


def test_a_circle_is_approached_with_the_fourth_order() -> None:
    errors = [_error_on_a_circle(n) for n in (12, 24, 48)]
    assert errors[0] < 3e-4
    for coarse, fine in itertools.pairwise(errors):
        assert 14.0 < coarse / fine < 18.0


@pytest.mark.parametrize("count", [1, 2])
def test_one_or_two_points_make_no_curve(count: int) -> None:
    made = _curve([1 + 1j, 2.0][:count])
    assert np.abs(made.tangents).max() == 0.0


@pytest.mark.slow
@settings(max_examples=most(150), deadline=None)
@given(POINTS, st.data())
def test_what_cannot_be_drawn_splits_the_row_into_natural_runs(
    points: list[complex], data: st.DataObject
) -> None:
    knots, n = np.array(points), len(points)
    gone = sorted(data.draw(st.sets(st.integers(0, n - 1), min_size=1)))
    knots[gone] = complex(np.nan, np.nan)
    curve = _curve(knots)
    drawn = bezier(curve)
    runs: list[list[int]] = []
    for k in range(gone[0] + 1, gone[0] + 1 + n):
        if k % n in gone:
            runs.append([])
        else:
            runs[-1].append(k % n) if runs else runs.append([k % n])
    runs = [run for run in runs if len(run) > 1]
    assert len(drawn) == len(runs)
    size = 1.0 + np.nanmax(np.abs(knots), initial=0.0)
    for run, controls in zip(runs, drawn, strict=True):
        np.testing.assert_array_equal(controls[0::3], knots[run])
        moments = _moments(knots[run], closed=False)
        begins, ends = _seconds(controls)
        np.testing.assert_allclose(begins, moments[:-1], rtol=0, atol=1e-11 * size)
        np.testing.assert_allclose(ends, moments[1:], rtol=0, atol=1e-11 * size)


def test_a_lost_position_is_a_matter_of_its_trial_only() -> None:
    circle = np.exp(2j * np.pi * np.arange(8) / 8)
    both = np.array([circle, circle])
    both[1, 3] = complex(np.nan, np.nan)
    made = _curve(both)
    np.testing.assert_array_equal(made.tangents[:1], _curve(circle).tangents)
    assert np.flatnonzero(np.isnan(made.tangents[1])).tolist() == [3]
    assert len(bezier(made, 0)) == len(bezier(made, 1)) == 1
    assert bezier(made, 0)[0].size == 25
    assert bezier(made, 1)[0].size == 19


def test_extra_positions_stand_outside() -> None:
    circle = np.exp(2j * np.pi * np.arange(8) / 8)
    extra = np.append(circle, [5 + 5j, complex(np.nan, 0)])
    made = _curve(extra, row=8)
    np.testing.assert_array_equal(made.knots, circle[None, :])
    np.testing.assert_array_equal(made.tangents, _curve(circle).tangents)


def test_a_reading_keeps_the_curve_over_the_row() -> None:
    board = Board()
    board.open("positions")
    point = board.take(Point, "B")
    mark = board.draw(french_curve, "(B–B)", point, row=12)
    circle = np.exp(2j * np.pi * np.arange(14) / 12)[None, :]
    curve = execute(board.construction(), {point: circle}, [mark])[mark]
    assert isinstance(curve, Curve)
    assert curve.knots.shape == curve.tangents.shape == (1, 12)
    assert curve.closed


def test_an_arc_has_the_opening_to_its_first_point_that_is_there() -> None:
    points = np.array(
        [[complex(np.nan, np.nan), 4j, 3.0], [2.0, 9.0, 9.0], [np.nan] * 3], dtype=complex
    )
    arc = arc_through.run(np.full((3, 3), 1.0 + 0j), points, turn=0)
    assert arc.centre.shape == arc.radius.shape == (3, 1)
    np.testing.assert_allclose(arc.radius[:, 0], [17.0**0.5, 1.0, np.nan])


def test_over_a_knot_a_curve_has_its_height_also_where_it_is_upright() -> None:
    """Beside the end of an oval x goes as a square: a foot off by the last bit is 1e-8 of the way off."""
    turns = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    knots = 50.0 * np.cos(turns) + 1j * (20.0 * np.sin(turns) + 8.0 * np.cos(3 * turns))
    numbers = np.arange(24) * (1.0 + 1e-15)
    feet = knots[None, :] * (1.0 - 1e-15)
    heights = over.run(_curve(knots), numbers[None, :], feet, behind=0)
    np.testing.assert_allclose(heights[0], knots.imag, rtol=0, atol=1e-12)
