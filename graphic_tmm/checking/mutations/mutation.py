"""A mutation: what a student may have done instead of a step, with which other marks; a log changed by it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board import roles
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import lay_off, measure, measure_along
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Line, Number
from graphic_tmm.board.values import given as as_value

OPERAND, PREVIOUS, FACTOR, POWER = "operand", "previous", "factor", "power"
LEFT_OUT, DIRECTION, SENSE, WRONG_END = "left out", "direction", "sense", "wrong end"
MEETING, MIRRORED, START, SCALE = "meeting", "mirrored", "start", "scale"
EXCHANGED, CRANK, GIVEN, TABLE = "exchanged", "crank", "given", "table"
FAMILIES = (
    *(LEFT_OUT, SENSE, WRONG_END, OPERAND, FACTOR, POWER, DIRECTION, START, MEETING, MIRRORED),
    *(SCALE, EXCHANGED, CRANK, GIVEN, PREVIOUS, TABLE),
)
"""What mistakes are of: a family has the same share of what is expected beforehand as any other.

In the order in which they are told where nothing else tells mistakes apart."""

UNUSUAL = 3.0
"""A mark squared that is not, or a scale factor doubled, is this much less usual than what is left out."""
Key = tuple[Any, ...]
"""By what mutations of several steps are of one kind: made everywhere, they are one mistake."""


class Change(NamedTuple):
    """What is done instead of a step.

    ``step``: the operation, what it uses and its choice, as they are then; ``before``: which of its uses is
    that of the position before (-1: none); ``factor``: how many times its result is taken.
    """

    step: Step
    before: int = -1
    factor: float = 1.0


class Amiss(NamedTuple):
    """What becomes of a given mark: ``factor`` times that of ``source``, and ``plus``, (1, position) or one."""

    source: Mark
    factor: float = 1.0
    plus: float | NDArray[np.float64] = 0.0


class Mutation(NamedTuple):
    """A mutation of a log.

    ``changes``: by the slots of steps; ``amiss``: by the slots of given marks. What tells it in words:
    ``at`` its first step (None of one of the givens), ``was`` and ``now`` the marks, ``times`` the factor,
    ``formula`` as it was calculated; ``says``: a sentence with these as names. ``usual``: how usual it is
    among those of its family, 1 the most.
    """

    family: str
    says: str
    changes: Mapping[int, Change]
    amiss: Mapping[int, Amiss]
    at: Step | None = None
    was: Mark | None = None
    now: Mark | None = None
    times: float = 1.0
    formula: str = ""
    usual: float = 1.0
    wide: bool = False

    @property
    def slots(self) -> frozenset[int]:
        """The slots of what it changes."""
        return frozenset({*self.changes, *self.amiss})


def at_step(step: Step, family: str, says: str, change: Change, **told: Any) -> Mutation:
    """Return the mutation of one step."""
    return Mutation(family, says, {step.it.slot: change}, {}, step, **told)


def using(step: Step, k: int, mark: Mark) -> Step:
    """Return a step whose use ``k`` is another mark."""
    return step._replace(uses=(*step.uses[:k], mark, *step.uses[k + 1 :]))


TAKEN_FOR = {"1/s²": "1/s", "kg·m²": "kg"}
"""What is taken for a quantity of another unit: ω for ε, the mass for the moment of inertia."""
MEASURES = (measure.name, measure_along.name)


def measured_last(log: Construction) -> Construction:
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
        self.rows: dict[str, int] = {}
        """How many positions a graph has, by the views in which stations are given."""
        stations = {mark.view for mark in log.given if mark.role == roles.STATION}
        self.lines: dict[Key, list[Mark]] = defaultdict(list)
        for step in log.steps:
            if step.it.view in stations and "row" in step.choice:
                self.rows[step.it.view] = step.choice["row"]
            if step.it.kind is Line:
                self.lines[self._made_as(step)].append(step.it)
        self.scales = [mark for mark in log.given if is_scale(mark)]
        made = {step.it.slot: k for k, step in enumerate(log.steps)}
        self.turn = {mark.slot: made.get(mark.slot, -1) for row in self.of.values() for mark in row}

    def candidates(self, mark: Mark, it: Mark) -> list[Mark]:
        """Return the marks that may be taken for one where another is made; those that are there before."""
        before, view = self.turn[it.slot], it.view
        if mark.kind is Number:
            units = (mark.unit, TAKEN_FOR.get(mark.unit, "")) if mark.unit else ()
            found = [one for unit in units for one in self.alike.get(unit, ())]
        else:
            found = self.of[mark.kind, mark.view]
            if mark.kind is Line and view != mark.view:
                found = [*found, *self.of[mark.kind, view], *self._alike(mark, view)]
        return [one for one in found if self.turn[one.slot] < before and one.slot != mark.slot]

    def _alike(self, line: Mark, view: str) -> list[Mark]:
        """Return the lines that were drawn as a line on a graph is, on other graphs: chords, tangents."""
        made = self.steps.get(line.slot)
        key = self._made_as(made) if made is not None else ()
        found = self.lines[key] if len(key) > 1 else []
        return [one for one in found if one.view not in (line.view, view)]

    def _made_as(self, step: Step) -> Key:
        """Return by what operation a step is made, and by what it uses of other positions."""
        by = (self.steps.get(mark.slot) for mark in step.uses)
        return (step.op.name, *(one.op.name for one in by if one is not None and one.op.across))

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

    def begun(self, point: Mark) -> Mark | None:
        """Return the point from which another was laid off; None where it was found otherwise."""
        laid = self.step(point)
        on = self.uses(laid.uses[0]) if laid is not None and laid.op is lay_off else ()
        return on[0] if on else None

    def step(self, mark: Mark) -> Step | None:
        """Return the step that makes a mark; None if it is given."""
        return self.steps.get(mark.slot)


def is_scale(mark: Mark) -> bool:
    """Whether a mark is a scale factor."""
    return mark.kind is Number and mark.unit.endswith("/mm")


def changed_log(
    log: Construction, given: Mapping[Mark, object], mutation: Mutation, place: int | None = None
) -> tuple[Construction, Mapping[Mark, object]]:
    """Return a log and what is given with a mutation; ``place``: at one position only (its index)."""
    changes, count = mutation.changes, _positions(given)
    steps = tuple(
        _changed(step, changes[step.it.slot], place, count) if step.it.slot in changes else step
        for step in log.steps
    )
    taken: dict[Mark, object] = dict(given)
    for mark in log.given:
        way = mutation.amiss.get(mark.slot)
        if way is not None and mark in given:
            amiss = way.factor * as_value(given[way.source], way.source.kind) + way.plus
            taken[mark] = _only(place, amiss, as_value(given[mark], mark.kind), count)
    return log._replace(steps=steps), taken


def _positions(given: Mapping[Mark, object]) -> int:
    rows = [value for value in given.values() if isinstance(value, np.ndarray) and value.ndim > 1]
    return max((value.shape[1] for value in rows), default=1)


def _changed(step: Step, change: Change, place: int | None, positions: int) -> Step:
    run, count = _run(change), len(step.uses)
    if place is None or step.op.across:
        other = change.step
        return step._replace(op=other.op._replace(run=run), uses=other.uses, choice={})
    right = _run(Change(step))
    at = place

    def either(*values: Any) -> Any:
        due, found = right(*values[:count]), run(*values[count:])
        return _both(found, due, at, positions)

    # what it marks is then told by its place alone, not by the lines of either
    op = step.op._replace(run=either, name=f"{step.op.name} at one position")
    return step._replace(op=op, uses=(*step.uses, *change.step.uses), choice={})


def _run(change: Change) -> Callable[..., Any]:
    step = change.step

    def run(*values: Any) -> Any:
        if change.before >= 0:
            values = tuple(_rolled(v) if k == change.before else v for k, v in enumerate(values))
        value = step.op.run(*values, **step.choice)
        return value if change.factor == 1.0 else value * change.factor

    return run


def _rolled(value: Any) -> Any:
    if isinstance(value, tuple):
        return type(value)(*map(_rolled, value))
    return np.roll(value, 1, axis=1)


def _both(found: Any, due: Any, place: int, count: int) -> Any:
    if isinstance(due, tuple):
        return type(due)(*(_both(f, d, place, count) for f, d in zip(found, due, strict=True)))
    return _only(place, found, due, count)


def _only(place: int | None, found: Any, due: Any, count: int) -> Any:
    if place is None:
        return found
    shape = (max(found.shape[0], due.shape[0]), max(count, found.shape[1], due.shape[1]))
    at = np.arange(shape[1]) == place
    return np.where(at, np.broadcast_to(found, shape), np.broadcast_to(due, shape))
