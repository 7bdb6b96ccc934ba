"""How accurate a flywheel for a cycle of moments is: J, or δ, known only where the cycle is divided finely."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Reference, Value
from graphic_tmm.board.charts import ScaleOrder, distances
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.task import ASKED, CYCLE, CycleTask
from graphic_tmm.chapters.flywheel.accuracy import BY_POSITIONS
from graphic_tmm.chapters.flywheel.task import VIEWS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

PARTS_OF_TRUTH = 48
"""A cycle divided so many times finer has converged; what stood at a position stands at one still."""
TIMES = (1, 2, 3, 4, 6)
"""How many times finer the cycle is divided."""
INERTIA, IRREGULARITY = "J_cycle", "delta_cycle"


def _quantities(project: Project) -> Iterator[Quantity]:
    made, due = CYCLE_PLAN.on(project).flywheel, Reference(_converged)
    if made.order.J is None:
        yield Quantity(INERTIA, "kg·m²", (Value(made.inertia),), reference=due)
    else:
        yield Quantity(IRREGULARITY, "", (Value(made.delta),), reference=due)


def _converged(scene: Scene) -> Scene | None:
    return next((one for _, one in _finer(scene, (PARTS_OF_TRUTH,), mean="areas")), None)


def _finer(scene: Scene, times: Iterable[int], mean: str = "") -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None:
        flywheel = order.flywheel
        told = replace(flywheel, integration=mean or flywheel.integration)
        for one in times:
            count = order.positions * one
            yield str(count), ASKED.put(scene, replace(order, positions=count, flywheel=told))


def _at_count(scene: Scene, count: int) -> Scene | None:
    """Return the cycle divided into so many parts; None if jumps would stand at positions no more."""
    times, rest = divmod(count, _own(scene) or count)
    return None if rest else next((one for _, one in _finer(scene, (times,))), scene)


def _own(scene: Scene) -> int:
    order = ASKED.of(scene)
    return order.positions if order is not None else 0


def _poles(scene: Scene) -> tuple[str, ...]:
    order = ASKED.of(scene)
    if order is None:
        return ()
    return (INERTIA if order.flywheel.J is None else IRREGULARITY,)


def _farther(project: Project, times: float) -> dict[Mark, object]:
    """Return the distance of the pole of the works, or their scale."""
    work = VIEWS["work"]
    charts = (one for one in CYCLE_PLAN.on(project).flywheel.charts if one.view == work)
    moved = [*(one.mu for one in charts if one.chosen), *distances(project.given, work)]
    return {mark: np.asarray(project.given[mark]) * times for mark in moved}


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    return scene if order is None else ASKED.put(scene, _larger(order, drawn, times))


def _larger(order: CycleTask, drawn: Drawn, times: float) -> CycleTask:
    own = order.flywheel
    mu = {view: scale.value / times for view, scale in drawn.scales.items()}
    pole = own.A.pole * times if own.A.pole is not None else None
    work = None if pole is not None else mu.get(VIEWS["work"], own.A.mu)
    told = mu.get(VIEWS["moment"], own.mu_M)
    larger = replace(own, A=ScaleOrder(work, pole), base=own.base * times, mu_M=told)
    return replace(order, flywheel=larger)


WORDS = {
    INERTIA: said("J of the flywheel, by moments"),
    IRREGULARITY: said("δ, by moments"),
    "cycle parts": said("parts of the cycle"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(CYCLE,),
    axes=(
        Axis(
            "cycle parts",
            lambda scene: _finer(scene, TIMES),
            parts=_own,
            counted=said("{n} part", "{n} parts"),
        ),
    ),
    enlarged=_enlarged,
    poles=_poles,
    farther=_farther,
    words=WORDS,
)


FINER = FinerRow(
    at_count=_at_count,
    by_positions=BY_POSITIONS,
)
