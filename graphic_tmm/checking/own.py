"""The error that each step of a hand-made plan made itself: earlier readings are taken as they were found.

The log is run once more at the positions that have readings; every segment that was read replaces what the log
measured, every point that was read the point that the log marked: a later step starts from what was found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.findings import step_number
from graphic_tmm.board.geometry import along, wedge
from graphic_tmm.board.operations import cross, cut, lay_off, meet
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Length, Line, Point
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import POINTED
from graphic_tmm.checking.records import Taken
from graphic_tmm.studio import Made
from graphic_tmm.tables.columns import segment_name

MET = (meet, cut, cross)
"""Operations that mark where two lines or arcs meet."""


class Own(NamedTuple):
    """The error of one step, mm: of a length how much too long, of a point or a line how far it is off."""

    step: Step
    error: float


class OwnErrors:
    """Own errors of the readings in mm, and of the points, of a mechanism's plans."""

    def __init__(self, made: Made, readings: Sequence[Taken]) -> None:
        self.made = made
        self._found: dict[tuple[str, str, str], tuple[Own, ...]] = {}
        self._steps: dict[tuple[str, str], Step] = {}
        if made.work is None:
            return
        for step in _alone(made.work.project.construction):
            if step.it.view in POINTED and step.it.kind is Length:
                self._steps.setdefault((step.it.view, segment_name(step.it.letter)), step)
            if step.it.view in POINTED and step.it.kind is Point:
                self._steps.setdefault((step.it.view, step.it.letter), step)
        by_position: dict[str, dict[Mark, complex]] = {}
        for taken in readings:
            of = self.step(taken)
            if of is None:
                continue
            if of.it.kind is Point and taken.x is not None and taken.y is not None:
                spot = complex(taken.x, taken.y)
                by_position.setdefault(taken.position, {})[of.it] = spot
            elif of.it.kind is Length and taken.mm is not None:
                by_position.setdefault(taken.position, {})[of.it] = taken.mm
        for position, found in by_position.items():
            self._at(position, found)

    def of(self, taken: Taken) -> tuple[Own, ...]:
        """Return the errors of the steps that led to a reading; none where they cannot be told.

        A point where two lines meet has the errors of both: how far it is off either of them.
        """
        return self._found.get(taken.key, ())

    def step(self, taken: Taken) -> Step | None:
        """Return the step that a reading is of; None where it is no length or point of a plan."""
        return self._steps.get((taken.plan, taken.segment))

    def named(self, step: Step | None) -> str:
        """Return a step as a report names it: its number in its plan, its letter; empty for none."""
        if step is None:
            return ""
        assert self.made.work is not None
        return f"{step_number(self.made.work.project.construction, step)} {step.it.name}"

    def _at(self, position: str, found: dict[Mark, complex]) -> None:
        work = self.made.work
        assert work is not None
        if position not in work.project.names:
            return
        place = work.project.names.index(position)
        log = work.project.construction
        values: dict[int, Any] = {}
        for mark in log.given:
            if mark in work.given:
                value = as_value(work.given[mark], mark.kind)
                values[mark.slot] = value if value.shape[1] == 1 else value[:, place : place + 1]
        with np.errstate(all="ignore"):
            for step in needed(log, found):
                run = partial(step.op.run, **step.choice) if step.choice else step.op.run
                value = run(*[values[mark.slot] for mark in step.uses])
                if step.it in found:
                    values[self._as_measured(step.it)] = value
                    value = self._taken(step, position, found[step.it], value, values)
                values[step.it.slot] = value

    def _taken(
        self, step: Step, position: str, found: complex, value: Any, values: dict[int, Any]
    ) -> Any:
        """Note the errors of a step whose result was read; return what was read."""
        if step.it.kind is Point:
            key = (step.it.view, step.it.letter, position)
            self._found[key] = tuple(self._parts(step, found, complex(value[0, 0]), values))
            return np.full_like(value, found)
        due = float(value[0, 0])
        key = (step.it.view, segment_name(step.it.letter), position)
        self._found[key] = (Own(step, found.real - abs(due)),)
        return np.full_like(value, -found.real if due < 0.0 else found.real)

    @staticmethod
    def _as_measured(mark: Mark) -> int:
        """Return the key under which the log's own value of a mark is kept, where a reading took its place."""
        return -1 - mark.slot

    def _parts(
        self, step: Step, found: complex, due: complex, values: dict[int, Any]
    ) -> Iterator[Own]:
        """Yield how far a point is off each line and arc that it should lie on, or off its own place."""
        assert self.made.work is not None
        log = self.made.work.project.construction
        drawn = [(log.step(mark), values[mark.slot]) for mark in step.uses]
        if step.op in MET:
            for by, value in drawn:
                if isinstance(value, Line | Arc):
                    yield Own(by or step, _off(value, found))
        elif step.op is lay_off:
            by, line = drawn[0]
            yield Own(by or step, _off(line, found))
            long = float(along(np.asarray(found - line.at), line.along)[0, 0])
            # whether the length was laid off right, and read wrongly, or the other way round
            lengths = (drawn[1][1], values.get(self._as_measured(step.uses[1])))
            off = [abs(long - float(length[0, 0])) for length in lengths if length is not None]
            yield Own(step, min(off))
        else:
            yield Own(step, abs(found - due))


def _alone(log: Construction) -> Iterator[Step]:
    """Yield the steps whose results follow from their own position only."""
    tied: set[int] = set()
    for step in log.steps:
        if step.op.across or any(mark.slot in tied for mark in step.uses):
            tied.add(step.it.slot)
        else:
            yield step


def _off(figure: Line | Arc, found: complex) -> float:
    """Return how far a point is off a line or an arc, mm."""
    if isinstance(figure, Line):
        return abs(float(wedge(figure.along, found - figure.at)[0, 0]))
    return abs(float((np.abs(found - figure.centre) - figure.radius)[0, 0]))
