"""How every scale factor was chosen, as a construction of its own: calculated steps, told and costed as others.

What `rule` came to is recorded here as a person chooses: so long is the longest to be drawn, so many mm are
meant for it, therefore the scale factor is at least so much; the next standard value; the lengths that follow.
A scale factor that the scene gives is taken as it is. Chapters record their own choices (`Choice`); the log of
the drawing knows nothing of it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar, NamedTuple

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import (
    mm_of_row,
    mm_of_time,
    mm_of_turn,
    pole_distance,
    to_board,
)
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.scales import (
    Scale,
    accepted,
    next_standard,
    next_standard_length,
    of_turns,
    scale_of,
    standard,
    standard_length,
)
from graphic_tmm.board.values import Length, Number
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors
from graphic_tmm.fitting.sizes import GRAPHS
from graphic_tmm.language.said import Said, said
from graphic_tmm.project import Plan
from graphic_tmm.scene.chapter import Answer
from graphic_tmm.scene.quantities import turns_a_minute

SCALES = "scales"
"""The view of the choice, and the plan by which protocols tell it."""
GRAINS = (10.0, 5.0, 2.0, 1.0, 0.5, 0.1)
"""What is meant for something is told in multiples of these, mm, the coarsest first."""
SAME = 1e-9
"""A scale factor that is told and one that follows from a length that is told are one within this share."""
FOLLOWING = (mm_of_row, mm_of_time, mm_of_turn, pole_distance)
"""What is calculated of scale factors that are known: bases and pole distances."""
_NOTHING = said("There is nothing to be drawn to it, so any scale will do.")
_SHARED = said(
    "Lengths of one graph are taken from those of the other, or laid off against them: both have one scale "
    "factor."
)
_OWN_LENGTH = said(
    "The task says how long {quantity} is drawn; a scale factor tells how much of a quantity a millimetre "
    "stands for."
)


_APART = said(
    "What is measured in these positions would be too short to the scale factor of the others: they have one "
    "of their own."
)


def usual_room(most: float) -> Said:
    """Return the words for the room of what takes so many mm on an A1 at the most."""
    return said(
        "up to {most:g} mm on an A1 sheet (proportionally less on smaller formats; more where there is free "
        "space, less where the sheet is crowded)",
        most=most,
    )


class Choices(NamedTuple):
    """The choice of a board's scale factors: its log, what was given, and what became of each.

    ``chosen``: by slot of the mark of a scale factor on the board, the mark in this log that has its value.
    ``beside``: by view and letter those of pictures that are no construction of the board: of what is given.
    """

    construction: Construction
    given: Mapping[Mark, object]
    chosen: Mapping[int, Mark]
    beside: Mapping[tuple[str, str], Mark] = MappingProxyType({})

    def value(self, mu: Mark) -> float:
        """Return what was chosen for a scale factor of the board, SI a mm."""
        return self._figure(self.chosen[mu.slot])

    def scale(self, view: str, letter: str) -> Scale:
        """Return what was chosen for a picture that is no construction of the board."""
        mark = self.beside[view, letter]
        return Scale(mark.name, self._figure(mark), mark.unit)

    def _figure(self, mark: Mark) -> float:
        return float(execute(self.construction, self.given, [mark])[mark][0, 0])


class Ledger:
    """Where chapters record how their scale factors were chosen."""

    def __init__(self) -> None:
        self.draft = Draft()
        self.draft.open(SCALES)
        self.chosen: dict[int, Mark] = {}
        self.beside: dict[tuple[str, str], Mark] = {}
        self._known: dict[str, Mark] = {}
        self._view = ""

    def of(self, view: str) -> None:
        """Begin with the scale factor of a view of the board, or go on with it."""
        if view != self._view:
            self.draft.say(view)
        self._view = view

    def quantity(self, letter: str, value: float, unit: str) -> Mark:
        """Return a quantity (SI) that is known; taken once."""
        return self.draft.constant(letter, value, unit)

    def speed(self, index: str, speed: float) -> Mark:
        """Return an angular velocity without its sign (1/s): of the turns a minute, if it was given so."""
        letter, turns = f"ω_{index}", turns_a_minute(speed)
        if turns is None:
            return self.quantity(letter, abs(speed), "1/s")
        return self.calculated(
            of_turns, letter, self.quantity(f"n_{index}", turns, "rpm"), unit="1/s"
        )

    def calculated(self, op: Operation, letter: str, *uses: Mark, unit: str) -> Mark:
        """Return a quantity that is calculated; once."""
        if letter not in self._known:
            self._known[letter] = self.draft.draw(op, letter, *uses, unit=unit)
        return self._known[letter]

    def fitting(
        self, mu: Mark, largest: Mark, due: float, *, lengths: bool = False, why: str = ""
    ) -> Mark:
        """Record that ``due`` was chosen, the next standard value at which ``largest`` takes its room.

        ``lengths``: standard is what ГОСТ 2.302 has; ``why``: the rule by which so much is meant for it, a
        round number of mm from which the same follows. Where there is nothing to draw any scale factor will do.
        """
        if not self._value(largest) > 0.0:
            return self.given(mu, due, why=_NOTHING)
        rules = _rules(lengths=lengths)
        return self.enter(mu, self._standard(mu.letter, mu.unit, largest, due, *rules, why=why))

    def ruled(self, drawn: Drawn, one: ScaleFactor) -> Mark:
        """Record the choice of a scale factor that the scene gives, or that the largest rules."""
        mu, (segment, mm) = one.mu, one.length
        self.of(mu.view)
        if one.fixed:
            return self.given(mu, one.fixed)
        most = self.quantity(one.letter, one.largest, one.unit)
        if mm:
            return self.by_length(mu, most, segment, mm)
        due = one.value if one.apart else value_of(drawn, mu)
        found = self.fitting(mu, most, due, lengths=one.lengths, why=one.why)
        for largest in dict.fromkeys(one.apart.values()):
            at = "; ".join(drawn.names[k] for k, own in one.apart.items() if own == largest)
            # the scale factor of a view is what most of its positions are drawn to
            most = self.quantity(f"{one.letter}^{{({at})}}", largest, one.unit)
            letter, due = f"{mu.letter}^{{({at})}}", one.of(largest)
            self._standard(letter, mu.unit, most, due, *_rules(lengths=one.lengths), why=_APART)
        return found

    def pictured(self, letter: str, unit: str, largest: Mark, room: float) -> None:
        """Record the choice for the picture of what is given: ``largest`` takes ``room`` (mm) at most."""
        due = standard(self._value(largest), room)
        found = self._standard(letter, unit, largest, due, standard, next_standard)
        self.beside[self._view, letter] = found

    def _standard(
        self,
        letter: str,
        unit: str,
        largest: Mark,
        due: float,
        rule: Callable[[float, float], float],
        op: Operation,
        why: str = "",
    ) -> Mark:
        """Record the way from the largest to be drawn, over the length meant for it, to a standard value."""
        wanted = self.draft.take(
            Length, f"[{largest.name.strip('()')}]", _round(self._value(largest), due, rule)
        )
        exact = self.draft.draw(scale_of, f"{letter}′", largest, wanted, unit=unit, why=why)
        return self.draft.draw(op, letter, exact, unit=unit)

    def given(self, mu: Mark, value: float, *, why: str = "") -> Mark:
        """Record that a scale factor is what the scene gives."""
        told = self.draft.take(Number, "", value, mu.unit)
        return self.enter(mu, self.draft.draw(accepted, mu.letter, told, unit=mu.unit, why=why))

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

    def same(self, mu: Mark, other: Mark, letter: str, why: str) -> Mark:
        """Record that a scale factor, called by a letter, is one of the board that was chosen before."""
        found = self.draft.draw(accepted, letter, self.chosen[other.slot], unit=mu.unit, why=why)
        return self.enter(mu, found)

    def follows(self, letter: str, quantity: Mark, mu: Mark) -> Mark:
        """Record the length of a quantity that follows."""
        return self.draft.draw(to_board, letter, quantity, mu)

    def copied(self, drawn: Drawn, steps: Mapping[Mark, Step], mark: Mark) -> Mark:
        """Return what stands for a mark of the board: chosen before, given, or calculated as there.

        What was read off the drawing is taken as it was read.
        """
        if mark.slot in self.chosen:
            return self.chosen[mark.slot]
        value, step = value_of(drawn, mark), steps.get(mark)
        if step is not None and step.op.formula:
            uses = [self.copied(drawn, steps, one) for one in step.uses]
            found = self.draft.draw(step.op, mark.name, *uses, unit=mark.unit, why=step.why)
        elif mark.kind is Number and mark.unit.endswith("/mm"):
            return self.given(mark, value)
        else:
            found = self.draft.take(mark.kind, mark.name, value, mark.unit)
        return self.enter(mark, found)

    def choices(self) -> Choices:
        """Return what was recorded."""
        given, chosen, beside = dict(self.draft.given), dict(self.chosen), dict(self.beside)
        return Choices(self.draft.board.construction(), given, chosen, beside)

    def _value(self, mark: Mark) -> float:
        found = execute(self.draft.board.construction(), self.draft.given, [mark])
        return float(found[mark][0, 0])


def value_of(drawn: Drawn, mark: Mark) -> float:
    """Return the value of a mark of the board that is the same in all positions."""
    given = drawn.given.get(mark)
    value = drawn.reading[mark] if given is None else given
    return float(np.ravel(np.asarray(value))[0])


def _rules(*, lengths: bool) -> tuple[Callable[[float, float], float], Operation]:
    """Return what gives the standard value, and the operation that takes it."""
    return (standard_length, next_standard_length) if lengths else (standard, next_standard)


def _round(largest: float, due: float, rule: Callable[[float, float], float]) -> float:
    """Return a round length (mm) for ``largest``, from which the scale factor ``due`` follows."""
    for grain in GRAINS:
        wanted = grain * math.ceil(largest / due / grain)
        if wanted > 0.0 and rule(largest, wanted) == due:
            return wanted
    return largest / due


def _graphs(drawn: Drawn, charts: Iterable[Chart], ledger: Ledger) -> None:
    """Record the choice of the scale factors of graphs; of several that share one the largest rules."""
    found: dict[Mark, Chart] = {}
    reach: Mapping[str, float] = drawn.reach[GRAPHS]
    for chart in charts:
        known = found.get(chart.mu)
        if not chart.chosen or chart.mu.slot in ledger.chosen:
            continue
        if known is None or reach[chart.view] > reach[known.view]:
            found[chart.mu] = chart
    for mu, chart in found.items():
        ledger.of(chart.view)
        value, most = value_of(drawn, mu), reach[chart.view]
        letter = f"{chart.symbol}_{{max}}"
        if chart.wanted and chart.room and math.isclose(most, value * chart.room, rel_tol=SAME):
            largest = ledger.quantity(letter, most, chart.unit)
            ledger.by_length(mu, largest, f"[{letter}]", chart.room)
            continue
        if chart.wanted:
            ledger.given(mu, value)
            continue
        if chart.room is None and _crosses(drawn, chart):
            letter = f"({letter}−{chart.symbol}_{{min}})"
        ledger.fitting(mu, ledger.quantity(letter, most, chart.unit), value)


def _crosses(drawn: Drawn, chart: Chart) -> bool:
    """Whether a graph goes below its base."""
    rows = [drawn.reading[m].imag for m in chart.figure]
    rows = rows or [drawn.reading[m] for m in chart.ordinates]
    return any(bool(np.nanmin(row, initial=0.0) < 0.0) for row in rows)


def _calculated(drawn: Drawn, ledger: Ledger) -> None:
    """Record scale factors that are given with the log, or follow from others there, and what follows."""
    log, fixed = drawn.construction, drawn.project.given
    steps = {step.it: step for step in log.steps}
    for mark in (view.scale for view in log.views):
        if mark in fixed and mark.slot not in ledger.chosen:
            ledger.of(mark.view)
            ledger.given(mark, value_of(drawn, mark))
    wanted = [view.scale for view in log.views if view.scale in steps]
    wanted += [step.it for step in log.steps if step.op in FOLLOWING]
    for mark in sorted(
        {mark for mark in wanted if mark is not None and mark.slot not in ledger.chosen}
    ):
        ledger.of(mark.view)
        ledger.copied(drawn, steps, mark)


def _shared(charts: Iterable[Chart], ledger: Ledger) -> None:
    """Record that a graph has the scale factor of another, where it calls it by a letter of its own."""
    for chart in charts:
        if chart.mu.slot in ledger.chosen and chart.scale_name != chart.mu.name:
            ledger.of(chart.view)
            ledger.same(chart.mu, chart.mu, chart.scale_name, why=_SHARED)


@dataclass(frozen=True)
class Choice(Answer):
    """How a chapter's scale factors were chosen.

    ``factors``: by the largest of what is drawn to them, where it says more of that than `ScaleFactors`;
    ``choose``: enters others.
    """

    stands: ClassVar[str] = "scales.CHOICE"
    factors: Callable[[Drawn], Iterable[ScaleFactor]] = lambda drawn: ()
    choose: Callable[[Drawn, Ledger], None] = lambda drawn, ledger: None


def choices(drawn: Drawn) -> Choices:
    """Return how the scale factors of a board were chosen; recorded once for a drawing."""
    if SCALES not in drawn.cache:
        ledger = Ledger()
        for chapter in drawn.project.chapters:
            own = Choice.of(chapter)
            for one in (*ScaleFactors.of(chapter).factors(drawn), *own.factors(drawn)):
                ledger.ruled(drawn, one)
            own.choose(drawn, ledger)
            _graphs(drawn, Plan.of(chapter).charts(drawn.recorded[chapter.name]), ledger)
        _calculated(drawn, ledger)
        _shared(drawn.project.charts, ledger)
        drawn.cache[SCALES] = ledger.choices()
    found: Choices = drawn.cache[SCALES]
    return found
