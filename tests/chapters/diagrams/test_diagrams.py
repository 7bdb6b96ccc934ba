"""Kinematic diagrams of scenes: they agree with the plans as far as their positions allow; they close."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.boards import drawn_of
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN, Kinematic
from graphic_tmm.chapters.diagrams.task import KinematicTask
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

POINTS = {
    "windrower": "D",
    "engine": "B",
    "offset-slider": "B",
    "shaper": "D",
    "slider-diagrams": "B",
}
METHODS = ("chords", "tangents")
STARTS = ("displacement", "velocity")


@cache
def drawn(name: str, count: int = 0, **order: object) -> Drawn:
    """Draw a scene with diagrams; with ``count`` positions of the row instead of its own."""
    scene = read(SHEETS / name)
    row = replace(scene.row, count=count or scene.row.count, extra=())
    if count:
        row = replace(row, accelerations=())
    wanted = KinematicTask(POINTS[name], **order)  # type: ignore[arg-type]
    sheets = (SheetOrder("A1", ("positions", "velocities", "accelerations", "diagrams")),)
    return drawn_of(
        replace(scene, row=row, sheets=sheets).asking(diagrams=wanted, flywheel=None, forces=None),
        exact=True,
    )


def kinematic(made: Drawn) -> Kinematic:
    assert DIAGRAMS_PLAN.of(made) is not None
    return DIAGRAMS_PLAN.on(made)


def values(made: Drawn, symbol: str) -> np.ndarray:
    chart = kinematic(made).charts[symbol]
    return np.asarray(made.reading[chart.ordinates[0]][0] * made.reading[chart.mu][0])


def planned(made: Drawn) -> np.ndarray:
    mark = kinematic(made).planned["V"]
    return np.asarray(made.reading[mark][0] * made.scales["velocities"].value)


@cache
def harmonics(name: str) -> np.ndarray:
    """Fourier coefficients of the exact velocity over the turn, from 720 positions of the plan."""
    return np.fft.fft(planned(drawn(name, 720))) / 720


def derivative(name: str, order: int, count: int) -> np.ndarray:
    """The exact ``order``-th derivative of the velocity over time at the row's positions."""
    omega = abs(KINEMATICS_PLAN.on(drawn(name)).mechanism.drive.speed)
    k = np.fft.fftfreq(720, 1 / 720)
    row = np.fft.ifft(harmonics(name) * 720 * (1j * k * omega) ** order).real
    return row[:: 720 // count]


def bound(name: str, count: int, order: int) -> float:
    """What N positions cost a derivative: two chords' truncation h²/24 each, a spline's h⁴ beside it, in SI."""
    omega = abs(KINEMATICS_PLAN.on(drawn(name)).mechanism.drive.speed)
    h = 2 * np.pi / count / omega
    second = np.abs(derivative(name, order + 2, 720)).max()
    fourth = np.abs(derivative(name, order + 4, 720)).max()
    return float(h**2 / 24 * second * 1.5 + h**4 * fourth / 60)


@each("method", METHODS)
@each("start", STARTS)
@each("name", POINTS)
@pytest.mark.slow
def test_velocities_agree_with_the_plans(name: str, start: str, method: str) -> None:
    made = drawn(name, start=start, method=method)
    off = np.abs(values(made, "V") - planned(made)).max()
    if start == "velocity":
        assert off < 1e-9
    else:
        assert off <= bound(name, made.project.count, 0)
        assert off > 1e-9


@each("method", METHODS)
@each("start", STARTS)
@each("name", POINTS)
def test_accelerations_agree_with_the_exact_motion_and_the_plans(
    name: str, start: str, method: str
) -> None:
    made = drawn(name, start=start, method=method)
    count = made.project.count
    exact = derivative(name, 1, count)
    times = 2 if start == "displacement" else 1
    assert np.abs(values(made, "a") - exact).max() <= times * bound(name, count, 1)
    if "a" in kinematic(made).planned and made.of("accelerations") is not None:
        plan = (
            made.of("accelerations")[kinematic(made).planned["a"]][0]
            * made.scales["accelerations"].value
        )
        np.testing.assert_allclose(
            plan, exact[list(KINEMATICS_PLAN.on(made).accelerated)], atol=1e-6 * np.abs(exact).max()
        )


@pytest.mark.parametrize("name", POINTS)
def test_more_positions_bring_the_diagrams_nearer(name: str) -> None:
    errors = []
    for count in (12, 48):
        made = drawn(name, count)
        errors.append(np.abs(values(made, "a") - derivative(name, 1, count)).max())
    assert errors[1] < errors[0] / 8  # h² would be a sixteenth


@pytest.mark.parametrize(
    ("count", "low", "high"), [(8, 5e-3, 0.2), (12, 6e-5, 6e-3), (24, 0, 1e-8)]
)
def test_a_turn_integrated_from_the_velocities_closes_to_its_aliased_harmonics(
    count: int, low: float, high: float
) -> None:
    made = drawn("windrower", count, start="velocity")
    chart = kinematic(made).charts["S"]
    assert chart.end is not None
    stroke = np.ptp(made.reading[chart.ordinates[0]][0])
    error = abs(float(made.reading[chart.end][0, 0])) / stroke * 100
    assert low <= error <= high


def test_a_base_over_the_angle_gives_the_same_values() -> None:
    over_time, over_angle = drawn("engine"), drawn("engine", over="angle")
    assert over_angle.scales["base"].unit == "rad/mm"
    omega = 50.0
    np.testing.assert_allclose(
        values(over_angle, "V") * omega, values(over_time, "V"), rtol=1e-9, atol=1e-9
    )
    # a derivative by the angle is told as what it is, and not compared with the plan's velocity
    assert {chart.unit for chart in kinematic(over_angle).charts.values()} == {"m"}
    assert "V" in kinematic(over_time).planned
    assert not kinematic(over_angle).planned


def test_a_point_that_does_not_slide_is_refused_with_those_that_do() -> None:
    scene = read(SHEETS / "windrower").asking(diagrams=KinematicTask("C"))
    with pytest.raises(StructureError, match=r"diagrams.point: point C does not slide.*are D"):
        drawn_of(scene)
    none = read(SHEETS / "crank-rocker").asking(diagrams=KinematicTask("B"))
    none = replace(none, sheets=(SheetOrder("A1", ("positions", "diagrams")),))
    with pytest.raises(StructureError, match="this mechanism has none"):
        drawn_of(none)


@pytest.mark.parametrize("pole", [0.0, -10.0, float("nan")])
def test_a_pole_distance_that_is_none_is_refused(pole: float) -> None:
    order = KinematicTask("D", V=ScaleOrder(pole=pole))
    with pytest.raises(StructureError, match=r"H_V = .* is not greater than 0"):
        drawn_of(read(SHEETS / "windrower").asking(diagrams=order))


def test_positions_that_are_missing_leave_the_rest_and_are_told() -> None:
    """A row in which some positions cannot be drawn: their intervals are not there, no number is invented."""
    made = drawn("engine", start="velocity")
    whole = values(made, "a")
    given = dict(made.project.given)
    mark = kinematic(made).planned["V"]
    reading = made.reading[mark].copy()
    reading[0, 4] = np.nan
    from graphic_tmm.board.execute import execute
    from graphic_tmm.board.record import Construction

    log = made.project.construction
    steps = tuple(step for step in log.steps if step.it != mark)
    bare = Construction((*log.given, mark), steps, log.views, log.figures, log.size)
    values_given = {**given, mark: reading}
    for plan, scale in made.scales.items():
        view = log.view(plan)
        if view is not None and view.scale is not None:
            values_given[view.scale] = scale.value
    chart = kinematic(made).charts["a"]
    found = execute(bare, values_given, [chart.ordinates[0], chart.mu])
    a = found[chart.ordinates[0]][0] * found[chart.mu][0]
    assert np.isnan(a[4])
    there = np.isfinite(a)
    assert there.sum() >= 6
    off = np.abs(a[there] - whole[there]).max() / np.abs(whole).max()
    assert off < 0.15  # a natural end here and there instead of the closed curve
