"""Velocities as each drive alone causes them, the others held: together they come to the plan of velocities."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.task import BY_DRIVE
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect


class ByDrive(NamedTuple):
    """The plan of velocities where one drive alone goes; ``pairs``: all drives, that one first."""

    pairs: tuple[DrivenPair, ...]
    motion: Motion

    @property
    def link(self) -> int:
        """The link that goes."""
        return self.pairs[0].link


def draw_by_drive(
    draft: Draft, mechanism: Mechanism, positions: Positions, whole: Motion, *, turned: bool
) -> Iterator[ByDrive]:
    """Draw the plan of each drive; ``whole``, that of all, is the only one of a single drive.

    It is that of the first drive too where nothing moves, for it shows what this one could do.
    """
    for drive in mechanism.drives:
        alone = mechanism.driven_by(drive)
        structure = dissect(alone)
        only = alone.further == () or (mechanism.at_rest and drive == mechanism.drive)
        plan = whole
        if not only:
            view = f"{BY_DRIVE} {drive.link}"
            plan = draw_velocities(draft, alone, structure, positions, turned=turned, view=view)
        yield ByDrive(driven(alone, structure), plan)
