"""Least transmission angles of a turn against closed forms: triangles at the crank's two flat positions."""

from __future__ import annotations

import math
import random

import pytest
from support.linkages import four_bar, slider_crank
from support.rows import project_of

from graphic_tmm.chapters.kinematics.turning import TURNING
from graphic_tmm.mechanism.records import Mechanism

GRID = 0.02
"""Degrees: the turn is surveyed at places; near its least an angle changes with their distance squared."""


def least(mechanism: Mechanism) -> float:
    found = TURNING.passed(project_of(mechanism, "B", "right"))
    assert found.whole
    return found.least


def acute(cosine: float) -> float:
    angle = math.degrees(math.acos(cosine))
    return min(angle, 180.0 - angle)


@pytest.mark.parametrize("seed", range(6))
def test_of_a_crank_rocker_it_is_that_at_the_line_of_the_pivots(seed: int) -> None:
    pick = random.Random(seed)
    r, rod, s = 0.1, pick.uniform(0.3, 0.45), pick.uniform(0.25, 0.4)
    frame = pick.uniform(abs(rod - s) + 0.15, rod + s - 0.15)
    due = min(acute((rod**2 + s**2 - far**2) / (2 * rod * s)) for far in (frame - r, frame + r))
    assert least(four_bar(r, rod, s, complex(frame, 0.0))) == pytest.approx(due, abs=GRID)


@pytest.mark.parametrize("e", [0.0, 0.03, -0.06])
def test_of_a_slider_crank_it_is_that_farthest_from_the_guide(e: float) -> None:
    r, rod = 0.1, 0.3
    due = 90.0 - math.degrees(math.asin((r + abs(e)) / rod))
    assert least(slider_crank(r, rod, e)) == pytest.approx(due, abs=GRID)
