"""What is asked of the places of a plate: which plate, in which position of the mechanism."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey

LOCI = "loci"


@dataclass(frozen=True)
class LociTask:
    """All places of a ``plate`` on three legs, in one position of the mechanism.

    ``plate``: its link, None: of the first group of class III; ``at``: the position, None: the first.
    """

    plate: int | None = key(v.LINK_NUMBER, "the plate on three legs; left out: the first", 3, None)
    at: str | None = key(v.POSITION, "the position that is drawn; left out: the first", 1, None)


ASKED: SectionKey[LociTask] = SectionKey(LOCI)

SECTIONS = (
    Section(
        LOCI, LociTask, "all places of a plate on three legs, by the locus of one of its pins",
        begin='at = 1',
    ),
)  # fmt: skip
