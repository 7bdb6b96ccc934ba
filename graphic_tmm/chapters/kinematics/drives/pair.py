"""What a drive tells of itself: where its link stands, its velocity and acceleration, sizes and words."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import (
    angle_by_angle,
    angle_by_length,
    length_by_angle,
    length_by_length,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number, Reals
from graphic_tmm.chapters.kinematics.bodies import Body, Positions
from graphic_tmm.chapters.kinematics.motion import Motion, hold
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines
from graphic_tmm.fitting.choice import Ledger
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Drive, Mechanism, Sweep
from graphic_tmm.readers.task_sheet import Given, given_figures
from graphic_tmm.scene.quantities import turns_a_minute

_FOLLOW = {
    (True, True): angle_by_angle,
    (True, False): angle_by_length,
    (False, True): length_by_angle,
    (False, False): length_by_length,
}
"""How a drive follows the first: by whether it turns, and whether the first does."""
T = TypeVar("T")
Uses = Callable[[Mark], tuple[Mark, ...]]


class Sizes(NamedTuple, Generic[T]):
    """What is known of a drive before anything is drawn: a length, a velocity, an acceleration."""

    length: T
    speed: T
    acceleration: T


@dataclass(frozen=True)
class DrivenPair(ABC):
    """A pair whose coordinate is given."""

    mechanism: Mechanism
    driven: Driven

    @classmethod
    @abstractmethod
    def fits(cls, driven: Driven) -> bool:
        """Whether it is a drive of this kind."""

    @property
    def drive(self) -> Drive:
        """The drive, as the scene gives it."""
        return self.driven.drive

    @property
    def speed(self) -> float:
        """Its rate; of what stands, a possible one of the first drive, 1 of its unit, others held."""
        if self.mechanism.at_rest and self.drive == self.mechanism.drive:
            return float(self.drive.sense)
        return self.drive.speed

    def rates(self, *, signed: bool) -> float | Reals:
        """Return its rate as it is given: a number, or a row of positions (1, position)."""
        if self.drive.rates and not self.mechanism.at_rest:
            row = np.array(self.drive.rates)[None, :]
            return row if signed else np.abs(row)
        return self.speed if signed else abs(self.speed)

    def time(self, way: float) -> float:
        """Return how long it takes over a way (° or m), s, as it goes at one speed."""
        return (math.radians(way) if self.sweep.turns else way) / abs(self.speed)

    @property
    def gains(self) -> float | Reals:
        """Its second rate as it is given: a number, or a row of positions (1, position)."""
        return np.array(self.drive.gains)[None, :] if self.drive.gains else self.drive.acceleration

    @property
    def listed(self) -> bool:
        """Whether its speed or its acceleration is listed by positions."""
        return bool(self.drive.rates or self.drive.gains)

    def take(self, draft: Draft, letter: str, rate: float | Reals, unit: str) -> Mark:
        """Take a rate or a second rate as it is given."""
        return draft.take(Number, letter, rate, unit, roles.RATE if np.size(rate) > 1 else "")

    @property
    def held(self) -> bool:
        """Whether it follows another drive and stands still: nothing is drawn of what it does."""
        moves = self.drive.speed or self.drive.acceleration or self.listed
        return self.drive != self.mechanism.drive and not moves

    @property
    def pair(self) -> Pair:
        """The pair that it drives."""
        return self.driven.pair

    @property
    def link(self) -> int:
        """The link that it drives."""
        return self.driven.link

    @property
    @abstractmethod
    def sweep(self) -> Sweep:
        """What its coordinate can go through."""

    @abstractmethod
    def ask(self, draft: Draft) -> Mark:
        """Take its coordinate, whose value is found later."""

    def arm_ends(self, positions: Positions) -> tuple[Mark, ...]:
        """Return the ends of the arm that turns about a fixed pivot; none where there is none."""
        return ()

    @abstractmethod
    def led(self, positions: Positions) -> tuple[Mark, Mark]:
        """Return the mark about which it leads, and the one that it leads."""

    def path(self, positions: Positions, uses: Uses) -> Mark:
        """Return the line along which it slides; ``uses``: what the step of a mark used."""
        raise NotImplementedError

    @property
    def speed_letter(self) -> str:
        """The letter of the velocity that is given."""
        return f"v_{self.driven.pin}"

    @property
    def gain_letter(self) -> str:
        """The letter of the acceleration that is given."""
        return f"a_{self.driven.pin}"

    @abstractmethod
    def stand(self, draft: Draft, bodies: dict[int, Body], at: Mark) -> None:
        """Draw its link at a coordinate; of a leg of changing length, nothing yet."""

    def hold(self, positions: Positions, plan: Motion) -> None:
        """Enter its link into a plan in which it stands still; of a leg held at its length, nothing."""
        if not self.driven.telescopes:
            hold(plan, positions.bodies[self.link])

    @abstractmethod
    def velocity(self, positions: Positions, plan: Motion, lines: VelocityLines) -> None:
        """Draw the velocity that it gives."""

    @abstractmethod
    def acceleration(
        self, draft: Draft, positions: Positions, velocities: Motion, plan: Motion
    ) -> None:
        """Draw the acceleration that it gives."""

    def follow(self, draft: Draft, first: DrivenPair, row: Mark, zero: float) -> Mark:
        """Return its coordinate where the first drive stands at a row that begins at ``zero``."""
        own, other = self.sweep, first.sweep
        kinds = {True: Angle, False: Number}
        op = _FOLLOW[own.turns, other.turns]
        number = f"{own.letter}_{{{self.link}}}"
        start = draft.take(
            kinds[own.turns], f"{own.letter}_{{{self.link},0}}", self.drive.start, own.unit
        )
        per = math.degrees(1.0) if own.turns else 1.0, math.degrees(1.0) if other.turns else 1.0
        ratio = self.speed_ratio(first) * per[0] / per[1]
        unit = "" if own.turns == other.turns else f"{own.unit}/{other.unit}"
        share = draft.take(Number, f"i_{{{self.link}{first.link}}}", ratio, unit)
        begin = draft.take(kinds[other.turns], f"{other.letter}_{{0}}", zero, other.unit)
        return draft.draw(op, number, start, share, row, begin, unit=own.unit)

    def speed_ratio(self, first: DrivenPair) -> float:
        """Return how many times as fast as the first drive it goes (SI); what stands stays where it is."""
        return self.drive.speed / first.drive.speed if self.drive.speed else 0.0

    @property
    def sizes(self) -> Sizes[float]:
        """What is known of it beforehand (SI)."""
        return Sizes(reach(self.mechanism), abs(self.speed), abs(self.drive.acceleration))

    def rate_known(self, ledger: Ledger) -> Mark:
        """Write down the rate that is given: v (m/s); of what turns ω (1/s)."""
        return ledger.quantity(self.speed_letter, abs(self.speed), "m/s")

    @property
    @abstractmethod
    def segments(self) -> Sizes[str]:
        """The letters of the segments that show that: OA, pa, πa."""

    def length_known(self, ledger: Ledger) -> Mark | None:
        """Write down the length that is known (m); None where there is none."""
        return None

    def speed_known(self, ledger: Ledger) -> Mark:
        """Write down the velocity that is known (m/s)."""
        return self.rate_known(ledger)

    def gain_known(self, ledger: Ledger) -> Mark | None:
        """Write down the acceleration that is known (m/s²); None where there is none."""
        if self.listed or not self.drive.acceleration:
            return None
        return ledger.quantity(self.gain_letter, abs(self.drive.acceleration), "m/s²")

    @property
    def unit(self) -> str:
        """The unit of its speed; that of its acceleration is this by s."""
        return "m/s"

    def stated(self, language: str) -> Iterator[str]:
        """Tell in a sentence from where its coordinate is counted, if nothing else shows that."""
        yield from ()

    def given(self, language: str) -> Iterator[Given]:
        """Yield its speed and its acceleration in its sense; of a long row between which they lie."""
        for letter, row, unit in self.speeds_given():
            yield Given(letter, given_figures(row, language), unit)

    def speeds_given(self) -> Iterator[tuple[str, tuple[float, ...], str]]:
        """Yield the letters of its speed and its acceleration, each with its figures by positions, its unit."""
        drive, unit = self.drive, self.unit
        rates = [abs(rate) for rate in (drive.rates if drive.speed else ()) or (drive.speed,)]
        turns = [turns_a_minute(rate) for rate in rates if drive.speed and unit == "1/s"]
        known = [turn for turn in turns if turn is not None]
        if len(known) == len(rates):
            yield f"n_{self.link}", tuple(known), "rpm"
        else:
            yield self.speed_letter, tuple(rates), unit
        if drive.acceleration:
            gains = (drive.sense * gain for gain in drive.gains or (drive.acceleration,))
            yield self.gain_letter, tuple(gains), f"{unit}²"


def reach(mechanism: Mechanism, without: Collection[int] = ()) -> float:
    """Return how far all bodies of a mechanism together reach, m; ``without``: some of them."""
    found = 0.0
    for number, link in mechanism.by_number.items():
        spots = [*link.points.values(), *(guide.through for guide in link.guides)]
        if number not in without:
            found += max((abs(a - b) for a in spots for b in spots), default=0.0)
        found += sum(abs(slide.offset) for slide in link.slides)
    return found
