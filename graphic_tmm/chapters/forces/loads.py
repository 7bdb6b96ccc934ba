"""What acts on the links, and what that is drawn on: forces, couples, loads, reactions handed on."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.task import Spring
from graphic_tmm.chapters.forces.travel import Traveller
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.by_drive import ByDrive
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.mechanism.records import Mechanism

VIEW = "loads"


class Force(NamedTuple):
    """A force on a link: its letter, its point of application, line of action, size (N, signed along it).

    ``image``: of the point, as a point of that link, on the plan of velocities.
    """

    letter: str
    link: int
    point: Mark
    line: Mark
    value: Mark
    image: Mark | None = None


class Couple(NamedTuple):
    """A couple on a link: its letter, its moment (N·m, counter-clockwise positive).

    ``rubs``: of friction, the letter of its pair and the link on the other side of it.
    """

    letter: str
    link: int
    value: Mark
    rubs: tuple[str, int] | None = None


class Ends(NamedTuple):
    """The ends of a spring, that of a moving link first: their letters, their links."""

    letters: tuple[str, str]
    links: tuple[int, int]

    @property
    def names(self) -> tuple[str, str]:
        """Both letters as one word, from either end: AC, CA."""
        first, last = self.letters
        return first + last, last + first

    @property
    def indices(self) -> tuple[str, str]:
        """The indices of the forces on its ends, each towards the other: {AC}, {CA}."""
        first, last = self.names
        return f"{{{first}}}", f"{{{last}}}"


class Sprung(NamedTuple):
    """A spring as drawn: its ends, its length (mm), the force of the spring alone, N; none of a damper.

    ``number``: the index of what it is given by.
    """

    spring: Spring
    ends: Ends
    length: Mark | None
    force: Mark | None
    number: str = ""


@dataclass
class Loads:
    """What acts on the links: as kinetostatics takes it, and as it is carried onto the lever.

    They differ where an inertia force and couple are replaced by one force. ``given``: the sizes of the loads
    that the scene gives, in their order; ``travels``: what those of them go by that vary with a travel;
    ``springs``: those between links.
    """

    forces: list[Force] = field(default_factory=list)
    couples: list[Couple] = field(default_factory=list)
    on_lever: list[Force] = field(default_factory=list)
    couples_on_lever: list[Couple] = field(default_factory=list)
    given: list[Mark] = field(default_factory=list)
    travels: dict[Mark, Traveller] = field(default_factory=dict)
    springs: list[Sprung] = field(default_factory=list)

    @property
    def outer(self) -> tuple[Mark, ...]:
        """The sizes of the loads that are not inertia's."""
        sizes = [force.value for force in self.on_lever]
        sizes += [couple.value for couple in self.couples_on_lever]
        return tuple(size for size in sizes if size.role != roles.INERTIA)

    def add(self, load: Force | Couple) -> None:
        """Enter a load that both methods take alike."""
        if isinstance(load, Force):
            self.forces.append(load)
            self.on_lever.append(load)
        else:
            self.couples.append(load)
            self.couples_on_lever.append(load)


@dataclass
class Acting:
    """What acts on the links while groups are solved one after another: loads, then reactions handed on."""

    forces: dict[int, list[Force]] = field(default_factory=dict)
    couples: dict[int, list[Couple]] = field(default_factory=dict)

    def add(self, load: Force | Couple) -> None:
        """Enter a load."""
        if isinstance(load, Force):
            self.forces.setdefault(load.link, []).append(load)
        else:
            self.couples.setdefault(load.link, []).append(load)


class Ground(NamedTuple):
    """What loads are drawn on: the board, the mechanism, its plans, how the velocity plan is turned.

    ``by_drive``: velocities as each drive alone causes them.
    ``quarters``: right angles by which a vector of the velocity plan is turned into its true direction.
    ``survey``: the mechanism at any angles. ``numbers``: where each position stands in the row, which has so
    many ``turns`` of so many ``intervals``; ``steps``: of one that does not close, how far each position
    is from the first as it goes.
    """

    draft: Draft
    mechanism: Mechanism
    positions: Positions
    velocities: Motion
    by_drive: tuple[ByDrive, ...]
    accelerations: Motion | None
    quarters: int
    survey: Survey
    numbers: np.ndarray
    intervals: int
    turns: int = 1
    steps: np.ndarray | None = None

    @property
    def pairs(self) -> tuple[DrivenPair, ...]:
        """What is driven, the drive of the row first."""
        return self.survey.pairs

    @property
    def pin_speed(self) -> Mark:
        """The segment of the velocity that the first drive gives (Length)."""
        return self.draft.uses(self.velocities.driven[self.pairs[0].link][1])[1]


def point_of(ground: Ground, link: int, letter: str) -> tuple[Mark, Mark]:
    """Return a link's point on the plan of positions, and its image on that of velocities."""
    body = ground.positions.bodies[link]
    return body.marks[letter], ground.velocities.images.by_letter[link][letter]
