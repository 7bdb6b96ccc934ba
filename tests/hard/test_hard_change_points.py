"""Change points, where both assemblies meet: exactly there, and off by 1e-2 … 1e-15 rad."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.drawn import board
from support.each import each
from support.figures_judge import drawn_at
from support.hard_judge import Verdict, judge, named, right
from support.hard_mechanisms import (
    FRAMES,
    Frame,
    coulisse,
    four_bar,
    put,
    slider_crank,
    weighed,
)

from graphic_tmm.chapters.kinematics.assembly import check_assembly
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect

OFFS = (0.0, *(s * 10.0**-k for k in (2, 4, 6, 8, 11, 15) for s in (1, -1)))
CASES: dict[str, tuple[Mechanism, tuple[float, ...]]] = {
    "l = r, passing on": (slider_crank(0.1, 0.1, flips=(90.0, 270.0)), (90.0, 270.0)),
    "l = r, turning back": (slider_crank(0.1, 0.1, flips=()), (90.0,)),
    "parallelogram": (four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0)), (0.0, 180.0)),
    "antiparallelogram": (four_bar(0.1, 0.3, 0.1, 0.3, flips=()), (0.0, 180.0)),
    "kite": (four_bar(0.2, 0.5, 0.5, 0.2, flips=()), (0.0,)),
    "kite, passing on": (four_bar(0.1, 0.2, 0.2, 0.1, flips=(0.0,)), (0.0,)),
    "Grashof's borderline": (four_bar(0.1, 0.2, 0.25, 0.35, flips=()), (180.0,)),
    "stone over the rocker's pivot": (coulisse(0.1, 0.1, flips=(0.0,)), (0.0,)),
    "guide that touches its circle": (coulisse(0.1, 0.3, 0.2, flips=()), (0.0,)),
}


def _all(name: str, frame: Frame) -> list[tuple[float, Verdict]]:
    mechanism, angles = CASES[name]
    there = put(mechanism, frame)
    return [(off, judge(there, frame.angle(a + math.degrees(off)))) for a in angles for off in OFFS]


@pytest.mark.turns(3)
@pytest.mark.slow
@each("frame", [FRAMES[k] for k in (0, 1, 4)])
@pytest.mark.parametrize("name", CASES)
def test_right_within_the_condition_or_named(name: str, frame: Frame) -> None:
    for off, found in _all(name, frame):
        assert right(found), (off, found.shares, found.conditions, found.kinds)


@pytest.mark.parametrize("name", CASES)
def test_at_the_change_point_itself_the_plan_says_so(name: str) -> None:
    mechanism, angles = CASES[name]
    for angle in angles:
        found = judge(mechanism, angle)
        assert found.kinds & {"touching", "undrawn"}


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_position_that_lost_its_digits_is_named(name: str) -> None:
    """Where a pin could be a thousandth of the mechanism off, or more, a finding says why."""
    for off, found in _all(name, FRAMES[0]):
        lost = found.bounds.get("r", np.inf) > 1e-3 * 0.1
        assert named(found) or not lost, (off, found.bounds, found.conditions)


def test_an_acceleration_that_lost_its_digits_is_named() -> None:
    """At 1e-6 rad of l = r the acceleration (about 0.8 m/s²) is off by its whole size, and more."""
    found = judge(slider_crank(0.1, 0.1, flips=(90.0, 270.0)), 90.0 + math.degrees(1e-6))
    assert found.shares["a"] * found.bounds["a"] < 0.1 or named(found)


@pytest.mark.parametrize("name", CASES)
def test_a_side_that_does_not_speak_of_a_change_point_is_refused(name: str) -> None:
    from dataclasses import replace

    mechanism, angles = CASES[name]
    links = []
    for link in mechanism.links:
        slides = tuple(
            replace(s, side=replace(s.side, flips_at=None)) if s.side else s for s in link.slides
        )
        side = replace(link.side, flips_at=None) if link.side else None
        links.append(replace(link, slides=slides, side=side))
    silent = replace(mechanism, links=tuple(links))
    with pytest.raises(StructureError, match="change point") as caught:
        check_assembly(survey(silent, dissect(silent)))
    assert all(f'"{angle:g} deg"' in str(caught.value) for angle in angles)


@pytest.mark.parametrize(
    "flipping",
    [
        four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0)),
        slider_crank(0.1, 0.1, flips=(90.0, 270.0)),
        four_bar(0.1, 0.2, 0.2, 0.1, flips=(0.0,)),
    ],
)
def test_a_mechanism_that_passes_on_has_one_smooth_path(flipping: Mechanism) -> None:
    """The branch kept through the flips is one curve: no step of B is longer than its fastest speed allows."""
    angles = np.arange(0.5, 359.6, 1.0)[None, :]
    b = board(flipping).read(angles)["r"]["B", 2]
    step = np.abs(np.diff(b))
    assert np.isfinite(b).all()
    assert step.max() <= 3 * 0.2 * math.radians(1.0)


# mechanisms that lock over a part of the turn


@each("off", [0.0, 1e-16, 1e-13, 1e-10, 1e-6])
@each("frame", [FRAMES[k] for k in (0, 3, 4)])
def test_about_the_angle_where_a_mechanism_locks(off: float, frame: Frame) -> None:
    r, rod, s, d = 0.3, 0.5, 0.15, 0.4
    lock = math.degrees(math.acos((r * r + d * d - (rod + s) ** 2) / (2 * r * d)))
    mechanism = put(four_bar(r, rod, s, d), frame)
    for sense in (1, -1):
        found = judge(mechanism, frame.angle(lock * (1 + sense * off)))
        assert right(found), (found.shares, found.kinds)


def test_grashofs_borderline_is_told_from_both_sides() -> None:
    """A coupler longer or shorter by 1e-6: turns through, or locks near 180° over the range of closed form."""
    r, rod, s = 0.1, 0.2, 0.25
    through = four_bar(r, rod, s, rod + s - r - 1e-7)
    assert check_assembly(survey(through, dissect(through))).groups == ()
    d = rod + s - r + 1e-7
    locks = four_bar(r, rod, s, d)
    found = check_assembly(survey(locks, dissect(locks)))
    half = math.degrees(math.acos((r * r + d * d - (rod + s) ** 2) / (2 * r * d)))
    assert found.ranges[0] == pytest.approx((360 - half, 360 + half), abs=1e-6)


@pytest.mark.slow
def test_close_to_a_change_point_a_rate_is_right_or_left_out() -> None:
    """A parallelogram turns both cranks alike; some 1e-6° off the line rounding alone parts its circles.

    The point where they touch is off by the root of that, so what is drawn of its directions agrees with
    itself, and is wrong: the rocker turned by −2.8, −3.4 or −1 rad/s instead of 2.
    """
    source, there = np.random.default_rng(0), 0
    angles = [s * off % 360.0 for off in (1e-3, 1e-4, 3e-7, 3e-8, 1e-8) for s in (1, -1)]
    for _ in range(12):
        r = float(source.uniform(0.05, 0.3))
        c = r * float(source.uniform(1.5, 4.0))
        linkage = weighed(four_bar(r, c, r, c, flips=(0.0, 180.0)))
        _, columns = drawn_at(linkage, [30.0, *angles])
        (row,) = (one.first_figures[1] for one in columns if one.segment == "omega3")
        assert row[0] == pytest.approx(2.0, rel=1e-11)
        rates = [rate for rate in row[1:] if rate is not None]
        assert rates == pytest.approx([2.0] * len(rates), rel=0.1)
        there += len(rates)
    assert there >= 4 * 12
