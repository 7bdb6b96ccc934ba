"""Poles of accelerations and radii of curvature of published problems, each to the digits that are printed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from support.published_mechanisms import cardioid, slider_crank, swinging_cylinder

import graphic_tmm


def told(scene: dict[str, Any], at: list[float]) -> Any:
    plans: list[Any] = ["positions", "velocities", "accelerations", "curvature"]
    return graphic_tmm.motion(graphic_tmm.read(scene), at, plans=plans, exact=True)


@pytest.mark.parametrize(
    ("at", "from_a", "from_b", "gained"),
    [(0.0, None, 12.0, 108.0), (90.0, 1.96, 0.40, 18.37), (180.0, None, 8.0, 72.0)],
)
def test_the_pole_of_accelerations_of_a_rod(
    at: float, from_a: float | None, from_b: float, gained: float
) -> None:
    """Meshchersky 18.9: OA 40 cm, AB 2 m, 15 rad/s: a_B, and how far the pole is from B and A.

    At 90° the rod does not turn: there is no centre of velocities, but one of accelerations.
    """
    found = told(slider_crank(0.4, 2.0, "15 rad/s", curvature={"points": ["M"]}), [at])
    pole, a, b = found.centres["Π"][0], found.places["A", 2][0], found.places["B", 2][0]
    assert abs(pole - b) == pytest.approx(from_b, abs=5e-3)
    if from_a is not None:
        assert abs(pole - a) == pytest.approx(from_a, abs=5e-3)
        assert np.isnan(found.centres["P"][0])
    assert abs(found.accelerations["B", 2][0]) == pytest.approx(gained, abs=5e-3)


def test_the_end_of_a_rod_in_a_swinging_cylinder() -> None:
    """Meshchersky 18.20: B in position III (180°): a = 258.3 cm/s², ρ = 0.39 cm."""
    found = told(swinging_cylinder(curvature={"points": ["B"]}), [180.0])
    assert abs(found.accelerations["B", 2][0]) == pytest.approx(2.583, abs=5e-4)
    assert found.columns["rho_B"][0] == pytest.approx(0.0039, abs=5e-5)


def test_an_answer_that_is_off_by_its_own_rounding() -> None:
    """Meshchersky 18.20, crank square to the rod: printed 6.12 cm/s² and 589 cm, exact 6.186 and 581.9.

    a_B is the difference of 306.19 and 300 cm/s²: OC² − OA² has the root 58.788 cm, and with 58.8 cm, as a hand
    rounds it, B has 6.12 cm/s² and ρ = (60 cm/s)²/6.12 = 588 cm. The book's rounding, not the motion's.
    """
    at = math.degrees(math.acos(0.2))
    found = told(swinging_cylinder(curvature={"points": ["B"]}), [at])
    gained, radius = abs(found.accelerations["B", 2][0]), found.columns["rho_B"][0]
    assert found.omega[2][0] == pytest.approx(0.0, abs=1e-12)

    def by_hand(root: float) -> float:
        """a_B: ω_0²·OA towards O along the crank; ε·AB square to the rod, ε = ω_0²·OA/AC: both are parallel."""
        return abs(25.0 * 12.0 - 25.0 * 12.0 / root * 60.0)

    exact = by_hand(math.sqrt(60.0**2 - 12.0**2))
    assert 100.0 * gained == pytest.approx(exact, rel=1e-9)
    assert 100.0 * gained == pytest.approx(6.186, abs=5e-4)
    assert by_hand(58.8) == pytest.approx(6.12, abs=5e-3)
    assert 100.0 * radius == pytest.approx(60.0**2 / exact, rel=1e-9)
    assert 60.0**2 / by_hand(58.8) == pytest.approx(589.0, rel=0.002)


def test_the_cardioid_of_a_rod_in_a_sleeve() -> None:
    """Meshchersky 12.32: at t = 0 ρ = 4a/3; anywhere on a cardioid it is (4a/3)·cos(ωt/4)."""
    a, at = 0.5, [0.0, 40.0, -95.0, 140.0]
    found = told(cardioid(a, 2.0, curvature={"points": ["M"]}), at)
    due = 4 * a / 3 * np.cos(np.radians(at) / 4)
    assert found.columns["rho_M"] == pytest.approx(due, rel=1e-9)
    assert found.columns["rho_M"][0] == pytest.approx(4 * a / 3, rel=1e-12)
