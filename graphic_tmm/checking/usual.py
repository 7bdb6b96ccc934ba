"""What errors the hand's own steps make, where earlier readings are taken as they were found."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.checking.cells import Key, cells, points
from graphic_tmm.checking.own import Own, OwnErrors
from graphic_tmm.checking.records import Taken
from graphic_tmm.checking.scatter import Limits, Scatter, limited
from graphic_tmm.studio import Made, drawings

TRIALS = 150
"""How often the hand draws to tell what errors its steps make by themselves."""
LEAST = 1e-9
"""Errors of a step are never taken for smaller than this, mm."""


class Usual(NamedTuple):
    """The hand's own errors of what led to a reading: their root mean squares, mm, step by step.

    ``scatter``: of the largest error measured by these.
    """

    sizes: tuple[float, ...]
    scatter: Scatter

    def worst(self, errors: Sequence[Own]) -> tuple[float, Own]:
        """Return the error that is the largest as the hand goes, and how many times its usual one it is."""
        times = [abs(own.error) / size for own, size in zip(errors, self.sizes, strict=True)]
        k = times.index(max(times))
        return times[k], errors[k]


def usual_errors(
    made: Made, readings: Sequence[Taken], hand: Hand, limits: Limits
) -> dict[Key, Usual]:
    """Return how far off the hand's own steps are, by reading."""
    rows: dict[Key, list[list[float]]] = {}
    for drawn in drawings(made, hand._replace(trials=min(hand.trials, TRIALS))):
        again = _as_drawn(drawn, readings)
        errors = OwnErrors(made, again)
        for taken in again:
            if mine := errors.of(taken):
                key = taken.key
                rows.setdefault(key, []).append([abs(own.error) for own in mine])
    return {key: _usual(np.array(row), limits) for key, row in rows.items()}


def _usual(errors: np.ndarray, limits: Limits) -> Usual:
    """Return what is usual of errors (trial, step)."""
    sizes = np.maximum(np.sqrt(np.mean(errors**2, axis=0)), LEAST)
    largest = np.sort(np.max(errors / sizes, axis=1))
    return Usual(tuple(map(float, sizes)), limited(largest, limits))


def _as_drawn(drawn: Made, readings: Sequence[Taken]) -> list[Taken]:
    """Return the same readings as they would be of another drawing."""
    figures, where = cells(drawn), points(drawn)
    again = []
    for taken in readings:
        key = taken.key
        if taken.pointed and key in where:
            z = where[key]
            again.append(taken._replace(x=z.real, y=z.imag))
        elif taken.mm is not None and key in figures and figures[key].mm is not None:
            again.append(taken._replace(mm=abs(figures[key].mm or 0.0)))
    return again
