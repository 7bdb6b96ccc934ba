"""Acceleration diagrams as they are read off paper: nearly equal areas, jumps anywhere, the return's sign.

What is drawn is compared with closed forms of a diagram that this file evens by itself.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.cams import C6, Made, made, motion
from support.scenes import written

from graphic_tmm.chapters.cam.findings import changes
from graphic_tmm.chapters.cam.phases import divide
from graphic_tmm.chapters.cam.refusals import Points, areas, balanced, legible
from graphic_tmm.chapters.cam.task import ASKED, CamTask, Law
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.scene.read import read

READ = ((0.0, 40.0), (0.337, 40.0), (0.337, 0.0), (0.337, -20.0), (1.0, -20.5))
"""Millimetres off paper: a jump at no simple share, told through the axis; areas 1.3 % apart."""
HEAD = """title = "T"
[cam]
stroke = "28 mm"
rise = 100
upper_dwell = 20
fall = 90
law = "diagram"
law_points = [[0, 2], [0.25, 2], [0.25, -1], [0.5, -1], [1, 0]]
"""


def rows(of: Made, which: str, phase: int) -> tuple[np.ndarray, np.ndarray]:
    """Angles of a phase and its quantity (SI); of two ordinates at a jump the earlier."""
    diagram, turn = getattr(of.cam.diagrams, which), of.cam.diagrams.turn
    own = slice(turn.phases[phase].first, turn.phases[phase].last + 1)
    values = of.reading[diagram.reading][0, own] * of.one(diagram.axes.mu)
    return np.array(turn.angles)[own], values


def area(points: Points) -> float:
    return float(sum((b[0] - a[0]) * (a[1] + b[1]) / 2.0 for a, b in pairwise(points)))


values = st.floats(0.1, 10.0)


@given(st.lists(values, min_size=2, max_size=5), st.lists(values, min_size=2, max_size=5), values)
def test_one_factor_below_the_axis_makes_areas_equal(
    up: list[float], down: list[float], wide: float
) -> None:
    heights = [*up, *(-one for one in down)]
    shares = np.linspace(0.0, 1.0, len(heights)) ** (wide / 5.0)
    points = tuple(zip(shares.tolist(), heights, strict=True))
    even, factor = balanced(points)
    assert area(even) == pytest.approx(0.0, abs=1e-12 * areas(points)[1] + 1e-6 * areas(even)[1])
    for (_, before), (_, after) in zip(points, even, strict=True):
        assert after == pytest.approx(before * (factor if before < 0.0 else 1.0))


def test_what_is_allowed_is_what_moving_every_point_by_half_a_millimetre_does() -> None:
    """By brute force: all points up by 0.5 mm of 40, each share by 0.5 mm to the side that adds most."""
    points = ((0.0, 1.0), (0.3, 2.0), (0.3, -1.0), (0.8, -0.5), (1.0, -2.0))
    base = 60.0
    higher = tuple((u, value + 2.0 * 0.5 / 40.0) for u, value in points)
    added = area(higher) - area(points)
    for k in range(1, len(points) - 1):
        trials = [
            tuple((u + side * 0.5 / base * (i == k), v) for i, (u, v) in enumerate(points))
            for side in (1.0, -1.0)
        ]
        added += max(area(one) - area(points) for one in trials)
    assert legible(points, base) == pytest.approx(added)


def test_a_diagram_read_off_paper_is_drawn_with_its_jump_at_a_position_and_even_areas() -> None:
    order = CamTask(**C6, rise_law=Law("diagram", READ), divisions=12)
    found = made(order)
    k = 4.0 / 12.0
    brake = (
        2.0 * 40.0 * k / ((1.0 - k) * 40.5)
    )  # both areas equal: 40·k = brake·(20 + 20.5)/2·(1 − k)
    even = ((0.0, 40.0), (k, 40.0), (k, -20.0 * brake), (1.0, -20.5 * brake))
    due = replace(order, rise_law=Law("diagram", even))
    for which in ("S", "V"):
        angles, drawn = rows(found, which, 0)
        right = motion(due, angles)["SV".index(which)]
        np.testing.assert_allclose(drawn, right, atol=1e-9 * np.abs(right).max())
    told = list(changes(found.cam, "en"))
    assert len(told) == 2
    assert "0.337" in told[0]
    assert "0.3333" in told[0]
    assert f"{brake:.5g}" in told[1]
    assert not list(changes(made(CamTask(**C6)).cam, "en"))
    by_phases = replace(order, phases=tuple(one for one in order.stages if one.angle))
    assert list(changes(made(by_phases).cam, "en")) == [f"phase 1: {one}" for one in told]


def test_three_points_of_one_share_are_the_jump_from_the_first_to_the_last() -> None:
    plain = ((0.0, 2.0), (1 / 3, 2.0), (1 / 3, -1.0), (1.0, -1.0))
    told = (*plain[:2], (1 / 3, 0.5), (1 / 3, 0.0), *plain[2:])
    one, other = (made(CamTask(**C6, rise_law=Law("diagram", points))) for points in (plain, told))
    np.testing.assert_array_equal(rows(one, "S", 0)[1], rows(other, "S", 0)[1])


@pytest.mark.parametrize("k", [0.4637, 0.0613, 0.91, 0.511])
def test_a_jump_may_stand_anywhere_if_a_ruler_does_not_tell_where_it_is_drawn(k: float) -> None:
    law = Law("diagram", ((0, 1 / k), (k, 1 / k), (k, -1 / (1 - k)), (1, -1 / (1 - k))))
    phase = divide(CamTask(**C6, rise_law=law)).rise
    ((share, place),) = phase.changed.moved
    assert (share, place * phase.parts) == (k, pytest.approx(round(place * phase.parts)))
    assert abs(place - share) * 240.0 * C6["rise"] / 360.0 <= 0.5
    assert area(phase.law.points) == pytest.approx(0.0, abs=1e-12)


def test_jumps_that_no_division_parts_are_refused() -> None:
    points = ((0, 1), (0.5, 1), (0.5, 2), (0.5005, 2), (0.5005, -1), (1, -1.0))
    with pytest.raises(StructureError, match="position at every jump"):
        made(CamTask(**C6, rise_law=Law("diagram", points)))


def test_areas_that_a_ruler_tells_apart_are_refused() -> None:
    for low, fits in ((-20.0, True), (-20.5, True), (-23.0, False), (-17.0, False)):
        points = ((0, 40.0), (1 / 3, 40.0), (1 / 3, low), (1, low))
        order = CamTask(**C6, rise_law=Law("diagram", points))
        if fits:
            assert divide(order).rise.changed.factor == pytest.approx(-20.0 / low)
        else:
            with pytest.raises(StructureError, match="areas"):
                divide(order)


def asked(folder: Path, more: str) -> CamTask:
    found = ASKED.of(read(written(folder, HEAD + more)))
    assert found is not None
    return found


def test_a_mirrored_return_is_the_rise_run_backwards(tmp_path: Path) -> None:
    order = asked(tmp_path, 'return = "mirrored"\n')
    for found in (order, asked(tmp_path, "")):
        drawn = made(found)
        rise, back = (rows(drawn, "S", k)[1] for k in (0, 1))
        same = rise.size == back.size and np.allclose(rise, back[::-1], atol=1e-9 * found.stroke)
        assert same == (found is order)


def test_a_return_as_given_has_the_sign_of_its_diagram(tmp_path: Path) -> None:
    """The second derivative of the displacement itself, by differences of the closed form."""
    points = "return_points = [[0, -3], [0.25, -3], [0.25, 1], [1, 1]]\n"
    order = asked(tmp_path, points + 'return = "given"\n')
    drawn = made(order)
    angles, second = rows(drawn, "A", 1)
    step = 1e-3
    around = [motion(order, angles + k * step)[0] for k in (-1, 0, 1)]
    found = (around[0] - 2.0 * around[1] + around[2]) / np.radians(step) ** 2
    inside = [1, 2, -3, -2]
    np.testing.assert_allclose(second[inside], found[inside], rtol=1e-4)
    assert (second[1] < 0.0, second[-2] > 0.0) == (True, True)
    with pytest.raises(SceneError, match="wrong way"):
        asked(tmp_path, points)


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ('return = "given"', "points of its own"),
        ('return = "mirrored"\nreturn_points = [[0, 1], [1, -1]]', "run backwards"),
        ('return = "mirrored"\nreturn_law = "sine"', "run backwards"),
        ('return = "twice"', "mirrored"),
        ('mu_dS = "0.01 rad/mm"', "0.001 m/mm"),
        ("speed = 0", "stands still"),
    ],
)
def test_contradictions_are_refused(more: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=says):
        asked(tmp_path, more + "\n")


def test_only_a_diagram_has_another_way_round(tmp_path: Path) -> None:
    text = HEAD.replace("diagram", "sine").replace("law_points", "# law_points")
    with pytest.raises(SceneError, match="same both ways"):
        read(written(tmp_path, text + 'return = "mirrored"\n'))
