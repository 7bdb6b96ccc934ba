"""Ends of hodographs against published velocities, each to the digits that are printed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.boards import in_usual_size
from support.published_mechanisms import cardioid, slider_crank, swinging_cylinder

import graphic_tmm
from graphic_tmm.chapters.hodograph.record import HODOGRAPH_PLAN


def ends(scene: dict[str, Any]) -> Any:
    """The ends of the one hodograph of a scene from its pole, m/s."""
    (drawn,) = in_usual_size(graphic_tmm.read(scene), exact=True).boards
    (one,) = HODOGRAPH_PLAN.on(drawn).curves
    return drawn.reading[one.end][0] * drawn.scales["velocities"].value


def test_the_middle_of_a_rod() -> None:
    """Meshchersky 16.15: OA 40 cm, AB 2 m, 180 rpm: v_M = 377 cm/s in line, 754 square to the guide."""
    asks = {"points": ["M"]}
    found = ends(slider_crank(0.4, 2.0, "180 rpm", hodograph=asks, drive={"positions": 4}))
    due = np.array([3.77j, -7.54, -3.77j, 7.54])
    assert found == pytest.approx(due, abs=5e-3)


def test_the_end_of_a_rod_in_a_swinging_cylinder() -> None:
    """Meshchersky 16.27: v_B = 15 and 10 cm/s in line; 58.88 printed at 90 and 270°, where it is 58.835.

    Along the rod v_A·OC/AC, 60·60/√(60² + 12²) = 58.835; across it ω_2·BC = 0.23, which adds 4·10⁻⁴: the book
    is off by 0.08 %, its own rounding.
    """
    found = ends(swinging_cylinder(hodograph={"points": ["B"]}, drive={"positions": 4}))
    speeds = np.abs(found)
    assert speeds[[0, 2]] == pytest.approx([0.15, 0.10], abs=1e-9)
    away = np.hypot(0.6, 0.12)
    due = 0.6 * np.hypot(0.6 / away, 0.12 / away**2 * (away - 0.6))
    assert speeds[[1, 3]] == pytest.approx(due, rel=1e-9)
    assert speeds[1] == pytest.approx(0.5888, rel=1e-3)


def test_the_cardioid_of_a_rod_in_a_sleeve() -> None:
    """Meshchersky 12.30, 12.31: v = aω·cos(ωt/4), w = (aω²/4)·√(5 + 4·cos(ωt/2)): both hodographs of M."""
    a, omega = 0.5, 2.0
    asks = {"points": ["M"], "accelerations": True}
    scene = cardioid(a, omega, hodograph=asks, drive={"accelerations": "all"})
    (drawn,) = in_usual_size(graphic_tmm.read(scene), exact=True).boards
    first, second = HODOGRAPH_PLAN.on(drawn).curves
    turned = np.array([phi for phi in drawn.project.coordinates if phi is not None])
    turned = np.radians((turned + 180.0) % 360.0 - 180.0)
    due = {first: a * omega * np.cos(turned / 4),
           second: a * omega**2 / 4 * np.sqrt(5 + 4 * np.cos(turned / 2))}  # fmt: skip
    for one, size in due.items():
        ends = drawn.reading[one.end][0] * drawn.scales[one.plan].value
        assert np.abs(ends) == pytest.approx(size, rel=1e-9)
