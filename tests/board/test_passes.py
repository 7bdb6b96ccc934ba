"""Passes that look at numbers first find what they find without looking."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.board import geometry, passes

RNG = np.random.default_rng(5)


@pytest.mark.parametrize("count", [3, 500])
@pytest.mark.parametrize("scale", [1.0, 1e-170, 1e170, 1e-300, 1e300])
def test_a_length_loses_nothing_at_any_scale(count: int, scale: float) -> None:
    x, y = RNG.normal(size=(2, count)) * scale
    x[1], y[1] = 0.0, 0.0
    with np.errstate(over="ignore", under="ignore"):
        found = passes.length(x, y, np.empty(count), np.empty(count))
    np.testing.assert_allclose(found, np.hypot(x, y), rtol=4e-16)


def test_a_length_that_is_undefined_hides_no_other() -> None:
    x = np.where(np.arange(300) == 7, np.nan, 3e-200)
    found = passes.length(x, np.full(300, 4e-200), np.empty(300), np.empty(300))
    assert np.isnan(found[7])
    np.testing.assert_allclose(np.delete(found, 7), 5e-200, rtol=4e-16)


@pytest.mark.parametrize("true", [0, 2, 5])
def test_what_is_chosen_is_copied_only_where_both_are(true: int) -> None:
    mask = np.arange(5) < true
    first, second = np.arange(5.0), -np.arange(5.0)
    found = passes.choose(passes.count(mask), mask, first, second)
    np.testing.assert_array_equal(found, np.where(mask, first, second))
    assert (found is first) is (true == 5)
    assert (found is second) is (true == 0)


QUARTERS = [*(np.full(400, float(k)) for k in range(-5, 6)), np.arange(-8.0, 8.0)]


@pytest.mark.parametrize("quarters", QUARTERS)
def test_right_angles_turn_exactly(quarters: np.ndarray) -> None:
    z = RNG.normal(size=quarters.size) + 1j * RNG.normal(size=quarters.size)
    same = passes.alike(quarters)
    with np.errstate(invalid="ignore"):
        x = passes.turn_x(same, quarters, z.real, z.imag)
        y = passes.turn_y(same, quarters, z.real, z.imag)
        due = geometry.quadrant(quarters) * z
    np.testing.assert_array_equal(x + 1j * y, due)


@pytest.mark.parametrize("least", [1.0, 0.0, -1e-17, -1.0, np.nan])
def test_a_root_is_that_of_the_board(least: float) -> None:
    gap = RNG.uniform(0.5, 2.0, 300)
    gap[4] = least
    product = gap * 3.0
    with np.errstate(invalid="ignore"):
        found = passes.root(product, gap, np.full(300, 2.0), np.empty(300))
        due = geometry.root(product, gap, np.full(300, 2.0))
    np.testing.assert_array_equal(found, due)


def test_alike_are_those_that_are_one_number() -> None:
    for odd in (None, 0, 7, 399):
        quarters = np.full(400, 3.0)
        if odd is not None:
            quarters[odd] = 2.0
        assert passes.alike(quarters) == (odd is None)
    assert not passes.alike(np.full(400, np.nan))


@pytest.mark.parametrize("step", [1, 2])
def test_a_sign_is_put_on_by_bits(step: int) -> None:
    """Also that of a row that does not lie in one piece, as the parts of complex numbers do not."""
    x = np.array([0.0, 1.0, 2.5, np.inf, np.nan, 1e-310, 3.0, 0.0])
    signs = np.zeros(8 * step)[::step]
    signs[:] = [-0.0, -1.0, 2.0, -np.inf, -3.0, -1e-310, 0.0, 5.0]
    out = np.empty(8)
    assert passes.signed(x, signs, out) is out
    assert out.tobytes() == np.copysign(x, signs).tobytes()
