"""The oracle judged: closed forms, differences of its own positions, and the power balance."""

from __future__ import annotations

import cmath
import math
from collections import Counter
from dataclasses import replace
from typing import Any

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import given, settings
from support.each import each
from support.examples import most
from support.mechanisms import KINDS, Sampled, mechanisms, sample, sides, sides_kept
from support.oracle import (
    OracleError,
    Rates,
    State,
    equations,
    solve,
    solve_digits,
    solve_fast,
    solve_from_points,
    system_of,
)

from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

PHIS = (-150.0, -20.0, 7.0, 65.0, 90.0, 111.0, 200.0)
MANY = sample(200, seed=1)
DRIVE = Drive(1, -3.0, 7.0)
CRANK = Link(1, {"O": 0, "A": 0.2})


def motion(place: Any, phi_deg: float, drive: Drive) -> list[complex]:
    """r, v, a of a closed form place(φ) by the chain rule, its derivatives by mpmath."""
    with mpmath.workdps(40):
        r, d, dd = mpmath.taylor(place, mpmath.radians(mpmath.mpf(phi_deg)), 2)
        speed, gain = drive.speed, drive.acceleration
        return [complex(r), complex(d * speed), complex(2 * dd * speed**2 + d * gain)]


def unit(angle: Any) -> Any:
    return mpmath.expj(angle)


def slider_crank() -> Mechanism:
    """l = 0.5, the slider's pin 0.04 below its own origin, which lies 0.1 left of a line at 0."""
    line = Guide("x", 0.3 - 0.02j, 0.0)
    rod = Link(2, {"A": 0, "B": 0.5, "S2": 0.2 + 0.1j})
    block = Link(3, {"B": 0.03 - 0.04j}, slides=(Slide(0, line, 0.1, 0.0),))
    return Mechanism(Link(0, {"O": 0}, (line,)), (CRANK, rod, block), DRIVE)


@pytest.mark.parametrize("phi", PHIS)
def test_slider_crank_has_its_closed_form(phi: float) -> None:
    def pin(t: Any) -> Any:
        height = mpmath.mpf(-0.02) + 0.1 + mpmath.mpf(-0.04)
        a = mpmath.mpf(0.2) * unit(t)
        return mpmath.mpc(a.real + mpmath.sqrt(0.25 - (height - a.imag) ** 2), height)

    due = motion(pin, phi, DRIVE)
    a = 0.2 * cmath.exp(1j * math.radians(phi))
    state = solve_from_points(slider_crank(), phi, {"A": a, "B": due[0]})
    for found in (state, solve(slider_crank(), phi, state.pose)):
        assert found.points["B"] == pytest.approx(due, abs=1e-12)
        assert found.points["B", 2] == pytest.approx(due, abs=1e-12)
        assert (found.omega[3], found.epsilon[3]) == pytest.approx((0, 0), abs=1e-12)


def test_a_slider_turned_on_an_inclined_guide_stands_as_its_docstring_says() -> None:
    # the guide runs up (90 degrees) through (1, 0); left of it is smaller x; own x axis points left
    line = Guide("y", 1 + 0j, 90.0)
    block = Link(3, {"B": 0.1 + 0.3j}, slides=(Slide(0, line, 0.2, 90.0),))
    rod = Link(2, {"A": 0, "B": 0.9})
    links = (CRANK, rod, block)
    state = solve_from_points(
        Mechanism(Link(0, {"O": 0}, (line,)), links, DRIVE),
        0.0,
        {"A": 0.2, "B": complex(1 - 0.2 - 0.1, math.sqrt(0.81 - 0.25))},
    )
    assert state.pose[3][0] == pytest.approx(0.8)
    assert math.remainder(state.pose[3][2] - math.pi, 2 * math.pi) == pytest.approx(0, abs=1e-12)
    assert state.points["B"].r.real == pytest.approx(0.7)


