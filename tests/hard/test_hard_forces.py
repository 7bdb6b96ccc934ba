"""Forces in hard cases: polygons of nearly parallel sides, vectors of no length, friction near self-locking.

The judge solves Newton's and Euler's equations of all links at once at 50 digits. The bound is u·κ of the
largest force, u = 8·ε·(steps), κ the product of the conditions of all steps: errors of positions enter the
accelerations, those the forces.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from support import dynamics, oracle
from support.dynamics import Loaded
from support.each import each
from support.hard_judge import DIGITS
from support.hard_mechanisms import (
    FRAMES,
    Frame,
    closed,
    coulisse,
    four_bar,
    put,
    side_at,
    slider_crank,
    weighed,
)
from support.loaded import Solved, errors, order_of, places, solve

from graphic_tmm.board.execute import execute
from graphic_tmm.board.findings import examine
from graphic_tmm.board.geometry import EPS
from graphic_tmm.chapters.forces.task import Friction
from graphic_tmm.mechanism.records import Mechanism


def poses(mechanism: Mechanism, degrees: float) -> tuple[dict[int, Any], Any]:
    """Poses for the oracle in floats, and rates in digits."""
    with mp.workdps(DIGITS + 5):
        phi = mp.mpf(degrees) * mp.pi / 180
        found = closed(mechanism, phi, side_at(mechanism, degrees))
        assert found is not None
        system = oracle.system_of(mechanism, digits=True)
        q = [[mp.mpf(0)] * 3]
        for link in mechanism.links:
            z, along = found[link.number]
            q.append([z.real / system.size, z.imag / system.size, mp.arg(along)])
        start = {
            link.number: (float(x * system.size), float(y * system.size), float(t))
            for link, (x, y, t) in zip(mechanism.links, q[1:], strict=True)
        }
        return start, oracle.rates(mechanism, system, np.array(q, dtype=object), phi)


def judged(loaded: Loaded, degrees: float, **options: Any) -> tuple[Solved, float]:
    """Solve a position and let the judge speak in digits; return the product of all conditions too."""
    start, rates = poses(loaded.mechanism, degrees)
    order = order_of(loaded, gravity=True, inertia=True, balance="force", **options)
    solved = solve(loaded, degrees, start, order, judged=False)
    with mp.workdps(DIGITS):
        friction = order.friction
        rough = None if friction is None else dynamics.Friction(friction.f, friction.radius)
        judge = dynamics.statics(
            loaded.mechanism,
            replace(solved.state, rates=rates),
            loaded.forces,
            loaded.moments,
            gravity=True,
            inertia=True,
            balance="force",
            friction=rough,
            at=places(solved.structure, solved.positions),
            digits=True,
        )
    kappa = 1.0
    with np.errstate(all="ignore"):
        for step in solved.log.steps:
            if step.op.condition is not None:
                value = step.op.condition(*(solved.reading[mark] for mark in step.uses))
                kappa *= max(1.0, float(np.ravel(value)[0]))
    told = judge._replace(
        reactions={k: complex(v) for k, v in judge.reactions.items()}, balance=float(judge.balance)
    )
    return solved._replace(judge=told), kappa


LOCK = math.degrees(math.acos((0.3**2 + 0.4**2 - 0.65**2) / (2 * 0.3 * 0.4)))
"""Where coupler and rocker of the first case come in line, degrees."""
NEARLY = {
    "coupler and rocker nearly in line": (four_bar(0.3, 0.5, 0.15, 0.4), LOCK),
    "rod nearly square to its guide": (slider_crank(0.1, 0.09), math.degrees(math.asin(0.9))),
    "stone near the rocker's pivot": (coulisse(0.1, 0.1, flips=()), 0.0),
}


@each("frame", [FRAMES[k] for k in (0, 1, 5)])
@each("off", [1e-1, 1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("name", NEARLY)
def test_polygons_of_nearly_parallel_sides(name: str, off: float, frame: Frame) -> None:
    mechanism, angle = NEARLY[name]
    sense = 1.0 if "stone" in name else -1.0
    at = frame.angle(angle + sense * math.degrees(off))
    solved, kappa = judged(weighed(put(mechanism, frame)), at)
    found = errors(solved)
    # what is near to a pivot, or far from the frame's origin, loses once more
    reach = 1.0 / off**2 if "stone" in name else 1.0
    assert max(found.values()) <= 8 * EPS * len(solved.log.steps) * kappa * reach, (found, kappa)


@each("frame", FRAMES[:4])
@each("angle", [0.0, 180.0, 90.0, 1e-13, 45.0])
def test_forces_at_dead_centres(angle: float, frame: Frame) -> None:
    solved, kappa = judged(weighed(put(slider_crank(0.3, 0.64), frame)), frame.angle(angle))
    found = errors(solved)
    assert max(found.values()) <= 8 * EPS * len(solved.log.steps) * kappa, found


def _bare(mechanism: Mechanism) -> Loaded:
    links = tuple(replace(link, mass=None, inertia=None) for link in mechanism.links)
    return Loaded(replace(mechanism, links=links), [], [])


@each("angle", [0.0, 90.0, 180.0, 37.0])
@each("mechanism", [slider_crank(0.3, 0.64), four_bar(1, 2.5, 2, 3), coulisse(0.1, 0.3)])
def test_no_load_is_no_force_anywhere(mechanism: Mechanism, angle: float) -> None:
    """All vectors of all polygons have no length: exactly nothing, and no direction is missed."""
    one = _bare(mechanism)
    solved = solve(
        one,
        angle,
        poses(mechanism, angle)[0],
        order_of(one, gravity=True, inertia=True),
        judged=False,
    )
    assert {solved.number(r.value) for r in solved.forces.reactions} == {0.0}
    assert solved.number(solved.forces.first.balance) == 0.0
    for polygon in solved.forces.polygons:
        assert all(solved.vector(tail, head) == 0 for _, tail, head in polygon.sides)


def test_only_the_vectors_without_length_are_points() -> None:
    """At its dead centre a light rod carries the piston's force and nothing across it."""
    mechanism = _bare(slider_crank(0.3, 0.64)).mechanism
    one = Loaded(mechanism, [(3, "B", -100.0 + 0j)], [])
    solved = solve(one, 0.0, poses(mechanism, 0.0)[0], order_of(one), judged=False)
    values = {r.links: solved.vector(r.tail, r.head) for r in solved.forces.reactions}
    assert solved.number(solved.forces.first.balance) == 0.0
    assert {abs(v) for v in values.values()} == {0.0, 100.0}


