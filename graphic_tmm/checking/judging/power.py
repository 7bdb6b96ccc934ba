"""What error of a length is seen: how many mm are called wrong in half of the drawings, and in 19 of 20."""

from __future__ import annotations

from collections import defaultdict
from statistics import median
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Length
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.counted import counted_readings
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.residuals import sets_of
from graphic_tmm.checking.judging.scatter import Limits, Scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.judging.yardstick import Yardsticks
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene

NINETEEN = 1.645
"""So many standard deviations beyond a limit a normal figure is above it in 19 of 20 drawings."""


class SeenError(NamedTuple):
    """How large an error of a segment is called wrong, mm: in half of the drawings, in 19 of 20 (medians).

    ``least``, ``most``: in half of them, of its positions.
    """

    plan: str
    segment: str
    half: float
    nearly: float
    least: float
    most: float


def seen_errors(made: DrawnScene, yardsticks: Yardsticks) -> tuple[SeenError, ...]:
    """Return what is seen of one length that is off where all lengths of the plans are given.

    Parameters
    ----------
    made
        The scene as the exact hand draws it.
    yardsticks
        By what its drawings are judged.
    """
    steps = steps_of(made.mechanism)
    rows = [
        Taken(plan, position, segment, mm=abs(cell.mm), line=k)
        for k, ((plan, segment, position), cell) in enumerate(cells(made).items())
        if cell.mm is not None and (step := steps.get((plan, segment))) is not None
        if step.it.kind is Length and step.op.reads
    ]
    if not rows:
        return ()
    by = yardsticks.of(rows)
    counted = counted_readings(made, judge(made, rows, by), by)
    sets = list(sets_of(counted, by))
    if not sets:
        return ()
    limit = by.covariances.usual([one.together for one in sets]).limit
    limit *= by.limits.wrong / Limits().wrong
    found: dict[tuple[str, str], list[tuple[float, float]]] = defaultdict(list)
    for some in sets:
        roots = np.sqrt(np.diag(some.together.precision))
        for k, root, size in zip(some.numbers, roots, some.together.sizes, strict=True):
            one = counted[k]
            usual = by.spread[one.judged.taken.at]
            mm = _size(one.by) / float(root)
            alone = max(limit * float(size) * mm, usual.doubtful)
            half = min(alone, usual.wrong)
            spread = mm * float(size) if half == alone else usual.rms
            taken = one.judged.taken
            found[taken.plan, taken.segment].append((half, half + NINETEEN * spread))
    return tuple(
        SeenError(
            *at,
            median(half for half, _ in some),
            median(nearly for _, nearly in some),
            min(some)[0],
            max(some)[0],
        )
        for at, some in found.items()
    )


def _size(by: StepScatter | Scatter) -> float:
    """Return what is usual of a reading, mm: of its step's own errors or of its figure."""
    return by.sizes[0] if isinstance(by, StepScatter) else by.rms
