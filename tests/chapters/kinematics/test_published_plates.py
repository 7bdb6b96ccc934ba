"""Machines of the literature with plates on three legs, as their scenes are drawn."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.gallery import SHEETS
from support.published_plates import (
    BASE,
    LEGS,
    SIX_PLACES,
    Judge,
    State,
    allan,
    hoist,
    pins,
    stephenson,
)

import graphic_tmm as tmm

OMEGA = 4 * math.pi
"""Of 120 rpm, 1/s."""


def scene(name: str) -> tmm.Scene:
    return tmm.read(SHEETS / name / "scene.toml")


def alike(motion: tmm.Motion, name: str, link: int, row: Sequence[tuple[complex, ...]]) -> None:
    """Hold place, velocity and acceleration of a point against its judge, m, s."""
    tables = motion.places, motion.velocities, motion.accelerations
    for table, due, close in zip(tables, zip(*row, strict=True), (1e-11, 1e-9, 3e-6), strict=True):
        size = max(1.0, np.abs(due).max())
        assert np.abs(table[name, link] - np.array(due)).max() < close * size, name


def point(one: State, x: int, y: int | None) -> tuple[complex, complex, complex]:
    """Return place, velocity and acceleration of a point whose coordinates are unknowns."""
    parts = [complex(row[x], 0.0 if y is None else row[y]) for row in one]
    return parts[0], OMEGA * parts[1], OMEGA**2 * parts[2]


def test_the_six_published_places_close_the_legs() -> None:
    for place in SIX_PLACES:
        for pin, pivot, leg in zip(pins(*place), BASE, LEGS, strict=True):
            assert abs(abs(pin - pivot) - leg) < 0.021, place


@pytest.mark.parametrize("place", SIX_PLACES)
def test_a_published_place_of_the_platform_is_drawn(
    place: tuple[float, float, float], tmp_path: Path
) -> None:
    text = (SHEETS / "planar-platform" / "scene.toml").read_text("utf-8")
    near = f'near = "{math.degrees(place[2])!r} deg"'
    (tmp_path / "scene.toml").write_text(re.sub(r'near = ".*"', near, text), "utf-8")
    motion = tmm.motion(tmm.read(tmp_path / "scene.toml"), [1.498], plans="positions", exact=True)
    drawn = [complex(motion.places[letter, 3][0]) * 10 for letter in "ABC"]
    assert abs(drawn[0] - complex(*place[:2])) < 0.02
    turn = cmath.phase((drawn[1] - drawn[0]) * cmath.exp(-1j * place[2]))
    assert abs(turn) < 0.002
    for pin, due in zip(drawn, pins(*place), strict=True):
        assert abs(pin - due) < 0.05


def test_stephensons_link_and_valve_go_as_circles_and_lines_say() -> None:
    at = np.array([71.0, 131.0, 200.0, 290.0, 355.0])
    begin = np.array([1.39, 0.23, 1.39, -0.07, 0.75])
    row = Judge(stephenson).followed(begin, math.radians(71.0), np.radians(at))
    motion = tmm.motion(scene("stephenson-gear"), at, exact=True)
    alike(motion, "C", 4, [point(one, 0, 1) for one in row])
    alike(motion, "D", 4, [point(one, 2, 3) for one in row])
    valve = [die(one) for one in row]
    alike(motion, "K", 7, valve)


def die(one: State) -> tuple[complex, complex, complex]:
    """Return place, velocity and acceleration of the die along the valve's line."""
    (c, d, k), (c1, d1, k1), (c2, d2, k2) = ((row[0], row[2], row[4]) for row in one)
    moved = c1 + k1 * (d - c) + k * (d1 - c1)
    sped = c2 + k2 * (d - c) + 2 * k1 * (d1 - c1) + k * (d2 - c2)
    return complex(c + k * (d - c)), complex(OMEGA * moved), complex(OMEGA**2 * sped)


def test_allans_two_groups_go_as_circles_and_lines_say() -> None:
    at = np.array([67.0, 97.0, 187.0, 277.0, 367.0])
    begin = np.array([1.22, 0.18, 1.22, -0.12, 0.7, 2.22])
    row = Judge(allan).followed(begin, math.radians(67.0), np.radians(at))
    motion = tmm.motion(scene("allan-gear"), at, exact=True)
    alike(motion, "C", 4, [point(one, 0, 1) for one in row])
    alike(motion, "D", 4, [point(one, 2, 3) for one in row])
    alike(motion, "M", 9, [point(one, 5, None) for one in row])


def test_the_hoist_lifts_by_virtual_work() -> None:
    at = np.array([1.65, 1.9, 2.2, 2.45])
    row = Judge(hoist).followed(np.array([1.32, 0.19, 1.77, 0.21]), 1.65, at)
    motion = tmm.motion(scene("tipper-hoist"), at, exact=True)
    for k, one in enumerate(row):
        a, moved = complex(*one.q[:2]), complex(*one.first[:2])
        assert abs(motion.places["A", 1][k] - a) < 1e-12
        assert abs(motion.places["B", 2][k] - complex(*one.q[2:])) < 1e-12
        omega = (moved / a).imag * 0.04
        assert abs(motion.omega[1][k] - omega) < 1e-12
    forces = tmm.motion(scene("tipper-hoist"), at, plans="forces", exact=True)
    for k, one in enumerate(row):
        a, moved = complex(*one.q[:2]), complex(*one.first[:2])
        mass = a * (1.5 + 0.6j) / (1.32 + 0.19j)
        due = 6000 * 9.81 * (1j * mass * (moved / a).imag).imag
        for method in ("forces", "lever"):
            found = abs(forces.balance[f"P_bal_{method}"][k])
            assert abs(found - due) < 1e-9 * due, (method, found, due)
