"""Where two places of a group meet its drive stands: right on this side, nothing there and behind it."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from support.dead_places import DeadPlace, dead_places
from support.plates import Assembly, Machine, machine
from support.squares import square
from support.turns import in_turn

import graphic_tmm as tmm

CLOSE = 1e-12
"""By so much, rad, by how badly its bodies are held a way of 1 from there, the drive is known to stand off."""


def dyad(seed: int) -> Machine:
    one = Assembly(seed)
    one.dyad("A", 1, "B", "C", (0.02, 0.06))
    return one.machine("Dyad")


MACHINES: dict[str, Callable[[int], Machine]] = {
    "dyad": dyad,
    "legs": machine,
    "guide": lambda seed: machine(seed, guides=1),
    "guides": lambda seed: machine(seed, guides=2),
    "before": lambda seed: machine(seed, before=True),
    "behind": lambda seed: machine(seed, behind=True),
    "slot": lambda seed: machine(seed, slots=1),
    "guide and slot": lambda seed: machine(seed, guides=1, slots=1),
    "slots": lambda seed: machine(seed, slots=2),
    "three guides": lambda seed: machine(seed, guides=3),
    "two guides and slot": lambda seed: machine(seed, guides=2, slots=1),
    "guide and two slots": lambda seed: machine(seed, guides=1, slots=2),
    "three slots": lambda seed: machine(seed, slots=3),
    "joined": lambda seed: square(seed).machine,
    "joined, before": lambda seed: square(seed, before=True).machine,
}
CASES = [(kind, seed) for seed in range(20) for kind in MACHINES]
FAST = pytest.mark.parametrize("fast", [False, True], ids=["steps", "compiled"])


def speeds(text: str, angles: np.ndarray, fast: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return ω and ε of all links but the crank that turn (link, angle)."""
    with np.errstate(all="raise"):
        moved = tmm.motion(tmm.read(text), angles, exact=True, fast=fast)
    omega, epsilon = (
        np.array([row for link, row in rates.items() if link != 1])
        for rates in (moved.omega, moved.epsilon)
    )
    return omega, epsilon


@FAST
@pytest.mark.parametrize(("kind", "seed"), in_turn(CASES, 5))
def test_at_its_dead_place_nothing_is_sure(kind: str, seed: int, fast: bool) -> None:
    one = MACHINES[kind](seed)
    for place in dead_places(one):
        at = math.degrees(place.phi)
        # what hangs on a plate has the plate's rounding in its pivots: its dead place is as sure as they are
        beyond = place.sense * np.array(
            [*([] if kind == "behind" else [0.0]), 1e-13, 1e-11, 1e-9, 1e-7]
        )
        for rates in speeds(one.text, at + beyond, fast):
            # what stands before the group does not know of it
            assert np.isnan(rates).any(axis=0).all()
            assert (np.isnan(rates).all(axis=1) | np.isfinite(rates).all(axis=1)).all()


@pytest.mark.parametrize(("kind", "seed"), in_turn(CASES, 5))
def test_before_its_dead_place_it_is_right(kind: str, seed: int) -> None:
    one = MACHINES[kind](seed)
    for place in dead_places(one):
        row = [two for k in np.arange(2.0, 7.5, 0.5) if (two := ahead(place, 10.0**-k))]
        moved = tmm.motion(tmm.read(one.text), np.degrees([phi for phi, _ in row]), exact=True)
        right = 0
        for k, (phi, q) in enumerate(row):
            v, _, bad = one.bodies.rates(q, 10.0)
            off = abs(place.phi - phi)
            for link, omega in moved.omega.items():
                if math.isfinite(omega[k]):
                    near = CLOSE * (1.0 + bad * abs(q - place.poses).max())
                    wrong = abs(omega[k] - v[3 * link - 1]) / np.abs(v).max()
                    assert wrong * off <= near, (link, off)
                    right += link != 1 and off < 1e-6
        assert right


def ahead(place: DeadPlace, way: float) -> tuple[float, np.ndarray] | None:
    """Return the crank and the poses a way before a dead place; None where that is not there."""
    bodies = place.one.bodies
    sign = np.linalg.det(bodies.equations(bodies.start(), place.one.phi)[1]) > 0.0
    for s in (way, -way):
        reached = place.away(s)
        if reached is None:
            continue
        phi, q = reached
        if (np.linalg.det(bodies.equations(q, phi)[1]) > 0.0) == sign:
            return phi, q
    return None
