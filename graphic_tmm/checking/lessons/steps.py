"""The steps of a scene as a report names them, their numbers, and which of them leaves a figure of a table."""

from __future__ import annotations

import cmath
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, Step, segment_name
from graphic_tmm.board.values import Angle, Arc, Length, Line, Number, Point, Side
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import RESULTS, Cell, cells
from graphic_tmm.checking.judging.own_errors import exact, run
from graphic_tmm.checking.judging.taken_marks import Reader, as_marks, steps_of
from graphic_tmm.checking.records import Likely, Taken
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.units import unit_name
from graphic_tmm.readers.protocol import Protocols

NOTHING = 1e-9
"""A length below so many mm is none: numbers of the machine agree to some 1e-12 of a plan."""

PLAIN = frozenset({Point, Length, Angle, Number, Side})
"""Marks that are numbers; lines and arcs are told by their letters."""


@dataclass(frozen=True, eq=False)
class NamedStep:
    """A step, as a report names it (its number in its plan, its letter), and the board it is drawn on."""

    board: Drawn
    step: Step
    label: str


class Steps:
    """The steps of a scene by plan and by what they are called."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self.cells = cells(made)
        self.readable = steps_of(made.mechanism)
        self.in_turn: list[NamedStep] = []
        self._by_label: dict[tuple[str, str], NamedStep] = {}
        self._by_letter: dict[tuple[str, str], NamedStep] = {}
        for board in made.boards:
            count: defaultdict[str, int] = defaultdict(int)
            for step in board.construction.steps:
                mark = step.it
                count[mark.view] += 1
                told = NamedStep(board, step, f"{count[mark.view]} {mark.name}")
                self.in_turn.append(told)
                self._by_label.setdefault((mark.view, told.label), told)
                for name in (mark.letter, mark.name, segment_name(mark.letter)):
                    self._by_letter.setdefault((mark.view, name), told)
        self._by_mark = {(told.board.board, told.step.it): told for told in self.in_turn}

    def labelled(self, plan: str, label: str) -> NamedStep | None:
        """Return the step of a plan that a report calls so: 5 an2; of another plan, if only that has it."""
        if (plan, label) in self._by_label:
            return self._by_label[plan, label]
        others = [told for (_, name), told in self._by_label.items() if name == label]
        return others[0] if len(others) == 1 else None

    def drawn_by(self, told: NamedStep) -> list[NamedStep]:
        """Return the steps of the same plan that drew what a step measures: the points, and their lines."""
        if not told.step.op.reads:
            return []
        wanted, view = list[NamedStep](), told.step.it.view
        for end in told.step.uses:
            by = self._by_mark.get((told.board.board, end))
            if end.kind is Point and by is not None and by.step.it.view == view:
                lines = [self._by_mark.get((told.board.board, mark)) for mark in by.step.uses]
                there = [one for one in lines if one is not None and one.step.it.view == view]
                wanted += [*(one for one in there if one.step.it.kind in (Line, Arc)), by]
        return sorted(dict.fromkeys(wanted), key=lambda one: one.step.it.slot)

    def of(self, finding: Likely) -> NamedStep | None:
        """Return the step that a finding was made in; None where it is not of a single one.

        Its plan and segment may be those where it shows: the step is then the last of its letter before that.
        """
        seen = self._named(finding.plan, finding.segment)
        if not finding.step:
            return seen
        if finding.view and (finding.view, finding.step) in self._by_letter:
            return self._by_letter[finding.view, finding.step]
        found = self._named(finding.plan, finding.step)
        if found is not None:
            return found
        there = [one for one in self.in_turn if finding.step in (one.step.it.letter, one.label)]
        before = [one for one in there if seen is None or self._before(one, seen)]
        return before[-1] if before else seen

    def _named(self, plan: str, name: str) -> NamedStep | None:
        """Return the step of a plan by its label, its letter, or the segment that a reading is of."""
        if not name:
            return None
        found = self._by_label.get((plan, name)) or self._by_letter.get((plan, name))
        step = self.readable.get((plan, name))
        if found is not None or step is None or self.made.mechanism is None:
            return found
        return self._by_mark.get((self.made.mechanism.board, step.it))

    def _before(self, one: NamedStep, other: NamedStep) -> bool:
        return one.board is other.board and one.step.it.slot < other.step.it.slot


class Numbers:
    """What a drawing has of each mark: as it was read, as it follows from that, else as it is due."""

    def __init__(self, steps: Steps, rows: Sequence[Taken], by: Reader) -> None:
        self._found: Mapping[Mark, Any] = {}
        self._due: Mapping[Mark, Any] = {}
        self._values: Mapping[int, Any] = {}
        self._work = work = steps.made.mechanism
        self._made = {step.it: step for step in work.construction.steps} if work is not None else {}
        if work is not None:
            self._found, grain = as_marks(work, steps.readable, rows, steps.cells, by)
            found = run(work, self._found, grain)
            self._due, self._values = found.due, found.values

    def own(self, told: NamedStep, place: int) -> bool:
        """Whether all that a step is calculated from in a position (index) was read, or is given.

        What is calculated from that is the reader's own, too; what he measured and did not tell is not.
        """
        if told.board is not self._work:
            return False
        log = self._made
        ahead, seen, read = list(told.step.uses), set[Mark](), False
        while ahead:
            mark = ahead.pop()
            if mark in seen:
                continue
            seen.add(mark)
            if mark in self._found and not np.isnan(_at(self._found[mark], place)):
                read = True
            elif mark in log:
                if not (log[mark].op.formula or log[mark].op.proportion):
                    return False
                ahead += log[mark].uses
        return read

    def reading(self, told: NamedStep, place: int) -> tuple[Reading, int]:
        """Return the numbers by which a step is told in a position (index), and its index in them.

        It is done right: with what the drawing has, else as the protocol of the exact drawing tells it.
        """
        board, step = told.board, told.step
        view, own = step.it.view, self.own(told, place)
        exactly, row = board.of(view), board.row(view)
        there = exactly is not None and all(mark in exactly for mark in (step.it, *step.uses))
        if exactly is not None and there and place in row and not own:
            return exactly, row.index(place) if view in board.project.rows else place
        marks = [mark for mark in (*step.uses, step.it) if mark.kind in PLAIN]
        values = {mark.slot: self._value(board, mark, own=own) for mark in marks}
        if own and step.it in self._due:
            values[step.it.slot] = self._due[step.it]
        for mark in marks:
            if mark.kind is Length:
                length = values[mark.slot]
                values[mark.slot] = np.where(np.abs(length) < NOTHING, 0.0, length)
        if own:
            self._without_needless_signs(step, values)
        return Reading(values, len(board.names)), place

    def _without_needless_signs(self, step: Step, values: dict[int, Any]) -> None:
        """Take away the sign of a length that was read without one, where nothing hangs on it: of a square."""
        if not all(mark.slot in values for mark in step.uses):
            return

        def result() -> Any:
            with np.errstate(all="ignore"):
                return step.op.run(*(values[mark.slot] for mark in step.uses), **step.choice)

        for mark in step.uses:
            if mark.kind is Length and mark in self._found:
                due, signed = result(), values[mark.slot]
                values[mark.slot] = np.abs(signed)
                if not np.array_equal(result(), due, equal_nan=True):
                    values[mark.slot] = signed

    def _value(self, board: Drawn, mark: Mark, *, own: bool) -> Any:
        if own and mark.slot in self._values:
            return self._values[mark.slot]
        step = self._made.get(mark) if own else None
        if step is not None and step.op.formula:
            values = [self._value(board, one, own=True) for one in step.uses]
            with np.errstate(all="ignore"):
                return step.op.run(*values, **step.choice)
        if mark in board.given:
            return as_value(board.given[mark], mark.kind)
        return exact(board, mark)


def _at(row: Any, place: int) -> Any:
    flat = np.ravel(row)
    return flat[place if flat.size > 1 else 0]


SAME = 1e-9
"""Figures that differ by less than this share are one: what two ways of calculating leave is some 1e-12."""


def step_of_figure(steps: Steps, taken: Taken) -> NamedStep | None:
    """Return the step that leaves the figure of a reading; None where none can be told for sure."""
    cell = steps.cells.get(taken.key)
    if cell is None or taken.pointed:
        return None
    there = [told for told in _of_plan(steps, taken.plan) if _same(told, cell, taken.position)]
    named = [told for told in there if taken.segment in _names(told.step.it)]
    if named:
        return named[0]
    whole = cell.value is None or float(cell.value).is_integer()
    # a whole number is many things: teeth, positions, wheels
    return there[0] if len(there) == 1 and not whole else None


def _of_plan(steps: Steps, plan: str) -> Iterator[NamedStep]:
    """Yield the steps of the views of a plan; of results those of all views."""
    views: dict[str, set[str]] = {}
    for told in steps.in_turn:
        board = told.board
        if board.board not in views:
            views[board.board] = {plan, *_views(board, plan)}
        if plan == RESULTS or told.step.it.view in views[board.board]:
            yield told


def _views(board: Drawn, plan: str) -> Iterator[str]:
    for chapter in board.project.chapters:
        yield from Protocols.of(chapter).views(board.project).get(plan, ())


def _names(mark: Mark) -> tuple[str, ...]:
    """Return what a table may call a mark: R12, r_b1, rb1."""
    return (
        mark.name,
        mark.name.translate({ord(sign): None for sign in "{}"}),
        segment_name(mark.letter),
    )


def _same(told: NamedStep, cell: Cell, position: str) -> bool:
    """Whether a step leaves just what a figure is due, in mm or as a quantity of its unit."""
    mark, names = told.step.it, told.board.names
    if mark.kind is Length:
        due = cell.mm
    elif mark.kind is Number and unit_name(mark.unit, told.board.scene.language) == cell.unit:
        due = cell.value
    else:
        return False
    row = np.ravel(exact(told.board, mark))
    place = names.index(position) if position in names else 0
    value = row[place] if row.size > place else row[0]
    if due is None or not due or not cmath.isfinite(value):
        return False
    return bool(abs(abs(value) - abs(due)) <= SAME * abs(due))
