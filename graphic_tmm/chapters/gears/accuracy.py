"""How accurate a pair of gears is: the contact ratio, by the line of action and by the arc of a tooth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import pi

from graphic_tmm.accuracy.quantities import Accuracy, Axis, Quantity, Value
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.task import ASKED, GEARS
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

STEPS = (4, 6, 8, 12, 16, 24, 48)
"""Steps of a rolling."""


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield the contact ratio as drawn on the line of action, and by the arc that a tooth goes through."""
    made = GEARS_PLAN.on(project)
    due = Value(made.sizes.contact_ratio)
    wheel, size = made.contact.wheels[0], made.sizes.wheels[0]
    pitch = 2.0 * pi / made.order.z1
    yield Quantity("contact_ratio", "", (Value(made.contact.drawn),), due=(due,))
    # the arc is as long as the contact ratio times the pitch on the working circle
    arc = Value(wheel.real, 1.0 / pitch)
    due = Value(made.sizes.contact_ratio, size.r_w)
    yield Quantity("contact_arc", "m", (arc,), due=(due,))


def _rolled(scene: Scene) -> Iterator[tuple[str, Scene]]:
    order = ASKED.of(scene)
    if order is not None:
        for n in sorted({*STEPS, order.steps}):
            yield str(n), ASKED.put(scene, replace(order, steps=n))


def _own(scene: Scene) -> int:
    order = ASKED.of(scene)
    return order.steps if order is not None else 0


def _enlarged(scene: Scene, drawn: Drawn, times: float) -> Scene:
    order = ASKED.of(scene)
    if order is None:
        return scene
    mu = drawn.scales[GEARS_PLAN.on(drawn).line.mu.view].value
    return ASKED.put(scene, replace(order, mu=mu / times, axes=None))


WORDS = {
    "contact_ratio": said("contact ratio, line"),
    "contact_arc": said("contact ratio, arc"),
    "steps": said("rolling steps"),
}
"""What is told of by name, in English."""

ACCURACY = Accuracy(
    quantities=_quantities,
    places=(GEARS,),
    axes=(Axis("steps", _rolled, parts=_own, counted=said("{n} step", "{n} steps")),),
    enlarged=_enlarged,
    words=WORDS,
)
