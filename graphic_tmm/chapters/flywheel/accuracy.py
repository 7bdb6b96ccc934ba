"""How accurate a flywheel is: its moment of inertia by both methods, known only where the row is fine."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from graphic_tmm.accuracy.quantities import Accuracy, Effect, Quantity, Reference, Value
from graphic_tmm.board.charts import ScaleOrder, distances
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.task import ASKED, FLYWHEEL, VIEWS, FlywheelTask
from graphic_tmm.chapters.forces.accuracy import masses
from graphic_tmm.chapters.forces.task import ASKED as FORCES
from graphic_tmm.chapters.indicator.accuracy import (
    BELOW,
    at_count,
    enlarged,
    one_sided,
    sampled,
    two_sided,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

FINE = 3072
"""Positions of a row that has converged: J errs as N^−1.93, so by 6e-4 of what 64 positions leave."""
INERTIA, ENERGY_MASS, IRREGULARITY = "J_fly", "J_fly_energy_mass", "delta"


def _quantities(project: Project) -> Iterator[Quantity]:
    made, due = FLYWHEEL_PLAN.on(project), Reference(_exactly, FINE)
    if made.order.J is None:
        yield Quantity(INERTIA, "kg·m²", (Value(made.inertia),), reference=due)
    else:
        yield Quantity(IRREGULARITY, "", (Value(made.delta),), reference=due)
    if made.energy_mass is not None:
        value = Value(made.energy_mass.inertia)
        yield Quantity(ENERGY_MASS, "kg·m²", (value,), reference=due)


def _exactly(scene: Scene) -> Scene | None:
    """Return the scene with works that are areas, and tangents of the curve itself."""
    order = ASKED.of(scene)
    if order is None:
        return None
    tangents = "curve" if order.tangents is not None else None
    return ASKED.put(scene, replace(order, integration="areas", tangents=tangents))


def _at_count(scene: Scene, count: int) -> Scene:
    order = ASKED.of(scene)
    if order is None or order.indicator is None:
        return scene
    return ASKED.put(scene, replace(order, indicator=at_count(order.indicator, count)))


BY_POSITIONS = {
    INERTIA: -1,
    ENERGY_MASS: -1,
    IRREGULARITY: -1,
    "A_excess": -1,
    "cd": -1,
    "rim_mass": -1,
    "rim_width": -1,
    "M_mean": 0,
    "power": 0,
    "p_mean_cover": 0,
    "p_mean_shaft": 0,
}
"""Results of the curves. A flywheel that is found too light, a δ that is found too small, are dangerous."""


def _sampled(scene: Scene) -> bool:
    """Whether pressures, or the sizes of loads, are given position by position."""
    order, forces = ASKED.of(scene), FORCES.of(scene)
    if order is not None and order.indicator is not None:
        return sampled(order.indicator)
    return forces is not None and any(isinstance(load.size, tuple) for load in forces.loads)


def _poles(scene: Scene) -> tuple[str, ...]:
    order = ASKED.of(scene)
    if order is None:
        return ()
    return (INERTIA if order.J is None else IRREGULARITY, ENERGY_MASS)


def _farther(project: Project, times: float) -> dict[Mark, object]:
    return farther(project, FLYWHEEL_PLAN.on(project), times)


def farther(project: Project, flywheel: Flywheel, times: float) -> dict[Mark, object]:
    """Return the distance of the pole of the works, or their scale; ΔT has that of the works."""
    work = VIEWS["work"]
    scales = [chart.mu for chart in flywheel.charts if chart.view == work and chart.chosen]
    moved = [*scales, *distances(project.given, work)]
    return {mark: np.asarray(project.given[mark]) * times for mark in moved}


def _effects(scene: Scene) -> Iterator[Effect]:
    order = ASKED.of(scene)
    if order is None:
        return
    yield from masses(scene)
    if two_sided(order.indicator):
        yield Effect(BELOW, _one_sided)


def _one_sided(scene: Scene) -> Scene:
    order = ASKED.of(scene)
    if order is None or order.indicator is None:
        return scene
    return ASKED.put(scene, replace(order, indicator=one_sided(order.indicator)))


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene
    indicator = enlarged(order.indicator, times) if order.indicator is not None else None
    return ASKED.put(scene, replace(larger(order, drawn, times), indicator=indicator))


def larger(order: FlywheelTask, drawn: Drawn, times: float) -> FlywheelTask:
    """Return a flywheel whose graphs are drawn so many times larger than they were, each μ so much finer."""
    mu = {view: scale.value / times for view, scale in drawn.scales.items()}
    pole = order.A.pole * times if order.A.pole is not None else None
    work = None if pole is not None else mu.get(VIEWS["work"], order.A.mu)
    moment = mu.get(VIEWS["moment"], order.mu_M)
    return replace(order, A=ScaleOrder(work, pole), base=order.base * times, mu_M=moment)


WORDS = {
    INERTIA: said("J of the flywheel"),
    ENERGY_MASS: said("J, energy–mass"),
    IRREGULARITY: "δ",
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(FLYWHEEL,),
    effects=_effects,
    enlarged=_enlarged,
    poles=_poles,
    farther=_farther,
    words=WORDS,
)


FINER = FinerRow(
    at_count=_at_count,
    by_positions=BY_POSITIONS,
    sampled=_sampled,
)
