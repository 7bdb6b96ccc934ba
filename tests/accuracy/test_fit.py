"""Slopes in log-log: exact powers, numpy's least squares, tables of Student's distribution, coverage."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.accuracy.fit import slope, student


@pytest.mark.slow
@given(
    power=st.floats(-4.0, 4.0),
    factor=st.floats(1e-3, 1e3),
    n=st.integers(3, 20),
)
def test_a_power_is_found_with_no_uncertainty(power: float, factor: float, n: int) -> None:
    x = 2.0 ** np.arange(n)
    y = factor * x**power
    found = slope(x.tolist(), y.tolist())
    # logarithms are rounded to ε of the largest; the arm of the slope is at least ln 2
    bound = 8 * n * np.finfo(float).eps * (1 + np.abs(np.log(y)).max() + np.log(x).max())
    assert found.slope == pytest.approx(power, abs=bound)
    assert found.level == pytest.approx(math.log(factor), abs=n * bound)
    assert found.error <= bound
    assert found.at(8.0) == pytest.approx(factor * 8.0**power, rel=4 * n * bound)
    assert found.points == n


def test_slope_and_error_are_those_of_the_normal_equations() -> None:
    rng = np.random.default_rng(8)
    x = np.exp(rng.uniform(0, 5, 12))
    y = 3.0 * x**-1.7 * np.exp(rng.normal(0, 0.2, 12))
    found = slope(x.tolist(), y.tolist())
    design = np.stack([np.log(x), np.ones(12)], axis=1)
    due, square, _, _ = np.linalg.lstsq(design, np.log(y), rcond=None)
    covariance = square[0] / 10 * np.linalg.inv(design.T @ design)
    assert found.slope == pytest.approx(due[0], rel=1e-12)
    assert found.level == pytest.approx(due[1], rel=1e-12)
    assert found.error == pytest.approx(math.sqrt(covariance[0, 0]), rel=1e-10)


def test_scale_and_order_change_nothing() -> None:
    x, y = [8.0, 12.0, 24.0, 48.0, 96.0], [9.1, 4.2, 1.3, 0.31, 0.07]
    plain, scaled = slope(x, y), slope([1e6 * v for v in x], [1e-9 * v for v in y])
    turned = slope(x[::-1], y[::-1])
    for other in (scaled, turned):
        assert other.slope == pytest.approx(plain.slope, rel=1e-13)
        assert other.error == pytest.approx(plain.error, rel=1e-11)
    back = slope(y, x)
    assert 0 < plain.slope * back.slope <= 1.0


def test_points_without_a_logarithm_are_left_out() -> None:
    whole = slope([1.0, 2.0, 4.0], [1.0, 4.0, 16.0])
    bad = slope([1, 2, 4, 8, 16, 0, math.inf], [1, 4, 16, 0.0, math.nan, 5, 5])
    assert bad == whole
    assert whole.slope == pytest.approx(2.0, rel=1e-15)


def test_too_few_points_have_no_slope_or_no_uncertainty() -> None:
    for x, y in (([], []), ([3.0], [4.0]), ([3.0, 3.0, 3.0], [1.0, 2.0, 3.0])):
        found = slope(x, y)
        assert math.isnan(found.slope)
        assert math.isnan(found.error)
        assert found.points == len(x)
    two = slope([1.0, 10.0], [5.0, 0.5])
    assert two.slope == pytest.approx(-1.0, rel=1e-15)
    assert math.isnan(two.error)
    assert math.isnan(two.half_width())
    with pytest.raises(ValueError, match="2 of x, but 1 of y"):
        slope([1.0, 2.0], [1.0])


@each("freedom", [1, 2, 3, 4, 5, 8, 13, 30, 101, 1000])
@each("confidence", [0.5, 0.9, 0.95, 0.99, 0.999])
def test_students_t_encloses_its_share_by_the_incomplete_beta_function(
    freedom: int, confidence: float
) -> None:
    with mpmath.workdps(40):
        t = mpmath.mpf(student(confidence, freedom))
        outside = mpmath.betainc(
            mpmath.mpf(freedom) / 2, 0.5, 0, freedom / (freedom + t * t), regularized=True
        )
        share = float(1 - outside)
    # the series has freedom / 2 terms, each rounded
    assert share == pytest.approx(confidence, abs=(freedom + 8) * np.finfo(float).eps)


@pytest.mark.parametrize(("freedom", "due"), [(1, 12.706), (2, 4.303), (6, 2.447), (30, 2.042)])
def test_students_t_is_that_of_the_printed_tables(freedom: int, due: float) -> None:
    assert student(0.95, freedom) == pytest.approx(due, abs=5e-4)


def test_there_is_no_t_outside_its_range() -> None:
    for confidence, freedom in ((0.0, 5), (1.0, 5), (math.nan, 5), (0.95, 0), (0.95, -1)):
        assert math.isnan(student(confidence, freedom))


@pytest.mark.slow
def test_the_interval_holds_the_true_slope_as_often_as_it_says() -> None:
    rng = np.random.default_rng(2024)
    x, trials = 2.0 ** np.arange(3, 10), 2000
    held = 0
    for _ in range(trials):
        y = x**-2.0 * np.exp(rng.normal(0, 0.1, x.size))
        found = slope(x.tolist(), y.tolist())
        held += abs(found.slope + 2.0) <= found.half_width(0.9)
    # a binomial count: five standard deviations about its mean
    assert abs(held - 0.9 * trials) <= 5 * math.sqrt(trials * 0.9 * 0.1)
