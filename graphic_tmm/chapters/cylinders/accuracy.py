"""How accurate the polygons of an engine's inertia are: what remains, where something does."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN
from graphic_tmm.chapters.cylinders.task import CYLINDERS
from graphic_tmm.chapters.cylinders.words import KINDS, ROMAN
from graphic_tmm.project import Project


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield what remains; where nothing does, the force of a cylinder, which is not drawn to be found."""
    made = CYLINDERS_PLAN.on(project)
    left = {kind: rest.size for kind, rest in made.rests.items() if rest.size is not None}
    for kind, size in (left or {"F1": made.orders[0]}).items():
        value = Value(size)
        yield Quantity(f"cylinders_{kind}", size.unit, (value,), due=(value,))


ACCURACY = Accuracy(
    quantities=_quantities,
    places=(CYLINDERS,),
    words={f"cylinders_{kind}": f"{kind[0]}_{ROMAN[kind[1]]}" for kind in KINDS},
)
