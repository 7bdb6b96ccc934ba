"""A plate on three legs: places, velocities, accelerations against constraints of single bodies."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.moved_bodies import held
from support.plate_by_hand import TRIAD
from support.plates import followed, machine
from support.turns import in_turn

import graphic_tmm as tmm

KINDS = (
    {},
    {"guides": 1},
    {"guides": 2},
    {"before": True},
    {"before": True, "guides": 1},
    {"behind": True},
    {"behind": True, "guides": 1, "before": True},
    {"slots": 1},
    {"slots": 1, "guides": 1, "behind": True},
    {"slots": 2, "before": True},
    {"slots": 1, "before": True, "behind": True},
)
CASES = [(seed, seed % len(KINDS)) for seed in range(300)]


@pytest.mark.parametrize(("seed", "kind"), in_turn(CASES, 12))
def test_a_plate_moves_as_its_bodies_do(seed: int, kind: int) -> None:
    one = machine(seed, **KINDS[kind])
    assert held(one, machine(seed, **(KINDS[kind] | {"behind": False}))) > 0


REFERENCE = f'title = "Triad"{TRIAD}positions = 12\naccelerations = "all"\n'


def test_reference_numbers_of_a_plate() -> None:
    moved = tmm.motion(tmm.read(REFERENCE), [60.0], exact=True)
    omega = {2: -1.108461, 3: 2.600771, 4: 0.586510, 5: -0.827195}
    assert {k: round(float(moved.omega[k][0]), 6) for k in omega} == pytest.approx(omega, abs=1e-6)
    assert float(moved.epsilon[3][0]) == pytest.approx(47.40321, abs=5e-6)
    assert abs(moved.velocities["F", 3][0]) == pytest.approx(0.165439, abs=5e-7)
    assert abs(moved.accelerations["F", 3][0]) == pytest.approx(3.73818, abs=5e-6)


def test_where_the_plate_stops_is_within_a_hundredth_of_a_degree() -> None:
    angles = [122.24, 122.26, -21.095, -21.106]
    omega = tmm.motion(tmm.read(REFERENCE), angles, exact=True).omega[3]
    assert [math.isfinite(one) for one in omega] == [True, False, True, False]


@pytest.mark.parametrize(("guides", "slots"), [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (0, 2)])
def test_a_plate_in_machine_code_moves_as_step_by_step(guides: int, slots: int) -> None:
    one = machine(11 + guides, guides=guides, slots=slots)
    row = followed(one)
    angles = np.degrees([phi for phi, _ in row if phi < row[0][0] + 2 * math.pi])[1:-1]
    slow, fast = (
        tmm.motion(tmm.read(one.text), angles, exact=True, fast=how) for how in (False, True)
    )
    for link, omega in slow.omega.items():
        size = np.nanmax(np.abs(omega))
        assert np.nanmax(np.abs(fast.omega[link] - omega)) <= 1e-9 * size, link
        assert (np.isnan(omega) == np.isnan(fast.omega[link])).all()
