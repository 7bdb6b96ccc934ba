"""How accurate forces are: what balances the crank; with friction it is known after many passes only."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Reference, Value
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ASKED, FORCES
from graphic_tmm.chapters.indicator.accuracy import at_count
from graphic_tmm.chapters.kinematics.accuracy import renamed, resampled
from graphic_tmm.chapters.kinematics.plan import ALL
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

PASSES = (2, 3, 4, 6, 8)
"""Numbers of passes of friction that are held against those that have settled."""
SETTLED = 12
"""Passes of friction after which nothing changes any more."""
FORCE, MOMENT = "P_bal", "M_bal"


def _quantities(project: Project) -> Iterator[Quantity]:
    made = FORCES_PLAN.on(project)
    name, unit = (MOMENT, "N·m") if made.order.balance == "moment" else (FORCE, "N")
    # of the last pass of friction, whether passes have settled or not: a hand that slips scatters more
    value = (Value(made.driven.balance),)
    if made.order.friction is None:
        yield Quantity(name, unit, value, project.count, due=value)
    else:
        yield Quantity(name, unit, value, project.count, reference=Reference(_many))


def _many(scene: Scene) -> Scene | None:
    return next((found for _, found in _by_passes(scene, (SETTLED,))), None)


def _by_passes(scene: Scene, passes: tuple[int, ...] = PASSES) -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None and order.friction is not None:
        for n in passes:
            friction = replace(order.friction, passes=n)
            yield str(n), ASKED.put(scene, replace(order, friction=friction))


def _kept(project: Project) -> tuple[Mark, ...]:
    """Return how many times the lever is larger than the plan, and to what scale groups are drawn."""
    made = FORCES_PLAN.on(project)
    return (made.lever.times, *(figure.mu for figure in made.figures))


def _whole(scene: Scene) -> Scene:
    order = ASKED.of(scene)
    return scene if order is None else ASKED.put(scene, replace(order, positions=ALL))


def _at_count(scene: Scene, count: int) -> Scene | None:
    order = ASKED.of(scene)
    if order is None:
        return scene
    positions = renamed(order.positions, scene.row, count)
    if positions is None:
        return None
    loads = tuple(
        replace(load, size=resampled(load.size, count)) if isinstance(load.size, tuple) else load
        for load in order.loads
    )
    gas = at_count(order.gas, count) if order.gas is not None else None
    return ASKED.put(scene, replace(order, positions=positions, loads=loads, gas=gas))


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None or order.mu is None:
        return scene
    return ASKED.put(scene, replace(order, mu=order.mu / times))


WORDS = {
    FORCE: said("P_bal"),
    MOMENT: said("M_bal"),
    "passes": said("passes of friction"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(FORCES,),
    axes=(Axis("passes", _by_passes, (FORCE, MOMENT)),),
    kept=_kept,
    enlarged=_enlarged,
    words=WORDS,
)


FINER = FinerRow(
    whole=_whole,
    at_count=_at_count,
)
