"""How finely a reading can be told: what is lost between the paper and the row of a file.

A figure is read with the slip of the hand and the divisions of its ruler, and written with so many digits.
What the hand measures has its slip in it already; what it calculates (a length laid off, a rate) has none
until somebody reads it off the paper. A coordinate is read with a slip of its own.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand, Streams
from graphic_tmm.board.values import Reals
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.records import Last
from graphic_tmm.scene.records import Scene


class Pointing(NamedTuple):
    """How x and y are read: the standard deviation of each is ``hand`` of the slip of the hand, or ``mm``."""

    hand: float
    mm: float


POINTS: Mapping[str, Pointing] = {
    "paper": Pointing(hand=1.0, mm=0.0),
    "screen": Pointing(hand=0.0, mm=0.1),
    "photo": Pointing(hand=0.0, mm=0.5),
}
"""With ruler and square on the paper; by a cursor on the drawing itself; by a cursor on a photograph of it.

0.1 mm is what a cursor on an enlarged drawing leaves; 0.5 mm what corners clicked to 2 px leave of the
photograph of an A1 (0.7 mm at most). That is the most of it: where many points were read, the drawing
itself tells how much of it there is.
"""
GIVEN = 0.005
"""What the scene gives is right to three digits: it is looked at for slips, not for rounding. Could be
at least 0.002 to 0.015."""


class Reader(NamedTuple):
    """Who reads a drawing: the hand that drew it, with the coarser of its ruler and the sheet's.

    ``points``: how points are read.
    ``finest``: the finer of the two rulers, mm; 0 for one without divisions.
    """

    hand: Hand
    points: str = "paper"
    finest: float = 0.0

    @property
    def half(self) -> float:
        """Half a division of the ruler, mm."""
        return 0.5 * (self.hand.ruler or 0.0)

    def unblurred(self, written: float) -> float:
        """Return how far rounding alone carries a length read off the paper, mm; see `slips`."""
        return slips.unblurred(self.half, written, self.hand.reading)

    def lost(self, last: Last, share: float = 1.0) -> float:
        """Return how far rounding alone carries a point, mm: the digits written, less the slip of reading it.

        ``share``: of that slip, as a drawing has it.
        """
        return slips.lost(last.x, last.y, share * self.pointing)

    def rounding(self, figure: float) -> float:
        """Return half a unit of the last digit that the hand keeps in a calculation."""
        return 0.0 if self.hand.digits is None else slips.rounding(self.hand.digits, figure)

    def calculated(self, length: float) -> bool:
        """Whether a length is written finer than the rulers divide: calculated, not read off the paper."""
        return bool(self.finest) and slips.between(length, self.finest)

    @property
    def pointing(self) -> float:
        """The standard deviation of a coordinate, mm."""
        share, own = POINTS.get(self.points, Pointing(hand=0.0, mm=0.0))
        return max(share * self.hand.reading, own)

    @property
    def sharp(self) -> Reader:
        """Who reads the same drawing, but coordinates without a slip."""
        return self._replace(points="exact")

    def chance(self, key: str, shape: tuple[int, int]) -> Reals:
        """Return standard normal numbers of a stream of their own."""
        return Streams(self.hand).normal(f"read|{key}", 0, 0, shape)

    def measured(self, length: Reals, key: str) -> Reals:
        """Return lengths (trial, position) that were drawn, as they are read off the paper."""
        return self.hand.read(length + self.hand.reading * self.chance(key, length.shape))

    def pointed(self, spot: np.ndarray, key: str) -> np.ndarray:
        """Return points (trial, position) as their coordinates are read."""
        wide = (spot.shape[0], 2 * spot.shape[1])
        spot = spot + self.pointing * self.chance(key, wide).view(np.complex128)
        if self.points != "paper":
            return spot
        return np.asarray(self.hand.read(spot.real) + 1j * self.hand.read(spot.imag))


def reader(scene: Scene, hand: Hand, points: str) -> Reader:
    """Return who reads a drawing of a scene."""
    rulers = [ruler for ruler in (hand.ruler, scene.ruler) if ruler is not None]
    finest = 0.0 if scene.ruler is None else min(rulers)
    return Reader(hand._replace(ruler=max(rulers, default=None)), points, finest)
