"""The numbers of a planetary train while it is inked."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.planetary.ink_scheme import Scheme2KH, Side
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.paper.symbols.gears import CENTRE_BEYOND, RIM

SIZE, NUMBER = 5.0, 3.5
"""Letters of wheels, and of points, mm."""
OVER = 6.0
"""How far a line goes on behind its last point, mm."""
LEAST = 0.5
"""Shorter vectors are points, mm."""
BESIDE = 2.2
"""From a heavy line to the box of a letter left of it, which leans over, mm."""


class TrainInk:
    """The places of a train's marks, mm.

    ``points``: A, B, C of the circles; ``zeros``: O, A, B, C beside them; ``tips``: a and b of the velocities.
    """

    def __init__(self, reading: Reading, made: Planetary) -> None:
        self.reading, self.made = reading, made
        self.wheels = made.train.scheme.wheels
        self.fixed = self.wheels[-1]
        discs = {
            wheel: Side(*(self.one(mark) for mark in disc))
            for wheel, disc in made.axial.discs.items()
        }
        axis, foot = (self.one(mark) for mark in made.axial.arm)
        self.scheme = Scheme2KH(made.train.scheme, discs, (axis, foot))
        self.centre = self.one(made.end.origin)
        self.points = [self.one(mark) for mark in made.end.points]
        self.zeros = [self.one(mark) for mark in made.picture.zeros]
        self.tips = [self.one(mark) for mark in made.picture.ends]
        self.pole, self.foot = self.one(made.rates.pole), self.one(made.rates.foot)
        self.ends = {body: self.one(mark) for body, mark in made.rates.ends.items()}
        self.axes = [complex(z) for z in np.ravel(reading[made.end.satellites])]
        self.reach = self._reach()

    def one(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return complex(self.reading[mark][0, 0])

    def radius(self, wheel: str) -> float:
        """The pitch radius of a wheel; of the axes of the satellites for "H"."""
        return float(np.ravel(self.reading[self.made.end.lengths[wheel]])[0])

    def ring(self, wheel: str) -> bool:
        """Whether a wheel is a ring."""
        scheme = self.made.train.scheme
        return (wheel == "1" and scheme.first < 0) or (wheel == self.fixed and scheme.second < 0)

    def _reach(self) -> float:
        """The radius that the view along the axis takes."""
        out = [self.radius(w) + (RIM if self.ring(w) else 0.0) for w in ("1", self.fixed)]
        rims = [self.radius(w) for w in self.wheels[1:-1]]
        return max(*out, self.radius("H") + max(rims))

    @property
    def beyond(self) -> float:
        """How far the centre lines of the circles go."""
        return self.reach + CENTRE_BEYOND
