"""Operations for cams: stretches, touching lines, extremes and swept profiles, against brute force."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.values import Arc, Curve, Line
from graphic_tmm.chapters.cam import operations as c

RNG = np.random.default_rng(5)
ROW = np.cumsum(RNG.normal(size=(1, 9)) * 4 + 6, axis=1) + 1j * RNG.normal(size=(1, 9)) * 10
UP = Line(np.zeros((1, 9), complex), np.full((1, 9), 1j))
POINTS = st.lists(
    st.complex_numbers(max_magnitude=100, allow_nan=False, allow_infinity=False),
    min_size=5,
    max_size=9,
    unique=True,
)


def dense(curve: Curve, trial: int = 0) -> np.ndarray:
    t = np.linspace(0, 1, 2001)
    (controls,) = bezier(curve, trial)
    parts = []
    for k in range(0, len(controls) - 1, 3):
        a, b, d, e = controls[k : k + 4]
        parts.append(
            (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * d + t**3 * e
        )
    return np.concatenate(parts)


@pytest.mark.parametrize(("first", "last"), [(0, 8), (2, 7), (3, 5), (4, 5)])
def test_a_stretch_passes_through_its_points_and_through_no_others(first: int, last: int) -> None:
    curve = c.smooth_stretch.run(ROW, first=first, last=last)
    np.testing.assert_array_equal(curve.knots, ROW[:, first : last + 1])
    assert np.isfinite(curve.tangents).all()
    assert not curve.closed


@given(st.lists(st.floats(-2, 2), min_size=8, max_size=8), st.integers(3, 8))
def test_a_cubic_is_drawn_exactly_and_a_parabola_by_three_points(
    parts: list[float], last: int
) -> None:
    k = np.arange(9.0)
    b = np.array(parts[:4]) + 1j * np.array(parts[4:])
    cubic = (b[0] + b[1] * k + b[2] * k**2 + b[3] * k**3)[None, :]
    curve = c.smooth_stretch.run(cubic, first=0, last=last)
    due = b[1] + 2 * b[2] * k + 3 * b[3] * k**2
    np.testing.assert_allclose(curve.tangents[0], due[: last + 1], atol=1e-9)
    parabola = (b[0] + b[1] * k + b[2] * k**2)[None, :]
    short = c.smooth_stretch.run(parabola, first=2, last=4)
    np.testing.assert_allclose(short.tangents[0], (b[1] + 2 * b[2] * k)[2:5], atol=1e-10)


def test_missing_points_leave_runs_and_touch_their_trial_only() -> None:
    rows = np.concatenate([ROW] * 2)
    rows[1, 4] = np.nan
    curve = c.smooth_stretch.run(rows, first=0, last=8)
    assert np.isfinite(curve.tangents[0]).all()
    assert np.isnan(curve.tangents[1, 4])
    assert np.isfinite(np.delete(curve.tangents[1], 4)).all()
    with np.errstate(all="ignore"):
        top = c.crest_of_curve.run(curve, above=1)
        line = c.touch_curve.run(curve, UP, np.full((1, 9), 30.0), sense=1, left=1)
    assert np.isfinite(top[0])
    assert np.isnan(top[1])
    assert np.isnan(line.at[1])


@given(POINTS, st.floats(-89, 89), st.sampled_from([1, -1]), st.sampled_from([1, -1]))
def test_a_line_touches_the_whole_curve(
    points: list[complex], by: float, sense: int, left: int
) -> None:
    row = np.array(points)[None, :]
    curve = c.smooth_stretch.run(row, first=0, last=row.size - 1)
    up = Line(np.zeros_like(row), np.full_like(row, 1j))
    with np.errstate(all="ignore"):
        line = c.touch_curve.run(curve, up, np.full(row.shape, by), sense=sense, left=left)
    way = 1j * np.exp(1j * sense * np.radians(by))
    np.testing.assert_allclose(line.along, way, atol=1e-12)
    away = left * ((dense(curve) - line.at[0, 0]) * np.conj(1j * way)).real
    size = np.abs(curve.knots).max() + np.abs(curve.tangents).max()
    assert away.max() <= 1e-12 * size
    assert away.max() >= -1e-5 * size  # 2000 chords an arc


@given(POINTS, st.sampled_from([1, -1]))
def test_the_extreme_of_a_curve(points: list[complex], above: int) -> None:
    row = np.array(points)[None, :]
    curve = c.smooth_stretch.run(row, first=0, last=row.size - 1)
    with np.errstate(all="ignore"):
        top = c.crest_of_curve.run(curve, above=above)[0, 0]
    size = np.abs(curve.knots).max() + np.abs(curve.tangents).max()
    heights = above * dense(curve).imag
    assert heights.max() - 1e-12 * size <= above * top.imag <= heights.max() + 1e-5 * size


def test_the_outer_of_parallels_and_the_extreme_of_points() -> None:
    way = np.exp(1j * np.array([[0.3]]))
    inner, far = Line(np.array([[2 + 1j]]), way), Line(np.array([[2 + 5j]]), way)
    for pair in ((inner, far), (far, inner)):
        assert c.outer_parallel.run(*pair, left=1).at[0, 0] == 2 + 5j
        assert c.outer_parallel.run(*pair, left=-1).at[0, 0] == 2 + 1j
        assert c.extreme_of_two.run(pair[0].at, pair[1].at, above=1)[0, 0] == 2 + 5j
        assert c.extreme_of_two.run(pair[0].at, pair[1].at, above=-1)[0, 0] == 2 + 1j
    gone = np.array([[np.nan + 0j]])
    assert np.isnan(c.outer_parallel.run(inner, Line(gone, way), left=1).at)
    assert np.isnan(c.extreme_of_two.run(gone, inner.at, above=1))


@pytest.mark.parametrize("sense", [1, -1])
def test_angles_are_laid_off_and_measured_in_one_sense(sense: int) -> None:
    centre, radius = np.array([[1 + 2j]]), np.array([[5.0]])
    start = Line(centre, np.array([[-1 + 0j]]))
    angles = np.array([[0.0, 30.0, 90.0, 150.0]])
    spots = c.divide_semicircle.run(Arc(centre, radius), start, angles, sense=sense)
    np.testing.assert_allclose(np.abs(spots - centre), 5.0)
    assert spots[0, 2] == 1 + 2j - 5j * sense
    found = c.slant.run(centre, spots, start, sense=sense)
    np.testing.assert_allclose(found, angles, atol=1e-12)
    turned = c.slew.run(centre, start, angles, sense=sense)
    np.testing.assert_allclose(turned.along, (spots - centre) / 5.0, atol=1e-15)
    inward = c.inward_normal.run(centre, start, angles, sense=sense)
    np.testing.assert_allclose(inward.along, -turned.along)
    with np.errstate(all="ignore"):
        assert np.isnan(c.slant.run(centre, centre, start, sense=sense))


def test_readings_in_turn_and_the_end_of_a_phase() -> None:
    first, second = np.array([[1.0, np.nan, 3.0]]), np.array([[np.nan, 5.0, 6.0]])
    at = np.array([[1.0, 0.0, 0.0]])
    np.testing.assert_array_equal(c.in_turn.run(first, second, at), [[1.0, 5.0, 6.0]])
    assert c.phase_end.run(ROW, at=3)[0, 0] == ROW[0, 3]


@pytest.mark.parametrize("sense", [1, -1])
def test_a_profile_swept_about_a_circle_is_the_circle(sense: int) -> None:
    """Points of a circle of 40 mm, every 10°: the arcs stay on it within the error of a cubic, r·Δ⁴/384."""
    phi = np.radians(np.arange(9) * 10.0)[None, :]
    points = 40 * 1j * np.exp(-1j * sense * phi)
    normals = Line(points, -points / 40)
    pace, step = np.full((1, 9), 40.0), np.full((1, 9), 10.0)
    curve = c.swept_profile.run(points, normals, pace, step, first=1, last=7, sense=sense)
    np.testing.assert_array_equal(curve.knots, points[:, 1:8])
    due = 40 * np.radians(10.0) ** 4 / 384
    assert np.abs(np.abs(dense(curve)) - 40).max() <= due
    trials = c.swept_profile.run(
        np.concatenate([points] * 2), normals, pace, step, first=1, last=7, sense=sense
    )
    np.testing.assert_array_equal(trials.tangents[1], curve.tangents[0])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_line_cuts_an_arc_or_has_its_foot(side: float) -> None:
    line = Line(np.array([[-7 + 3j, -7 + 4j, 2 + 9j]]), np.full((1, 3), 1 + 0j))
    arc = Arc(np.array([[1 + 0j]]), np.array([[5.0]]))
    found = c.cut_or_foot.run(line, arc, np.array([[side]]))
    np.testing.assert_allclose(found, [[1 + 4 * side + 3j, 1 + 3 * side + 4j, 1 + 9j]], atol=1e-12)
