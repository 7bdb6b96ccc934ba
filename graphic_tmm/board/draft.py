"""A board together with the values of what was given on it, in SI: what every plan is drawn on.

The values never touch the log; they are kept here because a plan knows what it asks for.
"""

from __future__ import annotations

from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.record import Board, Mark
from graphic_tmm.board.values import Angle, Kind, Length, Number

ROUNDING = 1e-12
"""A coordinate below this share of its link counts as zero: a step for it would draw nothing."""


class Draft:
    """The board, the given values so far, and the scale factor of lengths once it is taken."""

    def __init__(self) -> None:
        self.board = Board()
        self.given: dict[Mark, object] = {}
        self.mu_l: Mark | None = None
        self._constants: dict[tuple[str, str, float], Mark] = {}
        self._lengths: dict[tuple[str, str, float], Mark] = {}

    def take(self, kind: Kind, letter: str, value: object, unit: str = "") -> Mark:
        """Take a given mark and keep its value."""
        mark = self.board.take(kind, letter, unit)
        self.given[mark] = value
        return mark

    def angle(self, letter: str, degrees: float) -> Mark:
        """Take a given angle, degrees."""
        return self.take(Angle, self.board.free(letter), degrees, "°")

    def direction(self, degrees: float) -> Mark:
        """Take a given angle that has no letter: it is told by its value."""
        return self.take(Angle, self.board.free(""), degrees, "°")

    def constant(self, letter: str, value: float, unit: str) -> Mark:
        """Take a given number, once in a view however often it is asked for."""
        known = self._constants.get((self.board.view, letter, value))
        if known is None:
            known = self.take(Number, self.board.free(letter), value, unit)
            self._constants[self.board.view, letter, value] = known
        return known

    def length(self, letter: str, metres: float) -> Mark:
        """Take a real length l (m) and calculate the length on the board: AB = l_AB/μ_l; once in a view."""
        assert self.mu_l is not None, "the scale factor of lengths is taken first"
        known = self._lengths.get((self.board.view, letter, metres))
        if known is None:
            real = self.take(Number, self.board.free(_real(letter)), metres, "m")
            known = self.board.draw(to_board, letter, real, self.mu_l)
            assert known.kind is Length
            self._lengths[self.board.view, letter, metres] = known
        return known


def _real(letter: str) -> str:
    """Return the letter of the real length: l_{AB} of AB; X_{S} of a coordinate x_{S} on the board."""
    return f"l_{{{letter}}}" if "_" not in letter else letter[0].upper() + letter[1:]
