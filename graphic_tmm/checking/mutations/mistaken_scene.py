"""A scene as it is drawn with a mistake that was named: what a report shows beside what is due."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.checking.mutations.diagnosis import Diagnosis
from graphic_tmm.checking.mutations.execution import AssumedLog, as_drawn, executed
from graphic_tmm.checking.mutations.hypotheses import Hypothesis
from graphic_tmm.checking.mutations.mistakes import NONE
from graphic_tmm.checking.mutations.mutation import Mutation, measured_last
from graphic_tmm.checking.records import MISTAKE, Likely
from graphic_tmm.drawn import DrawnScene


class MistakenScene(NamedTuple):
    """A scene drawn exactly but for a mistake; the steps done otherwise, by the slot of their mark."""

    drawn: DrawnScene
    steps: Mapping[int, Step]


def mistaken_scenes(
    findings: Sequence[Likely], diagnosis: Diagnosis, made: DrawnScene
) -> tuple[MistakenScene | None, ...]:
    """Return for each finding the scene as it is drawn with it; None of what is no mistake of the drawing.

    ``findings``: as told of the diagnosis, the named ones first, in its order.
    """
    named = [group[0] for group, _ in diagnosis.named]
    return tuple(
        _drawn(named[k], made) if one.kind == MISTAKE and k < len(named) else None
        for k, one in enumerate(findings)
    )


def _drawn(one: Hypothesis, made: DrawnScene) -> MistakenScene | None:
    if not isinstance(one.what, Mutation):
        return None
    board = made.boards[one.board]
    base = AssumedLog(board, measured_last(board.construction), board.given)
    wrong = base.mistaken(one.what, one.place)
    beside = executed(wrong.log, wrong.given, (NONE,), wrong.marks)
    steps = {slot: change.step for slot, change in one.what.changes.items()}
    return MistakenScene(as_drawn(made, board, beside, np.arange(1)), steps)
