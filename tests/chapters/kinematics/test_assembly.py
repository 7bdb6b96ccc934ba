"""Whether lengths assemble, over which part of the turn, and where a side cannot hold."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable
from contextlib import nullcontext

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.assemblies import assembly, message, ranges
from support.chains import chain
from support.each import each
from support.examples import most
from support.linkages import coulisse, four_bar, slider_crank

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.assembly import Assembly, check_assembly
from graphic_tmm.chapters.kinematics.survey import Survey, survey
from graphic_tmm.chapters.kinematics.winding import STEPS
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Guide, Link, Mechanism, Side, Slide
from graphic_tmm.mechanism.structure import dissect

Pose = tuple[float, float, float]


# lengths that never assemble


def _named(text: str) -> tuple[float, float]:
    """The mm that are short, and the crank angle, in a message."""
    found = re.search(r"short by ([\d.e+-]+) mm at the best crank angle, ([\d.e+-]+)°", text)
    assert found is not None, text
    return float(found[1]), float(found[2])


def test_a_coupler_and_rocker_too_short_are_named_with_what_is_short() -> None:
    # C off the x axis, so that the best angle lies between the angles tried
    mechanism = four_bar(0.1, 0.15, 0.12, 0.5)
    frame = Link(0, {"O": 0j, "C": cmath.rect(0.5, math.radians(20.1234))})
    text = message(Mechanism(frame, mechanism.links, mechanism.drive))
    assert "group 2-3 never assembles" in text
    assert "together are too short" in text
    assert "AB (link 2) or CB (link 3)" in text
    turn = np.radians(np.linspace(0, 360, 360001))
    short = np.min(np.abs(frame.points["C"] - 0.1 * np.exp(1j * turn))) - 0.27
    assert _named(text)[0] == pytest.approx(short * 1000, rel=1e-3)
    assert _named(text)[1] == pytest.approx(20.1234, abs=6e-3)


def test_a_coupler_too_long_is_named_with_what_differs() -> None:
    text = message(four_bar(0.1, 0.9, 0.12, 0.5))
    assert "group 2-3 never assembles" in text
    assert "differ too much" in text
    short = (0.9 - 0.12) - (0.5 + 0.1)
    assert _named(text)[0] == pytest.approx(short * 1000, rel=1e-3)


def test_a_rod_too_short_for_its_guide_names_rod_and_guide() -> None:
    text = message(slider_crank(0.05, 0.1, 0.3))
    assert "group 2-3 never assembles" in text
    assert "AB (link 2) or the guide x (link 0)" in text
    assert _named(text) == pytest.approx((150.0, 90.0), rel=1e-3)


def test_a_stone_too_near_its_rockers_pivot_is_named() -> None:
    text = message(coulisse(0.1, 0.3 + 0j, 0.5))
    assert "group 2-3 never assembles" in text
    assert "guide z" in text
    assert _named(text)[0] == pytest.approx(100.0, rel=1e-3)


def test_the_second_group_is_named_where_the_first_one_assembles() -> None:
    first = four_bar(0.1, 0.4, 0.3, 0.45)
    guide = Guide("y", 3 + 0j, 90.0)
    text = message(
        Mechanism(
            Link(0, first.frame.points, (guide,)),
            (
                *first.links,
                Link(4, {"B": 0j, "D": 0.2 + 0j}),
                Link(5, {"D": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
            ),
            first.drive,
        )
    )
    assert "group 4-5 never assembles" in text
    assert "BD (link 4)" in text


@settings(max_examples=most(40), deadline=None)
@given(st.floats(0.05, 0.3), st.floats(0.05, 0.3), st.floats(0.05, 0.3), st.floats(0.31, 1.0))
def test_what_is_short_equals_brute_force(r: float, rod: float, s: float, d: float) -> None:
    mechanism = four_bar(r, rod, s, d)
    reach = (d - r, d + r)
    short = max(reach[0] - (rod + s), abs(rod - s) - reach[1])
    if short > 1e-6:
        assert _named(message(mechanism))[0] == pytest.approx(short * 1000, rel=1e-3)
    elif short < -1e-6:
        try:
            assembly(mechanism)
        except StructureError as error:
            assert "change point" in str(error)  # noqa: PT017


# lengths that assemble over a part of the turn


@pytest.mark.parametrize(
    "lengths",
    [
        (0.3, 0.22, 0.25, 0.35),
        (0.3, 0.5, 0.15, 0.4),
        (0.4, 0.35, 0.2, 0.3),
        (0.5, 0.25, 0.35, 0.3),
        (0.3, 0.25, 0.36, 0.8),
    ],
)
def test_the_range_of_the_crank_is_right_to_a_hundredth_of_a_degree(
    lengths: tuple[float, float, float, float],
) -> None:
    mechanism = four_bar(*lengths)
    found = assembly(mechanism)
    due = ranges(*lengths)
    assert found.groups == ("2-3",)
    assert len(found.ranges) == len(due)
    for ours, theirs in zip(sorted(found.ranges), sorted(due), strict=True):
        assert ours == pytest.approx(theirs, abs=1e-6)


def test_an_offset_slider_with_a_short_rod_names_its_two_ranges() -> None:
    found = assembly(slider_crank(0.1, 0.08, 0.01))
    up = math.degrees(math.asin(0.09 / 0.1))
    down = math.degrees(math.asin(0.07 / 0.1))
    assert sorted(found.ranges) == [
        pytest.approx((180 - up, 180 + down), abs=1e-6),
        pytest.approx((360 - down, 360 + up), abs=1e-6),
    ]


def test_a_range_narrower_than_the_angles_tried_is_found() -> None:
    r, rod, s = 0.1, 0.2, 0.15
    d = r + rod + s - 1e-8
    mechanism = four_bar(r, rod, s, d)
    turned = Link(0, {"O": 0j, "C": cmath.rect(d, math.radians(33.1))})
    found = assembly(Mechanism(turned, mechanism.links, mechanism.drive))
    half = ranges(r, rod, s, d)[0][1] - 360.0
    assert half < 0.125
    assert len(found.ranges) == 1
    assert found.ranges[0] == pytest.approx((33.1 - half, 33.1 + half), abs=1e-5)


def test_a_gap_narrower_than_the_angles_tried_is_found() -> None:
    r, rod, s = 0.1, 0.2, 0.25
    d = rod + s - r + 1e-8
    mechanism = four_bar(r, rod, s, d)
    turned = Link(0, {"O": 0j, "C": cmath.rect(d, math.radians(33.1))})
    found = assembly(Mechanism(turned, mechanism.links, mechanism.drive))
    assert found.groups == ("2-3",)
    half = 180.0 - ranges(r, rod, s, d)[0][1] % 360.0
    assert 0 < half < 0.125
    assert found.ranges[0] == pytest.approx((213.1 + half, 573.1 - half), abs=1e-5)


# change points


def test_a_parallelogram_must_say_where_its_side_flips() -> None:
    text = message(four_bar(0.1, 0.3, 0.1, 0.3))
    assert "group 2-3" in text
    assert 'flips_at = ["0 deg", "180 deg"]' in text


@pytest.mark.parametrize(
    ("mechanism", "angles"),
    [
        (slider_crank(0.1, 0.1), ("90", "270")),
        (slider_crank(0.1, 0.12, 0.02), ("270",)),
        (coulisse(0.1, 0.1 + 0j), ("0",)),
        (coulisse(0.1, -0.1 + 0j), ("180",)),
        (coulisse(0.1, 0.3 + 0j, 0.2), ("0",)),
        (four_bar(0.2, 0.5, 0.5, 0.2), ("0",)),
        (four_bar(0.1, 0.2, 0.25, 0.35), ("180",)),
        (four_bar(0.1, 0.2, 0.2, 0.1), ("0",)),
    ],
)
def test_a_change_point_is_named_with_its_angle(
    mechanism: Mechanism, angles: tuple[str, ...]
) -> None:
    text = message(mechanism)
    assert "flips_at = [" + ", ".join(f'"{angle} deg"' for angle in angles) + "]" in text


@each(
    "ends, comes",
    [((15.0, 85.0), False), ((85.0, 15.0), False), ((60.0, 100.0), True), ((100.0, 60.0), True),
     ((95.0, 265.0), False), ((300.0, 440.0), False), ((300.0, 460.0), True), ((-85.0, 85.0), False)],
)  # fmt: skip
def test_an_open_row_asks_of_the_change_points_that_it_comes_to(
    ends: tuple[float, float], comes: bool
) -> None:
    mechanism = slider_crank(0.1, 0.1)
    found = survey(mechanism, dissect(mechanism))
    with pytest.raises(StructureError, match="90°, 270°") if comes else nullcontext():
        check_assembly(found, ends)


def test_a_change_point_between_the_angles_tried_is_named() -> None:
    mechanism = coulisse(0.1, cmath.rect(0.1, math.radians(47.1234)))
    assert '"47.1234 deg"' in message(mechanism)


def test_a_flip_where_the_assemblies_do_not_meet_is_refused() -> None:
    text = message(slider_crank(0.1, 0.1, flips=(90.0, 200.0)))
    assert "group 2-3" in text
    assert "200°" in text
    assert "leave it out" in text
    assert "0.1°" in message(slider_crank(0.1, 0.3, flips=(0.1,)))


def test_a_flip_that_is_a_little_off_is_refused() -> None:
    assert "90.05°" in message(slider_crank(0.1, 0.1, flips=(90.05, 270.0)))


def test_an_odd_number_of_flips_is_refused_where_an_even_one_is_due() -> None:
    for mechanism in (
        slider_crank(0.1, 0.1, flips=(90.0,)),
        four_bar(0.1, 0.3, 0.1, 0.3, flips=(180.0,)),
    ):
        text = message(mechanism)
        assert "even number" in text
        assert "other side" in text


def test_a_flip_named_twice_is_refused() -> None:
    assert "twice" in message(slider_crank(0.1, 0.1, flips=(90.0, 90.0, 270.0, 270.0)))


@pytest.mark.parametrize("off", [1e-6, 3e-8])
def test_a_mechanism_near_a_change_point_is_not_refused(off: float) -> None:
    for mechanism in (
        slider_crank(0.1, 0.1 * (1 + off)),
        four_bar(0.1, 0.3 * (1 + off), 0.1, 0.3),
        four_bar(0.1, 0.3, 0.1 * (1 + off), 0.3),
        coulisse(0.1, 0.1 * (1 + off) + 0j),
        coulisse(0.1, 0.3 + 0j, 0.2 * (1 - off)),
    ):
        try:
            found = assembly(mechanism)
        except StructureError as error:
            pytest.fail(str(error))
        assert all(high - low > 359 for low, high in found.ranges)


def test_one_slice_of_the_log_tells_of_all_groups(monkeypatch: pytest.MonkeyPatch) -> None:
    """However many groups there are: their gaps are read off one run over the turn."""
    mechanism = chain(6)
    tried = survey(mechanism, dissect(mechanism))
    asked: list[int] = []
    at = Survey.at

    def counted(self: Survey, angles: Reals, wanted: Iterable[Mark]) -> Reading:
        asked.append(angles.size)
        return at(self, angles, wanted)

    monkeypatch.setattr(Survey, "at", counted)
    assert check_assembly(tried) == Assembly((), ())
    assert asked == [STEPS]
