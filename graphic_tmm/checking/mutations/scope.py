"""What a step may be mistaken for: the marks of its kind that are there before, what was measured of them."""

from __future__ import annotations

from collections import defaultdict
from functools import cache
from typing import Any

import numpy as np

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import measure, measure_along
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Line, Number
from graphic_tmm.checking.mutations.mutation import Change

TAKEN_FOR = {"1/s²": "1/s", "kg·m²": "kg"}
"""What is taken for a quantity of another unit: ω for ε, the mass for the moment of inertia."""
MEASURES = (measure.name, measure_along.name)


def late(log: Construction) -> Construction:
    """Return a log whose readings of the ruler are taken as late as they can be: when the plan stands.

    Another point may be taken for the right one then, if only it does not hang on what is measured. A length
    along a line is measured from point to point: they may not be on one line any more.
    """
    waiting = list(log.steps)
    known = {mark.slot for mark in log.given}
    found: list[Step] = []
    while waiting:
        held: list[Step] = []
        for step in waiting:
            ready = all(mark.slot in known for mark in step.uses)
            if ready and not step.op.reads:
                known.add(step.it.slot)
                found.append(step)
            else:
                held.append(step)
        read = [_by_rule(s) for s in held if s.op.reads and all(m.slot in known for m in s.uses)]
        known |= {step.it.slot for step in read}
        found += read
        taken = {step.it.slot for step in read}
        waiting = [step for step in held if step.it.slot not in taken]
    return log._replace(steps=tuple(found))


def _by_rule(step: Step) -> Step:
    return step._replace(op=_between(step.op)) if step.op is measure_along else step


@cache
def _between(op: Operation) -> Operation:
    """Return the operation of measuring from point to point, with the sense along a line."""

    def run(start: Any, end: Any, on: Any) -> Any:
        return np.copysign(np.abs(end - start), op.run(start, end, on))

    return op._replace(run=run)


class Scope:
    """What marks there are of a kind, view by view, as the log makes them."""

    def __init__(self, log: Construction) -> None:
        self.steps = {step.it.slot: step for step in log.steps}
        self.of: dict[tuple[Any, str], list[Mark]] = defaultdict(list)
        self.alike: dict[str, list[Mark]] = defaultdict(list)
        for mark in (*log.given, *(step.it for step in log.steps)):
            self.of[mark.kind, mark.view].append(mark)
            if mark.kind is Number and mark.unit:
                self.alike[mark.unit].append(mark)
        self.readings: dict[int, list[Step]] = defaultdict(list)
        for step in log.steps:
            if step.op.name in MEASURES and step.it.view in {mark.view for mark in step.uses}:
                for mark in step.uses:
                    self.readings[mark.slot].append(step)
        self.given = {mark.slot for mark in log.given}
        self.scales = [mark for mark in log.given if is_scale(mark)]
        made = {step.it.slot: k for k, step in enumerate(log.steps)}
        self.turn = {mark.slot: made.get(mark.slot, -1) for row in self.of.values() for mark in row}

    def others(self, mark: Mark, it: Mark) -> list[Mark]:
        """Return the marks that may be taken for one where another is made; those that are there before."""
        before, view = self.turn[it.slot], it.view
        if mark.kind is Number:
            units = (mark.unit, TAKEN_FOR.get(mark.unit, "")) if mark.unit else ()
            found = [one for unit in units for one in self.alike.get(unit, ())]
        else:
            found = self.of[mark.kind, mark.view]
            if mark.kind is Line and view != mark.view:
                found = [*found, *self.of[mark.kind, view]]
        return [one for one in found if self.turn[one.slot] < before and one.slot != mark.slot]

    def measured(self, line: Step, was: Mark, now: Mark) -> dict[int, Change]:
        """Return what is measured from a line's start, from another one: who draws from there measures so."""
        return {
            step.it.slot: Change(
                step._replace(uses=tuple(now if m is was else m for m in step.uses))
            )
            for step in self.readings.get(was.slot, ())
            if any(m is not was and line.it in self.uses(m) for m in step.uses)
        }

    def uses(self, mark: Mark) -> tuple[Mark, ...]:
        """Return what a mark was made from."""
        made = self.steps.get(mark.slot)
        return () if made is None else made.uses

    def step(self, mark: Mark) -> Step | None:
        """Return the step that makes a mark; None if it is given."""
        return self.steps.get(mark.slot)


def is_scale(mark: Mark) -> bool:
    """Whether a mark is a scale factor."""
    return mark.kind is Number and mark.unit.endswith("/mm")
