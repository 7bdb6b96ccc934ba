"""Centres of curvature, poles and circles against judges: all links at once, paths by 60 digits."""

from __future__ import annotations

import cmath
import copy
import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpc, mpf
from support.against_judge import parameter, ways
from support.random_mechanisms import KINDS, drawn

import graphic_tmm
from graphic_tmm.errors import TmmError

BAR = (0.1, 0.28, 0.2, 0.3)
"""Crank, coupler, rocker, frame of the four-bar of the field's acceptance, m."""


def four_bar(lengths: Sequence[float], point: complex, **asked: Any) -> dict[str, Any]:
    """A four-bar with a point K on its coupler."""
    a, b, c, d = lengths
    return {
        "title": "T", "language": "en",
        "frame": {"O": [0, 0], "D": [d, 0]},
        "link": [
            {"number": 1, "points": {"O": [0, 0], "A": [a, 0]}},
            {"number": 2, "side": "left of AD",
             "points": {"A": [0, 0], "B": [b, 0], "K": [point.real, point.imag]}},
            {"number": 3, "points": {"B": [c, 0], "D": [0, 0]}},
        ],
        "drive": {"link": 1, "speed": "10 rad/s", "turns": "counterclockwise", "zero": "0 deg",
                  "positions": 12},
        "curvature": {"link": 2, "positions": [2], **asked},
    }  # fmt: skip


