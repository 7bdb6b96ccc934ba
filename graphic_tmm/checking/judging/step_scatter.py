"""What errors the hand's own steps make, where earlier readings are taken as they were found."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Length, Point, Reals
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.own_errors import Found, Own, Run
from graphic_tmm.checking.judging.scatter import Limits, Scatter, limited
from graphic_tmm.checking.judging.taken_marks import Reader

LEAST = 1e-9
"""Errors of a step are never taken for smaller than this, mm: what is divided by it is then no number
of the machine's last digits."""
FEW = 20
"""Fewer errors of points do not tell how finely points were read: of so many the quantile may be off by
half of itself (`SURE`). Could be at least 10 to 40."""
MOST = 0.8
"""The share of the errors of a drawing that tells how finely it was read: fewer than a fifth are gross.
With 0.6 three verdicts of 2000 change, with 0.9 four."""
SURE = 2.2
"""That quantile of normal errors is off by 1.1 of it by the root of their number: twice that, so that
points are taken for finer read than they were in one drawing of forty at the most. With 1.1 three verdicts
of 2000 change, with 4.4 two."""
SHARES = (0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
"""Of the slip of reading coordinates that was counted upon: no finer than the estimate, which is
good to a tenth from some 500 errors on."""


class StepScatter(NamedTuple):
    """The hand's own errors of what led to a reading: their root mean squares, mm, step by step.

    ``sharp``: the same, if coordinates were read without a slip. ``scatter``: of the largest error measured
    by its size; ``most``: what `MOST` of the errors, so measured, are below. ``steady``: which of the
    errors are counted for that: not those that a hand makes now and then. ``drawn``: the largest error of each
    drawing, by its size, with its sign.
    """

    sizes: tuple[float, ...]
    sharp: tuple[float, ...]
    scatter: Scatter
    most: float
    steady: tuple[bool, ...]
    drawn: Reals

    def at(self, share: float) -> tuple[float, ...]:
        """Return the sizes if coordinates were read with this share of the slip that was counted upon."""
        pairs = zip(self.sizes, self.sharp, strict=True)
        return tuple(slips.sized(a, b, share) for a, b in pairs)

    def worst(
        self, errors: Sequence[tuple[Step, float, float]], share: float
    ) -> tuple[float, Step, float]:
        """Return how many times its root mean square the largest error is, as the hand goes, its step, and it.

        ``errors``: each a step, its error, and how much of it may be rounding; ``share``: as in `at`.
        """
        times = [
            slips.counted(error, grain) / size
            for (_, error, grain), size in zip(errors, self.at(share), strict=True)
        ]
        k = times.index(max(times))
        return times[k], errors[k][0], errors[k][1]


def share_of_slip(seen: Sequence[tuple[StepScatter, Sequence[float]]]) -> float:
    """Return with which share of the slip that was counted upon the coordinates of a drawing were read.

    What most of the errors of a drawing are below tells, whatever a few gross ones are. It is counted with
    what it may be off by, and is never more than all.

    Parameters
    ----------
    seen
        How the hand scatters at each point, and the errors of that point, mm.
    """
    rows = [
        (own, k, abs(error))
        for own, errors in seen
        for k, error in enumerate(errors)
        if own.steady[k]
    ]
    if len(rows) < FEW:
        return 1.0
    wide = 1.0 + SURE / math.sqrt(len(rows))
    most = float(np.median([own.most for own, _ in seen]))
    for share in SHARES:
        times = [error / own.at(share)[k] for own, k, error in rows]
        if float(np.quantile(times, MOST)) * wide <= most:
            return share
    return 1.0


def scatters_of(
    log: Construction,
    run: Callable[[Found], Run],
    found: Found,
    drawn: Found,
    by: Reader,
    limits: Limits,
) -> dict[tuple[Mark, int], StepScatter]:
    """Return how far off the hand's own steps are, by mark and position (its index), where they were read.

    ``run``: the log run with what was read; ``drawn``: the numbers of the same marks in the hand's drawings.
    """
    steps = {step.it: step for step in log.steps}
    blunt, sharp = (
        run(
            {
                mark: where_read(as_read(steps[mark], drawn[mark], who), there)
                for mark, there in found.items()
            }
        ).errors
        for who in (by, by.sharp)
    )
    return {
        (mark, int(place)): step_scatter(blunt[mark], sharp[mark], int(place), limits)
        for mark, there in found.items()
        for place in np.flatnonzero(~np.isnan(there[0]))
    }


def step_scatter(
    errors: Sequence[Own], sharp: Sequence[Own], place: int, limits: Limits
) -> StepScatter:
    """Return how large the errors of a hand are at one position; ``sharp``: coordinates read without a slip."""
    sizes, least = (tuple(_size(own, place) for own in some) for some in (errors, sharp))
    times = [
        np.nan_to_num(np.abs(own.error[:, place])) / size
        for own, size in zip(errors, sizes, strict=True)
    ]
    steady = tuple(own.sized_by is own.error for own in errors)
    most = np.quantile([row for row, counts in zip(times, steady, strict=True) if counts], MOST)
    scatter = _limited(np.array(times), limits)
    drawn = np.max(times, axis=0)
    if len(errors) == 1:
        drawn = np.copysign(drawn, np.nan_to_num(errors[0].error[:, place]))
    return StepScatter(sizes, least, scatter, float(most), steady, drawn.astype(np.float32))


def _limited(times: Reals, limits: Limits) -> Scatter:
    """Return the limits of the largest of errors (step, trial), each measured by its own root mean square."""
    found = limited(np.sort(np.max(times, axis=0)), limits)
    wrong = max(limits.wrong, limits.beyond * float(found.sorted[-1]), found.doubtful)
    return found._replace(wrong=wrong)


def _size(own: Own, place: int) -> float:
    seen = _at(own.sized_by, place)
    return max(float(np.sqrt(np.mean(seen**2))), LEAST) if seen.size else LEAST


def _at(values: Reals, place: int) -> Reals:
    row = values[:, place]
    return row[np.isfinite(row)]


def as_read(step: Step, drawn: Any, by: Reader) -> Any:
    """Return what the hand would read of a step's mark, (trial, position)."""
    row, key = drawn, "|".join(step.it.key)
    if step.it.kind is Point:
        row = by.pointed(row, key)
    elif step.it.kind is Length:
        row = np.abs(row) if step.op.reads else by.measured(np.abs(row), key)
    return row


def where_read(row: Any, there: Any) -> Any:
    """Return what the hand would read, NaN where it was not read: where it is NaN ``there``."""
    return np.where(np.isnan(there), np.nan, row)
