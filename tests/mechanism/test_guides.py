"""A sliding pair seen from either of its links: one guide, and every point as far off it by both."""

from __future__ import annotations

import cmath
import math

import pytest
from support.each import each

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.guides import direction, level
from graphic_tmm.mechanism.records import Guide, Slide


def pair(offset: float, turned: float, angle: float, through: complex) -> Pair:
    """Link 2 slides on link 3: ``offset`` to the left of the guide, its axes ``turned`` (degrees)."""
    return Pair("P", "y", (2, 3), Slide(3, Guide("y", through, angle), offset, turned))


@each("offset", [0.0, 0.03, -0.05])
@each("turned", [0.0, 90.0, -37.0])
@each("angle", [0.0, 180.0, 64.0])
def test_a_point_lies_as_far_off_the_guide_by_either_link(
    offset: float, turned: float, angle: float
) -> None:
    """Link 3 stands still; link 2 stands anywhere along the guide, its origin to the left of it."""
    through, point = 0.2 + 0.1j, 0.07 - 0.02j
    sliding = pair(offset, turned, angle, through)
    along = cmath.rect(1.0, math.radians(angle))
    origin = through + (0.4 + 1j * offset) * along
    spot = origin + point * cmath.rect(1.0, math.radians(angle + turned))
    assert level(sliding, 2, point) == pytest.approx(level(sliding, 3, spot), abs=1e-15)
    assert (direction(sliding, 2) + angle + turned) % 360.0 == pytest.approx(angle % 360.0)
    assert direction(sliding, 3) == angle


def test_a_level_is_counted_to_the_left() -> None:
    """The slider's origin 30 mm to the left, a point 20 mm farther; of link 3 one 40 mm above the guide."""
    level_ = pair(0.03, 0.0, 0.0, 0.1j)
    assert level(level_, 2, 0.5 + 0.02j) == pytest.approx(0.05)
    assert level(level_, 3, 0.14j) == pytest.approx(0.04)
