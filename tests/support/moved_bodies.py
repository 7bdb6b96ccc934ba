"""A mechanism held against its single bodies, which keep to their constraints, at angles all over."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

import graphic_tmm as tmm
from support.plates import Machine, followed

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
