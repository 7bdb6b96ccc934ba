"""The numbers of a planetary train while it is inked."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.planetary.ink_scheme import Scheme2KH, Side
from graphic_tmm.chapters.planetary.pictures import VIEW, Disc
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.seen import Seen
from graphic_tmm.paper.symbols.gears import CENTRE_BEYOND, RIM

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

    def __init__(self, seen: Seen, made: Planetary, heights: Heights) -> None:
        self.seen, self.made, self.heights = seen, made, heights
        self.wheels = made.train.scheme.wheels
        self.fixed = self.wheels[-1]
        discs = {wheel: self.side(disc) for wheel, disc in made.axial.discs.items()}
        pair = made.pair.discs if made.pair is not None else {}
        axis, foot = (self.one(mark) for mark in made.axial.arm)
        self.scheme = Scheme2KH(
            made.train.scheme,
            discs,
            (axis, foot),
            {wheel: self.side(disc) for wheel, disc in pair.items()},
            made.order.driving,
        )
        self.centre = self.one(made.end.origin)
        self.points = [self.one(mark) for mark in made.end.points]
        self.zeros = [self.one(mark) for mark in made.picture.zeros]
        self.tips = [self.one(mark) for mark in made.picture.ends]
        self.pole, self.foot = self.one(made.rates.pole), self.one(made.rates.foot)
        self.ends = {body: self.one(mark) for body, mark in made.rates.ends.items()}
        self.axes = [seen.point(made.end.satellites, k) for k in seen.positions]
        self.reach = self._reach()

    def one(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return self.seen.point(mark, 0)

    def side(self, disc: Disc) -> Side:
        """A wheel from its side."""
        return Side(*(self.one(mark) for mark in disc))

    def figures(self, kind: str) -> list[Figure]:
        """The bodies of a kind, as the plan tells them."""
        told = self.seen.construction.figures
        return [figure for figure in told if figure.view == VIEW and figure.kind == kind]

    def radius(self, wheel: str) -> float:
        """The pitch radius of a wheel; of the axes of the satellites for "H"."""
        return float(np.ravel(self.seen.reading[self.made.end.lengths[wheel]])[0])

    def ring(self, wheel: str) -> bool:
        """Whether a wheel is a ring."""
        return any(figure.name == wheel for figure in self.figures("ring"))

    def _reach(self) -> float:
        """The radius that the view along the axis takes."""
        out = [self.radius(w) + (RIM if self.ring(w) else 0.0) for w in ("1", self.fixed)]
        rims = [self.radius(w) for w in self.wheels[1:-1]]
        return max(*out, self.radius("H") + max(rims))

    @property
    def beyond(self) -> float:
        """How far the centre lines of the circles go."""
        return self.reach + CENTRE_BEYOND