# friction near self-locking, f·tan β = q: the line of the leaning reaction becomes parallel to the rod at q = 1


ANGLE, CRANK, ROD = 80.0, 0.3, 0.31


def _rubbing(q: float, passes: int) -> tuple[Solved, complex, Any]:
    """Drive a piston against 100 N by a steep rod; return the drawing, the exact balance, the finding."""
    mechanism = _bare(slider_crank(CRANK, ROD)).mechanism
    beta = math.asin(CRANK * math.sin(math.radians(ANGLE)) / ROD)
    one = Loaded(mechanism, [(3, "B", 100.0 + 0j)], [])
    friction = Friction({"x": q / math.tan(beta)}, {}, passes)
    start, _ = poses(mechanism, ANGLE)
    solved = solve(one, ANGLE, start, order_of(one, friction=friction), judged=False)
    with mp.workdps(DIGITS):
        sine = mp.mpf(CRANK) * mp.sin(mp.radians(ANGLE)) / mp.mpf(ROD)
        b = mp.asin(sine)
        f = mp.mpf(friction.f["x"])
        rod = 100 / (mp.cos(b) - f * mp.sin(b))
        due = rod * mp.sin(mp.radians(ANGLE) + b)
    given = {mark: solved.reading[mark] for mark in solved.log.given}
    told = examine(solved.log, given, [solved.forces.first.balance])
    return solved, due, told


@pytest.mark.slow
@pytest.mark.parametrize("passes", [2, 4, 12])
@pytest.mark.parametrize("q", [0.01, 0.1, 0.5, 0.9, 0.99])
def test_what_the_passes_leave_open_holds_the_truth(q: float, passes: int) -> None:
    solved, due, told = _rubbing(q, passes)
    assert solved.forces.first.open is not None
    value, left = (
        solved.number(solved.forces.first.balance),
        solved.number(solved.forces.first.open),
    )
    if math.isnan(value):
        assert q > 0.5
        assert any("do not settle" in f.step.op.fails for f in told)
        return
    rounding = 8 * EPS * len(solved.log.steps) * abs(due) / (1 - q) ** 2
    assert abs(abs(value) - abs(due)) <= left * (1 + rounding) + rounding


@pytest.mark.parametrize("q", [1 - 1e-3, 1 - 1e-6, 1 - 1e-9, 1 - 1e-12])
def test_just_before_a_mechanism_locks_itself(q: float) -> None:
    """Right within 1/(1 − q), and doubted where that is more than half of the digits."""
    solved, due, told = _rubbing(q, 4)
    bound = 8 * EPS * len(solved.log.steps) / (1 - q)
    value = solved.number(solved.forces.first.balance)
    assert abs(value - abs(due)) <= bound * abs(due)
    assert ("doubtful" in {f.kind for f in told}) == (1 - q < 1e-8)


def test_where_it_begins_to_lock_the_lines_are_parallel() -> None:
    solved, _, told = _rubbing(1.0, 4)
    assert math.isnan(solved.number(solved.forces.first.balance))
    assert any("parallel" in f.step.op.fails for f in told)


@pytest.mark.parametrize("q", [1 + 1e-12, 1 + 1e-6, 1.5, 1e6])
def test_a_mechanism_that_locks_itself_is_named(q: float) -> None:
    solved, _, told = _rubbing(q, 4)
    assert math.isnan(solved.number(solved.forces.first.balance))
    assert any("locks itself" in f.step.op.fails for f in told)


def test_self_locking_at_one_position_leaves_the_others() -> None:
    """Along the row the rod is steep near 90° only: there, and only there, no balance stands."""
    mechanism = _bare(slider_crank(CRANK, ROD)).mechanism
    one = Loaded(mechanism, [(3, "B", 100.0 + 0j)], [])
    order = order_of(one, friction=Friction({"x": 0.5}, {}, 6))
    solved = solve(one, ANGLE, poses(mechanism, ANGLE)[0], order, judged=False)
    given = {mark: solved.reading[mark] for mark in solved.log.given}
    given[solved.positions.row[0]] = np.array([[10.0, 30.0, 50.0, 89.0, 91.0]])
    found = execute(solved.log, given, [solved.forces.first.balance])[solved.forces.first.balance]
    beta = np.arcsin(CRANK * np.sin(np.radians([10.0, 30.0, 50.0, 89.0, 91.0])) / ROD)
    assert np.isfinite(found[0]).tolist() == (0.5 * np.tan(beta) < 0.9).tolist()
