"""A smaller construction narrowed down in several positions at once is what it is in each alone."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.operations.locus import refinement


def test_each_position_is_narrowed_down_by_itself() -> None:
    """Two drawings with three positions, one bound for all; another angle may stand for either."""
    op = refinement(lambda row: np.cos(np.radians(row)), "{it}")
    low = np.array([[10.0, 20.0, 100.0], [80.0, 30.0, -170.0]])
    found = op.run(low, np.array([[120.0]]))
    assert found.shape == low.shape
    for place, one in np.ndenumerate(low):
        alone = op.run(np.array([[one]]), np.array([[120.0]]))
        np.testing.assert_array_equal(found[place], alone[0, 0])
    assert np.isnan(found[0, 2]), "no change of sign"
    np.testing.assert_allclose(found[0, :2], 90.0)
