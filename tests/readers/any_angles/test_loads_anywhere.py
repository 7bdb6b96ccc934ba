"""Loads at any angle: by virtual power where they act alone, by the tables at the positions drawn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS

import graphic_tmm
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.chapters.forces.task import ASKED, ForcesTask, Friction, Load, Travel
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.readers.any_angles.results import Motion
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

ENGINE, WINDROWER = read(SHEETS / "engine"), read(SHEETS / "windrower")
ANGLES = np.random.default_rng(7).uniform(0.0, 360.0, 500)
OMEGA, CRANK = 50.0, 0.3
"""The scene `engine`."""


def loaded(scene: Scene, *loads: Load, **options: object) -> Scene:
    order = ForcesTask(("all",), tuple(loads), **options)  # type: ignore[arg-type]
    return scene.asking(forces=order, flywheel=None)


def at(scene: Scene, angles: object) -> Motion:
    plans = ("positions", "velocities", "forces")
    return graphic_tmm.motion(scene, angles, plans=plans, exact=True)  # type: ignore[arg-type]


def size_of(found: Motion, name: str) -> np.ndarray:
    """The force along x on the piston B that the balancing force holds, by the sum of their powers."""
    return -found.balance[name] * OMEGA * CRANK / found["B"].velocity.real


@pytest.mark.parametrize("way", ["P_bal_forces", "P_bal_lever"])
def test_a_load_by_the_angle_and_by_the_position(way: str) -> None:
    sizes = tuple(float(k % 7) for k in range(12))
    by_angle = tuple((30.0 * k, size) for k, size in enumerate(sizes))
    zero = ENGINE.row.zero
    start = zero if isinstance(zero, float) else 0.0
    due = np.interp((ANGLES - start) % 360.0, *zip(*by_angle, strict=True), period=360.0)
    for load in (Load(3, "B", 0.0, 0.0, by_angle=by_angle), Load(3, "B", sizes, 0.0)):
        found = at(loaded(ENGINE, load), ANGLES)
        np.testing.assert_allclose(size_of(found, way), due, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("zero", [Extreme("B", "right"), 23.0])
def test_a_load_by_the_travel_turns_where_the_piston_does(zero: Extreme | float) -> None:
    """Off the crank's axis the stroke out takes more than half a turn, and no position drawn is its end."""
    scene = read(SHEETS / "offset-slider")
    assert scene.mechanism is not None
    row = replace(scene.row, zero=zero, count=7, extra=())
    out, back = ((0.0, 10.0), (1.0, 20.0)), ((0.0, 5.0), (1.0, 1.0))
    travel = Travel("B", out, back)
    scene = loaded(replace(scene, row=row), Load(3, "B", 0.0, 0.0, travel=travel))
    angles = np.linspace(0.0, 360.0, 3601)
    found = at(scene, angles)
    x, v = found["B"].place.real, found["B"].velocity.real
    share = (x.max() - x) / np.ptp(x)
    due = np.where(v < 0.0, 10.0 + 10.0 * share, 5.0 - 4.0 * share)
    crank = scene.mechanism.drive
    arm = abs(scene.mechanism.links[0].points["A"])
    power = found.balance["P_bal_lever"] * crank.speed * arm + due * v
    clear = (share > 1e-6) & (share < 1.0 - 1e-6)
    assert np.abs(power[clear]).max() <= 1e-5 * np.abs(due * v).max()


def compared(scene: Scene) -> int:
    """Compare motion at the positions of a drawing with its table; return how many numbers were."""
    sheet = (SheetOrder("A1", ("positions", "velocities", "forces")),)
    made = drawn_of(replace(scene, sheets=sheet), exact=True)
    found = at(scene, np.array(made.project.coordinates, dtype=float))
    due = {column.segment: column.value[0] for column in force_columns(made, everywhere=True)}
    told = {name: np.abs(one) for name, one in found.forces.items()} | dict(found.balance)
    for name, one in told.items():
        largest = np.nanmax(np.abs(due[name]))
        np.testing.assert_allclose(one, due[name], rtol=1e-9, atol=1e-9 * largest, err_msg=name)
    return sum(one.size for one in told.values())


@pytest.mark.parametrize("name", ["windrower", "lever", "crank-press"])
def test_at_the_positions_drawn_it_is_the_table(name: str) -> None:
    assert compared(read(SHEETS / name)) >= 6 * 12


def test_friction_is_that_of_the_drawing() -> None:
    order = ASKED.of(WINDROWER)
    assert order is not None
    rubbed = replace(order, friction=Friction({"y": 0.1, "A": 0.1}, {"A": 0.01}, 2))
    assert compared(WINDROWER.asking(forces=rubbed, flywheel=None)) >= 6 * 12


def test_gas_is_read_off_the_diagram_as_drawn() -> None:
    """At the positions drawn it is the pressure that is given, between them one between its neighbours."""
    flywheel = ENGINE.tasks["flywheel"]
    scene = loaded(ENGINE, gas=flywheel.indicator)
    assert compared(scene) >= 6 * 12
    zero = ENGINE.row.zero
    angles = (zero if isinstance(zero, float) else 0.0) + 30.0 * np.arange(0.25, 12.0, 0.5)
    force = np.abs(size_of(at(scene, angles), "P_bal_lever"))
    given = np.array(flywheel.indicator.cover.pressures) * np.pi * 0.12**2 / 4
    given = np.append(given, given[0])
    low, high = np.minimum(given[:-1], given[1:]), np.maximum(given[:-1], given[1:])
    for k in range(12):
        assert (force[2 * k : 2 * k + 2] >= low[k] * (1.0 - 0.05) - 1e-6).all(), k
        assert (force[2 * k : 2 * k + 2] <= high[k] * (1.0 + 0.05) + 1e-6).all(), k
