"""Two plates that two links join: all their places, velocities, accelerations against single bodies."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from support.moved_bodies import held, returns
from support.plates import Machine, followed
from support.squares import Square, square
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.errors import StructureError

KINDS = ({}, {"before": True}, {"behind": True}, {"before": True, "behind": True})
CASES = [(seed, seed % len(KINDS)) for seed in range(60)]


def laid(one: Square, poses: np.ndarray, near: int = 0) -> Machine:
    """Return the machine as it is laid in another of its places; ``near``: the plate that says so."""
    machine = one.machine
    lies = {
        k: (complex(*poses[3 * k - 3 : 3 * k - 1]), float(poses[3 * k - 1]))
        for k in machine.bodies.poses
    }
    return machine._replace(text=one.place(poses, near), bodies=replace(machine.bodies, poses=lies))


@pytest.mark.parametrize(("seed", "kind"), in_turn(CASES, 6))
def test_all_places_move_as_their_bodies_do(seed: int, kind: int) -> None:
    one = square(seed, **KINDS[kind])
    bare = square(seed, **(KINDS[kind] | {"behind": False}))
    for k, poses in enumerate(one.places()):
        alone = laid(bare, poses[: bare.machine.bodies.start().size])
        assert held(laid(one, poses, k % 2), alone) > 0


@pytest.mark.parametrize("seed", in_turn(range(60), 6))
def test_as_many_places_as_there_are_are_told(seed: int) -> None:
    one = square(seed)
    count, wanted = len(one.places(600)), one.machine.text
    line = next(row for row in wanted.splitlines() if row.startswith("near ="))
    for angle in range(0, 360, 10):
        try:
            tmm.motion(tmm.read(wanted.replace(line, f'near = "{angle} deg"')), [0.0])
        except StructureError as error:
            if found := re.search(r"can be assembled in (\d+) ways", str(error)):
                assert int(found[1]) == count
                return
    raise AssertionError("every direction is near a place")


@pytest.mark.parametrize("seed", in_turn(range(60), 6))
def test_a_turn_has_no_jump(seed: int) -> None:
    """At 720 angles of a turn every pin is where that of the bodies is which were followed on their own."""
    one = square(seed)
    row = followed(one.machine)
    angles = np.degrees([phi for phi, _ in row if phi < row[0][0] + 2 * math.pi])
    if angles.size < 3:
        return
    if not returns(row):
        return
    moved = tmm.motion(tmm.read(one.text), angles, exact=True)
    for k, poses in enumerate(q for phi, q in row if phi < row[0][0] + 2 * math.pi):
        for (letter, link), own in one.machine.letters.items():
            place = complex(moved.places[letter, link][k])
            if math.isfinite(abs(place)):
                z = complex(*poses[3 * link - 3 : 3 * link - 1])
                assert abs(place - z - own * np.exp(1j * poses[3 * link - 1])) < 1e-6


@pytest.mark.parametrize("seed", range(3))
def test_in_machine_code_it_moves_as_step_by_step(seed: int) -> None:
    one = square(seed)
    row = followed(one.machine)
    angles = np.degrees([phi for phi, _ in row if phi < row[0][0] + 2 * math.pi])[1:-1]
    slow, fast = (
        tmm.motion(tmm.read(one.text), angles, exact=True, fast=how) for how in (False, True)
    )
    for link, omega in slow.omega.items():
        size = np.nanmax(np.abs(omega))
        assert np.nanmax(np.abs(fast.omega[link] - omega)) <= 1e-9 * size, link
        assert (np.isnan(omega) == np.isnan(fast.omega[link])).all()


@pytest.mark.parametrize("seed", in_turn(range(60), 6))
def test_near_where_two_places_meet_it_is_right_or_nothing(seed: int) -> None:
    one = square(seed)
    row = followed(one.machine)
    if row[-1][0] - row[0][0] > 2 * math.pi:
        return
    ends = [math.degrees(row[k][0]) for k in (0, -1)]
    angles = np.concatenate([end + np.linspace(-0.6, 0.6, 241) for end in ends])
    moved = tmm.motion(tmm.read(one.text), angles, exact=True)
    for link in one.joining:
        own = [(a, z) for (a, k), z in one.machine.letters.items() if k == link]
        first, second = (moved.places[letter, link] for letter, _ in own)
        off = np.abs(second - first) - abs(own[1][1] - own[0][1])
        there = np.isfinite(off)
        assert 0 < there.sum() < there.size
        assert np.abs(off[there]).max() < 1e-9
