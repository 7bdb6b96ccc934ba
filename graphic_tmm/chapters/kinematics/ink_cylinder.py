"""A cylinder that swings, in ink: its tube, the piston on its rod, what presses on the piston.

The lengths of tube and rod follow from how far the pin of the rod moves along the axis over the turn, so that
the piston stays in the tube and the pin out of it in every position. The tube ends at the pivot of the cylinder
where the rod leaves room for that; else it hangs in the middle and reaches behind its pivot.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.paper.arithmetic import bearing, larger, smaller
from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.labels import TOGETHER
from graphic_tmm.paper.symbols.kinematic import (
    JOINT_RADIUS,
    PISTON_LENGTH,
    PORT,
    TUBE_WIDTH,
    piston,
    port,
    tube,
)

OUT, BEFORE = JOINT_RADIUS + 1.5, JOINT_RADIUS + 3.5
"""So far the pin of the rod stays out of the tube, and the tube ends before its pivot, mm."""
ROOM = 2.0
"""What is left between the piston and the ends of the tube in its outermost places, mm."""

BEYOND = 8.0
"""So far the line of a named axis goes on behind tube and pivot, mm."""


class Cylinder(NamedTuple):
    """A tube along its axis, mm from where its link is told from, and the rod of its piston.

    ``sense``: which way along the axis the rod runs from its pin; lengths are counted that way. ``open``: the
    end through which the rod goes, ``closed``: the other; ``rod``: from the pin to the middle of the piston.
    """

    sense: float
    open: float
    closed: float
    rod: float

    def place(self, foot: complex, way: complex) -> Placed:
        """Return it where it stands: ``foot`` is the point of the axis that it is told from."""
        return Placed(self, foot, self.sense * way)


def cylinder(reach: Reach) -> Cylinder:
    """Return the cylinder whose piston rod's pin moves over a reach (mm) of the axis."""
    sense = -1.0 if reach.low + reach.high > 0.0 else 1.0
    ends = sense * reach.low, sense * reach.high
    far, near = smaller(*ends), larger(*ends)
    inside = near - far + PISTON_LENGTH + 2 * ROOM
    closed = larger(near + OUT + inside, -BEFORE)
    return Cylinder(sense, closed - inside, closed, closed - ROOM - PISTON_LENGTH / 2 - near)


class Placed(NamedTuple):
    """A cylinder in one position."""

    of: Cylinder
    foot: complex
    way: complex

    @property
    def ends(self) -> tuple[complex, complex]:
        """The middles of both ends of the tube, that of the rod first."""
        return self.foot + self.of.open * self.way, self.foot + self.of.closed * self.way

    @property
    def corners(self) -> list[complex]:
        """The corners of the tube."""
        half = 1j * self.way * TUBE_WIDTH / 2
        first, last = self.ends
        return [first + half, last + half, last - half, first - half]

    def piston(self, pin: complex) -> complex:
        """Return the middle of the piston whose rod has its pin at a point of the axis."""
        return pin + self.of.rod * self.way

    def tube(self) -> Iterator[Stroke]:
        """Yield the tube."""
        yield from tube(*self.ends)

    def face(self, pin: complex) -> complex:
        """Return where the rod with its pin there meets the piston."""
        return self.piston(pin) - PISTON_LENGTH / 2 * self.way

    def head(self, pin: complex) -> Iterator[Stroke]:
        """Yield the piston."""
        yield from piston(self.piston(pin), bearing(self.way))

    def axis(self, pin: complex) -> tuple[complex, complex]:
        """Return the ends of the axis between the piston and the pivot, if that is behind it."""
        piston = self.piston(pin)
        behind = ((piston - self.foot) / self.way).real
        return piston, self.foot + larger(behind, 0.0) * self.way

    def guide(self, pin: complex) -> tuple[complex, complex]:
        """Return the ends of the line that the guide is lettered at: from the piston to behind the tube."""
        return self.piston(pin), self.foot + (larger(self.of.closed, 0.0) + BEYOND) * self.way

    def held(self, spots: list[complex], pen: str) -> Iterator[Stroke]:
        """Yield what holds points of the link to its tube: the shortest way from each that lies off it."""
        for spot in spots:
            own = (spot - self.foot) / self.way
            along = smaller(larger(own.real, self.of.open), self.of.closed)
            near = along + 1j * smaller(larger(own.imag, -TUBE_WIDTH / 2), TUBE_WIDTH / 2)
            if abs(own - near) > TOGETHER:
                yield line(pen, spot, self.foot + near * self.way)

    def filled(self, contents: str) -> Iterator[Stroke]:
        """Yield the sign of what presses on the piston, at the closed end, on the upper side of the tube."""
        side = 1j * self.way if (1j * self.way).imag >= 0.0 else -1j * self.way
        wall = self.ends[1] - (PORT / 2 + ROOM / 2) * self.way + side * TUBE_WIDTH / 2
        yield from port(wall, -side, filled=contents == "oil")
