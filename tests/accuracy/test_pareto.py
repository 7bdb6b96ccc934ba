"""The Pareto front and the cheapest setting, against all pairs compared."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.accuracy.pareto import cheapest, front

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


@given(POINTS, st.floats(0, 10))
def test_the_cheapest_is_on_the_front_and_within_the_budget(
    points: list[tuple[float, float]], budget: float
) -> None:
    found = cheapest(*costs_and_errors(points), budget)
    fit = [p for p in points if math.isfinite(p[0]) and p[1] <= budget]
    if found is None:
        assert not fit
        return
    assert points[found] == min(fit)
    assert found == points.index(min(fit))
    assert found in front(*costs_and_errors(points))


ERRORS = [[5.0, 1.0], [2.0, 3.0], [1.9, 1.9], [0.1, math.nan]]


@pytest.mark.parametrize(
    ("budget", "due"), [(10.0, 0), (4.0, 1), (2.0, 2), (1.0, None), ([6.0, 1.0], 0), ([2, 2], 2)]
)
def test_every_quantity_has_to_keep_within_its_budget(budget: object, due: int | None) -> None:
    assert cheapest([1.0, 2.0, 4.0, 8.0], ERRORS, budget) == due


def test_of_equal_costs_the_smaller_error_then_the_first() -> None:
    assert cheapest([2, 1, 1, 1], [0.0, 3.0, 2.0, 2.0], 5.0) == 2
    assert front([1, 1, 1], [2.0, 2.0, 2.0]) == (0,)


def test_more_work_that_makes_it_worse_is_not_on_the_front() -> None:
    positions = np.array([8, 12, 18, 24, 36, 72])
    truncation, hand = 30.0 * (8 / positions) ** 2, 0.05 * (positions / 8) ** 2
    errors = truncation + hand
    found = front(positions.tolist(), errors.tolist())
    assert found == tuple(range(int(errors.argmin()) + 1))
    assert found[-1] < 5


def test_nothing_is_on_no_front_and_within_no_budget() -> None:
    assert front([], []) == ()
    assert cheapest([], [], 1.0) is None
    assert front([math.nan, 1.0], [0.0, math.inf]) == ()


def test_costs_and_errors_belong_to_the_same_settings() -> None:
    with pytest.raises(ValueError, match="2 costs"):
        front([1.0, 2.0], [1.0])
    with pytest.raises(ValueError, match="2 costs"):
        cheapest([1.0, 2.0], [1.0], 1.0)
