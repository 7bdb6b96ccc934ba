"""What is gained by a number that nobody knows: as much as an integral over all numbers says."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.mutations.density import log_density, size_of
from graphic_tmm.checking.mutations.multiples import DECADES, multiple, scores

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


@pytest.mark.parametrize("times", [0.31, 0.62, 1.37, 4.4])
@pytest.mark.parametrize("seed", [1, 2, 3])
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
