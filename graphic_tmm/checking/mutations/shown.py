"""Where a mistake shows itself: the first reading that is off because of it."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.record import Construction, Mark, segment_name
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.evidence import Readings
from graphic_tmm.checking.mutations.execution import executed
from graphic_tmm.checking.mutations.hypotheses import Hypothesis
from graphic_tmm.checking.mutations.mistakes import NONE
from graphic_tmm.checking.mutations.mutation import CRANK, Mutation
from graphic_tmm.checking.mutations.scope import late


def shown_at(one: Hypothesis, diagnosis: Diagnosis, drawing: Comparison) -> tuple[str, str]:
    """Return plan and segment of the first reading that shows a mistake, a wrong one if there is one.

    Of what was not read at all, and of nothing that was: the plan and the letter of its step.
    """
    what, readings = one.what, diagnosis.readings
    assert isinstance(what, Mutation)
    if what.family == CRANK:
        return "", ""  # the whole drawing stands otherwise
    wrong = {(each.taken.plan, each.taken.segment) for each in diagnosis.doubtful}
    board = drawing.made.boards[one.board]
    marks: list[tuple[str, str]] = []
    if readings is not None and drawing.made.mechanism is board:
        marks = _marks(board.construction, what, readings)
    found = [at for at in marks if at in wrong]
    if not found and readings is not None:
        found = [at for at in _columns(one, what, readings, drawing) if at in wrong]
    if found or marks:
        return (found or marks)[0]
    mark = what.at.it if what.at is not None else what.was
    return (mark.view, segment_name(mark.letter)) if mark is not None else ("", "")


def explained(one: Hypothesis, diagnosis: Diagnosis, drawing: Comparison) -> tuple[int, ...]:
    """Return the lines of the wrong readings that a mistake moves; of all where that cannot be told."""
    what, readings = one.what, diagnosis.readings
    some = diagnosis.wrong or diagnosis.doubtful
    lines = tuple(dict.fromkeys(each.taken.line for each in some))
    if not isinstance(what, Mutation) or readings is None:
        return lines
    board = drawing.made.boards[one.board]
    moved = set(_columns(one, what, readings, drawing))
    if drawing.made.mechanism is board:
        moved |= set(_marks(board.construction, what, readings))
    names = drawing.made.mechanism.names if drawing.made.mechanism is not None else ()
    at = names[one.place] if one.place is not None else ""
    found = [
        each.taken.line
        for each in some
        if (each.taken.plan, each.taken.segment) in moved and at in ("", each.taken.position)
    ]
    return tuple(dict.fromkeys(found)) or lines


def _marks(log: Construction, what: Mutation, readings: Readings) -> list[tuple[str, str]]:
    """Return the readings of marks that a mutation moves, nothing read being between; in the log's order."""
    read: dict[Mark, tuple[str, str]] = {
        mark: (taken.plan, taken.segment) for (mark, _), taken in readings.by_mark.items()
    }
    moved = {slot for slot in what.slots if slot not in {step.it.slot for step in log.steps}}
    found: list[tuple[str, str]] = []
    for step in log.steps:
        if step.it.slot in what.slots or any(mark.slot in moved for mark in step.uses):
            if step.it in read:
                found.append(read[step.it])
            else:
                moved.add(step.it.slot)
    return found


def _columns(
    one: Hypothesis, what: Mutation, readings: Readings, drawing: Comparison
) -> list[tuple[str, str]]:
    """Return the figures of tables that a mutation moves, in the order of the tables."""
    board = drawing.made.boards[one.board]
    log = late(board.construction)
    beside = executed(log, board.given, (NONE, what), [step.it for step in log.steps])
    figures = readings.figures(board, beside, np.arange(2))
    found = []
    for each in readings.columns:
        row = figures.get(each.at)
        if row is not None and abs(abs(row[1]) - abs(row[0])) > 0.5 * max(each.scatter, 1e-9):
            found.append((each.taken.plan, each.taken.segment))
    order = {key[:2]: k for k, key in enumerate(drawing.due)}
    return sorted(dict.fromkeys(found), key=lambda at: order.get(at, 0))
