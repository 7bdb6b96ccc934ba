"""The error that each step of a hand-made plan made itself: earlier readings are taken as they were found.

The log is run once more at the positions that have readings; every segment that was read replaces what the log
measured, so a later step that calculates with it starts from the reading.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.findings import step_number
from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.operations import meet
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Length, Point
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import POINTED
from graphic_tmm.checking.records import Taken
from graphic_tmm.studio import Made
from graphic_tmm.tables.columns import segment_name

ON_LINE = 0.85
"""A point lies on the one line and off the other if its distances are in this ratio."""


class OwnErrors:
    """Own errors of the readings in mm, and of the points, of a mechanism's plans."""

    def __init__(self, made: Made, readings: Sequence[Taken]) -> None:
        self.made = made
        self._found: dict[tuple[str, str, str], float] = {}
        self._blamed: dict[tuple[str, str, str], Step] = {}
        self._steps: dict[tuple[str, str], Step] = {}
        if made.work is None:
            return
        log = made.work.project.construction
        for step in log.steps:
            if step.it.view in POINTED and step.it.kind is Length:
                self._steps.setdefault((step.it.view, segment_name(step.it.letter)), step)
            if step.it.view in POINTED and step.it.kind is Point:
                self._steps.setdefault((step.it.view, step.it.letter), step)
        by_position: dict[str, dict[Mark, complex]] = {}
        for taken in readings:
            of = self._steps.get((taken.plan, taken.segment))
            if of is None:
                continue
            if of.it.kind is Point and taken.x is not None and taken.y is not None:
                spot = complex(taken.x, taken.y)
                by_position.setdefault(taken.position, {})[of.it] = spot
            elif of.it.kind is Length and taken.mm is not None:
                by_position.setdefault(taken.position, {})[of.it] = taken.mm
        for position, found in by_position.items():
            self._at(position, found)

    def of(self, taken: Taken) -> float | None:
        """Return the own error of a reading, mm; None where it cannot be told."""
        return self._found.get((taken.plan, taken.segment, taken.position))

    def step(self, taken: Taken) -> str:
        """Return the step that made a reading: its number in the plan and its letter; "" if unknown."""
        step = self._blamed.get((taken.plan, taken.segment, taken.position))
        step = step or self._steps.get((taken.plan, taken.segment))
        if step is None or self.made.work is None:
            return ""
        log = self.made.work.project.construction
        return f"{step_number(log, step)} {step.it.letter}"

    def _at(self, position: str, found: dict[Mark, complex]) -> None:
        work = self.made.work
        assert work is not None
        if position not in work.project.names:
            return
        place = work.project.names.index(position)
        log = work.project.construction
        steps = needed(log, found)
        if any(step.op.across for step in steps):
            return
        values: dict[int, Any] = {}
        for mark in log.given:
            if mark in work.given:
                value = as_value(work.given[mark], mark.kind)
                values[mark.slot] = value if value.shape[1] == 1 else value[:, place : place + 1]
        with np.errstate(all="ignore"):
            for step in steps:
                run = partial(step.op.run, **step.choice) if step.choice else step.op.run
                value = run(*[values[mark.slot] for mark in step.uses])
                if step.it in found and step.it.kind is Point:
                    self._point(step, position, found[step.it], values, complex(value[0, 0]))
                    value = np.full_like(value, found[step.it])
                elif step.it in found:
                    sign = -1.0 if float(value[0, 0]) < 0.0 else 1.0
                    key = (step.it.view, segment_name(step.it.letter), position)
                    self._found[key] = found[step.it].real - abs(float(value[0, 0]))
                    value = np.full_like(value, sign * found[step.it].real)
                values[step.it.slot] = value

    def _point(
        self, step: Step, position: str, found: complex, values: dict[int, Any], due: complex
    ) -> None:
        """Note how far a point is off; where two lines met, the line that it is off is blamed."""
        key = (step.it.view, step.it.letter, position)
        self._found[key] = abs(found - due)
        if step.op is not meet:
            return
        log = self.made.work.project.construction if self.made.work is not None else None
        assert log is not None
        off = []
        for mark in step.uses:
            line = values[mark.slot]
            off.append(abs(float(wedge(line.along, found - line.at)[0, 0])))
        first, second = off
        if min(off) < ON_LINE * max(off):
            drawn = log.step(step.uses[0 if first > second else 1])
            if drawn is not None:
                self._blamed[key] = drawn
