"""What is asked of a Geneva wheel: its slots and pins, sizes of what is drawn (SI)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.bounds import Bound
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey

GENEVA = "geneva"
PIN, FREE = 0.15, 1.5
"""Diameter of a pin that a scene does not give, of the crank: drawn wheels have 0.1 to 0.2; by how many of them
the disc is smaller."""


@dataclass(frozen=True)
class GenevaTask:
    """A wheel with ``slots`` that a crank's pin turns by one pitch and leaves: the slotted link of a mechanism.

    ``pins``: on the crank's disc, evenly; ``pin``: their diameter (m), ``lock``: the radius of the disc that
    holds the wheel meanwhile (m); None: as is usual for the crank.
    """

    slots: int = key(v.number(Bound(3, 24, whole=True)), "how many slots the wheel has", 4)
    pins: int = key(
        v.number(Bound(1, 6, whole=True)), "how many pins the crank's disc bears, evenly", 1, 1
    )
    pin: float | None = key(
        v.POSITIVE_LENGTH, "the diameter of a pin; left out: 0.15 of the crank", "12 mm", None
    )
    lock: float | None = key(
        v.POSITIVE_LENGTH,
        "the radius of the disc that holds the wheel; left out: one and a half pins less than the crank",
        "70 mm",
        None,
    )

    @property
    def spare(self) -> int:
        """2·z − k·(z − 2): above 0 the wheel stands between two pins; below, two would be in slots at once."""
        return 2 * self.slots - self.pins * (self.slots - 2)


ASKED: SectionKey[GenevaTask] = SectionKey(GENEVA)

SECTIONS = (
    Section(
        GENEVA, GenevaTask, "a Geneva wheel: the slotted link turns by one pitch and stands",
        begin="slots = 4",
    ),
)  # fmt: skip
