"""How every scale factor was chosen, as a construction of its own: calculated steps, told and costed as others.

The search tries sizes; what it came to is recorded here as a person chooses: so long is the longest to be
drawn, so many mm are meant for it, therefore the scale factor is at least so much; the next standard value; the
lengths that follow. A scale factor that the scene gives is taken as it is. Chapters record their own choices
(`Chapter.choice`); the log of the drawing knows nothing of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.choice import (
    accepted,
    next_standard,
    next_standard_length,
    of_turns,
    scale_of,
)
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import standard, standard_length
from graphic_tmm.board.values import Length, Number
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.said import said
from graphic_tmm.scene.quantities import turns_a_minute

SCALES = "scales"
"""The view of the choice, and the plan by which protocols tell it."""
GRAINS = (10.0, 5.0, 2.0, 1.0, 0.5, 0.1)
"""What is meant for something is told in multiples of these, mm, the coarsest first."""
_OWN_LENGTH = said(
    "The task says how long {quantity} is drawn; a scale factor tells how much of a quantity a millimetre "
    "stands for."
)


class Choices(NamedTuple):
    """The choice of a board's scale factors: its log, what was given, and what became of each.

    ``chosen``: by slot of the mark of a scale factor on the board, the mark in this log that has its value.
    """

    construction: Construction
    given: Mapping[Mark, object]
    chosen: Mapping[int, Mark]

    def value(self, mu: Mark) -> float:
        """Return what was chosen for a scale factor of the board, SI a mm."""
        mark = self.chosen[mu.slot]
        return float(execute(self.construction, self.given, [mark])[mark][0, 0])


class Ledger:
    """Where chapters record how their scale factors were chosen."""

    def __init__(self) -> None:
        self.draft = Draft()
        self.draft.open(SCALES)
        self.chosen: dict[int, Mark] = {}
        self._known: dict[str, Mark] = {}

    def of(self, view: str) -> None:
        """Begin with the scale factor of a view of the board."""
        self.draft.say(view)

    def quantity(self, letter: str, value: float, unit: str) -> Mark:
        """Return a quantity (SI) that is known; taken once."""
        return self.draft.constant(letter, value, unit)

    def speed(self, index: str, speed: float) -> Mark:
        """Return an angular velocity without its sign (1/s): of the turns a minute, if it was given so."""
        letter, turns = f"ω_{index}", turns_a_minute(speed)
        if turns is None:
            return self.quantity(letter, abs(speed), "1/s")
        return self.found(of_turns, letter, self.quantity(f"n_{index}", turns, "rpm"), unit="1/s")

    def found(self, op: Operation, letter: str, *uses: Mark, unit: str) -> Mark:
        """Return a quantity that is calculated; once."""
        if letter not in self._known:
            self._known[letter] = self.draft.draw(op, letter, *uses, unit=unit)
        return self._known[letter]

    def fitting(self, mu: Mark, largest: Mark, room: float, *, lengths: bool = False) -> Mark:
        """Record that a standard scale factor was chosen at which ``largest`` takes ``room`` mm at most.

        ``lengths``: standard is what ГОСТ 2.302 has. What is told to be meant for it is a round number of mm
        from which the same follows.
        """
        draft, letter = self.draft, mu.letter
        least, rule, op = self._value(largest), standard, next_standard
        if lengths:
            rule, op = standard_length, next_standard_length
        wanted = draft.take(Length, f"[{largest.name}]", _round(least, room, rule))
        exact = draft.draw(scale_of, f"{letter}′", largest, wanted, unit=mu.unit)
        return self.enter(mu, draft.draw(op, letter, exact, unit=mu.unit))

    def told(self, mu: Mark, value: float) -> Mark:
        """Record that a scale factor is what the scene gives."""
        told = self.draft.take(Number, "", value, mu.unit)
        return self.enter(mu, self.draft.draw(accepted, mu.letter, told, unit=mu.unit))

    def by_length(self, mu: Mark, quantity: Mark, letter: str, mm: float) -> Mark:
        """Record that the scene gives the length ``letter`` (mm) that is to show a quantity."""
        length = self.draft.take(Length, letter, mm)
        found = self.draft.draw(
            scale_of, mu.letter, quantity, length, unit=mu.unit, why=_OWN_LENGTH
        )
        return self.enter(mu, found)

    def enter(self, mu: Mark, found: Mark) -> Mark:
        """Note that a mark of this log is what a scale factor of the board is."""
        self.chosen[mu.slot] = found
        return found

    def follows(self, letter: str, quantity: Mark, mu: Mark) -> Mark:
        """Record the length of a quantity that follows."""
        return self.draft.draw(to_board, letter, quantity, mu)

    def choices(self) -> Choices:
        """Return what was recorded."""
        return Choices(self.draft.board.construction(), dict(self.draft.given), dict(self.chosen))

    def _value(self, mark: Mark) -> float:
        found = execute(self.draft.board.construction(), self.draft.given, [mark])
        return float(found[mark][0, 0])


def _round(largest: float, room: float, rule: Callable[[float, float], float]) -> float:
    """Return a round length (mm) from which the same scale factor follows as from ``room``."""
    due = rule(largest, room)
    for grain in GRAINS:
        wanted = grain * math.ceil(largest / due / grain)
        if wanted > 0.0 and rule(largest, wanted) == due:
            return wanted
    return room


def choices(drawn: Drawn) -> Choices:
    """Return how the scale factors of a board were chosen; recorded once for a drawing."""
    if SCALES not in drawn.cache:
        ledger = Ledger()
        for chapter in drawn.project.chapters:
            chapter.choice(drawn, ledger)
        drawn.cache[SCALES] = ledger.choices()
    found: Choices = drawn.cache[SCALES]
    return found
