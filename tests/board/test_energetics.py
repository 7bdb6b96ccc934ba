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


def test_the_steepest_and_the_flattest_ray_are_those_of_the_largest_and_the_least_speed() -> None:
    """The energy of what turns at ω(1 ± δ/2) over its moment of inertia, each to its scale, to δ²/4."""
    mu_j, mu_t, omega, delta = 0.02, 100.0, 90.0, 0.01
    given = [np.array([[v]]) for v in (mu_j, mu_t, omega, delta)]
    for ray, speed in (
        (e.steepest, omega * (1 + delta / 2)),
        (e.flattest, omega * (1 - delta / 2)),
    ):
        slope = np.tan(np.radians(ray.run(*given)[0, 0]))
        assert slope == pytest.approx(0.5 * speed**2 * mu_j / mu_t, rel=delta**2 / 3)