@each("phi", PHIS)
@each("side", [1, -1])
def test_four_bar_has_its_closed_form(phi: float, side: int) -> None:
    c, rod, rocker = mpmath.mpc(0.6, 0.1), mpmath.mpf(0.5), mpmath.mpf(0.45)

    def pin(t: Any) -> Any:
        chord = c - mpmath.mpf(0.2) * unit(t)
        d = abs(chord)
        along = (d**2 + rod**2 - rocker**2) / (2 * d)
        up = side * mpmath.sqrt(rod**2 - along**2)
        return mpmath.mpf(0.2) * unit(t) + chord / d * (along + 1j * up)

    def trace(t: Any) -> Any:
        a = mpmath.mpf(0.2) * unit(t)
        return a + (pin(t) - a) / rod * (mpmath.mpf(0.3) - 0.125j)

    links = (
        CRANK,
        Link(2, {"A": 0, "B": 0.5, "E": 0.3 - 0.125j}),
        Link(3, {"C": 0, "B": 0.45}),
    )
    mechanism = Mechanism(Link(0, {"O": 0, "C": 0.6 + 0.1j}), links, DRIVE)
    with mpmath.workdps(40):
        start = complex(pin(mpmath.radians(phi)))
    a = 0.2 * cmath.exp(1j * math.radians(phi))
    state = solve_from_points(mechanism, phi, {"A": a, "B": start, "C": 0.6 + 0.1j})
    # abs(.) has no derivative along the complex plane: differences of the real and imaginary parts
    for letter, place in (("B", pin), ("E", trace)):
        parts = [motion(lambda t, f=place: f(t).real, phi, DRIVE)]
        parts += [motion(lambda t, f=place: f(t).imag, phi, DRIVE)]
        due = [x + 1j * y for x, y in zip(*parts, strict=True)]
        assert state.points[letter] == pytest.approx(due, abs=1e-11)


def rocker(*, owner: int) -> Mechanism:
    """Crank O A, rocker with its pivot C 0.5 below; the guide 0.05 left of C A, on either link."""
    frame = Link(0, {"O": 0, "C": -0.5j})
    if owner == 3:
        line = Guide("l", 0.05j, 0.0)
        stone = Link(2, {"A": 0}, slides=(Slide(3, line, 0.0, 0.0, Side(1)),))
        beam = Link(3, {"C": 0, "D": 0.9}, (line,))
    else:
        line = Guide("l", 0j, 0.0)
        stone = Link(2, {"A": 0}, (line,))
        beam = Link(3, {"C": -0.05j, "D": 0.9 - 0.05j}, slides=(Slide(2, line, 0.0, 0.0),))
    return Mechanism(frame, (CRANK, stone, beam), DRIVE)


@each("phi", PHIS)
@each("owner", [2, 3])
def test_rocker_has_its_closed_form(phi: float, owner: int) -> None:
    def angle(t: Any) -> Any:
        chord = mpmath.mpf(0.2) * unit(t) + 0.5j
        return mpmath.arg(chord) - mpmath.asin(mpmath.mpf(0.05) / abs(chord))

    turn, omega, epsilon = (x.real for x in motion(angle, phi, DRIVE))
    a = 0.2 * cmath.exp(1j * math.radians(phi))
    end = -0.5j + 0.9 * cmath.exp(1j * turn)
    state = solve_from_points(rocker(owner=owner), phi, {"A": a, "C": -0.5j, "D": end})
    for number in (2, 3):
        assert math.remainder(state.pose[number][2] - turn, math.tau) == pytest.approx(0, abs=1e-12)
        assert state.omega[number] == pytest.approx(omega, abs=1e-11)
        assert state.epsilon[number] == pytest.approx(epsilon, abs=1e-11)
    # the point of the rocker under A: velocity along the rocker is the crank pin's difference only
    under = state.points["A", 3]
    assert under.v == pytest.approx(1j * omega * (a + 0.5j), abs=1e-11)
    assert under.a == pytest.approx((1j * epsilon - omega**2) * (a + 0.5j), abs=1e-10)
    slip = (state.points["A"].v - under.v) * cmath.exp(-1j * turn)
    assert slip.imag == pytest.approx(0, abs=1e-11)
    relative = (state.points["A"].a - under.a - 2j * omega * (state.points["A"].v - under.v)) * (
        cmath.exp(-1j * turn)
    )
    assert relative.imag == pytest.approx(0, abs=1e-10)


def at_time(drawn: Sampled, step: float, start: State) -> Rates:
    """The position `step` seconds later, 45 digits; positions know the drive's rates only so."""
    drive = drawn.mechanism.drive

    def angle() -> Any:
        t = mpmath.mpf(step)
        return mpmath.radians(drawn.phi) + drive.speed * t + drive.acceleration * t**2 / 2

    return solve_digits(drawn.mechanism, angle, start.pose, dps=45)


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("drawn", sample(8, seed=2), ids=lambda drawn: "-".join(drawn.kinds))
def test_rates_are_differences_of_positions(drawn: Sampled) -> None:
    state = solve(drawn.mechanism, drawn.phi, drawn.poses)
    step = 2.0**-36
    with mpmath.workdps(50):
        before, now, after = (at_time(drawn, t, state).q for t in (-step, 0.0, step))
        first = np.array((after - before) / (2 * mpmath.mpf(step)), dtype=float)
        second = np.array((after - 2 * now + before) / mpmath.mpf(step) ** 2, dtype=float)
    for due, found in ((first, state.rates.dq), (second, state.rates.ddq)):
        np.testing.assert_allclose(
            np.asarray(found, dtype=float), due, rtol=1e-8, atol=1e-8 * float(np.max(np.abs(due)))
        )


