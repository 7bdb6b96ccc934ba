"""How accurate an engine's moment is: with a rod of two masses, judged by the kinetostatics of the rod."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Effect, Quantity, Reference, Value
from graphic_tmm.chapters.engine.formulas import KGF
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.engine.task import ASKED, ENGINE
from graphic_tmm.chapters.forces.accuracy import MOMENT
from graphic_tmm.chapters.forces.task import ASKED as FORCES_ASKED
from graphic_tmm.chapters.forces.task import FORCES, ForcesTask
from graphic_tmm.chapters.indicator.accuracy import BELOW, at_count, enlarged, one_sided, sampled
from graphic_tmm.chapters.kinematics.plan import ALL
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

TURNING = "M_engine"


def _quantities(project: Project) -> Iterator[Quantity]:
    made = ENGINE_PLAN.on(project)
    value = Value(made.values["M"], KGF if made.order.unit == "kgf" else 1.0)
    # what drives is the opposite of what balances
    balance = Reference(_of_the_rod, 0, frozenset({POSITIONS, FORCES}), MOMENT, -1.0)
    yield Quantity(TURNING, "N·m", (value,), project.count, reference=balance)


def _of_the_rod(scene: Scene) -> Scene | None:
    """Return the scene asking for the moment that balances the crank, in place of its forces."""
    order = ASKED.of(scene)
    if order is None:
        return None
    forces = ForcesTask(ALL, inertia=True, gas=order.indicator, balance="moment")
    return FORCES_ASKED.put(scene, forces)


def _rods(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """Yield the rod's mass as the scene shares it, and by the lever rule; the error is that of two masses."""
    order = ASKED.of(scene)
    if order is None:
        return
    if order.share is not None or order.mass is not None:
        yield "scene", scene
    yield "lever rule", ASKED.put(scene, replace(order, share=None, mass=None))


def _series(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """Yield the inertia force by the plan of accelerations, and by the series of two terms."""
    order = ASKED.of(scene)
    if order is not None:
        yield "plan", ASKED.put(scene, replace(order, series=False))
        yield "series", ASKED.put(scene, replace(order, series=True))


def _effects(scene: Scene) -> Iterator[Effect]:
    order = ASKED.of(scene)
    if order is None:
        return
    yield Effect(said("inertia"), partial(_changed, mass=0.0))
    if order.indicator.shaft is not None:
        yield Effect(BELOW, partial(_changed, indicator=one_sided(order.indicator)))


def _changed(scene: Scene, **changes: Any) -> Scene:
    order = ASKED.of(scene)
    return scene if order is None else ASKED.put(scene, replace(order, **changes))


def _at_count(scene: Scene, count: int) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene
    return ASKED.put(scene, replace(order, indicator=at_count(order.indicator, count)))


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene
    indicator = enlarged(order.indicator, times)
    return ASKED.put(scene, replace(order, indicator=indicator, base=order.base * times))


def _turning(scene: Scene) -> tuple[str, ...]:
    return (TURNING,)


WORDS = {
    TURNING: said("M of the engine"),
    "rod": said("mass of the rod"),
    "lever rule": said("by the lever rule"),
    "inertia": said("inertia force"),
    "plan": said("plan of accelerations"),
    "series": said("series of two terms"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(ENGINE,),
    axes=(Axis("rod", _rods, _turning), Axis("inertia", _series, _turning)),
    effects=_effects,
    enlarged=_enlarged,
    words=WORDS,
)


FINER = FinerRow(
    at_count=_at_count,
    by_positions={"work_T": 0, "work_P": 0},
    sampled=lambda scene: sampled(getattr(ASKED.of(scene), "indicator", None)),
)
