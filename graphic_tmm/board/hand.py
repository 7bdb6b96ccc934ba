"""The hand that works at the board: how far pencil, compass, square and ruler slip.

Five slips: the prick of a point, the opening of the compass, the swing of a ray drawn with the square or the
protractor, the reading of the ruler, the digits of a calculation. The exact hand has none of them. Random
streams are keyed by the seed, the plan and the letter, so that slices of the log, blocks of positions and the
order of links change nothing.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import Arc, Length, Line, Number, Point, Reals

SIZE = 16_384
"""Trials times positions in one block: few enough for the cache, enough to pay for the calls."""
MOST = 1024
"""Trials in one block at the most."""
CHUNK = 4096
"""Positions that share one random stream. Any number would do, but with another one every seed draws
otherwise."""


def trials_in_block(positions: int) -> int:
    """Return how many trials of a row of positions are drawn in one block: a power of two.

    At least two: in a block of one what varies by trial would look like what does not.
    """
    return min(1 << max(SIZE // max(positions, 1), 2).bit_length() - 1, MOST)


def rounded(length: Reals, division: float) -> Reals:
    """Return a length in whole divisions of a ruler; ties go up and do not depend on the last bit."""
    whole = np.abs(length)
    whole /= division
    whole += 0.5 + 1e-9
    whole = np.floor(whole)
    whole *= division
    whole = np.copysign(whole, length)
    # no reading is −0
    whole += 0.0
    return whole


class Hand(NamedTuple):
    """How far a hand slips: standard deviations in mm, ``swing`` in degrees; 0 for no slip.

    ``ruler``: its division in mm, None for readings without rounding; ``digits``: significant digits of a
    calculation, None for all. ``seed`` of the random streams; ``trials``: how often everything is drawn;
    ``first``: the number of the first of them, a multiple of `MOST`. ``alone``: keys of slips of which but one
    slips in each trial, in turn, up or down by its standard deviation in a balanced design: ``trials``
    is their number times a power of two, the turns; () for all of them, at random.
    """

    ruler: float | None = None
    prick: float = 0.0
    compass: float = 0.0
    swing: float = 0.0
    reading: float = 0.0
    digits: int | None = None
    seed: int = 0
    trials: int = 1
    first: int = 0
    alone: tuple[str, ...] = ()

    @property
    def slips(self) -> bool:
        """Whether anything is left to chance."""
        return max(self.prick, self.compass, self.swing, self.reading) > 0.0

    def read(self, length: Reals) -> Reals:
        """Return a length as read off the ruler; ties go up and do not depend on the last bit."""
        return length if self.ruler is None else rounded(length, self.ruler)

    def calculate(self, number: Reals) -> Reals:
        """Return a calculated number with so many digits as the hand keeps."""
        if self.digits is None:
            return number
        unit = np.take(_TENS, _ten(number) + (_LEAST - self.digits + 1), mode="clip")
        return np.asarray(np.round(number / unit) * unit)


_LEAST = 307
"""10⁻³⁰⁷ is the least power of ten that a float holds to full precision."""
_TENS = np.array([float(f"1e{k}") for k in range(-_LEAST, 309)])
"""Powers of ten by their exponent + 307."""
_BY_TWO = np.floor(np.arange(-1076, 1025) * np.log10(2.0)).astype(np.intp)
"""The exponent of ten of the least number with a given exponent of two (as frexp counts, less one)."""


def _ten(number: Reals) -> Any:
    """Return the exponent of ten of each number (of those that are not finite or zero: any)."""
    size = np.abs(number)
    least = np.take(_BY_TWO, np.frexp(size)[1] + 1075)
    return np.asarray(least + (size >= np.take(_TENS, least + (_LEAST + 1), mode="clip")))


EXACT = Hand()
HandName = Literal["exact", "cad", "careful", "student"]
"""What hands are called."""
HANDS = {
    "exact": EXACT,
    "cad": Hand(ruler=0.01, prick=0.002, compass=0.002, swing=0.002, reading=0.0, digits=6),
    "careful": Hand(ruler=0.1, prick=0.1, compass=0.1, swing=0.15, reading=0.15, digits=5),
    "student": Hand(ruler=0.5, prick=0.15, compass=0.15, swing=0.6, reading=0.75, digits=4),
}
"""Named hands; the student's is fitted to 49 published examples (see checking/README.md)."""


@lru_cache(maxsize=64)
def _signs(turns: int, width: int) -> Reals:
    """Return ±1, (turn, place): of as many places no two go together, of others as good as none."""
    rows = np.ones((1, 1))
    while len(rows) < turns:  # Sylvester's matrices
        rows = np.block([[rows, rows], [rows, -rows]])
    more = np.random.default_rng(0).choice((-1.0, 1.0), size=(turns, max(width - turns, 0)))
    return np.hstack([rows, more])[:, :width]


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
    elif op.leaves is Point and not op.kept:
        kind = "prick"
    elif op.leaves is Arc:
        kind = "compass"
    elif op.leaves is Line and op.swings:
        kind = "swing"
    return None if kind is None else Slip(kind, f"{view}|{letter}|{kind}")