@each("drawn", sample(40, seed=3))
def test_the_jacobian_is_the_complex_step_of_the_equations(drawn: Sampled) -> None:
    """Loops are written a second time, with complex numbers, and differentiated by a tiny step."""
    mechanism, size = drawn.mechanism, system_of(drawn.mechanism).size
    state = solve_fast(mechanism, drawn.phi, drawn.poses)
    numbers = [mechanism.frame.number, *(link.number for link in mechanism.links)]
    base = np.asarray(state.rates.q, dtype=complex)
    _, jacobian = equations(system_of(mechanism), base.real, math.radians(drawn.phi))
    for column in range(3, base.size):
        q = base.copy()
        q.flat[column] += 1e-30j
        pose = dict(zip(numbers, q, strict=True))
        slope = [value.imag * 1e30 for value in loops(mechanism, pose, size)]
        np.testing.assert_allclose(jacobian[:-1, column - 3], slope, rtol=1e-12, atol=1e-12)


def loops(mechanism: Mechanism, pose: dict[int, Any], size: float) -> list[complex]:
    """Residuals in the order of `oracle.equations` without the crank; complex numbers will do."""

    def seen(number: int, own: complex) -> tuple[Any, Any]:
        (x, y, t), p = pose[number], own / size
        return x + p.real * np.cos(t) - p.imag * np.sin(t), y + p.real * np.sin(
            t
        ) + p.imag * np.cos(t)

    links = (mechanism.frame, *mechanism.links)
    pins, angles, offsets = [], [], []
    for letter in dict.fromkeys(letter for link in links for letter in link.points):
        first, *rest = (
            seen(link.number, link.points[letter]) for link in links if letter in link.points
        )
        pins += [(x - first[0], y - first[1]) for x, y in rest]
    for slider, slide in ((link, slide) for link in links for slide in link.slides):
        direction = pose[slide.on][2] + math.radians(slide.guide.angle)
        through, (x, y, t) = seen(slide.on, slide.guide.through), pose[slider.number]
        angles.append(t - direction - math.radians(slide.angle))
        left = (y - through[1]) * np.cos(direction) - (x - through[0]) * np.sin(direction)
        offsets.append(left - slide.offset / size)
    return [*(x for x, _ in pins), *(y for _, y in pins), *angles, *offsets]


def test_drawn_points_satisfy_all_constraints() -> None:
    assert Counter(kind for drawn in MANY for kind in drawn.kinds).keys() == set(KINDS)
    for drawn in MANY:
        mechanism = drawn.mechanism
        size = system_of(mechanism).size
        pose = {n: (x / size, y / size, t) for n, (x, y, t) in drawn.poses.items()}
        residual = np.array(loops(mechanism, pose, size))
        slides = sum(len(link.slides) for link in mechanism.links)
        turns = slice(len(residual) - 2 * slides, len(residual) - slides)
        residual[turns] -= math.tau * np.rint(residual[turns] / math.tau)
        assert np.max(np.abs(residual)) < 1e-12
        for letter, place in drawn.points.items():
            for link in (mechanism.frame, *mechanism.links):
                if letter in link.points:
                    x, y, turn = drawn.poses[link.number]
                    own = complex(x, y) + link.points[letter] * cmath.exp(1j * turn)
                    assert abs(own - place) < 1e-12 * size
        angle = cmath.phase(drawn.points["A"] - drawn.points["O"]) - math.radians(drawn.phi)
        assert abs(math.remainder(angle, math.tau)) < 1e-12


def test_sides_are_told_from_poses() -> None:
    kinds = Counter(kind for drawn in MANY for kind in drawn.kinds)
    told = Counter(kind for drawn in MANY for kind, _ in sides(drawn, drawn.poses))
    assert told == {kind: kinds[kind] for kind in ("RRR", "RRP", "RPR")}
    assert all(sides_kept(drawn, drawn.poses) for drawn in MANY)


