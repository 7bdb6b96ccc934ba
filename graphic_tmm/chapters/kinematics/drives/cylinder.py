"""A cylinder between two links that move: its rod, driven out of it, makes both one leg as long as is given.

The group of that leg is closed as by any link of this length. On the plans of vectors what the rod does, seen
from the cylinder, is laid off first, from the image of the pivot: v_r along the rod; then 2·ω·v_r square to it
and a_r along it. What is left turns as a link of this length does, so that its end and the image of the other
pin are the base on which the images of both, rod and cylinder, are similar.
"""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.kinematics.bodies import Body, Positions
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair, Sizes, Uses, reach
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.records import Sweep


class Cylinder(DrivenPair):
    """A rod in its cylinder; its coordinate is how far apart the pins of both are, m."""

    @classmethod
    def fits(cls, driven: Driven) -> bool:
        """Whether a rod runs out of a link that moves."""
        return driven.telescopes

    @property
    def _ends(self) -> tuple[int, int]:
        """The cylinder and its rod."""
        rod, cylinder = self.pair.links
        return cylinder, rod

    @property
    def sweep(self) -> Sweep:
        """From nothing to as far as all other links together reach."""
        most = reach(self.mechanism, without=self._ends)
        return Sweep("l", "m", 0.0, most, False, f"l_{self._pivot}{self.driven.pin}")

    @property
    def _pivot(self) -> str:
        """The only letter by which the cylinder is joined to other links."""
        number, bodies = self._ends[0], self.mechanism.by_number
        others = {letter for n, body in bodies.items() if n != number for letter in body.points}
        return next(letter for letter in bodies[number].points if letter in others)

    def ask(self, draft: Draft) -> Mark:
        """Take how far apart both pins are."""
        return draft.ask(Number, "l", "m")

    def stand(self, draft: Draft, bodies: dict[int, Body], at: Mark) -> None:
        """Draw nothing yet: its group does."""

    def led(self, positions: Positions) -> tuple[Mark, Mark]:
        """Return the pivot of the cylinder, and the pin of the rod."""
        cylinder, rod = (positions.bodies[number] for number in self._ends)
        return cylinder.marks[self._pivot], rod.marks[self.driven.pin]

    def path(self, positions: Positions, uses: Uses) -> Mark:
        """Return the line from the outer pin of both to the inner one."""
        return positions.bodies[self._ends[0]].axis

    @property
    def speed_letter(self) -> str:
        """The letter of the relative velocity that is given."""
        return "v_r" if len(self.mechanism.drives) == 1 else f"v_{{r{self.link}}}"

    @property
    def gain_letter(self) -> str:
        """The letter of the relative acceleration that is given."""
        return self.speed_letter.replace("v", "a")

    def velocity(self, positions: Positions, plan: Motion, lines: VelocityLines) -> None:
        """Take how fast the rod runs out; its group draws it."""
        speed = self.take(lines.draft, self.speed_letter, self.rates(signed=True), "m/s")
        plan.speeds[self.link] = speed

    def acceleration(
        self, draft: Draft, positions: Positions, velocities: Motion, plan: Motion
    ) -> None:
        """Take how fast it gains speed, if it does; its group draws it."""
        if self.drive.acceleration:
            gain = self.take(draft, self.gain_letter, self.gains, "m/s²")
            plan.speeds[self.link] = gain

    @property
    def segments(self) -> Sizes[str]:
        """Of the relative velocity and acceleration."""
        return Sizes("", f"[{self.speed_letter}]", f"[{self.gain_letter}]")


DRIVE = Cylinder
