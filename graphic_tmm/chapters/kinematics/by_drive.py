"""Velocities as each drive alone causes them, the others held; added up they come to the plan of velocities.

Velocities are linear in the rates of the drives (superposition), so each drive has a plan of its own, and what
a point has by one of them is carried over to the end of what it has by the others.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import READ, SLIDE, operation
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.task import BY_DRIVE
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect

PRIME = "′"


@operation(
    symbol=f"{READ} + N1 + {SLIDE} + M1 + R1 + M2",
    why=said(
        "Velocities are proportional to the rates of the drives: the velocity of a point is the sum of what "
        "each drive alone gives it."
    ),
)
def added_vector(start: Point, pole: Point, image: Point) -> Point:
    """From {start} lay off the vector from {pole} to {image}; mark {it}."""
    return Point(start + (image - pole))


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


class Summed(NamedTuple):
    """The velocity of a point as a sum: the pole, then where the part of each drive ends; what it bears."""

    pole: Mark
    ends: tuple[Mark, ...]

    @property
    def parts(self) -> tuple[tuple[Mark, Mark], ...]:
        """The ends of each part."""
        return tuple(zip((self.pole, *self.ends), self.ends, strict=False))


def draw_sums(draft: Draft, whole: Motion, by_drive: tuple[ByDrive, ...]) -> tuple[Summed, ...]:
    """Add up the velocities of all points that several drives move, in a view of their own."""
    draft.open(BY_DRIVE)
    pole = draft.take(Point, "p", 0j)
    draft.lay_out(pole, whole.mu)
    found = dict[Mark, Summed]()
    for number, images in whole.images.by_letter.items():
        for letter, image in images.items():
            if image in found or image == whole.images.pole:
                continue
            plans = [one.motion.images for one in by_drive]
            parts = [(one, one.by_letter[number].get(letter, one.pole)) for one in plans]
            parts = [(one, own) for one, own in parts if own != one.pole]
            if len(parts) < 2:  # nothing is to be added
                continue
            ends, end = list[Mark](), pole
            for k, (part, own) in enumerate(parts):
                last = k == len(parts) - 1
                name = image.letter if last else f"{image.letter}{PRIME * (k + 1)}"
                end = draft.draw(added_vector, name, end, part.pole, own)
                ends.append(end)
            found[image] = Summed(pole, tuple(ends))
    return tuple(found.values())
