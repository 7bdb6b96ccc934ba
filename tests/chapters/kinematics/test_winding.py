"""The angle by which a wheel on a coupler rolls goes on without a leap, over turns and back, as ω says."""

from __future__ import annotations

import random

import numpy as np
import pytest
from support.wheel_loops import FiveBar

import graphic_tmm as tmm
from graphic_tmm.errors import StructureError
from graphic_tmm.face.motion import Motion

BEHIND = """
[[link]]
number = 6
points = { C = [0, 0], E = [0.05, 0] }
[[mesh]]
links = [2, 6]
centres = ["B", "C"]
teeth = [23, 17]
"""
TEETH = ((30, 20), (20, 30), (13, 10), (10, 13), (50, 20))
STEP = 0.5
MIDDLES = 5e-3
"""Nearer than this (m) the ends of both couplers pass so fast that steps of half a degree do not follow."""


def _case(source: random.Random, teeth: tuple[tuple[int, int], ...]) -> FiveBar:
    a, d, f = (source.uniform(*ends) for ends in ((0.02, 0.06), (0.02, 0.06), (0.03, 0.12)))
    b = source.uniform(0.12, 0.25)
    z, internal = source.choice(teeth), source.random() < 0.5
    phase, side = source.uniform(-180.0, 180.0), source.choice((1, -1))
    return FiveBar(a, b, b, d, f, z, internal, phase, side)


def _off(found: Motion, step: float = STEP) -> np.ndarray:
    """How far each step of CE is off the integral of ω, degrees; NaN where it does not close."""
    places = found.places
    steps = np.diff(np.angle(places["E", 6] - places["C", 6]))
    rolled = (found.omega[6][1:] + found.omega[6][:-1]) / 2.0 * np.radians(step) / 10.0
    off = np.degrees(np.abs(np.angle(np.exp(1j * (steps - rolled)))))
    near = np.abs(places["A", 1] - places["C", 4]) < MIDDLES
    return np.where(near[1:] | near[:-1], np.nan, off)


def _follow(seed: int, count: int) -> None:
    at = np.arange(-720.0, 1800.1, STEP)
    source, refused = random.Random(seed), 0
    for _ in range(count):
        case = _case(source, TEETH)
        try:
            off = _off(tmm.motion(case.scene + BEHIND, at, exact=True))
        except StructureError as error:
            refused += "swings by more than a whole turn and back" in str(error) or count
            continue
        assert not np.any(off > 30.0), (case, at[1:][off > 30.0])
    assert refused <= count // 25, refused


def test_a_wheel_on_a_coupler_rolls_on_as_its_speed_says() -> None:
    _follow(3, 40)


@pytest.mark.slow
def test_many_wheels_on_couplers_roll_on_as_their_speed_says() -> None:
    _follow(5, 400)


def test_a_row_clockwise_is_counted_as_it_is_drawn() -> None:
    """One whose couplers are carried round in turns other than the first: that turn is drawn, both ways."""
    source = random.Random(3)
    case = [_case(source, TEETH) for _ in range(126)][-1]
    found = tmm.motion(case.scene + BEHIND, np.arange(0.0, -360.1, -STEP), exact=True)
    assert np.nanmax(_off(found, -STEP)) < 1.0


def test_what_cannot_be_followed_over_all_turns_stands_in_those_that_were_tried() -> None:
    """Wheels of 41 and 40 teeth carry the couplers round now and not then: two turns, no number beyond."""
    case = FiveBar(0.05, 0.2, 0.2, 0.05, 0.04, (41, 40), True)
    at = np.arange(-720.0, 1800.1, STEP)
    found = tmm.motion(case.scene + BEHIND, at, exact=True)
    tried = np.abs(at) <= 720.0
    assert np.isfinite(found.places["C", 4]).all()
    assert (np.isfinite(found.places["E", 6]) == (tried & np.isfinite(found.places["B", 2]))).all()
    assert not np.any(_off(found) > 30.0)
