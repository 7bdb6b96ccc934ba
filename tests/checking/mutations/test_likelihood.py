"""How likely a reading is: a density, and a segment that is so many times what is due."""

from __future__ import annotations

import numpy as np
import pytest
from support.each import each

from graphic_tmm.checking.mutations.likelihood import (
    BEYOND,
    DECADES,
    SLIP,
    common,
    explained,
    log_density,
    multiple,
    scores,
    size_of,
)


@pytest.mark.parametrize("size", [0.4, 1.0, 3.0])
@pytest.mark.parametrize("figure", [0.0, 20.0, 150.0])
def test_it_is_a_density(size: float, figure: float) -> None:
    half = np.concatenate(
        [np.linspace(0.0, 30 * size, 200_001), np.geomspace(30 * size, 3e3, 200_001)[1:]]
    )
    density = np.exp(log_density(half, size, figure))
    whole = 2.0 * float(np.trapezoid(density, half))
    # what is anything reaches farther than the sheet: at most its share is left out, or counted twice
    assert 0.96 <= whole <= 1.03


def test_it_falls_with_the_error() -> None:
    errors = np.geomspace(1e-3, 1e6, 500)
    assert (np.diff(log_density(errors, 1.0, 50.0)) <= 0.0).all()
    near, far = log_density(np.array([0.0, BEYOND]), 1.0, 50.0)
    assert near - far > 3.0


def test_extremes_are_numbers() -> None:
    for error in (0.0, 1e-300, 1e300, np.inf):
        for change in (0.0, 1e300, np.inf):
            size = size_of(0.5, 10.0, 1.0, change)
            assert np.isfinite(size)
            assert not np.isnan(log_density(error, size, 10.0))


def test_what_is_moved_and_left_beyond_counts_against_a_fit_as_one_slip() -> None:
    before = np.array([9.0, 9.0, 9.0, 1.5, 2.0])
    off = np.array([0.5, 1.0, 7.0, 1.5, 2.5])
    moved, squares = explained(off, before)
    assert moved.tolist() == [1.0, 1.0, 1.0, 0.0, 1.0]
    assert squares.tolist() == [0.25, 1.0, SLIP**2, 0.0, 6.25]
    passed, nothing = explained(np.array([20.0]), np.array([20.4]))
    assert passed.sum() == nothing.sum() == 0.0, "far off before and after: not its own"


DUE = np.array([41.0, 18.0, -30.0, 55.0, 12.0, 37.0])
SCATTER = np.full(DUE.size, 0.8)


def gained(found: np.ndarray, due: np.ndarray = DUE, scatter: np.ndarray = SCATTER) -> float:
    return multiple(found, due, scatter, np.abs(found), 1.0)


def integral(found: np.ndarray) -> float:
    """Return the same by summing over numbers that are as likely in every decade."""
    logs = np.linspace(-0.5 * DECADES, 0.5 * DECADES, 40_001)
    due = np.exp(logs)[:, None] * DUE
    size = size_of(SCATTER, np.abs(found), 1.0, due - DUE)
    mean = log_density(found - due, size, np.abs(found)).sum(axis=1)
    known = log_density(found - DUE, size_of(SCATTER, np.abs(found), 1.0), np.abs(found)).sum()
    return float(np.logaddexp.reduce(mean) - np.log(logs.size) - known)


@each("times", [0.31, 0.62, 1.37, 4.4])
@each("seed", [1, 2, 3])
def test_it_is_what_an_integral_over_all_numbers_gives(times: float, seed: int) -> None:
    found = times * DUE + np.random.default_rng(seed).normal(0.0, 0.5, DUE.size)
    assert gained(found) == pytest.approx(integral(found), abs=1.5)
    assert gained(found) > 10.0


def test_a_slip_of_one_reading_hides_no_number() -> None:
    found = 1.5 * DUE
    slipped = found.copy()
    slipped[3] += 20.0
    assert gained(slipped) > 0.6 * gained(found)


def test_readings_as_they_are_due_gain_nothing() -> None:
    assert gained(DUE + np.array([0.3, -0.2, 0.1, -0.4, 0.2, 0.1])) == 0.0


def test_two_readings_tell_nothing_of_a_number() -> None:
    found = np.where(np.arange(DUE.size) < 2, 1.5 * DUE, np.nan)
    assert gained(found) == 0.0


def test_more_segments_make_each_less_likely() -> None:
    assert scores([12.0, 0.0], 0.01) == pytest.approx([12.0 + np.log(0.005)])
    assert scores([], 0.01) == []


@pytest.mark.parametrize(
    ("ratios", "times"),
    [((1.1, 1.1, 1.1, 3.0), 1.1), ((1.0, 1.0, 3.0, 3.0), 1.0), ((1.1, 1.1), 1.0)],
)
def test_what_lengths_have_in_common_is_that_of_most(
    ratios: tuple[float, ...], times: float
) -> None:
    """Half as long and half three times as long have nothing in common, nor have two lengths."""
    due = np.linspace(30.0, 60.0, len(ratios))
    assert common(np.array(ratios) * due, due) == pytest.approx(times)
