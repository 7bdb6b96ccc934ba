"""How accurate the balance of a rotor is: what closes its polygons, where they do not close by themselves."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.rotors.plan import ROTOR_PLAN
from graphic_tmm.chapters.rotors.task import ROTOR
from graphic_tmm.project import Project

_NAMES = ("1", "k", "I", "II", "A", "B")


def _quantities(project: Project) -> Iterator[Quantity]:
    """Yield the unbalances that are read off; where none is, that of a mass, which is not drawn to be found."""
    made = ROTOR_PLAN.on(project)
    left = {one.name: one.size for one in (*made.weights, *made.reactions) if one.size is not None}
    for name, size in (left or {"1": made.rows[0].size}).items():
        value = Value(size)
        yield Quantity(f"rotor_D_{name}", "kg·m", (value,), due=(value,))


ACCURACY = Accuracy(
    quantities=_quantities,
    places=(ROTOR,),
    words={f"rotor_D_{name}": f"D_{name}" for name in _NAMES},
)
