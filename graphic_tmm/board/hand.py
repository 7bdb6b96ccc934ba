"""The hand that works at the board: how far pencil, compass, square and ruler slip.

Five slips: the prick of a point, the opening of the compass, the swing of a ray drawn with the square or the
protractor, the reading of the ruler, the digits of a calculation. The exact hand has none of them. Random
streams are keyed by the seed, the plan and the letter, so that slices of the log, blocks of positions and the
order of links change nothing.
"""

from __future__ import annotations

import hashlib
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import Arc, Length, Line, Number, Point, Reals

SWUNG = frozenset({"parallel", "square", "incline", "ray", "action", "tangent", "directed"})
"""Rays drawn with the square, the protractor or by eye; a line through two points is as good as they are."""
KEPT = frozenset(
    {"coincide", "at_zero", "following", "farthest", "highest", "lowest", "next_satellite", "stand"}
)
"""Operations that name what stands there already: nothing is drawn anew."""
TRIALS = 512
"""Trials in one block of random numbers."""


class Hand(NamedTuple):
    """How far a hand slips: standard deviations in mm, ``swing`` in degrees; 0 for no slip.

    ``ruler``: its division in mm, None for readings without rounding; ``digits``: significant digits of a
    calculation, None for all. ``seed`` of the random streams; ``trials``: how often everything is drawn.
    ``alone``: keys of slips of which but one slips in each trial, in turn, and nothing else; () for all of them.
    """

    ruler: float | None = None
    prick: float = 0.0
    compass: float = 0.0
    swing: float = 0.0
    reading: float = 0.0
    digits: int | None = None
    seed: int = 0
    trials: int = 1
    alone: tuple[str, ...] = ()

    @property
    def slips(self) -> bool:
        """Whether anything is left to chance."""
        return max(self.prick, self.compass, self.swing, self.reading) > 0.0

    def read(self, length: Reals) -> Reals:
        """Return a length as read off the ruler; ties go up and do not depend on the last bit."""
        if self.ruler is None:
            return length
        divisions = np.floor(np.abs(length) / self.ruler + (0.5 + 1e-9))
        return np.asarray(np.copysign(divisions * self.ruler, length) + 0.0)

    def calculate(self, number: Reals) -> Reals:
        """Return a calculated number with so many digits as the hand keeps."""
        if self.digits is None:
            return number
        size = np.abs(number)
        fine = np.isfinite(size) & (size > 0.0)
        places = np.floor(np.log10(np.where(fine, size, 1.0))) - (self.digits - 1)
        unit = 10.0**places
        return np.where(fine, np.round(number / unit) * unit, number)


EXACT = Hand()
HANDS = {
    "exact": EXACT,
    "cad": Hand(ruler=0.01, prick=0.002, compass=0.002, swing=0.002, reading=0.0, digits=6),
    "careful": Hand(ruler=0.1, prick=0.1, compass=0.1, swing=0.15, reading=0.15, digits=5),
    "student": Hand(ruler=0.5, prick=0.15, compass=0.15, swing=0.6, reading=0.75, digits=4),
}
"""Named hands; the student's is fitted to 49 published examples (see the README)."""


class Slip(NamedTuple):
    """What of a step's result slips: its kind, the key of its random stream."""

    kind: str
    key: str


def slip_of(op: Operation, view: str, letter: str) -> Slip | None:
    """Return how the result of an operation slips, None if it does not."""
    kind = None
    if op.reads:
        kind = "reading"
    elif op.formula and op.leaves in (Length, Number):
        kind = "digits"
    elif op.leaves is Point and op.name not in KEPT:
        kind = "prick"
    elif op.leaves is Arc:
        kind = "compass"
    elif op.leaves is Line and op.name in SWUNG:
        kind = "swing"
    return None if kind is None else Slip(kind, f"{view}|{letter}|{kind}")


def stream(hand: Hand, key: str, block: int) -> np.random.Generator:
    """Return the random stream of a step in a block of trials."""
    text = f"{hand.seed}|{key}|{block}".encode()
    words = np.frombuffer(hashlib.blake2b(text, digest_size=16).digest(), dtype=np.uint64)
    return np.random.Generator(np.random.Philox(key=words))


class Slipping(NamedTuple):
    """A hand at work in one block of trials, at some positions out of the ``whole`` row."""

    hand: Hand
    block: int
    trials: int
    whole: int
    places: Any

    def normal(self, slip: Slip, width: int, part: slice, way: str = "") -> Reals:
        """Return standard normal numbers (trial, position); one a trial where a value does not vary.

        ``way``: which of several independent slips of the step.
        """
        found = stream(self.hand, slip.key + way, self.block)
        if width == 1:
            drawn = found.standard_normal((self.trials, 1))
        else:
            drawn = found.standard_normal((self.trials, self.whole))[:, self.places][:, part]
        return np.asarray(drawn * self._turns(slip) if self.hand.alone else drawn)

    def _turns(self, slip: Slip) -> Reals:
        """Return 1 in the trials (trial, 1) in which this step slips alone, 0 in those in which another does."""
        alone = self.hand.alone
        own = alone.index(slip.key) if slip.key in alone else -1
        trials = self.block * TRIALS + np.arange(self.trials)
        return np.asarray(trials % len(alone) == own, dtype=np.float64)[:, None]

    def apply(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return the result of a step as this hand leaves it."""
        hand = self.hand
        if slip.kind == "digits":
            return hand.calculate(value)
        if slip.kind == "reading":
            if hand.reading > 0.0:
                value = value + hand.reading * self.normal(slip, value.shape[1], part)
            return hand.read(value)
        if slip.kind == "prick":
            if hand.prick == 0.0:
                return value
            width = value.shape[1]
            across = self.normal(slip, width, part, "|y")
            return value + hand.prick * (self.normal(slip, width, part) + 1j * across)
        if slip.kind == "compass":
            if hand.compass == 0.0:
                return value
            wide = max(value.centre.shape[1], value.radius.shape[1])
            return Arc(value.centre, value.radius + hand.compass * self.normal(slip, wide, part))
        if hand.swing == 0.0:
            return value
        wide = max(value.at.shape[1], value.along.shape[1])
        turn = np.radians(hand.swing) * self.normal(slip, wide, part)
        # (1 + i·t/2)/(1 − i·t/2) has the length 1 and, of a turn so small, the angle t
        half = 0.5j * turn
        return Line(value.at, value.along * ((1.0 + half) / (1.0 - half)))
