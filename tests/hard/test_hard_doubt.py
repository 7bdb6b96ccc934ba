"""What no finding names is right to a millionth: random mechanisms, and these near to where they lock.

The judges work at 50 digits: the loops solved by Newton, then the equations of motion and of all forces.
Errors count as shares of the largest quantity of their kind at that position; it is the promise of the
findings that none above 1e-6 stands there unnamed. Shaking is far more than rounding, so most of what is
named is still right: of that nothing is asked, but that a mechanism far from any change point has no finding.
"""

from __future__ import annotations

import math
from dataclasses import replace

import mpmath as mp  # type: ignore[import-untyped]
import pytest
from support import dynamics
from support.hard_judge import DIGITS, Verdict, exact_of, judge
from support.loaded import Solved, errors, order_of, places, solve, weighed
from support.locks import locks, solved_at
from support.mechanisms import Sampled, sample
from support.wrenches import StaticsError

from graphic_tmm.board.findings import DOUBTFUL, Finding, examine
from graphic_tmm.chapters.forces.task import Friction
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect

OFFS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
"""How far from locking, rad."""


def moved(mechanism: Mechanism, degrees: float) -> Verdict | None:
    found = solved_at(mechanism, degrees)
    if found is None:
        return None
    with mp.workdps(DIGITS + 5):
        return judge(mechanism, degrees, exact_of(mechanism, found[1]))


def rubbing(mechanism: Mechanism, f: float) -> Friction:
    """Friction in every pair, pins of 2 % of the mechanism's size."""
    size = max(abs(z) for link in mechanism.links for z in link.points.values())
    pairs = dissect(mechanism).pairs
    return Friction(
        {p.name: f for p in pairs}, {p.name: 0.02 * size for p in pairs if p.kind == "R"}, 30
    )


def forced(
    drawn: Sampled, degrees: float, seed: int, f: float = 0.0
) -> tuple[float, Solved] | None:
    """Draw all forces of a position; return the largest error, as a share of the largest force.

    It is infinite where no forces are in equilibrium.
    """
    found = solved_at(drawn.mechanism, degrees)
    if found is None:
        return None
    one = weighed(drawn, seed)
    friction = rubbing(drawn.mechanism, f) if f else None
    order = order_of(one, gravity=True, inertia=True, friction=friction)
    solved = solve(one, degrees, found[0], order, judged=False)
    try:
        with mp.workdps(DIGITS):
            judge_ = dynamics.statics(
                one.mechanism,
                replace(solved.state, rates=found[1]),
                one.forces,
                one.moments,
                gravity=True,
                inertia=True,
                balance="force",
                friction=None
                if friction is None
                else dynamics.Friction(friction.f, friction.radius),
                at=places(solved.structure, solved.positions),
                digits=True,
            )
    except StaticsError:
        return math.inf, solved
    forces = {k: complex(v) for k, v in judge_.reactions.items()}
    told = judge_._replace(reactions=forces, balance=float(judge_.balance))
    return max(errors(solved._replace(judge=told)).values()), solved


def named(solved: Solved) -> tuple[Finding, ...]:
    given = {mark: solved.reading[mark] for mark in solved.log.given}
    return examine(solved.log, given, [step.it for step in solved.log.steps])


def near(count: int, seed: int, most: int = 2) -> list[tuple[Sampled, float, float]]:
    """Return random mechanisms that lock, each with a crank angle so many rad before."""
    found = []
    for k, drawn in enumerate(sample(count, seed=seed, dyads=(1, most))):
        end, off = locks(drawn.mechanism, drawn.phi), OFFS[k % len(OFFS)]
        if end is not None:
            found.append((drawn, end - math.degrees(off), off))
    return found


@pytest.mark.slow
def test_far_from_a_change_point_nothing_is_named() -> None:
    for drawn in sample(15, seed=0, dyads=(1, 3)):
        found = moved(drawn.mechanism, drawn.phi)
        assert found is not None
        assert not found.findings, (drawn.kinds, found.findings)
        assert found.off <= 1e-10


@pytest.mark.slow
def test_near_to_where_it_locks_what_is_not_named_is_right() -> None:
    counts = [0, 0]
    for drawn, angle, _ in near(30, 100):
        found = moved(drawn.mechanism, angle)
        if found is not None:
            assert found.findings or found.off <= DOUBTFUL, (drawn.kinds, angle, found.off)
            counts[bool(found.findings)] += 1
    assert min(counts) >= 5, counts


@pytest.mark.slow
def test_forces_that_are_not_named_are_right() -> None:
    _forces_right(near(20, 200), 0.0)


@pytest.mark.slow
def test_forces_with_friction_that_are_not_named_are_right() -> None:
    """A tenth of the friction that would lock the mechanism: its lines meet at √off or so."""
    _forces_right(near(9, 300, most=1), 0.1)


def _forces_right(cases: list[tuple[Sampled, float, float]], share: float) -> None:
    counts = [0, 0]
    for k, (drawn, angle, off) in enumerate(cases):
        found = forced(drawn, angle, k, share * math.sqrt(off))
        if found is not None:
            told = named(found[1])
            assert told or found[0] <= DOUBTFUL, (drawn.kinds, angle, found[0])
            counts[bool(told)] += 1
    assert min(counts) >= 1, counts
