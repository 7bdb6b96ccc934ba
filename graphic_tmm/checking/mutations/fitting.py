"""What was misread, and by how much: the factor of a given, found from the readings.

A grid alone would name its neighbour with confidence: the best of the grid is the beginning of Newton's steps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.mutations.evidence import Board, Evidence, Readings, nothing, of_mutations
from graphic_tmm.checking.mutations.givens import misread
from graphic_tmm.checking.mutations.mistakes import NONE, Offered
from graphic_tmm.checking.mutations.mutation import Mutation

GRID = (0.4, 0.5, 0.6, 0.7, 0.8, 0.88, 1.12, 1.25, 1.4, 1.6, 1.8, 2.2)
"""Where the search begins: so many times as large a given was taken."""
STEP, ROUNDS = 0.01, 3
"""The step of the differences, and how often a step is taken: from a grid of 12 % the third is below 0.1 %."""
NEAR = 0.1
"""What is nearer to 1 is an instrument's, or a reading's, not a mistake."""
FARTHEST = 0.2
"""No step goes farther (of the logarithm): a parabola is none beyond."""


def fitted(
    readings: Readings, offered: Offered, base: Board, least: Mapping[tuple[Key, bool], float]
) -> tuple[list[Mutation], Evidence]:
    """Return the givens that were misread, each as it fits the readings best, and the evidence for them.

    The first row is the log as it is. ``least``: by how much a figure must move that is not fine.
    """
    trial = [NONE, *(misread(marks, 1.2) for marks in offered.free)]
    rows = offered.moving(least, offered.run(trial, base)) if offered.free else np.zeros(1, int)
    free = [offered.free[k - 1] for k in rows if k]
    if not free:
        return [], nothing(1, readings.places)

    def gains(factors: Sequence[Sequence[float]]) -> np.ndarray:
        """Return what each given gains, taken so many times as large; (given, factor)."""
        some = [misread(m, f) for m, row in zip(free, factors, strict=True) for f in row]
        found = _evidence(readings, offered, base, [NONE, *some]).gain[1:].sum(axis=1)
        return np.asarray(found.reshape(len(free), -1))

    first = gains([GRID] * len(free))
    at = np.log(np.array(GRID)[np.argmax(first, axis=1)])
    for _ in range(ROUNDS):
        told = gains([np.exp(x + np.array([-STEP, 0.0, STEP])).tolist() for x in at])
        slope = (told[:, 2] - told[:, 0]) / (2.0 * STEP)
        bend = (told[:, 2] - 2.0 * told[:, 1] + told[:, 0]) / STEP**2
        with np.errstate(all="ignore"):
            newton = np.where(bend < 0.0, -slope / bend, np.sign(slope) * STEP * 5.0)
        at = at + np.clip(np.nan_to_num(newton), -FARTHEST, FARTHEST)
    factors = np.exp(at)
    kept = [misread(m, float(f)) for m, f in zip(free, factors, strict=True) if abs(f - 1.0) > NEAR]
    return [NONE, *kept], _evidence(readings, offered, base, [NONE, *kept])


def _evidence(
    readings: Readings, offered: Offered, base: Board, some: Sequence[Mutation]
) -> Evidence:
    plain = offered.run(some, base)
    return of_mutations(readings, base, some, plain, np.arange(len(some)))[0]
