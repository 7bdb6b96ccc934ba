"""Work and energy by published figures."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.board.operations import energetics as e


def test_the_flywheel_of_the_engine_by_its_published_segment() -> None:
    found = e.flywheel_inertia.run(*[np.array([[v]]) for v in (61.0, 16.7, 0.23, 50.0)])
    assert found[0, 0] == pytest.approx(1.77, abs=0.005)
    rim = e.rim_width.run(*[np.array([[v]]) for v in (1.77, 7800, 0.45, 0.38, 0.415)])
    assert rim[0, 0] == pytest.approx(0.115, abs=0.001)
    assert e.rim_mass.run(np.array([[1.77]]), np.array([[0.415]]))[0, 0] == pytest.approx(
        41.1, abs=0.1
    )
