"""How accurate diagrams are: V and a, judged by the plans at the same positions; method, start, poles."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Value
from graphic_tmm.board.charts import STANDARD, ScaleOrder, distances
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN, whole
from graphic_tmm.chapters.diagrams.task import ASKED, BASE, DIAGRAMS, VIEWS, KinematicTask, settled
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow
from graphic_tmm.scene.records import Scene

NAMES = {"V": "V_diagram", "a": "a_diagram"}
"""What the quantities are called, by their symbols."""


def _quantities(project: Project) -> Iterator[Quantity]:
    made, plans = DIAGRAMS_PLAN.on(project), KINEMATICS_PLAN.on(project)
    for symbol, plan in (("V", VELOCITIES), ("a", ACCELERATIONS)):
        motion = plans.motion(plan)
        if motion is None or symbol not in made.planned:
            continue
        chart = made.charts[symbol]
        own = Value(chart.ordinates[0], chart.mu)
        due = Value(made.planned[symbol], motion.mu)
        yield Quantity(NAMES[symbol], chart.unit, (own,), plans.count, due=(due,))


def _whole(scene: Scene) -> Scene:
    """Return the scene with its plans of accelerations: diagrams are judged by them."""
    if ASKED.of(scene) is None:
        return scene
    first, *others = scene.sheets
    first = replace(first, place=(*first.place, ACCELERATIONS))
    return replace(scene, sheets=(first, *others))


def _methods(scene: Scene) -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None:
        for method in ("chords", "tangents"):
            yield method, ASKED.put(scene, replace(order, method=method))


def _starts(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """Yield what is taken from the plans; poles told for the scene's own start do not hold for the other."""
    order = ASKED.of(scene)
    if order is None:
        return
    for start in ("displacement", "velocity"):
        other = order
        if start != order.start:
            other = replace(order, start=start, integral="drawn")
            other = replace(other, S=STANDARD, V=STANDARD, a=STANDARD)
        yield start, ASKED.put(scene, other)


def _poles(scene: Scene) -> tuple[str, ...]:
    return tuple(NAMES.values()) if ASKED.of(scene) is not None else ()


def _finer(start: str, times: float) -> dict[str, float]:
    """Return how μ of each diagram that is found from another changes where poles stand so many times farther.

    What is differentiated comes out so much larger, once or twice; what is integrated so much smaller.
    """
    if start == "velocity":
        return {"S": times, "a": 1.0 / times}
    return {"V": 1.0 / times, "a": 1.0 / times**2}


def _farther(project: Project, times: float) -> dict[Mark, object]:
    """Return the distances of the poles, or the scales that they follow from."""
    made, given, found = DIAGRAMS_PLAN.on(project), project.given, dict[Mark, object]()
    for symbol, change in _finer(made.order.start, times).items():
        chart = made.charts.get(symbol)
        if chart is None:
            continue
        if chart.chosen:
            found[chart.mu] = np.asarray(given[chart.mu]) * change
        for distance in distances(given, VIEWS[symbol]):
            found[distance] = np.asarray(given[distance]) * times
    return found


def _drawn_order(scene: Scene, drawn: Drawn) -> KinematicTask | None:
    """Return what a scene asks for, with the scale factors that it comes to where standard ones are wanted."""
    order = ASKED.of(scene)
    if order is None:
        return order
    return replace(settled(order, whole(order, KINEMATICS_PLAN.on(drawn))), standard=False)


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = _drawn_order(scene, drawn)
    if order is None:
        return scene

    def scaled(symbol: str, one: ScaleOrder) -> ScaleOrder:
        if one.pole is not None:
            return ScaleOrder(None, one.pole * times)
        own = drawn.scales.get(VIEWS[symbol])
        return ScaleOrder(own.value / times if own is not None else one.mu)

    along = None if order.mu_along is None else order.mu_along / times
    base = None if order.mu_along is not None else (order.base or BASE) * times
    return ASKED.put(scene, replace(_scaled(order, scaled), base=base, mu_along=along))


def _scaled(order: KinematicTask, change: Callable[[str, ScaleOrder], ScaleOrder]) -> KinematicTask:
    """Return the same diagrams with the scale of each changed, by its symbol."""
    scales = (change("S", order.S), change("V", order.V), change("a", order.a))
    return replace(order, S=scales[0], V=scales[1], a=scales[2])


WORDS = {
    NAMES["V"]: said("V by diagram"),
    NAMES["a"]: said("a by diagram"),
    "method": said("differentiation"),
    "chords": said("chords"),
    "tangents": said("tangents"),
    "start": said("taken from the plans"),
    "displacement": said("displacement"),
    "velocity": said("velocity"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(DIAGRAMS,),
    axes=(
        Axis("method", _methods, _poles, free=True),
        Axis("start", _starts, _poles),
    ),
    enlarged=_enlarged,
    poles=_poles,
    farther=_farther,
    words=WORDS,
)


FINER = FinerRow(
    whole=_whole,
)
