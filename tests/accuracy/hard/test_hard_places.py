"""Hard places against closed forms: ends of a range, circles that touch, points that stand still."""

from __future__ import annotations

import math
import re

import pytest
from support import drives
from support.digits_left import scene_of
from support.hard_mechanisms import coulisse, four_bar, slider_crank, weighed

from graphic_tmm.accuracy.hard.hard_places import HardPlace
from graphic_tmm.accuracy.hard.walk import walk
from graphic_tmm.mechanism.records import Mechanism


def places(mechanism: Mechanism) -> tuple[HardPlace, ...]:
    return walk(scene_of(weighed(mechanism))).places


def test_dead_centres_of_an_offset_slider() -> None:
    """Crank and rod in line: sin φ = e/(l ± r)."""
    found = places(slider_crank(0.1, 0.3, 0.05))
    due = (math.asin(0.05 / 0.4), math.pi + math.asin(0.05 / 0.2))
    assert [one.kind for one in found] == ["still", "still"]
    assert [one.at for one in found] == pytest.approx([*map(math.degrees, due)], abs=1e-9)


def test_ends_of_a_crank_that_rocks() -> None:
    """Coupler and rocker in line: (b + c)² = r² + d² − 2·r·d·cos φ."""
    found = places(four_bar(0.3, 0.2, 0.2, 0.4))
    end = math.degrees(math.acos((0.3**2 + 0.4**2 - 0.4**2) / (2 * 0.3 * 0.4)))
    ends = [one for one in found if one.kind == "end"]
    assert [one.at for one in ends] == pytest.approx([end, 360.0 - end], abs=1e-9)
    assert {one.step.op.name for one in ends if one.step} == {"cross"}


@pytest.mark.parametrize(
    ("mechanism", "due", "name"),
    [
        (four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0)), [0.0, 180.0], "cross"),
        (slider_crank(0.1, 0.1, flips=(90.0, 270.0)), [90.0, 270.0], "cut"),
        (coulisse(0.1, 0.3, 0.2, flips=()), [0.0], "tangent"),
        (coulisse(0.1, 0.1, flips=(0.0,)), [0.0], "rocker_line"),
    ],
)
def test_change_points_are_sharp_crossings(
    mechanism: Mechanism, due: list[float], name: str
) -> None:
    found = [one for one in places(mechanism) if one.kind == "sharp"]
    assert [one.at for one in found] == due
    assert {one.step.op.name for one in found if one.step} == {name}
    assert all(one.times > 1e6 for one in found)


def test_a_crossing_that_is_sharp_but_does_not_touch_says_how_sharp() -> None:
    """A rod 0.1 % longer than the crank: at 90° it stands at √(l² − r²) : l to its guide."""
    (first, second) = (one for one in places(slider_crank(0.1, 0.1001)) if one.kind == "sharp")
    assert (first.at, second.at) == pytest.approx((90.0, 270.0), abs=1e-5)
    assert first.times == pytest.approx(0.1001 / math.sqrt(0.1001**2 - 0.1**2), rel=1e-6)


@pytest.mark.parametrize("size", [1.0, 1e-3, 1e4])
def test_a_rod_reaches_from_where_it_lies_on_its_arm_to_where_it_is_in_line(size: float) -> None:
    """l_GN goes from ON − OG to ON + OG, in mm, whatever the size of the boom."""
    found = walk(drives.scene(_sized(drives.BOOM, size)))
    assert [one.kind for one in found.places] == ["end", "end"]
    due = [1e3 * size * (0.5 - 0.4), 1e3 * size * (0.5 + 0.4)]
    assert [one.at for one in found.places] == pytest.approx(due, rel=1e-9)
    assert found.span.low <= due[0] - found.span.offs[0] < due[1] + found.span.offs[0]


def test_a_slider_reaches_between_two_circles() -> None:
    """OB is from AB − OA to AB + OA, to both sides: also there its range ends within what is walked."""
    found = walk(drives.scene(drives.SLIDER))
    assert [one.kind for one in found.places] == ["end"] * 4
    assert [one.at for one in found.places] == pytest.approx([-400, -200, 200, 400], abs=1e-9)
    assert {one.step.op.name for one in found.places if one.step} == {"cross"}
    assert all(one.step for one in found.places)


def test_dead_centres_along_a_rack_are_those_of_its_crank() -> None:
    """A rack comes r·φ: that of 40 mm by the length of the arc."""
    turned = [one.at for one in walk(drives.scene(drives.LEVER)).places]
    come = walk(drives.scene(drives.RACK)).places
    assert [one.kind for one in come] == ["still", "still"]
    due = [40.0 * math.radians(at) for at in turned]
    assert [one.at for one in come] == pytest.approx(due, abs=1e-8)


def _sized(text: str, size: float) -> str:
    """A scene as many times as large: its coordinates and the ends of its row."""
    text = re.sub(
        r"\[(-?[\d.]+), (-?[\d.]+)\]",
        lambda xy: f"[{_times(xy[1], size)}, {_times(xy[2], size)}]",
        text,
    )
    return re.sub(r'"(\d+) mm"', lambda mm: f'"{_times(mm[1], size)} mm"', text)


def _times(number: str, size: float) -> str:
    return repr(float(number) * size)


def test_an_even_crossing_is_no_hard_place() -> None:
    assert {one.kind for one in places(slider_crank(0.1, 0.3))} == {"still"}