def slider_crank(point: complex, **asked: Any) -> dict[str, Any]:
    """A slider-crank in line, crank and half of the rod alike: each point of the rod goes along an ellipse."""
    return {
        "title": "T", "language": "en",
        "frame": {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"}},
        "link": [
            {"number": 1, "points": {"O": [0, 0], "A": [0.1, 0]}},
            {"number": 2, "points": {"A": [0, 0], "B": [0.1, 0], "K": [point.real, point.imag]}},
            {"number": 3, "points": {"B": [0, 0]},
             "slides": {"on": "frame", "along": "x", "side": "right"}},
        ],
        "drive": {"link": 1, "speed": "10 rad/s", "turns": "counterclockwise", "from": "10 deg",
                  "to": "80 deg", "positions": 8},
        "curvature": {"points": ["K"], "positions": [1], **asked},
    }  # fmt: skip


def told(scene: dict[str, Any], at: Sequence[float]) -> Any:
    """What `motion` says of curvature."""
    plans: list[Any] = ["positions", "curvature"]
    return graphic_tmm.motion(graphic_tmm.read(scene), at, plans=plans, exact=True)


def coupler(lengths: Sequence[float], own: Any) -> Callable[[Any], tuple[Any, Any]]:
    """Where a point of the coupler is at an angle of the crank, x and y, by the triangle of A, B and D."""
    a, b, c, d = map(mpf, lengths)

    def at(phi: Any) -> tuple[Any, Any]:
        ax, ay = a * mp.cos(phi), a * mp.sin(phi)
        rx, ry = d - ax, -ay
        r2 = rx**2 + ry**2
        along = (r2 + b**2 - c**2) / (2 * b * mp.sqrt(r2))
        left = mp.sqrt(1 - along**2)
        ux, uy = rx / mp.sqrt(r2), ry / mp.sqrt(r2)
        cx, cy = ux * along - uy * left, uy * along + ux * left
        return ax + own.real * cx - own.imag * cy, ay + own.real * cy + own.imag * cx

    return at


def derivatives(path: Callable[[Any], tuple[Any, Any]], phi: Any, count: int) -> list[Any]:
    """The derivatives of a path by the crank's angle, x + iy."""
    with mp.workdps(60):
        x, y = (
            [mp.diff(lambda p, k=k: path(p)[k], mpf(phi), n) for n in range(count + 1)]
            for k in (0, 1)
        )
    return [mpc(u, v) for u, v in zip(x, y, strict=True)]


def curvature(path: Callable[[Any], tuple[Any, Any]], phi: Any) -> Any:
    """The curvature of a path, signed, 1/m."""
    _, first, second = derivatives(path, phi, 2)
    return (mp.conj(first) * second).imag / abs(first) ** 3


def test_the_figures_of_the_field() -> None:
    found = told(four_bar(BAR, 0.14 + 0.07j), [60.0])
    due = {"P": 0.316596 + 0.548361j, "K_0": 0.126197 + 0.159237j,
           "K_0′": 0.126197 + 0.159237j, "Π": 0.331497 - 0.126560j}  # fmt: skip
    for name, place in due.items():
        assert abs(found.centres[name][0] - place) < 1e-6, name
    assert abs(found.columns["rho_K"][0] - 0.053472) < 5e-7


@pytest.mark.parametrize("phi", [20.0, 75.0, 160.0, 250.0, 310.0])
def test_radii_by_a_loop_differentiated_with_many_digits(phi: float) -> None:
    lengths, own = (0.1, 0.23, 0.25, 0.21), 0.05 + 0.05j
    found, angle = told(four_bar(lengths, own), [phi]), math.radians(phi)
    path = coupler(lengths, own)
    place, way, _ = map(complex, derivatives(path, angle, 2))
    radius = 1.0 / float(curvature(path, angle))
    centre = place + radius * 1j * way / abs(way)
    size = max(1.0, abs(radius))
    assert abs(found.columns["rho_K"][0] - abs(radius)) < 1e-11 * size
    for name in ("K_0", "K_0′"):
        assert abs(found.centres[name][0] - centre) < 1e-10 * size


def fixed_on_coupler(found: Any, k: int, place: complex) -> complex:
    """A place on the sheet in the axes of the coupler."""
    a, b = found.places["A", 2][k], found.places["B", 2][k]
    return complex((place - a) * abs(b - a) / (b - a))


def test_no_acceleration_at_its_pole_and_none_along_the_normal_on_the_circle() -> None:
    lengths = (0.1, 0.23, 0.25, 0.21)
    found = told(four_bar(lengths, 0.05 + 0.05j), [30.0, 110.0, 200.0])
    rng = np.random.default_rng(1)
    for k, phi in enumerate((30.0, 110.0, 200.0)):
        pole, far = found.centres["P"][k], found.centres["J"][k]
        own = fixed_on_coupler(found, k, found.centres["Π"][k])
        assert abs(derivatives(coupler(lengths, own), math.radians(phi), 2)[2]) < 1e-11
        for turn in rng.uniform(0.5, 6.0, 4):
            place = (pole + far) / 2 + (pole - far) / 2 * cmath.exp(1j * turn)
            own = fixed_on_coupler(found, k, place)
            assert abs(curvature(coupler(lengths, own), math.radians(phi))) < 1e-9


def test_balls_point_goes_straight_to_the_third_order() -> None:
    lengths = (0.1, 0.23, 0.25, 0.21)
    scene = four_bar(lengths, 0.05 + 0.05j, ball=True)
    found = told(scene, [30.0, 110.0])
    for k, phi in enumerate((30.0, 110.0)):
        path = coupler(lengths, fixed_on_coupler(found, k, found.centres["U"][k]))
        _, first, second, third = derivatives(path, math.radians(phi), 3)
        bend = (mp.conj(first) * second).imag / abs(first) ** 2
        change = (mp.conj(first) * third).imag / abs(first) ** 2
        assert abs(bend) < 1e-11
        assert abs(change) < 1e-9, "its curvature does not change"


def test_balls_point_wants_two_pivots() -> None:
    with pytest.raises(TmmError, match="Ball's point wants"):
        told(slider_crank(0.05 + 0.02j, ball=True), [30.0])


def test_the_ellipses_of_scott_russell() -> None:
    """A point of the rod, seen from the circle about A, has the half axes 0.1 ± |AK|: ρ = (…)^{3/2}/(pq)."""
    reach, at = 0.04, 35.0
    found = told(slider_crank(complex(-reach, 0.0)), [at])
    p, q, phi = 0.1 - reach, 0.1 + reach, math.radians(at)
    # K = (0.1 − 0.04)·cos φ, (0.1 + 0.04)·sin φ
    radius = (p**2 * math.sin(phi) ** 2 + q**2 * math.cos(phi) ** 2) ** 1.5 / (p * q)
    assert abs(found.places["K", 2][0] - complex(p * math.cos(phi), q * math.sin(phi))) < 1e-14
    assert abs(found.columns["rho_K"][0] - radius) < 1e-13
    for name in ("K_0", "K_0′"):
        c = p**2 - q**2
        due = complex(c / p * math.cos(phi) ** 3, -c / q * math.sin(phi) ** 3)
        assert abs(found.centres[name][0] - due) < 1e-13


def test_a_straight_path_has_no_centre_and_says_so() -> None:
    sheet = graphic_tmm.draw(slider_crank(-0.1 + 0j), exact=True)
    table = sheet.table("curvature")
    assert np.isnan(table["rhoK"].value).all()
    assert any("straight there" in one for one in sheet.warnings)
    assert np.isfinite(table["xP"].value[0]).any()


def judged(seed: int) -> dict[str, float]:
    """How far what is found of every link of a random mechanism is off, of its size."""
    found = next(
        r for k in range(9) if (r := drawn(seed + 1000 * k, ("crank",), 1 + seed % 3, KINDS))
    )
    worst: dict[str, float] = {}

    def note(name: str, off: float) -> None:
        worst[name] = max(worst.get(name, 0.0), off if off == off else math.inf)

    for link in found.scene["link"]:
        scene, n = copy.deepcopy(found.scene), link["number"]
        scene["drive"]["zero"] = math.degrees(found.at[0])
        scene["curvature"] = {"link": n}
        row = ways(found, 5)
        try:
            curved = told(scene, [parameter(found, way) for way in row])
        except TmmError:
            continue
        for k, way in enumerate(row):
            state = found.solved(way)
            letter = next(iter(link["points"]))
            place, speed, gain = state.point(letter, n)
            omega, turning = state.omega[n], 1j * state.epsilon[n] - state.omega[n] ** 2
            if abs(omega) < 1e-9:
                assert np.isnan(curved.centres["P"][k]), (seed, n)
                continue
            pole = place + 1j * speed / omega
            note("P", abs(curved.centres["P"][k] - pole) / (found.scale + abs(pole)))
            rest = place - gain / turning
            note("Π", abs(curved.centres["Π"][k] - rest) / (found.scale + abs(rest)))
            middle = (curved.centres["P"][k] + curved.centres["J"][k]) / 2
            straight = any(np.isnan(one).all() for one in curved.columns.values())
            for turn in () if straight else (1.0, 2.0, 4.0):
                spot = middle + (middle - curved.centres["P"][k]) * cmath.exp(1j * turn)
                v, a = speed + 1j * omega * (spot - place), gain + turning * (spot - place)
                note("circle", abs((a * (1j * v).conjugate()).real) / (abs(v) * abs(a)))
            for name, radii in curved.columns.items():
                letter = name.removeprefix("rho_")
                place, speed, gain = state.point(letter, n)
                normal = 1j * speed / abs(speed)
                part = (gain * normal.conjugate()).real
                if abs(part) <= 1e-9 * abs(gain):  # it slides along a guide of a link that stands
                    assert np.isnan(radii[k]), (seed, n, letter)
                    continue
                radius = abs(speed) ** 2 / part
                size = found.scale + abs(radius)
                note("ρ", abs(radii[k] - abs(radius)) / size)
                name = f"{letter}_0" if len(letter) == 1 else f"{letter[0]}_{{0{letter[1:]}}}"
                for own in {name, f"{name}′"[: None if not straight else -1]} & {*curved.centres}:
                    off = abs(curved.centres[own][k] - place - radius * normal) / size
                    note(own[-1:].replace("}", "0"), off)
    return worst


@pytest.mark.parametrize("seed", range(3))
def test_random_mechanisms_of_all_kinds(seed: int) -> None:
    worst = judged(seed)
    assert worst
    assert all(off < 1e-8 for off in worst.values()), worst


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("block", range(6))
def test_random_mechanisms_oftener(block: int) -> None:
    told_of = set[str]()
    for seed in range(10 + 5 * block, 15 + 5 * block):
        worst = judged(seed)
        assert all(off < 1e-8 for off in worst.values()), (seed, worst)
        told_of |= worst.keys()
    assert {"P", "Π", "circle", "ρ", "′"} <= told_of


@pytest.mark.parametrize("turned", ["turned", "direct"])
def test_turned_plans_and_either_sense_tell_the_same(turned: str) -> None:
    scene = four_bar(BAR, 0.14 + 0.07j)
    scene["drive"]["turns"] = "clockwise"
    scene["plans"] = {"velocities": turned}
    scene["curvature"]["positions"] = [10]
    table = graphic_tmm.draw(scene, exact=True).table("curvature")
    at = table.positions.index("10")
    for name, due in (("rhoK", 0.053472), ("xP", 0.316596), ("yK0", 0.159237)):
        assert abs(table[name].value[0, at] - due) < 1e-6, name
