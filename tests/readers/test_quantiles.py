"""Quantiles of figures that come in blocks are those of all of them at once, to the last bit."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graphic_tmm.board.values import Reals
from graphic_tmm.readers.quantiles import Quantiles

SHARES = (0.5, 0.05, 0.95)


def at_once(figures: Reals) -> Reals:
    """The quantiles of each row, by numpy; what is not finite is left out."""
    found = np.full((len(SHARES), len(figures)), np.nan)
    for row, values in enumerate(figures):
        there = values[np.isfinite(values)]
        if there.size:
            found[:, row] = np.quantile(there, SHARES)
    return found


def in_blocks(figures: Reals, block: int, sure: float = 6.0) -> Quantiles:
    """The same figures, a block after the other."""
    found = Quantiles(SHARES, figures.shape[1], sure)
    for start in range(0, figures.shape[1], block):
        found.add(figures[:, start : start + block])
    return found


@st.composite
def rows(draw: st.DrawFn) -> Reals:
    """Rows of figures: fine or in divisions, some of them missing, one missing altogether."""
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    shape = draw(st.integers(1, 5)), draw(st.integers(1, 400))
    found = rng.standard_normal(shape) * draw(st.sampled_from([1e-12, 1.0, 1e9]))
    if draw(st.booleans()):
        found = np.round(found * 2.0) / 2.0
    found[rng.random(shape) < draw(st.sampled_from([0.0, 0.02, 0.5, 0.98]))] = np.nan
    found[rng.random(shape) < draw(st.sampled_from([0.0, 0.1]))] = -np.inf
    found[0, draw(st.integers(0, 400)) :] = 3.25
    if draw(st.booleans()):
        found[-1] = np.nan
    return found


@settings(deadline=None)
@given(rows(), st.integers(1, 150), st.sampled_from([6.0, 0.5, 1e12]))
def test_they_are_those_of_all_figures_or_known_to_be_missed(
    figures: Reals, block: int, sure: float
) -> None:
    found = in_blocks(figures, block, sure)
    if found.missed:
        assert sure < 1e12
        due = at_once(figures)
        there = np.isfinite(found.told())
        np.testing.assert_array_equal(found.told()[there], due[there])
    else:
        np.testing.assert_array_equal(found.told(), at_once(figures))


@pytest.mark.parametrize("division", [None, 0.25])
def test_what_is_kept_grows_with_the_root_of_the_figures(division: float | None) -> None:
    rng = np.random.default_rng(4)
    most = []
    for count in (4000, 64000):
        figures = rng.standard_normal((4, count))
        figures = figures if division is None else np.round(figures / division) * division
        found, kept = Quantiles(SHARES, count), 0
        for start in range(0, count, 1000):
            found.add(figures[:, start : start + 1000])
            kept = max(kept, found.kept)
        assert not found.missed
        np.testing.assert_array_equal(found.told(), at_once(figures))
        most.append(kept / len(figures))
    assert most[1] < 5 * most[0]  # 16 times as many figures: 4 times the root
    assert most[1] < 64000 / 20


def test_figures_that_come_sorted_are_missed_and_found_when_all_are_kept() -> None:
    figures = np.sort(np.random.default_rng(2).standard_normal((2, 5000)), axis=1)
    assert in_blocks(figures, 500).missed
    all_kept = in_blocks(figures, 500, sure=1e12)
    assert not all_kept.missed
    np.testing.assert_array_equal(all_kept.told(), at_once(figures))
