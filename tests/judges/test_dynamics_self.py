"""The judge of kinetostatics judged: closed forms and energy."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from typing import Any

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from support.dynamics import Friction, statics
from support.each import each
from support.oracle import State, solve_fast, solve_from_points
from support.wrenches import StaticsError

from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Slide

G, R, L = 9.81, 0.2, 0.5
PHIS = (-150.0, -20.0, 7.0, 65.0, 90.0, 111.0, 200.0)
DRIVE = Drive(1, -3.0, 7.0)
PLAIN: Any = {"gravity": False, "inertia": False}


def engine(tilt: float = 0.0) -> Mechanism:
    """A slider-crank in line, its guide inclined by ``tilt`` degrees."""
    line = Guide("x", 0, tilt)
    crank = Link(1, {"O": 0, "A": R, "S1": R / 4}, mass=3.0, inertia=0.02, centre="S1")
    rod = Link(2, {"A": 0, "B": L, "S2": 0.2 + 0.1j}, mass=2.0, inertia=0.05, centre="S2")
    block = Link(3, {"B": 0, "E": 0.1 + 0.05j}, slides=(Slide(0, line),), mass=5.0, centre="B")
    return Mechanism(Link(0, {"O": 0}, (line,)), (crank, rod, block), DRIVE)


def lever(speed: float = 2.0) -> Mechanism:
    return Mechanism(Link(0, {"O": 0}), (Link(1, {"O": 0, "A": 0.4, "C": -0.7}),), Drive(1, speed))


def bare(mechanism: Mechanism) -> Mechanism:
    """Only the block keeps its mass."""
    crank, rod, block = mechanism.links
    return replace(mechanism, links=(replace(crank, mass=None), replace(rod, mass=None), block))


def stand(mechanism: Mechanism, phi: float, tilt: float = 0.0) -> State:
    """The engine with its block ahead, the crank at phi from the guide."""
    a, turn = cmath.rect(R, math.radians(phi)), cmath.rect(1.0, math.radians(tilt))
    b = a.real + math.sqrt(L**2 - a.imag**2)
    return solve_from_points(mechanism, phi + tilt, {"A": a * turn, "B": b * turn})


@pytest.mark.parametrize("phi", PHIS)
def test_a_slider_crank_carries_what_the_textbook_says(phi: float) -> None:
    p, t = 700.0, math.radians(phi)
    beta = math.asin(R * math.sin(t) / L)
    n, tangential = p * math.tan(beta), p * math.sin(t + beta) / math.cos(beta)
    state, push = stand(engine(), phi), [(3, "B", -p + 0j)]
    found = statics(engine(), state, push, **PLAIN, balance="force", at={"x": "B"})
    assert found.balance == pytest.approx(-tangential, abs=1e-10 * p)
    assert found.reactions[0, 3] == pytest.approx(1j * n, abs=1e-10 * p)
    assert found.reactions[2, 3] == pytest.approx(p - 1j * n, abs=1e-10 * p)
    assert found.reactions[3, 2] == -found.reactions[2, 3]
    assert found.reactions[0, 1].imag + found.balance * math.cos(t) == pytest.approx(-n, abs=1e-7)
    assert found.couples[0, 3] == pytest.approx(0, abs=1e-10 * p)
    about = statics(engine(), state, push, **PLAIN, balance="moment")
    assert about.balance == pytest.approx(-tangential * R, abs=1e-10 * p)
    assert about.couples[0, 3] == pytest.approx(n * state.points["B"].r.real, abs=1e-10 * p)
    turned = statics(engine(), state, push, [(3, 11.0)], **PLAIN, balance="moment", at={"x": "E"})
    assert turned.couples[0, 3] == pytest.approx(-11 - 0.1 * n, abs=1e-10 * p)  # E is 0.1 ahead


@each("tilt", [0.0, 35.0])
@each("phi", PHIS)
@each("gravity, inertia", [(True, False), (False, True), (True, True)])
def test_the_balancing_moment_is_the_power_of_the_energy(
    phi: float, tilt: float, gravity: bool, inertia: bool
) -> None:
    """M ω = d(T + V)/dt with the energies in closed form, differentiated by mpmath."""
    lean = mpmath.mpf(tilt) * mpmath.pi / 180

    def places(t: Any) -> tuple[Any, ...]:
        a = R * mpmath.expj(t)
        b = a.real + mpmath.sqrt(L**2 - a.imag**2)
        rod = (b - a) / L
        return tuple(z * mpmath.expj(lean) for z in (a / 4, a + (0.2 + 0.1j) * rod, b, rod))

    def height(t: Any) -> Any:
        s1, s2, b, _ = places(t)
        return G * (3 * s1.imag + 2 * s2.imag + 5 * b.imag)

    def inertia_of(t: Any) -> Any:
        s1, s2, b, turn = (
            mpmath.mpc(
                *(
                    mpmath.diff(lambda u, k=k, part=part: getattr(places(u)[k], part), t)
                    for part in ("real", "imag")
                )
            )
            for k in range(4)
        )
        return 3 * abs(s1) ** 2 + 0.02 + 2 * abs(s2) ** 2 + 0.05 * abs(turn) ** 2 + 5 * abs(b) ** 2

    with mpmath.workdps(40):
        t = mpmath.mpf(phi) * mpmath.pi / 180
        due = gravity * mpmath.diff(height, t)
        if inertia:
            speed, gain = DRIVE.speed, DRIVE.acceleration
            due += inertia_of(t) * gain + mpmath.diff(inertia_of, t) * speed**2 / 2
    state = stand(engine(tilt), phi, tilt)
    found = statics(engine(tilt), state, [], gravity=gravity, inertia=inertia, balance="moment")
    assert found.balance == pytest.approx(float(due), abs=1e-8)
    pushed = statics(engine(tilt), state, [], gravity=gravity, inertia=inertia, balance="force")
    assert pushed.balance * R == pytest.approx(float(due), abs=1e-8)


def test_a_lever_is_in_balance() -> None:
    state = solve_fast(lever(), 30.0, {1: (0, 0, math.radians(30))})
    found = statics(lever(), state, [(1, "C", -21j)], **PLAIN, balance="force")
    turn = cmath.rect(1.0, math.radians(30))
    assert found.balance * 0.4 == pytest.approx(-0.7 * 21 * turn.real)
    assert found.reactions[0, 1] == pytest.approx(21j - found.balance * 1j * turn)
    assert found.reactions[1, 0] == -found.reactions[0, 1]


@pytest.mark.parametrize("speed", [2.0, -2.0, 0.0])
def test_a_journal_drags_with_its_friction_couple(speed: float) -> None:
    state = solve_fast(lever(speed), 0.0, {1: (0, 0, 0)})
    friction, load, sense = Friction({"O": 0.3}, {"O": 0.05}), 21.0, math.copysign(1, speed)
    sense *= speed != 0
    found = statics(
        lever(speed), state, [(1, "C", -1j * load)], **PLAIN, balance="moment", friction=friction
    )
    assert found.balance == pytest.approx(-0.7 * load + sense * 0.015 * load)
    assert found.drags[0, 1] == pytest.approx(-sense * 0.015 * load) == -found.drags[1, 0]
    # by a force at A: R = load - P, and 0.4 P = -0.7 load + sense 0.015 |R|, P < 0 < R
    found = statics(
        lever(speed), state, [(1, "C", -1j * load)], **PLAIN, balance="force", friction=friction
    )
    assert found.balance == pytest.approx((-0.7 + sense * 0.015) * load / (0.4 + sense * 0.015))
    # by a force askew to the load: a quadratic equation
    found = statics(
        lever(speed),
        state,
        [(1, "C", load + 0j), (1, "C", 1j * load)],
        **PLAIN,
        balance="force",
        friction=friction,
    )
    p = found.balance
    assert 0.4 * p - 0.7 * load == pytest.approx(sense * 0.015 * math.hypot(load, load + p))


@each("tilt", [0.0, 20.0, -50.0, 140.0])
@each("phi", [40.0, 120.0, 225.0, 300.0])
def test_a_block_on_an_incline_is_pushed_as_the_textbook_says(tilt: float, phi: float) -> None:
    """Q = G sin(α ± ρ)/cos(β ± ρ): up + with the rod pressing the block to the guide."""
    light, f = bare(engine(tilt)), 0.2
    state = stand(light, phi, tilt)
    turn = cmath.rect(1.0, math.radians(tilt))
    beta = math.asin(R * math.sin(math.radians(phi)) / L)  # the rod leans by -β to the guide
    slip = (state.points["B"].v / turn).real
    up = 5j * G / turn  # in the axes of the guide
    for press in (1, -1):  # N = press |N| to the left of the guide
        friction = -math.copysign(1, slip) * f * press
        # Q cos β + friction N = up.real; -Q sin β + N = up.imag
        rows = [[math.cos(beta), friction], [-math.sin(beta), 1]]
        q, n = np.linalg.solve(rows, [up.real, up.imag])
        if n * press > 0:
            break
    else:
        pytest.fail("no sense of N")
    found = statics(
        light,
        state,
        [],
        gravity=True,
        inertia=False,
        balance="force",
        friction=Friction({"x": f}),
        at={"x": "B"},
    )
    assert found.reactions[2, 3] / turn == pytest.approx(cmath.rect(q, -beta), abs=1e-9)
    assert found.reactions[0, 3] / turn == pytest.approx(n * (1j + friction), abs=1e-9)
    assert found.rubs[0, 3] / turn == pytest.approx(n * friction, abs=1e-9)
    assert found.couples[0, 3] == pytest.approx(0, abs=1e-9)
    assert abs(found.power) <= 1e-10 * found.work


def test_climbing_needs_the_textbook_formula() -> None:
    tilt, f = 20.0, 0.2
    light = replace(bare(engine(tilt)), drive=Drive(1, 3.0))
    state = stand(light, -40.0, tilt)  # below the guide, turning forward: the block climbs
    alpha, rho = math.radians(tilt), math.atan(f)
    beta = math.asin(R * math.sin(math.radians(40)) / L)
    found = statics(
        light,
        state,
        [],
        gravity=True,
        inertia=False,
        balance="force",
        friction=Friction({"x": f}),
        at={"x": "B"},
    )
    # the rod comes from below: it lifts the block off the guide
    due = 5 * G * math.sin(alpha + rho) / math.cos(beta - rho)
    assert abs(found.reactions[2, 3]) == pytest.approx(due)


def test_the_friction_runs_through_the_letter() -> None:
    state, push = stand(engine(), 65.0), [(3, "B", -700 + 0j)]
    ways = [
        statics(
            engine(),
            state,
            push,
            **PLAIN,
            balance="force",
            friction=Friction({"x": 0.1}),
            at={"x": letter},
        )
        for letter in "BE"
    ]
    assert ways[0].reactions[0, 3] == pytest.approx(ways[1].reactions[0, 3])
    n, rub = ways[1].reactions[0, 3].imag, ways[1].rubs[0, 3].real
    # both make no moment about B: n stands behind E by its arm, the rub 0.05 above B
    assert ways[1].couples[0, 3] + 0.1 * n - 0.05 * rub == pytest.approx(0, abs=1e-9)


def test_what_cannot_be_solved_is_refused() -> None:
    state = stand(engine(), 65.0)
    with pytest.raises(StaticsError, match="x needs a letter"):
        statics(engine(), state, [], **PLAIN, balance="force", friction=Friction({"x": 0.1}))
    with pytest.raises(StaticsError, match="Z is on no link"):
        statics(engine(), state, [(1, "Z", 1j)], **PLAIN, balance="force")
    # cos(β + ρ) < 0: no force of the rod moves a block that it presses to the guide
    state = stand(engine(), 90.0)
    with pytest.raises(StaticsError, match="no equilibrium"):
        statics(
            engine(),
            state,
            [(3, "B", -1000j)],
            **PLAIN,
            balance="force",
            friction=Friction({"x": 3.0}),
            at={"x": "B"},
        )
