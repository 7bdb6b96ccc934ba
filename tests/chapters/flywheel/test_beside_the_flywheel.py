"""What is calculated beside a flywheel, and the two ways round between δ and J: against numpy alone."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.boards import drawn_of
from support.flywheels import along, taut
from support.gallery import SHEETS
from support.scenes import edited

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.record import BESIDE
from graphic_tmm.chapters.flywheel.table import flywheel_results
from graphic_tmm.chapters.flywheel.task import CALCULATED
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

R, L, W, BORE = 0.3, 0.64, 50.0, 0.12
P = np.array([300, 300, 240, 159, 121.5, 87, 30, 34.5, 42, 64.5, 100.5, 144]) * 1e3
PHI = np.arange(12) * np.pi / 6
SPEED = -R * np.sin(PHI) * (1 + R * np.cos(PHI) / np.sqrt(L**2 - (R * np.sin(PHI)) ** 2))
"""Of the piston over that of turning, m."""
MOMENT = -P * np.pi * BORE**2 / 4 * SPEED


def scene(**changes: object) -> Scene:
    made = read(SHEETS / "engine")
    order = replace(made.tasks["flywheel"], **changes)  # type: ignore[arg-type]
    return replace(made, sheets=(SheetOrder("A1", ("positions", "flywheel")),)).asking(
        flywheel=order
    )


@cache
def drawn(**changes: object) -> Drawn:
    return drawn_of(scene(**changes), exact=True)


def value(made: Drawn, mark: Mark | None) -> float:
    assert mark is not None
    return float(made.reading[mark][0, 0])


def test_what_is_calculated_beside_moves_no_mark_of_the_drawing() -> None:
    log = drawn().construction
    beside = [step for step in log.steps if step.it.view == CALCULATED]
    others = [step for step in log.steps if step.it.view != CALCULATED]
    assert beside
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_mean_moment_and_power_are_those_of_the_area_below_the_curve() -> None:
    """The mean of the curve through the moments, by 4000 samples an interval: cubic arcs, trapezia."""
    found = BESIDE.on(drawn())
    mean = float(np.mean(along(MOMENT, taut(MOMENT), 4000)))
    assert value(drawn(), found.moment) == pytest.approx(mean, rel=1e-6)
    assert value(drawn(), found.power) == pytest.approx(mean * W, rel=1e-6)


def test_a_clockwise_crank_has_the_same_power(tmp_path: Path) -> None:
    """The machine mirrored in its guide: the same pressures in the same positions."""
    other = edited(tmp_path, ('turns         = "counterclockwise"', 'turns = "clockwise"'))
    mirrored = drawn_of(read(other), exact=True)
    here, there = (value(one, BESIDE.on(one).power) for one in (drawn(), mirrored))
    assert there == pytest.approx(here, rel=1e-9)
    assert there > 0.0


def test_the_reduced_force_has_the_power_of_the_force_on_the_piston() -> None:
    force = BESIDE.on(drawn()).force
    assert force is not None
    np.testing.assert_allclose(drawn().reading[force][0], MOMENT / R, atol=1e-9)


def test_both_methods_are_compared_in_a_step_and_the_table_tells_it() -> None:
    made, found = drawn(), FLYWHEEL_PLAN.on(drawn())
    assert found.energy_mass is not None
    first, second = value(made, found.inertia), value(made, found.energy_mass.inertia)
    told = single(flywheel_results(made))
    assert told["J_apart"] == (round(100 * (1 - second / first), 2), "%")
    assert told["power"][1] == "W"
    assert BESIDE.on(drawn(tangents=None)).apart is None
    text = "\n".join(protocol(made, ("flywheel",), "2", "ru"))
    assert "N = M_ср·ω_1" in text
    assert "Вт" in text


@settings(max_examples=4, deadline=None)
@given(st.floats(0.05, 0.9))
def test_what_a_given_delta_asks_for_keeps_that_delta(delta: float) -> None:
    """J of δ, and δ of that J, by either method."""
    asked = drawn_of(scene(delta=delta), exact=True)
    inertia = value(asked, FLYWHEEL_PLAN.on(asked).inertia)
    back = drawn_of(scene(delta=None, J=inertia), exact=True)
    made = FLYWHEEL_PLAN.on(back)
    assert value(back, made.delta) == pytest.approx(delta, rel=1e-9)
    assert value(back, made.inertia) == inertia
    assert value(back, BESIDE.on(back).apart) == pytest.approx(
        value(asked, BESIDE.on(asked).apart), abs=1e-6
    )
    told = single(flywheel_results(back))
    assert told["delta"][0] == pytest.approx(delta, rel=1e-9)
    assert "delta" not in single(flywheel_results(asked))


def test_a_rim_is_made_as_round_as_the_task_says() -> None:
    """Document 000: 0.85·0.45 = 0.3825 m, made 0.38 m."""
    made = drawn_of(read(SHEETS / "engine"), exact=True)
    rim, inertia = FLYWHEEL_PLAN.on(made).rim, value(made, FLYWHEEL_PLAN.on(made).inertia)
    assert rim is not None
    assert value(made, rim.inner) == 0.38
    assert value(made, rim.mean) == pytest.approx(0.415)
    volume = np.pi / 4 * (0.45**2 - 0.38**2)
    assert value(made, rim.mass) == pytest.approx(4 * inertia / 0.415**2)
    assert value(made, rim.width) == pytest.approx(4 * inertia / 0.415**2 / (7800 * volume))
    lines = "\n".join(protocol(made, ("flywheel",), "2", "en"))
    assert "0.85·0.45 = 0.3825 m" in lines
    assert "0.38 m for D_i" in lines


@pytest.mark.parametrize(
    ("new", "key", "says"),
    [
        ("", "flywheel.delta", "or J of the flywheel"),
        ('delta = 0.2\nJ = "1.8 kg*m^2"', "flywheel.J", "given already"),
        ('J = "0 kg*m^2"', "flywheel.J", "greater than 0"),
        ('delta = 0.2\nD_i = "0.5 m"', "flywheel.D_i", "leaves no rim"),
    ],
)
def test_what_contradicts_itself_is_told(new: str, key: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as refused:
        read(edited(tmp_path, ("delta = 0.23", new), ('D_i   = "0.38 m"', ""), name="engine"))
    told = {fault.key: fault.message for fault in refused.value.faults}
    assert says in told[key]


def test_an_inertia_that_is_none_is_refused_off_files_too() -> None:
    with pytest.raises(StructureError, match="J"):
        drawn_of(scene(delta=None, J=-1.0))


def test_the_excess_work_and_what_the_rim_keeps() -> None:
    """A = J·δ·ω²; a rim in whole millimetres has the J of its ring and keeps δ in the inverse ratio."""
    made = drawn()
    found, order = BESIDE.on(made), FLYWHEEL_PLAN.on(made)
    inertia = value(made, order.inertia)
    assert value(made, found.excess) == pytest.approx(inertia * 0.23 * W**2, rel=1e-9)
    assert found.rim is not None
    width, own, kept = (value(made, mark) for mark in found.rim)
    assert width == pytest.approx(round(width, 3), abs=1e-12)
    assert abs(width - single(flywheel_results(made))["rim_width"][0]) <= 0.0005
    outer, inner = 0.45, 0.38
    ring = np.pi * 7800 * (outer**2 - inner**2) * ((outer + inner) / 2) ** 2 * width / 16
    assert own == pytest.approx(ring, rel=1e-9)
    assert kept == pytest.approx(0.23 * inertia / ring, rel=1e-9)


def test_a_flywheel_without_a_rim_has_nothing_made() -> None:
    made = drawn(rim=None)
    assert BESIDE.on(made).rim is None
    assert not {"J_made", "delta_made"} & set(flywheel_results(made))
