"""How finely coordinates were read: told by what most errors of a drawing are below."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.judging.scatter import Scatter
from graphic_tmm.checking.judging.step_scatter import FEW, StepScatter, share_of_slip

MOST = 1.2816
"""Below this are four fifths of what is normal."""
STEP = StepScatter((1.0,), (0.0,), Scatter(np.zeros(1), 0.0, 0.0), MOST, (True,), np.zeros(1))
"""A step whose errors come from reading coordinates alone, by 1 mm with the whole slip."""


def read_finely(share: float, count: int, drawings: int) -> list[float]:
    """Return how finely drawings seem to be read that were read with this share of the slip."""
    rng = np.random.default_rng(7)
    errors = share * rng.standard_normal((drawings, count))
    return [share_of_slip([(STEP, (float(e),)) for e in row]) for row in errors]


@pytest.mark.slow
def test_of_drawings_read_as_coarsely_as_is_counted_upon_one_in_forty_seems_finer() -> None:
    """Whether 20 points were read or 200: of few the quantile is off by half of itself."""
    for count in (FEW, 60, 200):
        assert sum(share < 1.0 for share in read_finely(1.0, count, 80)) <= 2


def test_a_finer_hand_is_known_by_many_points_and_is_not_taken_for_finer_than_it_is() -> None:
    found = read_finely(0.3, 500, 20)
    assert set(found) <= {0.3, 0.4}
    assert sum(found) / 20 < 0.4 + 1e-9


def test_few_points_tell_nothing() -> None:
    assert set(read_finely(0.1, FEW - 1, 5)) == {1.0}
