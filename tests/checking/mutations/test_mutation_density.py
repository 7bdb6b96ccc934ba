"""The density of a reading's error is one, and no figure of any size breaks it."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.mutations.density import BEYOND, SLIP, explained, log_density, size_of


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
