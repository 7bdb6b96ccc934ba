"""Instantaneous centres of published problems, each to the digits that are printed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from support.published_mechanisms import four_bar, slider_crank

import graphic_tmm as tmm
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.studio import make


def centres(scene: dict[str, Any], at: list[float]) -> Any:
    plans: list[Any] = ["positions", "velocities", "centres"]
    return tmm.motion(tmm.read(scene), at, plans=plans, exact=True)


def turned(found: Any, at: int) -> float:
    """ω_2 by ω_1 and the distances of the pin of crank and rod from O and from P_20, rad/s."""
    pin = found.places["A", 2][at]
    return float(found.omega[1][at] * abs(pin) / abs(pin - found.centres["P20"][at]))


def test_a_rod_whose_ends_slide_on_the_axes() -> None:
    """Meshchersky 16.8: AB = 1 m, ∠OAB = 60°: the centre has x = 0.866, y = 0.5 m."""
    along = {"on": "frame", "along": "x", "side": "+"}
    scene = {
        "title": "T", "language": "en",
        "frame": {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"},
                  "y": {"through": [0, 0], "angle": "90 deg"}},
        "link": [
            {"number": 1, "points": {"A": [0, 0]}, "slides": {"on": "frame", "along": "y"}},
            {"number": 2, "points": {"A": [0, 0], "B": [1, 0]}},
            {"number": 3, "points": {"B": [0, 0]}, "slides": along},
        ],
        "drive": {"link": 1, "speed": "1 m/s", "from": "0.8 m", "to": "0.2 m", "positions": 4},
    }  # fmt: skip
    found = centres(scene, [math.cos(math.radians(60.0))])
    assert abs(found.centres["P20"][0] - (0.866 + 0.5j)) < 5e-4


def test_a_slider_crank_with_its_crank_along_and_square_to_the_guide() -> None:
    """Meshchersky 16.15: OA 40 cm, AB 2 m, 180 rpm: in I ω_2 = 6π/5; in II it is 0: P_20 is infinitely far."""
    found = centres(slider_crank(0.4, 2.0, "180 rpm"), [0.0, 90.0, 180.0])
    assert turned(found, 0) == pytest.approx(1.2 * math.pi, rel=1e-9)
    assert turned(found, 2) == pytest.approx(1.2 * math.pi, rel=1e-9)
    assert np.isnan(found.centres["P20"][1])


def test_a_four_bar_with_its_crank_and_coupler_in_a_line() -> None:
    """Meshchersky 16.21: BC = 3 AB, ω_0 = 6π: ω_BC = 2π, ω_CD = 0 wherever D is."""
    for pivot in (0.55 - 0.25j, 0.3 - 0.4j):
        rocker = abs(0.4 - pivot)
        scene = four_bar((0.1, 0.3, rocker), pivot, f"{6 * math.pi!r} rad/s", "left")
        found = centres(scene, [0.0])
        assert turned(found, 0) == pytest.approx(2 * math.pi, rel=1e-9)
        assert abs(found.centres["P13"][0]) < 1e-12, "the rocker stands: P_13 is O"


def test_a_press_whose_rod_is_square_to_its_lever() -> None:
    """Meshchersky 16.24: OA 15 cm under 30°, 2 rad/s, AB ⊥ OA: v = 34.6 cm/s, ω_AB = 2 rad/s."""
    rod, pin = 0.15 * math.tan(math.pi / 6), 0.15 / math.cos(math.pi / 6)
    scene = slider_crank(
        0.15, rod, "2 rad/s", through=pin, angle=-90.0,
        drive={"from": "28 deg", "to": "32 deg", "positions": 3},
    )  # fmt: skip
    found = centres(scene, [30.0])
    assert turned(found, 0) == pytest.approx(2.0, rel=1e-9)
    reach = abs(found.places["B", 2][0] - found.centres["P20"][0])
    assert turned(found, 0) * reach == pytest.approx(0.346, abs=5e-4)


def test_a_crossed_four_bar() -> None:
    """Meshchersky 18.19: AB = CD = 40, BC = AD = 20 cm, ∠ADC = 90°: ω_BC = 8/3 ω_0."""
    scene = four_bar(
        (0.4, 0.2, 0.4), 0.2, "1 rad/s", "right",
        drive={"from": "20 deg", "to": "160 deg", "positions": 8},
    )  # fmt: skip
    found = centres(scene, [math.degrees(math.atan2(0.24, 0.32))])
    assert abs(found.places["B", 2][0] - (0.2 + 0.4j)) < 1e-12
    assert turned(found, 0) == pytest.approx(8 / 3, rel=1e-9)


def test_what_is_drawn_says_the_same() -> None:
    """Meshchersky 16.15 as a sheet: ω_2 read off the centres in I, none where the rod only moves along."""
    scene = slider_crank(0.4, 2.0, "180 rpm", centres={"positions": "all"})
    (found,) = make(tmm.read(scene)).boards
    rate = next(one.omega for one in CENTRES_PLAN.on(found).rotations if one.link == 2)
    assert rate is not None
    value = np.abs(found.reading[rate][0])
    assert value[0] == pytest.approx(1.2 * math.pi, rel=0.01)
    assert np.isnan(value[3])
