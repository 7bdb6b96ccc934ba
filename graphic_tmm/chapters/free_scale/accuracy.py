"""How true velocities of pins are by the special point, and by another driving link to a free scale."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.free_scale.record import FREE_SCALE_PLAN
from graphic_tmm.chapters.free_scale.task import ASKED, FREE_SCALE
from graphic_tmm.chapters.kinematics.accuracy import same_place
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow

WORDS = {
    "v special point": said("v of pins by the special point"),
    "v free scale": said("v of pins by another driving link"),
}
"""What is told of by name, in English."""


def _quantities(project: Project) -> Iterator[Quantity]:
    made, velocities = FREE_SCALE_PLAN.on(project), KINEMATICS_PLAN.on(project).velocities
    assert velocities is not None
    ways = (
        tuple(Value(one.usual, velocities.mu) for one in made.results),
        tuple(Value(one.value) for one in made.results),
    )
    for name, values in zip(WORDS, ways, strict=True):
        yield Quantity(name, "m/s", values, 1, due=values, places=(FREE_SCALE,), at=(made.at,))


ACCURACY = Accuracy(
    quantities=_quantities, places=(FREE_SCALE,), compared=tuple(WORDS), words=WORDS
)
FINER = FinerRow(at_count=same_place(ASKED))
