"""How accurate a flywheel for a cycle of moments is: J, or δ, known only where the cycle is divided finely."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Effect, Quantity, Reference, Value
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.task import ASKED, CYCLE, Moment
from graphic_tmm.chapters.flywheel.accuracy import BY_POSITIONS, farther, larger
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


def _effects(scene: Scene) -> Iterator[Effect]:
    order = ASKED.of(scene)
    for k, moment in enumerate(order.moments if order is not None else ()):
        yield Effect(said("moment {n}", n=k + 1), partial(_without, moment=moment))


def _without(scene: Scene, moment: Moment) -> Scene:
    """Return the scene without one of its moments; another that says the same stays."""
    order = ASKED.of(scene)
    if order is None:
        return scene
    moments = tuple(one for one in order.moments if one is not moment)
    return ASKED.put(scene, replace(order, moments=moments))


def _poles(scene: Scene) -> tuple[str, ...]:
    order = ASKED.of(scene)
    if order is None:
        return ()
    return (INERTIA if order.flywheel.J is None else IRREGULARITY,)


def _farther(project: Project, times: float) -> dict[Mark, object]:
    return farther(project, CYCLE_PLAN.on(project).flywheel, times)


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene
    return ASKED.put(scene, replace(order, flywheel=larger(order.flywheel, drawn, times)))


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
    effects=_effects,
    enlarged=_enlarged,
    poles=_poles,
    farther=_farther,
    words=WORDS,
)


FINER = FinerRow(
    at_count=_at_count,
    by_positions=BY_POSITIONS,
)
