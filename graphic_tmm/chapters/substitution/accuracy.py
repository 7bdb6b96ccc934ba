"""How true accelerations of pins are by the special point, and by substitution."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.quantities import Accuracy, Quantity, Value
from graphic_tmm.chapters.kinematics.accuracy import same_place
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.substitution.record import SUBSTITUTION_PLAN
from graphic_tmm.chapters.substitution.task import ASKED, SUBSTITUTION
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.readers.position_count import FinerRow

WORDS = {
    "a special point": said("a of pins by the special point"),
    "a substitution": said("a of pins by substitution"),
}
"""What is told of by name, in English."""


def _quantities(project: Project) -> Iterator[Quantity]:
    made = SUBSTITUTION_PLAN.on(project)
    plans = KINEMATICS_PLAN.on(project)
    for name, marks in zip(
        WORDS,
        ([pin.special for pin in made.pins], [pin.substituted for pin in made.pins]),
        strict=True,
    ):
        values = tuple(Value(mark, made.motion.mu) for mark in marks)
        yield Quantity(name, "m/s²", values, plans.count, due=values, places=(SUBSTITUTION,))


ACCURACY = Accuracy(
    quantities=_quantities, places=(SUBSTITUTION,), compared=tuple(WORDS), words=WORDS
)
FINER = FinerRow(at_count=same_place(ASKED))
