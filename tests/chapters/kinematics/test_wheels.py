"""Wheels on links against the equations of the loops, published figures, and what is known of such wheels."""

from __future__ import annotations

import math
import random
from pathlib import Path

import numpy as np
import pytest
from support.compare import errors
from support.each import each
from support.wheel_loops import FiveBar, Planet, rates
from support.wheels import geared, near

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.studio import make

RATIO = 1e-9


@each("turned", [False, True])
def test_wheels_on_any_links_equal_the_loops(turned: bool) -> None:
    _all_equal(range(10), turned)


@pytest.mark.slow
@each("turned", [False, True])
def test_many_wheels_on_any_links_equal_the_loops(turned: bool) -> None:
    _all_equal(range(100, 250), turned)


@each("turned", [False, True])
def test_belts_on_any_links_equal_the_loops(turned: bool) -> None:
    _all_equal(range(10), turned, belted=True)


@pytest.mark.slow
@each("turned", [False, True])
def test_many_belts_on_any_links_equal_the_loops(turned: bool) -> None:
    _all_equal(range(100, 250), turned, belted=True)


def _all_equal(seeds: range, turned: bool, *, belted: bool = False) -> None:
    for seed in seeds:
        drawn = geared(seed, 1 + seed % 2, belted=belted)
        found = errors(drawn, turned=turned, wound=near(drawn))
        assert max(found.values()) <= RATIO, (seed, found)


def _five_bar(source: random.Random) -> FiveBar:
    a, d = source.uniform(0.01, 0.03), source.uniform(0.01, 0.03)
    f = source.uniform(0.08, 0.12)
    return FiveBar(
        a,
        source.uniform(0.17, 0.2),
        source.uniform(0.17, 0.2),
        d,
        f,
        (source.randint(10, 60), source.randint(61, 120)),
        source.random() < 0.5,
        source.uniform(-180.0, 180.0),
        source.choice((1, -1)),
        source.uniform(1.0, 50.0),
        source.choice((0.0, source.uniform(-300.0, 300.0))),
    )


def _planet(source: random.Random) -> Planet:
    a, b = source.uniform(0.03, 0.09), source.uniform(0.01, 0.06)
    return Planet(
        a,
        b,
        1.3 * (a + b),
        (source.randint(20, 120), source.randint(10, 19)),
        source.random() < 0.5,
        source.uniform(-180.0, 180.0),
        source.uniform(1.0, 50.0),
        source.choice((0.0, source.uniform(-300.0, 300.0))),
    )


def _equal(case: FiveBar | Planet, at: list[float]) -> None:
    """Places, velocities, accelerations, ω and ε at crank angles, over more than one turn."""
    found = tmm.motion(case.scene, at, exact=True)
    size = 0.3
    for k, degrees in enumerate(at):
        for name, (value, first, second) in rates(
            case.loop, degrees, case.speed, case.gain
        ).items():
            if isinstance(name, str):
                link = next(link for letter, link in found.places if letter == name and link)
                own = [
                    table[name, link][k]
                    for table in (found.places, found.velocities, found.accelerations)
                ]
                due = [complex(one) for one in (value, first, second)]
                tops = size, size * case.speed, size * (case.speed**2 + abs(case.gain))
            else:
                own = [found.omega[name][k], found.epsilon[name][k]]
                due, tops = (
                    [float(first), float(second)],
                    (case.speed, case.speed**2 + abs(case.gain)),
                )
            for there, wanted, top in zip(own, due, tops, strict=True):
                assert abs(there - wanted) <= RATIO * max(top, abs(wanted)), (case, degrees, name)


@pytest.mark.parametrize("draw", [_five_bar, _planet])
def test_wheels_roll_on_over_turns_as_closed_loops_say(draw) -> None:
    source = random.Random(7)
    for _ in range(3):
        _equal(draw(source), [-400.0, -33.0, 0.0, 10.5, 123.4, 359.9, 500.0])


@pytest.mark.slow
@pytest.mark.parametrize("draw", [_five_bar, _planet])
def test_many_wheels_roll_on_as_closed_loops_say(draw) -> None:
    source = random.Random(8)
    for _ in range(100):
        _equal(draw(source), [source.uniform(-800.0, 800.0) for _ in range(6)])


OPEN = (173.642, -177.715, 32.6, 16.9, 3191.0, 2492.0)
CROSSED = (-115.407, -124.050, -75.2, -59.6, -6648.0, -5950.0)


@pytest.mark.parametrize(("side", "due"), [(1, OPEN), (-1, CROSSED)])
def test_a_published_geared_five_bar(side: int, due: tuple[float, ...]) -> None:
    """R. L. Norton, Design of Machinery, tables of geared fivebars of chapters 4, 6 and 7, row a.

    Links 6, 1, 7, 9, 4 inches, ratio 2, phase 30°, θ2 = 60°, ω2 = 10 rad/s: angles of both couplers (°), ω, ε.
    """
    case = FiveBar(1.0, 7.0, 9.0, 4.0, 6.0, (40, 20), True, 30.0, side)
    found = tmm.motion(case.scene, [60.0], exact=True)
    places = {letter: complex(z[0]) for (letter, _), z in found.places.items()}
    angles = [math.degrees(np.angle(places["B"] - places[letter])) for letter in "AC"]
    rows = [table[link][0] for table in (found.omega, found.epsilon) for link in (2, 3)]
    for own, published, off in zip(
        [*angles, *rows], due, (5e-4,) * 2 + (0.05,) * 2 + (0.5,) * 2, strict=True
    ):
        assert abs(own - published) <= off, (own, published)


