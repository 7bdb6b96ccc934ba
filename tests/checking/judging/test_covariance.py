"""Limits of whole drawings and of residuals, against draws that no covariance was taken from."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.judging.covariance import (
    FALSE_ALARMS,
    FEW,
    MUCH_WORSE,
    Covariances,
    covariance,
    rare_largest,
    tail,
    usual,
    without,
    worse_than,
)

SHARED = 2.0
"""By so much all readings of a position slip together, measured by what each slips by itself."""


def drawn(rng: np.random.Generator, count: int, drawings: int) -> np.ndarray:
    own = rng.standard_normal((count, drawings))
    return (own + SHARED * rng.standard_normal(drawings)) / np.hypot(1.0, SHARED)


def residuals(hand: np.ndarray, times: np.ndarray) -> np.ndarray:
    one = covariance(hand)
    return np.abs(one.precision @ times) / np.sqrt(np.diag(one.precision))[:, None]


def test_what_is_common_to_all_readings_is_taken_off() -> None:
    """A slip of one reading shows more than by itself, and less in every other one."""
    rng = np.random.default_rng(1)
    times = np.zeros((6, 1))
    times[2] = 3.0
    seen = residuals(drawn(rng, 6, 400), times)[:, 0]
    assert seen[2] > 1.5 * 3.0
    assert int(np.argmax(seen)) == 2
    assert np.max(np.delete(seen, 2)) < 0.6 * seen[2]
    together = residuals(drawn(rng, 6, 400), np.full((6, 1), 3.0))
    assert np.max(together) < 1.5


@pytest.mark.parametrize("count", [5, 40])
def test_fresh_drawings_are_as_far_off_as_the_hand_s_own(count: int) -> None:
    """Though the covariance was taken from these: each is judged as if it were that of the others."""
    rng = np.random.default_rng(2)
    one = covariance(drawn(rng, count, 400))
    fresh = drawn(rng, count, 4000)
    squares = np.einsum("it,ij,jt->t", fresh, one.precision, fresh)
    assert np.mean(one.squares) == pytest.approx(np.mean(squares), rel=0.06)


def test_so_many_honest_drawings_are_wrong_as_is_stated() -> None:
    rng = np.random.default_rng(3)
    false, of = 0, 8000
    for _ in range(3):
        some = [covariance(drawn(rng, 6, 400)) for _ in range(8)]
        limit = usual(some).limit
        fresh = [drawn(rng, 6, of) for _ in some]
        roots = [np.sqrt(np.diag(one.precision))[:, None] * one.sizes[:, None] for one in some]
        far = [
            np.abs(one.precision @ rows) / root
            for one, rows, root in zip(some, fresh, roots, strict=True)
        ]
        false += int(np.sum(np.max(np.concatenate(far), axis=0) > limit))
    assert 0.1 * FALSE_ALARMS < false / (3 * of) < 4.0 * FALSE_ALARMS


def test_a_hand_with_long_tails_has_a_wider_limit() -> None:
    rng = np.random.default_rng(4)
    normal, tails = drawn(rng, 1, 400), rng.standard_t(3, (1, 400)) / np.sqrt(3.0)
    assert covariance(tails).sizes[0] > 1.2 * covariance(normal).sizes[0]


def test_without_a_reading_the_rest_is_as_if_it_had_never_been() -> None:
    hand = drawn(np.random.default_rng(7), 6, 400)
    rest = covariance(np.delete(hand, 2, axis=0)).precision
    assert without(covariance(hand).precision, 2) == pytest.approx(rest)


def test_the_largest_of_more_readings_is_larger() -> None:
    largest = np.random.default_rng(5).standard_normal((200, 400)) ** 2
    few, many = (rare_largest(np.max(largest[:n], axis=0), 0.001) for n in (10, 200))
    assert many > few + 4.0
    assert rare_largest(np.max(largest, axis=0), 1e-5) > many + 4.0


def test_no_hand_is_taken_for_much_worse_nor_by_few_readings() -> None:
    assert worse_than(1.0, 0.5, FEW) == 1.0
    assert worse_than(1.0, 1.3, FEW) == pytest.approx(1.3)
    assert worse_than(1.0, 9.0, FEW) == MUCH_WORSE
    assert worse_than(1.0, 9.0, FEW - 1) == 1.0


def test_a_covariance_is_found_once_and_none_of_too_few_drawings() -> None:
    rng = np.random.default_rng(6)
    rows = list(drawn(rng, 5, 40))
    kept = Covariances()
    assert kept.of(rows) is kept.of(list(rows))
    assert kept.of(rows[:4]) is not kept.of(rows)
    assert kept.of([row[:19] for row in rows]) is None
    one = kept.of(rows)
    assert one is not None
    assert kept.usual([one]) is kept.usual([one])


def test_the_tail_is_that_of_a_sum_of_squares() -> None:
    """Of five equal normal variables (χ² with five degrees of freedom): P(> 25) = 1.39e-4, P(> 35) = 1.5e-6."""
    hand = np.sum(np.random.default_rng(1).standard_normal((5, 400)) ** 2, axis=0)
    assert tail(25.0, hand) == pytest.approx(1.39e-4, rel=1.0)
    assert tail(35.0, hand) == pytest.approx(1.5e-6, rel=3.0)
    assert tail(float(np.max(hand)), hand) == 1.0
