"""A plate on three legs: places, velocities, accelerations against constraints of single bodies."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.moved_bodies import CLOSE, held
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
    {"guides": 3},
    {"guides": 2, "slots": 1, "behind": True},
    {"guides": 1, "slots": 2, "before": True},
    {"slots": 3},
)
LEGS = [(guides, slots) for guides in range(4) for slots in range(4 - guides)]
"""So many of three legs slide, so many of these along the plate."""
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


@pytest.mark.parametrize(("guides", "slots"), LEGS)
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


SLOTTED = ({"slots": 1}, {"slots": 1, "guides": 1}, {"slots": 2}, {"guides": 3}, {"slots": 3})


@pytest.mark.parametrize(("seed", "kind"), [(3, 0), (13, 1), (14, 2)])
def test_a_plate_that_is_passed_by_is_right_as_far_as_it_goes(seed: int, kind: int) -> None:
    """Up to where two of its places meet, and nowhere behind that."""
    one = machine(seed, **SLOTTED[kind])
    phi, q = followed(one)[-1]
    step = math.radians(0.25)
    sign = np.sign(np.linalg.det(one.bodies.equations(q, phi)[1]))
    while step > 1e-9:
        there = one.bodies.settle(q, phi + step)
        if there is not None and sign == np.sign(
            np.linalg.det(one.bodies.equations(there, phi + step)[1])
        ):
            phi, q = phi + step, there
        else:
            step /= 2
    plate = next(link for letter, link in reversed(one.letters) if letter == "B")
    offs = [-1e-5, -1e-6, 1e-6, 1e-4, 1e-2]
    with np.errstate(all="raise"):
        found = tmm.motion(tmm.read(one.text), np.degrees([phi + off for off in offs]), exact=True)
    for off, omega in zip(offs, found.omega[plate], strict=True):
        if off > 0:
            assert math.isnan(omega)
            continue
        near = one.bodies.settle(q, phi + off)
        assert near is not None
        v, _, bad = one.bodies.rates(near, 10.0)
        assert abs(omega - v[3 * plate - 1]) <= 10 * CLOSE * bad * np.abs(v).max()


def test_a_leg_that_only_slides_is_refused_by_name() -> None:
    rail = "S = [0.07, 0.08] }\nguides = { z = { through = [0, 0], angle = 0 } }"
    text = REFERENCE.replace("F = [0.07, 0.08] }", rail)
    text = text.replace("E = [0.42, 0.12]", 'u = { through = [0, 0], angle = "40 deg" }').replace(
        "points = { F = [0, 0], E = [0.2, 0] }",
        'points = { T = [0, 0] }\nslides = [{ on = 3, along = "z" }, { on = "frame", along = "u" }]',
    )
    with pytest.raises(tmm.StructureError, match="at most one sliding pair; links 5 do not"):
        tmm.motion(tmm.read(text), [0.0])
