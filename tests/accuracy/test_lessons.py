"""Slopes in log-log: exact powers, numpy's least squares, tables of Student's distribution, coverage."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import product

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

from graphic_tmm.accuracy.cost import BoardWork
from graphic_tmm.accuracy.lessons import best_of, front, optima, slope, slopes, student
from graphic_tmm.accuracy.measure import Errors, Measurement
from graphic_tmm.accuracy.timing import Seconds


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


VALUES = st.one_of(
    st.integers(0, 6).map(float), st.floats(0, 10), st.sampled_from([math.nan, math.inf])
)
POINTS = st.lists(st.tuples(VALUES, VALUES), max_size=25)


def brute(points: list[tuple[float, float]]) -> set[int]:
    """Compare all pairs."""
    there = [k for k, p in enumerate(points) if all(map(math.isfinite, p))]

    def beaten(k: int) -> bool:
        c, e = points[k]
        return any(
            points[j][0] <= c and points[j][1] <= e and (points[j] != points[k] or j < k)
            for j in there
            if j != k
        )

    return {k for k in there if not beaten(k)}


def costs_and_errors(points: list[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [p[0] for p in points], [p[1] for p in points]


@given(POINTS)
def test_the_front_is_what_no_other_beats(points: list[tuple[float, float]]) -> None:
    found = front(*costs_and_errors(points))
    assert set(found) == brute(points)
    assert len(found) == len(set(found))
    rows = [points[k] for k in found]
    assert rows == sorted(rows)
    assert [e for _, e in rows] == sorted((e for _, e in rows), reverse=True)


def test_of_equal_ones_the_first_stands_for_all() -> None:
    assert front([1, 1, 1], [2.0, 2.0, 2.0]) == (0,)


def test_more_work_that_makes_it_worse_is_not_on_the_front() -> None:
    positions = np.array([8, 12, 18, 24, 36, 72])
    truncation, hand = 30.0 * (8 / positions) ** 2, 0.05 * (positions / 8) ** 2
    errors = truncation + hand
    found = front(positions.tolist(), errors.tolist())
    assert found == tuple(range(int(errors.argmin()) + 1))
    assert found[-1] < 5


def test_nothing_is_on_no_front() -> None:
    assert front([], []) == ()
    assert front([math.nan, 1.0], [0.0, math.inf]) == ()


def run(
    n: int, error: float, *, hand: str = "student", spread: float = 0.0, axis: str = "positions"
) -> Measurement:
    errors = Errors(error, error / 2, spread, 0.0)
    each = 1e-3 * n**0.5
    seconds = Seconds(each, each, each, 1.2 * each)
    return Measurement(
        axis, f"{n}", "V", n, hand, 1.0, 100, errors, BoardWork({}, {}, 5.0 * n), seconds
    )


def test_powers_of_the_number_of_positions_are_found() -> None:
    runs = [run(n, 300.0 / n**2, hand="exact") for n in (4, 8, 12, 24, 48, 96)]
    runs[0] = run(4, 1e6, hand="exact")  # too few positions to follow the power
    (found,) = slopes(runs)
    assert found.error.slope == pytest.approx(-2.0, abs=1e-9)
    assert found.minutes.slope == pytest.approx(1.0, abs=1e-9)
    assert found.seconds.slope == pytest.approx(0.5, abs=1e-9)


def test_a_doubtful_time_bears_on_no_law() -> None:
    runs = [run(n, 300.0 / n**2, hand="exact") for n in (12, 24, 48, 96)]
    wild = Seconds(9.0, 9.0, 12.0, 15.0)
    (found,) = slopes([replace(runs[0], seconds=wild), *runs[1:]])
    assert (found.seconds.slope, found.seconds.points) == (pytest.approx(0.5, abs=1e-9), 3)
    (none,) = slopes([replace(one, seconds=wild) for one in runs])
    assert math.isnan(none.seconds.slope)


def test_an_optimum_is_told_with_what_is_as_good() -> None:
    errors = {6: 30.0, 8: 12.0, 10: 10.2, 12: 10.0, 16: 14.0, 24: 20.0, 48: 50.0}
    (found,) = optima([run(n, e, spread=0.2) for n, e in errors.items()], ["student"])
    assert (found.best.value, found.sure) == ("12", (10, 12))
    assert (found.inside, found.flat) == (True, False)


def test_an_optimum_at_the_end_is_not_inside_and_a_flat_row_is_told_so() -> None:
    (falling,) = optima([run(n, 100.0 / n) for n in (6, 12, 24)], ["student"])
    assert (falling.best.value, falling.inside) == ("24", False)
    (level,) = optima([run(n, 4.0 + 0.001 * n) for n in (6, 12, 24)], ["student"])
    assert level.flat


def test_a_setting_that_could_not_be_drawn_is_no_optimum() -> None:
    runs = [run(n, e) for n, e in ((6, 5.0), (8, 3.0), (12, 4.0), (16, float("nan")))]
    (found,) = optima(runs, ["student"])
    assert found.best.value == "8"


def test_the_front_is_what_no_other_setting_of_the_hand_beats() -> None:
    rng = np.random.default_rng(11)
    runs = [
        run(int(n), float(e)) for n, e in zip(rng.permutation(40) + 1, rng.random(40), strict=True)
    ]
    runs += [run(int(n), 0.01, hand="exact") for n in (3, 5)]
    runs += [run(1, 0.001, axis="ruler"), run(1, 0.001, axis="trials")]
    found = best_of(runs)
    for one in runs[:40]:
        beaten = any(
            o.work.minutes <= one.work.minutes
            and o.error <= one.error
            and (o.work.minutes, o.error) != (one.work.minutes, one.error)
            for o in runs[:40]
        )
        assert (one in found) == (not beaten)
    assert [r.value for r in runs[40:] if r in found] == ["3"]


def test_fronts_of_quantities_and_hands_do_not_mix() -> None:
    runs = [run(n, e, hand=h) for (n, e), h in product([(4, 2.0), (8, 1.0)], ["student", "cad"])]
    assert best_of(runs) == frozenset(runs)