def test_the_circles_of_cardan() -> None:
    """In a ring twice as large a point of a wheel's rim goes along a diameter: B at 2·a·cos φ (De La Hire)."""
    case = Planet(0.05, 0.05, 0.3, (40, 20))
    at = np.linspace(0.0, 360.0, 25)
    found = tmm.motion(case.scene, at, exact=True)
    assert np.allclose(found.places["B", 2], 0.1 * np.cos(np.radians(at)), atol=1e-15)
    assert np.allclose(found.omega[2], -10.0)
    assert np.allclose(found.accelerations["B", 2], -100.0 * found.places["B", 2], atol=1e-12)


FOUR_BAR = """
title = "T"
language = "en"
[frame]
O = [0, 0]
D = [0.12, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.03, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.1, 0] }
[[link]]
number = 3
points = { B = [0, 0], D = [0.08, 0] }
side = "left of AD"
[[link]]
number = 4
points = { D = [0, 0], E = [0.05, 0] }
[[mesh]]
links = [2, 4]
centres = ["B", "D"]
teeth = [30, 20]
[drive]
link = 1
speed = 10
accelerations = "all"
"""


def test_a_wheel_that_is_one_with_a_coupler_turns_by_willis() -> None:
    """(ω4 − ω3)/(ω2 − ω3) = −z2/z4, and the same of ε: one wheel with the coupler, one about the pivot."""
    found = tmm.motion(FOUR_BAR, np.linspace(0.0, 700.0, 29), exact=True)
    for table in (found.omega, found.epsilon):
        assert np.allclose(table[4] - table[3], -1.5 * (table[2] - table[3]), rtol=1e-9, atol=1e-7)


def test_what_a_wheel_rolls_from_is_calculated_and_its_arm_is_drawn_once() -> None:
    """Nothing that follows from the teeth is given; the line of centres is the rocker that is there already."""
    log = make(tmm.read(FOUR_BAR)).mechanism
    assert log is not None
    steps = [step for step in log.construction.steps if step.it.view == "positions"]
    assert [step.it.name for step in steps].count("(DB)") == 1
    given = {mark.name: value for mark, value in log.given.items() if mark.view == "positions"}
    assert given["φ_{40}"] == 0.0
    assert given["β_3"] == 180.0


def test_its_angle_goes_on_without_a_leap() -> None:
    """What a wheel has rolled is an integral: E's angle follows ω4 over the whole turn, and comes back."""
    at = np.linspace(0.0, 360.0, 3601)
    found = tmm.motion(FOUR_BAR, at, exact=True)
    way = np.unwrap(np.angle(found.places["E", 4] - 0.12))
    rolled = np.cumsum((found.omega[4][1:] + found.omega[4][:-1]) / 2.0) * np.radians(0.1) / 10.0
    assert np.allclose(way[1:] - way[0], rolled, atol=1e-6)
    assert abs(way[-1] - way[0]) < 1e-9


def test_a_ratio_that_is_no_whole_number_leaves_the_row_open(tmp_path: Path) -> None:
    whole, broken = (FiveBar(0.03, 0.19, 0.18, 0.03, 0.1, (z, 20)) for z in (40, 30))
    for case, rolls_on in ((whole, False), (broken, True)):
        mechanism = tmm.read(case.scene).mechanism
        assert mechanism is not None
        assert survey(mechanism, dissect(mechanism)).rolls_on == rolls_on


def test_a_wheel_between_links_that_stand_already_is_a_group_above_class_two() -> None:
    """Two links in mesh that are both held by more: told by name, with its mobility."""
    text = FOUR_BAR.replace(
        "points = { D = [0, 0], E = [0.05, 0] }", "points = { D = [0, 0], A = [0.05, 0] }"
    )
    mechanism = tmm.read(text).mechanism
    assert mechanism is not None
    with pytest.raises(StructureError, match="W = 3·4 − 2·6 − 1 = −1"):
        dissect(mechanism)


CHAIN = (
    FiveBar(0.03, 0.19, 0.18, 0.03, 0.1, (30, 20)).scene
    + """
[[link]]
number = 6
points = { C = [0, 0], E = [0.05, 0] }
[[mesh]]
links = [2, 6]
centres = ["B", "C"]
teeth = [23, 17]
"""
)


def test_a_wheel_behind_a_wheel_goes_on_without_a_leap_over_turns() -> None:
    """Links that swing by a wheel of a broken ratio come back after no turn: their angles follow the wheel."""
    at = np.linspace(0.0, 2000.0, 4001)
    found = tmm.motion(CHAIN, at, exact=True)
    way = np.unwrap(np.angle(found.places["E", 6] - found.places["C", 6]))
    rolled = np.cumsum((found.omega[6][1:] + found.omega[6][:-1]) / 2.0) * np.radians(0.5) / 10.0
    assert np.allclose(way[1:] - way[0], rolled, atol=1e-3)