class Streams:
    """The random streams of a hand: one generator, set to the key of a step whenever it is asked."""

    def __init__(self, hand: Hand) -> None:
        self.seed = hand.seed
        self._bits = np.random.Philox(key=np.zeros(2, np.uint64))
        self._begin = self._bits.state
        self._generator = np.random.Generator(self._bits)

    def normal(self, key: str, block: int, chunk: int, shape: tuple[int, int]) -> Reals:
        """Return standard normal numbers from the beginning of a stream."""
        text = f"{self.seed}|{key}|{block}|{chunk}".encode()
        words = hashlib.blake2b(text, digest_size=16).digest()
        self._begin["state"]["key"] = np.frombuffer(words, dtype=np.uint64)
        self._bits.state = self._begin
        return self._generator.standard_normal(shape)


class Slipping(NamedTuple):
    """A hand at work in one block of trials, at some positions (None: all) out of the ``whole`` row."""

    hand: Hand
    streams: Streams
    block: int
    trials: int
    whole: int
    places: Any

    def normal(self, slip: Slip, width: int, part: slice, axes: int = 1) -> Reals:
        """Return standard normal numbers (trial, position·axes); one a trial where a value does not vary."""
        if not self.hand.alone:
            return self._drawn(slip, width, part, axes)
        if slip.key not in self.hand.alone:
            return np.zeros((1, width * axes))
        return self._balanced(slip.key, width * axes)

    def _balanced(self, key: str, width: int) -> Reals:
        """Return ±1 in the trials (trial, width) in which this step slips alone, 0 in the others."""
        alone = self.hand.alone
        trials = self.block * trials_in_block(self.whole) + np.arange(self.trials)
        mine = (trials % len(alone) == alone.index(key))[:, None]
        signs = _signs(self.hand.trials // len(alone), width)
        return np.asarray(mine * signs[trials // len(alone) % len(signs)])

    def _drawn(self, slip: Slip, width: int, part: slice, axes: int) -> Reals:
        if width == 1:
            return self.streams.normal(slip.key, self.block, 0, (self.trials, axes))
        if self.places is None and part == slice(None) and self.whole <= CHUNK:
            return self._chunk(slip, 0, axes)
        at = (np.arange(self.whole) if self.places is None else self.places)[part]
        row = np.empty((self.trials, at.size, axes))
        for chunk in np.unique(at // CHUNK):
            mine = at // CHUNK == chunk
            drawn = self._chunk(slip, int(chunk), axes).reshape(self.trials, -1, axes)
            row[:, mine] = drawn[:, at[mine] - chunk * CHUNK]
        return row.reshape(self.trials, -1)

    def _chunk(self, slip: Slip, chunk: int, axes: int) -> Reals:
        long = min(CHUNK, self.whole - chunk * CHUNK)
        return self.streams.normal(slip.key, self.block, chunk, (self.trials, long * axes))

    def apply(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return the result of a step as this hand leaves it."""
        return _APPLIED[slip.kind](self, slip, value, part)

    def digits(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return a calculated number with the digits that the hand keeps."""
        return self.hand.calculate(value)

    def reading(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return a length as this hand reads it."""
        hand = self.hand
        if hand.reading > 0.0:
            off = self.normal(slip, value.shape[1], part)
            off *= hand.reading
            value = value + off
        return hand.read(value)

    def prick(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return a point beside its place."""
        if self.hand.prick == 0.0:
            return value
        off = self.normal(slip, value.shape[1], part, axes=2)
        off *= self.hand.prick
        return value + off.view(np.complex128)

    def compass(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return an arc of a slightly different opening."""
        if self.hand.compass == 0.0:
            return value
        wide = max(value.centre.shape[1], value.radius.shape[1])
        return Arc(value.centre, value.radius + self.hand.compass * self.normal(slip, wide, part))

    def swing(self, slip: Slip, value: Any, part: slice) -> Any:
        """Return a ray turned a little about the point it goes through."""
        if self.hand.swing == 0.0:
            return value
        wide = max(value.at.shape[1], value.along.shape[1])
        # tan(t/2) = t/2 for a turn so small; with it the factor has the length 1
        half = (0.5 * np.radians(self.hand.swing)) * self.normal(slip, wide, part)
        share = 2.0 / (1.0 + half * half)
        turn = np.empty(half.shape, dtype=np.complex128)
        turn.real = share - 1.0
        turn.imag = half * share
        return Line(value.at, value.along * turn)


_APPLIED: dict[str, Callable[[Slipping, Slip, Any, slice], Any]] = {
    "digits": Slipping.digits,
    "reading": Slipping.reading,
    "prick": Slipping.prick,
    "compass": Slipping.compass,
    "swing": Slipping.swing,
}