@pytest.mark.parametrize("kind", ["RRR", "RRP", "RPR"])
def test_the_other_assembly_breaks_the_side(kind: str) -> None:
    found = 0
    for drawn in sample(30, seed=4, dyads=(1, 1), kinds=(kind,)):
        for turn in (0.0, 2.0, 4.0):  # from poses turned by far Newton often ends in the other one
            start = {n: (x, y, t + turn * (n > 1)) for n, (x, y, t) in drawn.poses.items()}
            try:
                state = solve_fast(drawn.mechanism, drawn.phi, start)
            except OracleError:
                continue
            away = max(abs(state.points[p].r - r) for p, r in drawn.points.items()) / state.size
            assert sides_kept(drawn, state.pose) == (away < 1e-9)
            found += away > 1e-9
    assert found > 5


@settings(max_examples=most(40), deadline=None)
@given(mechanisms())
def test_the_strategy_draws_what_the_oracle_solves(drawn: Sampled) -> None:
    state = solve_from_points(drawn.mechanism, drawn.phi, drawn.points, tolerance=1e-9)
    for letter, place in drawn.points.items():
        assert abs(state.points[letter].r - place) < 1e-10 * state.size
    assert state.condition < 1e5


@pytest.mark.slow
def test_digits_and_float64_agree() -> None:
    for drawn in sample(15, seed=5, dyads=(1, 2)):
        quick = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
        state = solve(drawn.mechanism, drawn.phi, drawn.poses)
        for due, found in zip(state.rates, quick.rates, strict=True):
            exact = np.asarray(due, dtype=float)
            near = 1e-11 * float(np.max(np.abs(exact)))
            np.testing.assert_allclose(found, exact, rtol=0, atol=near)


def energy(drawn: Sampled, state: State) -> float:
    """Kinetic energy of all links, J."""
    return sum(
        float(link.mass or 0) / 2 * abs(state.points[str(link.centre)].v) ** 2
        + float(link.inertia or 0) / 2 * state.omega[link.number] ** 2
        for link in drawn.mechanism.links
    )


def test_power_is_the_growth_of_the_kinetic_energy() -> None:
    for drawn in MANY[:100]:
        drive = drawn.mechanism.drive
        state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
        power = 0.0
        for link in drawn.mechanism.links:
            _, v, a = state.points[str(link.centre)]
            power += float(link.mass or 0) * (v.conjugate() * a).real
            power += (
                float(link.inertia or 0) * state.omega[link.number] * state.epsilon[link.number]
            )
        step = 1e-5 / abs(drive.speed)
        around = []
        for t in (-step, step):
            turn = drive.speed * t + drive.acceleration * t**2 / 2
            speed = drive.speed + drive.acceleration * t
            later = replace(drawn.mechanism, drive=replace(drive, speed=speed))
            around.append(solve_fast(later, drawn.phi + math.degrees(turn), drawn.poses))
        growth = (energy(drawn, around[1]) - energy(drawn, around[0])) / (2 * step)
        assert power == pytest.approx(
            growth, rel=1e-5, abs=1e-5 * energy(drawn, state) / step / 1e5
        )


def test_what_does_not_fit_is_refused() -> None:
    mechanism = slider_crank()
    good = {"A": 0.2 + 0j, "B": 0.2 + math.sqrt(0.25 - 0.04**2) + 0.04j}
    state = solve_from_points(mechanism, 0.0, good, tolerance=1e-12)
    for wrong in (good["B"] + 0.003, good["B"].conjugate()):
        with pytest.raises(OracleError, match=r"lies|stands"):
            solve_from_points(mechanism, 0.0, good | {"B": wrong})
    with pytest.raises(OracleError, match="lies"):  # another position of the crank
        solve_from_points(mechanism, 10.0, good)
    with pytest.raises(OracleError, match="no link"):
        solve_from_points(mechanism, 0.0, good | {"Q": 0j})
    with pytest.raises(OracleError, match="not numbers"):
        solve_from_points(mechanism, 0.0, good | {"B": complex(math.nan, 0)})
    with pytest.raises(OracleError, match=r"links \[2\]"):
        solve_from_points(mechanism, 0.0, {"A": 0.2 + 0j})
    crank, rod, block = mechanism.links
    with pytest.raises(OracleError, match="5 equations for 6 unknowns"):
        solve_fast(Mechanism(mechanism.frame, (crank, rod), DRIVE), 0.0, state.pose)
    short = replace(rod, points={"A": 0, "B": 0.03})  # does not reach the line of B at 90 degrees
    with pytest.raises(OracleError, match=r"do not close|singular"):
        solve(Mechanism(mechanism.frame, (crank, short, block), DRIVE), 90.0, state.pose)
