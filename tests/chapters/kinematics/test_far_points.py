"""Links that become parallel: numbers stay right next to it, drawings say what is off the sheet."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support.plates import Machine, followed
from support.squares import square

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.far_points import far_positions
from graphic_tmm.errors import StructureError
from graphic_tmm.studio import make, sheets

SEED = 3
"""Of the machine whose joining links become parallel, by about 93° of its crank."""


def parallel_at(one: Machine) -> tuple[float, np.ndarray]:
    """Return the crank (rad) and the poses where the joining links are parallel, to rounding."""
    first, second = (k for k in one.links[1:] if not {("A", k), ("D", k)} & one.letters.keys())

    def sine(q: np.ndarray) -> float:
        return math.sin(q[3 * first - 1] - q[3 * second - 1])

    row = followed(one)
    k = next(k for k in range(len(row) - 1) if sine(row[k][1]) * sine(row[k + 1][1]) < 0.0)
    (low, q), (high, _) = row[k], row[k + 1]
    before = sine(q) > 0.0
    for _ in range(60):
        middle = (low + high) / 2.0
        there = one.bodies.settle(q, middle)
        assert there is not None
        low, high, q = (middle, high, there) if (sine(there) > 0.0) == before else (low, middle, q)
    return low, q


def test_next_to_parallel_links_numbers_are_right() -> None:
    one = square(SEED).machine
    phi, q = parallel_at(one)
    offs = np.array([-1e-2, -1e-4, -1e-6, 1e-6, 1e-4, 1e-2])
    moved = tmm.motion(tmm.read(one.text), np.degrees(phi + offs), exact=True)
    for k, off in enumerate(offs):
        near = one.bodies.settle(q, phi + off)
        assert near is not None
        v, a, bad = one.bodies.rates(near, 10.0)
        # the special point is as far off as the lines are parallel
        lost = 1e-12 * bad / abs(off)
        for link, omega in moved.omega.items():
            assert abs(omega[k] - v[3 * link - 1]) <= lost * np.abs(v).max()
        for link, epsilon in moved.epsilon.items():
            assert abs(epsilon[k] - a[3 * link - 1]) <= lost * np.abs(a).max()


def scene(positions: str, place: str) -> str:
    text = square(SEED).text.replace("positions = 12\n", positions)
    return f'{text}\n[[sheet]]\nformat = "A1"\nplace = ["positions", {place}]\n'


def test_positions_whose_special_point_is_off_the_sheet_are_told() -> None:
    text = scene('positions = 3\nfrom = "93 deg"\nto = "205 deg"\n', '"velocities"')
    (drawn,) = make(tmm.read(text), exact=True).boards
    told = [*far_positions(drawn, "en")]
    assert len(told) == 1
    assert told[0].startswith("In positions 0, 1 the lines of links 2, 4 are parallel or nearly so")


def test_a_view_of_a_special_point_off_the_sheet_is_refused_by_name() -> None:
    text = scene('positions = 1\nzero = "93 deg"\n', '"special points"')
    with pytest.raises(StructureError, match="W35, where they cross, is off any sheet; name"):
        sheets(tmm.read(text))


def test_a_special_point_on_the_sheet_says_nothing() -> None:
    text = scene('positions = 2\nfrom = "190 deg"\nto = "205 deg"\n', '"velocities"')
    (drawn,) = make(tmm.read(text), exact=True).boards
    assert not [*far_positions(drawn, "en")]
