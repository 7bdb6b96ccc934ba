"""What can be practised: each plan that a check reads, in each of its positions, step by step."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.script import Script
from graphic_tmm.board.source import NotCompiled
from graphic_tmm.board.values import Length, Number, Point, arrays, undefined
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import cells, pointed, points
from graphic_tmm.checking.judging.own_errors import alone
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.drawn import Drawn, DrawnScene


@dataclass(frozen=True)
class Row:
    """A mechanism at a row of positions, drawn by the exact hand: those of the sheet, or others.

    ``given``: what is given there; ``places``: the positions (indices) in which each plan is practised;
    ``own``: the rows of which it is made, each drawn by itself by a hand; () of one that is made of no others.
    """

    work: Drawn
    log: Construction
    given: Mapping[Mark, object]
    names: Sequence[str]
    places: Mapping[str, Sequence[int]]
    own: tuple[Row, ...] = ()

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The steps of plans that are practised, with what they need, that follow from their position alone."""
        free = {step.it for step in alone(self.log)}
        wanted = [mark for mark in free if mark.view in self.places]
        return tuple(step for step in needed(self.log, wanted) if step.it in free)

    @cached_property
    def reading(self) -> Reading:
        """The numbers of all that these need."""
        marks = {mark for step in self.steps for mark in (step.it, *step.uses)}
        return execute(self.log, self.given, marks)

    def there(self, mark: Mark, at: int) -> bool:
        """Whether a mark is there in a position."""
        gone = undefined(self.reading[mark])[0]
        return not gone[at if gone.size > 1 else 0]

    def numbers(self, mark: Mark) -> list[list[float]]:
        """Return what a mark is, number by number, in each position; in one if it is always alike."""
        flat: list[Any] = []
        for part in arrays(self.reading[mark]):
            flat += [part[0].real, part[0].imag] if np.iscomplexobj(part) else [part[0]]
        return np.stack(np.broadcast_arrays(*flat), axis=1).tolist()  # type: ignore[no-any-return]


def sheet_row(made: DrawnScene) -> Row | None:
    """Return the row of the sheet; None of a scene without a mechanism, or without a plan that is practised."""
    work = made.mechanism
    if work is None:
        return None
    plans = {step.it.view for step in work.construction.steps} & set(pointed())
    places = {plan: work.row(plan) for plan in pointed() if plan in plans and work.row(plan)}
    if not places:
        return None
    return Row(work, work.construction, work.given, work.names, places)


def with_others(row: Row, other: Row) -> Row:
    """Return a row with the positions of another one behind its own."""
    count, more = len(row.names), len(other.names)
    used = {mark for step in row.steps for mark in step.uses}
    given = {}
    for mark in used & row.given.keys():
        value = row.given[mark]
        first = as_value(value, mark.kind)
        second = as_value(other.given.get(mark, value), mark.kind)
        if isinstance(first, np.ndarray) and isinstance(second, np.ndarray):
            wide = [np.broadcast_to(first, (1, count)), np.broadcast_to(second, (1, more))]
            joined = np.concatenate(wide, axis=1)
            given[mark] = first if np.ptp(joined) == 0.0 else joined
        else:
            given[mark] = first
    places = {
        plan: (*at, *(count + k for k in other.places.get(plan, ())))
        for plan, at in row.places.items()
    }
    names = (*row.names, *other.names)
    return Row(row.work, row.log, given, names, places, (row, other))


def written(script: Script, steps: Iterable[Step]) -> dict[str, Any]:
    """Return the functions of operations that can be written down in JavaScript, by their names."""
    found = {}
    for op in {step.op.name: step.op for step in steps}.values():
        try:
            script.add(op.run)
        except NotCompiled:
            continue
        found[op.name] = op.run
    return found


def readable(made: DrawnScene) -> dict[Mark, tuple[str, str, str, str]]:
    """Return what a check reads of marks: "point", "length" or "rate", plan, name, unit."""
    due, spots = cells(made), points(made)
    figures = {(plan, name): cell for (plan, name, _), cell in due.items()}
    stand = {(plan, name) for plan, name, _ in spots}
    found: dict[Mark, tuple[str, str, str, str]] = {}
    for (plan, name), step in steps_of(made.mechanism).items():
        kind, cell = step.it.kind, figures.get((plan, name))
        if kind is Point and (plan, name) in stand:
            found.setdefault(step.it, ("point", plan, name, "mm"))
        elif kind is Length and cell is not None and cell.mm is not None:
            found.setdefault(step.it, ("length", plan, name, "mm"))
        elif kind is Number and cell is not None and cell.value is not None:
            found.setdefault(step.it, ("rate", plan, name, cell.unit))
    return found
