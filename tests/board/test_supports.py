"""Figures as a whole: farthest point, supporting lines, the planimeter; against brute force."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.board.operations.curve import bezier, french_curve, taut_curve
from graphic_tmm.board.operations.supports import farthest, planimeter, supporting, supporting_curve
from graphic_tmm.board.values import Curve

POINTS = st.lists(
    st.complex_numbers(max_magnitude=100, allow_nan=False, allow_infinity=False),
    min_size=4,
    max_size=12,
    unique=True,
)
RING = 40 * np.exp(2j * np.pi * np.arange(12) / 12)[None, :] + 5 - 3j


def dense(curve: Curve) -> np.ndarray:
    t = np.linspace(0, 1, 400)
    (controls,) = bezier(curve)
    parts = []
    for k in range(0, len(controls) - 1, 3):
        a, b, c, d = controls[k : k + 4]
        parts.append(
            (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
        )
    return np.concatenate(parts)


@given(POINTS)
def test_the_farthest_point(points: list[complex]) -> None:
    row = np.array(points)[None, :]
    found = farthest.run(np.array([[1 + 2j]]), row, row=row.size)
    assert np.isclose(abs(found[0, 0] - (1 + 2j)), np.abs(row - (1 + 2j)).max(), rtol=1e-12)
    assert found[0, 0] in row


@given(POINTS, st.floats(-80, 80), st.sampled_from([1, -1]))
def test_a_supporting_line_leaves_all_points_on_one_side(
    points: list[complex], angle: float, above: int
) -> None:
    row = np.array(points)[None, :]
    line = supporting.run(row, np.array([[angle]]), row=row.size, above=above)
    across = 1j * line.along * above
    heights = ((row - line.at) * np.conj(across)).real
    assert heights.max() <= 1e-12 * 100
    assert np.isclose(heights, 0.0, atol=1e-12 * 100).any()


@each("above", [1, -1])
@each("angle", [-70.0, -10.0, 0.0, 25.0, 60.0])
def test_a_line_rests_on_the_whole_curve(angle: float, above: int) -> None:
    rng = np.random.default_rng(3)
    row = RING + rng.normal(size=12) * 8
    curve = french_curve.run(row, row=12)
    line = supporting_curve.run(curve, np.array([[angle]]), above=above)
    heights = above * ((dense(curve) - line.at[0, 0]) * np.conj(1j * line.along[0, 0])).real
    assert heights.max() <= 1e-9
    assert heights.max() >= -1e-2  # the sampling of the curve
    on_points = supporting.run(row, np.array([[angle]]), row=12, above=above)
    rise = above * ((line.at - on_points.at) * np.conj(1j * line.along)).real
    assert rise[0, 0] >= -1e-12


def test_trials_are_supported_each_by_itself_and_a_missing_point_leaves_no_line() -> None:
    rows = np.concatenate([RING, RING * 2, RING])
    rows[2, 5] = np.nan
    angle = np.array([[30.0]])
    found = supporting.run(rows, angle, row=12, above=1)
    assert np.isfinite(found.at[:2]).all()
    assert np.isnan(found.at[2]).all()
    curve = french_curve.run(rows, row=12)
    whole = supporting_curve.run(curve, angle, above=1)
    assert np.isfinite(whole.at[:2]).all()
    assert np.isnan(whole.at[2]).all()
    assert np.isnan(farthest.run(np.zeros((1, 1), complex), rows, row=12)[2]).all()


@pytest.mark.parametrize("op", [french_curve, taut_curve])
def test_the_planimeter_measures_what_shapely_measures(op: object) -> None:
    rng = np.random.default_rng(5)
    row = RING + rng.normal(size=12)
    curve = op.run(row, row=12)  # type: ignore[attr-defined]
    polygon = shapely.Polygon([(z.real, z.imag) for z in dense(curve)])
    area = planimeter.run(curve)[0, 0]
    assert area == pytest.approx(polygon.area, rel=1e-5)  # 400 chords an arc
    backwards = op.run(row[:, ::-1], row=12)  # type: ignore[attr-defined]
    assert planimeter.run(backwards)[0, 0] == pytest.approx(area, rel=1e-9)


def test_the_area_of_a_circle_drawn_with_the_french_curve() -> None:
    area = planimeter.run(french_curve.run(RING, row=12))[0, 0]
    assert area == pytest.approx(np.pi * 40**2, rel=2e-3)


def test_a_taut_curve_stays_within_the_reach_of_its_points() -> None:
    x = 50 - 50 * np.cos(np.pi * np.arange(12) / 6)
    y = np.array([200, 200, 160, 106, 81, 58, 20, 23, 28, 43, 67, 96.0])
    curve = taut_curve.run((x + 1j * y)[None, :], row=12)
    spots = dense(curve)
    assert spots.real.min() >= -1e-9
    assert spots.real.max() <= 100 + 1e-9
    assert spots.imag.max() <= 200 + 1e-9
    assert spots.imag.min() >= 20 - 1e-9
    np.testing.assert_allclose(curve.knots[0], x + 1j * y)
    broken = (x + 1j * y)[None, :].copy()
    broken[0, 3] = np.nan
    assert np.isnan(taut_curve.run(broken, row=12).tangents).all()
