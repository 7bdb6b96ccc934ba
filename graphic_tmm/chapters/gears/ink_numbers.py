"""The numbers of a gear pair while its meshing is inked."""

from __future__ import annotations

import cmath
import math

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.outline import spot
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.teeth import Wheel

OVER = 14.0
"""How far the line of action, the centre line and the circles go on, mm."""
TICK = 2.0
"""Half of a stroke across the line of action, mm."""
WHOLE, REACH = 450.0, 200.0
"""Where the centres are farther apart, one farther than the second from the pitch point is left out, mm."""
TURN = 16.0
"""Radius of the arrow of an angular velocity, mm."""
ANGLE = 0.4
"""Radius of the arc of α_w, of the length N1N2."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""
SIDES = (-1j, 1j)
"""Where the centres lie from the pitch point."""


class MeshInk:
    """The numbers of a gear pair while it is inked."""

    def __init__(self, reading: Reading, made: Gear) -> None:
        self.reading, self.made, self.line = reading, made, made.line
        self.pole = self.at(made.line.pole)
        self.limits = [self.at(mark) for mark in made.line.limits]
        self.ends = [self.at(mark) for mark in made.line.ends]
        self.centres = [self.at(circles.centre) for circles in made.line.circles]
        self.angle = self.real(made.line.angle)
        self.way = cmath.rect(1.0, math.radians(self.angle))

    def at(self, mark: Mark) -> complex:
        """Where a point stands."""
        return spot(self.reading, mark)

    def real(self, mark: Mark) -> float:
        """A number or a length."""
        return float(self.reading[mark][0, 0])

    def radius(self, mark: Mark) -> float:
        """The radius of an arc, mm."""
        return float(self.reading[mark].radius[0, 0])

    def shown(self, k: int) -> bool:
        """Whether the centre of a wheel stands on the drawing."""
        whole = abs(self.centres[1] - self.centres[0]) <= WHOLE
        return whole or abs(self.centres[k] - self.pole) <= REACH


def circles_of(wheel: Wheel) -> tuple[tuple[Mark, str, str], ...]:
    """Return the circles of a wheel with their pens and letters."""
    own, i = wheel.circles, wheel.sizes.number
    return (
        (own.tip, "thin", f"r_{{a{i}}}"),
        (own.working, "centre", f"r_{{w{i}}}"),
        (own.pitch, "centre", f"r_{{{i}}}"),
        (own.base, "thin", f"r_{{b{i}}}"),
        (own.root, "thin", f"r_{{f{i}}}"),
    )
