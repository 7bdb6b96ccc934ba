"""Every plan against vector loops that know nothing of plans."""

from __future__ import annotations

import numpy as np
import pytest
from drawn import board
from hypothesis import HealthCheck, given, settings
from mechanisms import KINDS, Drawn, mechanisms, sample
from oracle import solve_fast

RATIO = 1e-9


def _compare(drawn: Drawn, turned: bool) -> None:
    sheet = board(drawn.mechanism, turned=turned)
    read = sheet.read([[drawn.phi]])
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    moving = [link for link in drawn.mechanism.links]
    speed = abs(drawn.mechanism.drive.speed)
    largest = {"r": state.size, "v": state.size * speed, "a": state.size * speed**2}
    pairs = {"r": [], "v": [], "a": []}
    for link in moving:
        for letter in link.points:
            expected = state.points[letter, link.number]
            for name, value in zip("rva", expected, strict=True):
                pairs[name].append((read[name][letter, link.number][0], value, letter, link.number))
                largest[name] = max(largest[name], abs(value))
    for name, rows in pairs.items():
        for found, value, letter, number in rows:
            assert abs(found - value) <= RATIO * largest[name], (name, letter, number, drawn.kinds)
    for name, due, least in (("omega", state.omega, speed), ("epsilon", state.epsilon, speed**2)):
        top = max(least, *(abs(value) for value in due.values()))
        for link in moving:
            found = float(np.ravel(read[name].get(link.number, 0.0))[0])
            assert abs(found - due[link.number]) <= RATIO * top, (name, link.number, drawn.kinds)


@pytest.mark.parametrize("turned", [False, True])
@settings(max_examples=200, deadline=None, suppress_health_check=list(HealthCheck))
@given(drawn=mechanisms())
def test_all_plans_equal_the_vector_loops(turned: bool, drawn: Drawn) -> None:
    _compare(drawn, turned)


@pytest.mark.parametrize("kind", KINDS)
def test_one_group_of_each_kind(kind: str) -> None:
    for drawn in sample(60, seed=KINDS.index(kind), dyads=(1, 1), kinds=[kind]):
        _compare(drawn, turned=False)
