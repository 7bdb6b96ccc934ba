"""A board together with the values of what was given on it, in SI: what every plan is drawn on.

The values never touch the log; they are kept here because a plan knows what it asks for. A plan's lines read as
those of the book: a scale factor that an operation calculates with is named only where it is not plain.
"""

from __future__ import annotations

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.record import Board, Mark
from graphic_tmm.board.values import Angle, Kind, Length, Number
from graphic_tmm.errors import ConstructionError

ROUNDING = 1e-12
"""A coordinate below this share of its link counts as zero: a step for it would draw nothing."""
FACTOR = "mu"
"""Arguments of operations whose names begin so are scale factors."""


class Draft:
    """The board, the given values so far, and the scale factors of its views."""

    def __init__(self) -> None:
        self.board = Board()
        self.given: dict[Mark, object] = {}
        self._mu_l: Mark | None = None
        self._scales: dict[str, Mark] = {}
        self._constants: dict[tuple[str, str, float], Mark] = {}
        self._lengths: dict[tuple[str, str, float], Mark] = {}

    @property
    def mu_l(self) -> Mark:
        """The scale factor of lengths: of the plan of positions, and of each view that has no other."""
        if self._mu_l is None:
            raise ConstructionError(
                f"{self.view}: the scale factor of lengths, μ_l, is not taken yet"
            )
        return self._mu_l

    @mu_l.setter
    def mu_l(self, mark: Mark) -> None:
        self._mu_l = mark

    @property
    def view(self) -> str:
        """The view that is open."""
        return self.board.view

    def open(self, view: str) -> None:
        """Begin (or go on with) the view of that name."""
        self.board.open(view)

    def lay_out(
        self,
        pole: Mark | None = None,
        scale: Mark | None = None,
        *,
        role: str = "",
        last: str = "",
    ) -> None:
        """Tell the pole of the view that is open, and its scale factor if it was not taken in it."""
        if scale is not None:
            self._scales[self.view] = scale
        self.board.lay_out(pole, self.scale_of(self.view), role, last)

    def say(self, note: str) -> None:
        """Write a remark that stands before the next step."""
        self.board.say(note)

    def figure(self, kind: str, name: str, *marks: Mark) -> None:
        """Tell that marks belong together as a body on the plan."""
        self.board.figure(kind, name, *marks)

    def uses(self, mark: Mark) -> tuple[Mark, ...]:
        """Return the marks that the step which left ``mark`` used."""
        return self.board.uses(mark)

    def draw(
        self,
        op: Operation,
        letter: str,
        *uses: Mark,
        unit: str = "",
        role: str = "",
        free: bool = False,
        why: str = "",
        **choice: int,
    ) -> Mark:
        """Record one operation and return the mark it leaves (see `Board.draw`).

        Scale factors are given all or none. Those left out are found: μ_l where the operation calls for it;
        else that of the view in which the length just before it was read, and where there is no such length
        that of the view that is open.
        """
        if len(uses) < len(op.takes):
            uses = self._scaled(op, uses)
        return self.board.draw(
            op, letter, *uses, unit=unit, role=role, free=free, why=why, **choice
        )

    def _scaled(self, op: Operation, uses: tuple[Mark, ...]) -> tuple[Mark, ...]:
        """Put the scale factors in their places; what is given as it stands if it is not all the rest."""
        factors = [name.split("_")[0] == FACTOR for name in op.arguments]
        if len(uses) + sum(factors) != len(factors):
            return uses
        found: list[Mark] = []
        rest = iter(uses)
        for name, is_factor in zip(op.arguments, factors, strict=True):
            if not is_factor:
                found.append(next(rest))
            elif name == "mu_l":
                found.append(self.mu_l)
            else:
                read = bool(found) and found[-1].kind is Length
                found.append(self.scale_of(found[-1].view if read else self.view))
        return tuple(found)

    def scale_of(self, view: str) -> Mark:
        """Return the scale factor of a view, μ_l where it has none of its own."""
        return self._scales.get(view) or self.mu_l

    def scale(self, letter: str, unit: str) -> Mark:
        """Take the scale factor of the view that is open; its value is chosen when the sheet is."""
        mark = self._scales[self.view] = self.ask(Number, letter, unit)
        return mark

    def ask(self, kind: Kind, letter: str, unit: str = "", role: str = "") -> Mark:
        """Take a given mark whose value is found later."""
        return self.board.take(kind, letter, unit, role)

    def take(self, kind: Kind, letter: str, value: object, unit: str = "", role: str = "") -> Mark:
        """Take a given mark and keep its value."""
        mark = self.ask(kind, letter, unit, role)
        self.given[mark] = value
        return mark

    def angle(self, letter: str, degrees: float) -> Mark:
        """Take a given angle, degrees."""
        return self.take(Angle, letter, degrees, "°")

    def direction(self, degrees: float) -> Mark:
        """Take a given angle that has no letter: it is told by its value."""
        return self.take(Angle, "", degrees, "°")

    def constant(self, letter: str, value: float, unit: str) -> Mark:
        """Take a given number, once in a view however often it is asked for."""
        known = self._constants.get((self.view, letter, value))
        if known is None:
            known = self.take(Number, letter, value, unit)
            self._constants[self.view, letter, value] = known
        return known

    def length(self, letter: str, metres: float) -> Mark:
        """Take a real length l (m) and calculate the length on the board: AB = l_AB/μ_l; once in a view."""
        known = self._lengths.get((self.view, letter, metres))
        if known is None:
            real = self.take(Number, _real(letter), metres, "m")
            known = self.draw(to_board, letter, real, self.mu_l)
            assert known.kind is Length
            self._lengths[self.view, letter, metres] = known
        return known


def _real(letter: str) -> str:
    """Return the letter of the real length: l_{AB} of AB; X_{S} of a coordinate x_{S} on the board."""
    return f"l_{{{letter}}}" if "_" not in letter else letter[0].upper() + letter[1:]
