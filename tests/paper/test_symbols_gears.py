"""Symbols of gears and cams, the wavy line: their sizes, their places, their pens."""

from __future__ import annotations

import cmath

import pytest
import shapely

from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.paper.shapes import flat, shape
from graphic_tmm.paper.symbols.kinematic import (
    CENTRE_BEYOND,
    HEIGHT,
    JOINT_RADIUS,
    RIM,
    cam,
    gear,
    gear_side,
    wavy,
)


def circles(strokes: tuple[Stroke, ...]) -> list[float]:
    return sorted(
        (s.path[1][0] - s.path[0][0]) / 2 for s in strokes if s.closed and s.path[0][2] == 1.0
    )


def test_two_gears_in_mesh_touch_at_their_pitch_circles() -> None:
    first, second = gear(0j, 20.0), gear(50 + 0j, 30.0)
    assert circles(first) == [JOINT_RADIUS, 20.0]
    outer = [
        max((shape(s) for s in g if s.closed), key=lambda x: x.length) for g in (first, second)
    ]
    assert shapely.Polygon(outer[0]).intersection(shapely.Polygon(outer[1])).area < 1e-6
    assert outer[0].distance(outer[1]) < 0.1


def test_a_ring_has_its_rim_outside_and_no_shaft() -> None:
    assert circles(gear(0j, 40.0, internal=True)) == [40.0, 40.0 + RIM]


@pytest.mark.parametrize("internal", [False, True])
def test_centre_lines_cross_in_the_middle_and_go_on_behind_the_circle(internal: bool) -> None:
    made = gear(10 + 5j, 30.0, internal=internal)
    centre = [shape(s) for s in made if s.pen == "centre"]
    assert len(centre) == 2
    assert centre[0].intersection(centre[1]).equals(shapely.Point(10, 5))
    outer = circles(made)[-1]
    assert all(one.length == pytest.approx(2 * (outer + CENTRE_BEYOND)) for one in centre)


def test_a_gear_from_its_side_is_as_wide_and_high_as_it_is() -> None:
    made = gear_side(3 + 4j, 20.0, 8.0)
    assert shape(made[0]).bounds == (-1.0, -16.0, 7.0, 24.0)
    assert len(made) == 3
    assert len(gear_side(0j, 20.0, 8.0, fixed=False)) == 1


def test_a_cam_is_its_profile_about_its_centre() -> None:
    profile = [cmath.rect(20 + 5 * (k > 8), k * cmath.pi / 8) for k in range(16)]
    made = cam(100 + 0j, profile)
    assert made[0].closed
    assert [complex(x, y) - 100 for x, y, _ in made[0].path] == pytest.approx(profile)


@pytest.mark.parametrize("end", [50 + 0j, 30 + 40j, 3 + 0j])
def test_a_wavy_line_runs_to_its_end_in_whole_waves(end: complex) -> None:
    made = wavy(0j, end)
    assert made.pen == "thin"
    assert made.controls[-1] == pytest.approx(end)
    turned = [z * end.conjugate() / abs(end) for z in flat(made.controls)]
    assert max(z.imag for z in turned) == pytest.approx(0.75 * HEIGHT, rel=0.05)
    assert min(z.imag for z in turned) == pytest.approx(-0.75 * HEIGHT, rel=0.05)
