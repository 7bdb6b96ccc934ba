"""A plate on three legs: places, velocities, accelerations against constraints of single bodies."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from support.plates import Machine, followed, machine
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
CLOSE = 1e-12
"""Of the condition of the equations: double numbers of size 1 lose no more in so few steps."""


def held(one: Machine, alone: Machine) -> int:
    """Hold a machine against its bodies at angles all over; return how many were compared.

    ``alone``: the same without what hangs on its plate.
    """
    row = followed(one)
    if not returns(followed(alone)):
        with pytest.raises(tmm.StructureError, match="another of its places after a turn"):
            tmm.motion(tmm.read(one.text), [0.0])
        return 1
    row = [two for two in row if two[0] < row[0][0] + 2 * math.pi]
    wanted = row[:: max(1, len(row) // 16)]
    angles = np.degrees([phi for phi, _ in wanted])
    moved = tmm.motion(tmm.read(one.text), angles, exact=True)
    compared = 0
    for k, (_, q) in enumerate(wanted):
        v, a, bad = one.bodies.rates(q, 10.0)
        if bad > 1e4:
            continue
        near = CLOSE * bad
        for (letter, link), own in one.letters.items():
            z, turn = (
                complex(*q[3 * link - 3 : 3 * link - 1]),
                own * cmath.exp(1j * q[3 * link - 1]),
            )
            assert abs(complex(moved.places[letter, link][k]) - z - turn) <= near, (letter, link)
            speed = complex(*v[3 * link - 3 : 3 * link - 1]) + 1j * v[3 * link - 1] * turn
            size = 1.0 + np.abs(v).max()
            assert abs(complex(moved.velocities[letter, link][k]) - speed) <= near * size
        for link, omega in moved.omega.items():
            assert abs(omega[k] - v[3 * link - 1]) <= near * (1.0 + np.abs(v).max())
        for link, epsilon in moved.epsilon.items():
            assert abs(epsilon[k] - a[3 * link - 1]) <= 10 * near * (1.0 + np.abs(a).max())
        compared += 1
    return compared


def returns(row: list[tuple[float, np.ndarray]]) -> bool:
    """Whether the bodies are back after a turn of the crank, or it does not turn so far."""
    (first, begin), (last, end) = row[0], row[-1]
    if last - first < 2 * math.pi:
        return True
    if last - first < 4 * math.pi - 1e-6:
        return False
    middle = row[len(row) // 2][1]
    apart = [
        np.abs(np.exp(1j * one[2::3]) - np.exp(1j * middle[2::3])).max() for one in (begin, end)
    ]
    return max(apart) < 1e-6


@pytest.mark.parametrize(("seed", "kind"), in_turn(CASES, 12))
def test_a_plate_moves_as_its_bodies_do(seed: int, kind: int) -> None:
    one = machine(seed, **KINDS[kind])
    assert held(one, machine(seed, **(KINDS[kind] | {"behind": False}))) > 0


REFERENCE = """
title = "Triad"
[frame]
O = [0, 0]
D = [0.3, -0.05]
E = [0.42, 0.12]
[[link]]
number = 1
points = { O = [0, 0], A = [0.05, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.2, 0] }
[[link]]
number = 3
points = { B = [0, 0], C = [0.12, 0], F = [0.07, 0.08] }
near = "-114 deg"
[[link]]
number = 4
points = { C = [0, 0], D = [0.18, 0] }
[[link]]
number = 5
points = { F = [0, 0], E = [0.2, 0] }
[drive]
link = 1
speed = 10
positions = 12
accelerations = "all"
"""


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
