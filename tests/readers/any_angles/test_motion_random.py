"""Motion and forces of mechanisms drawn at random, against judges that know nothing of the board."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import HealthCheck, given, reject, settings
from support import dynamics
from support.examples import most
from support.loaded import order_of, places, weighed
from support.mechanisms import Sampled, mechanisms, sample
from support.oracle import solve_fast

import graphic_tmm
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.any_angles.motion import PLANS, recorded
from graphic_tmm.scene.records import Scene

EASY = 1e5
"""A condition number beyond which float64 has few digits left for accelerations and forces."""


def moved(drawn: Sampled) -> bool:
    """Compare places, velocities, accelerations, rates with those of the loops; False if too near locking."""
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    if state.condition > EASY:
        return False
    scene = Scene("random", "", "en", drawn.mechanism)
    found = graphic_tmm.motion(scene, [drawn.phi, drawn.phi], exact=True)
    for quantity, name in (("places", "r"), ("velocities", "v"), ("accelerations", "a")):
        values = getattr(found, quantity)
        due = {key: getattr(state.points[key], name) for key in values if key in state.points}
        assert len(due) == len(values)
        largest = max(map(abs, due.values()))
        for key, one in due.items():
            assert np.abs(values[key] - one).max() <= 1e-9 * largest, (quantity, key)
    # what comes out as nothing is told beside the crank's own speed, or its square
    speed = abs(drawn.mechanism.drive.speed)
    for told, turns, own in (
        (found.omega, state.omega, speed),
        (found.epsilon, state.epsilon, speed**2),
    ):
        largest = max((abs(one) for one in turns.values()), default=0.0)
        largest = max(largest, own)
        for link, turn in told.items():
            assert np.abs(turn - turns[link]).max() <= 1e-9 * largest, link
    return True


@settings(max_examples=most(60), deadline=None, suppress_health_check=list(HealthCheck))
@given(mechanisms(dyads=(1, 2)))
def test_motion_is_that_of_the_loops(drawn: Sampled) -> None:
    try:
        moved(drawn)
    except StructureError:
        # it passes a change point, or assembles at no whole degree
        reject()


@pytest.mark.slow
def test_enough_mechanisms_are_compared() -> None:
    assert sum(moved(drawn) for drawn in sample(30, seed=5, dyads=(1, 2))) >= 20


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.slow
def test_forces_are_those_of_newton_and_euler(seed: int) -> None:
    pick, compared = random.Random(seed), 0
    for k, drawn in enumerate(sample(6, seed=300 + seed, dyads=(1, 2))):
        loaded = weighed(drawn, k)
        balance = pick.choice(("force", "moment"))
        order = order_of(loaded, gravity=True, inertia=True, balance=balance)
        state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
        if state.condition > EASY:
            continue
        scene = Scene("random", "", "en", loaded.mechanism, tasks={"forces": order})
        found = graphic_tmm.motion(scene, [drawn.phi], plans=[*PLANS, "forces"], exact=True)
        made = KINEMATICS_PLAN.on(
            recorded(scene, frozenset([*PLANS, "forces"]), exact=True).sheet.project
        )
        judge = dynamics.statics(
            loaded.mechanism,
            state,
            loaded.forces,
            loaded.moments,
            gravity=True,
            inertia=True,
            balance="force" if balance == "force" else "moment",
            at=places(made.structure, made.positions),
        )
        largest = max(abs(one) for one in judge.reactions.values())
        assert found.forces
        for name, one in found.forces.items():
            due = next(f for (i, j), f in judge.reactions.items() if name == f"R{i}{j}")
            assert abs(one[0] - due) <= 1e-8 * largest, (name, k)
        arm = 1.0 if balance == "force" else state.size
        sign = "P" if balance == "force" else "M"
        for way in ("forces", "lever"):
            one = found.balance[f"{sign}_bal_{way}"]
            assert abs(one[0] - judge.balance) <= 1e-8 * largest * arm, (way, k)
        compared += 1
    assert compared >= 3
