"""Loads: constant, against the velocity, by position, by angle, by travel, the gas of a cylinder."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import SHEETS

from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ForcesTask, Load, Travel
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

ENGINE = read(SHEETS / "engine")
WINDROWER = read(SHEETS / "windrower")
SHEET = (SheetOrder("A1", ("positions", "velocities", "forces")),)


def loaded(*loads: Load, scene: Scene = ENGINE, **options: object) -> Drawn:
    order = ForcesTask(("all",), tuple(loads), **options)  # type: ignore[arg-type]
    flywheel = None
    return drawn_of(
        replace(scene, sheets=SHEET).asking(forces=order, flywheel=flywheel), exact=True
    )


def force(made: Drawn, letter: str) -> np.ndarray:
    """The force as a vector, N, at every position."""
    assert FORCES_PLAN.of(made) is not None
    found = next(f for f in FORCES_PLAN.on(made).loads.on_lever if f.letter == letter)
    return np.broadcast_to(
        (made.reading[found.line].along * made.reading[found.value])[0], (len(made.project.names),)
    )


def balance(made: Drawn) -> np.ndarray:
    assert FORCES_PLAN.of(made) is not None
    return made.reading[FORCES_PLAN.on(made).first.balance][0]


def test_against_the_velocity_of_a_slider() -> None:
    found = force(loaded(Load(3, "B", 100.0)), "F_3")
    assert found[0] == 0.0  # the dead centres: no velocity, no sense
    assert found[6] == 0.0
    np.testing.assert_allclose(found[1:6], 100.0, atol=1e-12)  # the piston goes left, to the crank
    np.testing.assert_allclose(found[7:], -100.0, atol=1e-12)


@pytest.mark.parametrize("turned", [False, True])
def test_against_the_velocity_of_any_point(turned: bool) -> None:
    made = loaded(Load(2, "S2", 50.0), scene=replace(ENGINE, turned=turned))
    found = force(made, "F_2")
    image = KINEMATICS_PLAN.on(made).velocities.images.by_letter[2]["S2"]  # type: ignore[union-attr]
    velocity = made.reading[image][0] * (1j if turned else 1.0)
    np.testing.assert_allclose(found, -50.0 * velocity / np.abs(velocity), atol=1e-10)


def test_a_fixed_direction() -> None:
    np.testing.assert_allclose(force(loaded(Load(3, "B", 10.0, -90.0)), "F_3"), -10j, atol=1e-14)


def test_by_position_and_by_angle() -> None:
    sizes = tuple(float(k) for k in range(12))
    by_position = loaded(Load(3, "B", sizes, 0.0))
    by_angle = loaded(Load(3, "B", 0.0, 0.0, by_angle=((0.0, 0.0), (330.0, 11.0))))
    np.testing.assert_allclose(force(by_position, "F_3"), sizes, atol=1e-12)
    np.testing.assert_allclose(force(by_angle, "F_3"), sizes, atol=1e-12)
    with pytest.raises(StructureError, match="2 sizes for 12 positions"):
        loaded(Load(3, "B", (1.0, 2.0), 0.0))


def test_a_moment_against_the_rotation() -> None:
    made = loaded(Load(2, None, 7.0))
    rate = made.reading[KINEMATICS_PLAN.on(made).velocities.rates[2]][0]  # type: ignore[union-attr]
    couple = made.reading[FORCES_PLAN.on(made).loads.couples[0].value][0]  # type: ignore[union-attr]
    moving = np.abs(rate) > 1e-6
    np.testing.assert_allclose(couple[moving], -7.0 * np.sign(rate[moving]))
    with pytest.raises(StructureError, match="does not turn"):
        loaded(Load(3, None, 7.0))


def test_by_travel_of_the_knife() -> None:
    travel = Travel(
        "D", out=((0.0, 0.0), (0.5, 200.0), (1.0, 100.0)), back=((0.2, 50.0), (0.8, 50.0))
    )
    made = loaded(Load(5, "D", travel=travel), scene=WINDROWER)
    found = np.abs(force(made, "F_5"))
    place = made.reading[KINEMATICS_PLAN.on(made).positions.point("D")][0]
    share = np.abs(place - place[0]) / np.abs(place[-1] - place[0])
    out = np.interp(share[1:8], (0.0, 0.5, 1.0), (0.0, 200.0, 100.0))
    np.testing.assert_allclose(found[1:8], out, rtol=1e-9)
    back = np.where((share[8:12] >= 0.2) & (share[8:12] <= 0.8), 50.0, 0.0)
    np.testing.assert_allclose(found[8:12], back, rtol=1e-9, atol=1e-12)


def test_the_gas_pushes_the_piston() -> None:
    assert ENGINE.tasks.get("flywheel") is not None
    made = loaded(gas=ENGINE.tasks["flywheel"].indicator)
    area = np.pi * 0.12**2 / 4
    assert ENGINE.tasks["flywheel"].indicator is not None
    pressures = np.array(ENGINE.tasks["flywheel"].indicator.cover.pressures)
    np.testing.assert_allclose(force(made, "P"), -pressures * area, rtol=1e-9)
    # the reduced moment of the flywheel's first step, reversed: P_b·OA
    speed = made.reading[KINEMATICS_PLAN.on(made).velocities.readings[3]][0]  # type: ignore[union-attr]
    due = pressures * area * speed / 60.0 if made.scales["velocities"].value == 0.25 else None
    if due is not None:
        np.testing.assert_allclose(balance(made), due, atol=1e-6)


def test_the_gas_balances_what_the_flywheel_is_driven_by() -> None:
    """The reduced moment of A2 is minus the balancing moment of the gas alone."""
    engine = drawn_of(ENGINE, exact=True)
    made = loaded(gas=ENGINE.tasks["flywheel"].indicator, balance="moment")  # type: ignore[union-attr]
    chart = next(c for c in FLYWHEEL_PLAN.on(engine).charts if c.view == "moment")  # type: ignore[union-attr]
    moment = engine.reading[chart.ordinates[0]] * engine.reading[chart.mu]
    np.testing.assert_allclose(balance(made), -moment[0], atol=1e-8)


@pytest.mark.parametrize(
    ("load", "says"),
    [
        (Load(9, "B", 1.0), "no moving link 9"),
        (Load(3, "C", 1.0), "has no point C"),
        (Load(1, "O", 1.0), "O does not move"),
    ],
)
def test_a_load_on_what_is_not_there_is_refused(load: Load, says: str) -> None:
    with pytest.raises(StructureError, match=says):
        loaded(load)


def test_the_windrowers_reduced_moment_is_its_power_over_omega() -> None:
    """The lever against forces times velocities, of the loads that are not inertia's."""
    made = drawn_of(WINDROWER, exact=True)
    assert FORCES_PLAN.of(made) is not None
    assert FLYWHEEL_PLAN.of(made) is not None
    assert KINEMATICS_PLAN.on(made).velocities is not None
    power = np.zeros(len(made.project.names))
    mu = made.scales["velocities"].value
    for one in FORCES_PLAN.on(made).loads.on_lever:
        if not one.letter.startswith("P_{i"):
            assert one.image is not None
            velocity = made.reading[one.image] * mu
            acting = made.reading[one.line].along * made.reading[one.value]
            power = power + (acting * velocity.conj()).real[0]
    chart = next(c for c in FLYWHEEL_PLAN.on(made).charts if c.view == "moment")
    found = made.reading[chart.ordinates[0]][0] * made.reading[chart.mu][0, 0]
    np.testing.assert_allclose(found, -power / WINDROWER.mechanism.drive.speed, atol=1e-9)  # type: ignore[union-attr]
