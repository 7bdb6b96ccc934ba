"""What is asked of accelerations by substitution: in which position."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey

SUBSTITUTION = "substitution"


@dataclass(frozen=True)
class SubstitutionTask:
    """Accelerations of a group of class IV by substitution.

    ``at``: the position, None: the first of those with a plan of accelerations.
    """

    at: str | None = key(
        v.POSITION, "the position that is drawn; left out: the first with accelerations", 1, None
    )


ASKED: SectionKey[SubstitutionTask] = SectionKey(SUBSTITUTION)

SECTIONS = (
    Section(
        SUBSTITUTION, SubstitutionTask,
        "accelerations of a group of class IV by substitution, ε of one plate taken as 0",
        begin='at = 1',
    ),
)  # fmt: skip
