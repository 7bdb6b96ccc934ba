"""Which wrong readings a mistake explains: those that it moves, by the log, towards what was read."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.execution import executed, figures_of
from graphic_tmm.checking.mutations.hypotheses import Hypothesis
from graphic_tmm.checking.mutations.mistakes import NONE
from graphic_tmm.checking.mutations.mutation import Mutation, measured_last
from graphic_tmm.checking.records import Judged

PART = 0.2
"""A mistake explains a reading if it moves it by so large a share of what it is off."""


def explained(one: Hypothesis, diagnosis: Diagnosis, drawing: Comparison) -> tuple[int, ...]:
    """Return the lines of the wrong readings that a mistake moves, by no small part of what they are off.

    They are nearer to it than to what is due, unless another mistake moves them, too; there may be none. Of a
    table written down otherwise, those of its place.
    """
    what = one.what
    some = diagnosis.wrong or diagnosis.doubtful
    if isinstance(what, Mutation):
        moved = _moved(one, what, some, drawing)
        alone = len(diagnosis.named) < 2
        found = [
            each
            for each in some
            if (to := moved.get(each.taken.at)) is not None
            and _apart(each, *to) > PART * _apart(each, _read(each), to[0])
            and not (alone and _apart(each, _read(each), to[1]) > _apart(each, _read(each), to[0]))
        ]
    else:
        its = [
            each
            for each in some
            if what.plan in ("", each.taken.plan) and what.segment in ("", each.taken.segment)
        ]
        found = its or list(some)
    return tuple(dict.fromkeys(each.taken.line for each in found))


def _read(one: Judged) -> complex:
    """Return what was read: a point by its place, else a figure."""
    return one.taken.spot if one.taken.pointed else one.found


def _apart(of: Judged, one: complex, other: complex) -> float:
    """Return how far two figures of a reading are apart, whatever their signs if none was read.

    Of a point, two places.
    """
    whole = of.taken.pointed or of.taken.signed or of.found < 0.0
    far = abs(one - other) if whole else abs(abs(one) - abs(other))
    return float(np.nan_to_num(far, nan=np.inf))


def _moved(
    one: Hypothesis, what: Mutation, some: Sequence[Judged], drawing: Comparison
) -> dict[tuple[Key, bool], tuple[complex, complex]]:
    """Return what is due of some readings, and what a mistake makes of it where it was made."""
    made, at = drawing.made, drawing.names[one.place] if one.place is not None else ""
    board = made.boards[one.board]
    log = measured_last(board.construction)
    beside = executed(log, board.given, (NONE, what), [step.it for step in log.steps])
    due = {each.taken.at: each.due for each in some if at in ("", each.taken.position)}
    moved = {}
    for key, row in figures_of(made, board, beside, np.arange(2), tuple(due)).items():
        whole = 1.0 if np.iscomplexobj(row) or not row[0] or not due[key] else due[key] / row[0]
        moved[key] = complex(row[0] * whole), complex(row[1] * whole)  # as it was written
    return moved
