"""What errors the hand's own steps make, where earlier readings are taken as they were found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Length, Point, Reals
from graphic_tmm.checking.own import Found, Own, run
from graphic_tmm.checking.scatter import Limits, Scatter, limited
from graphic_tmm.checking.tolerance import Reader
from graphic_tmm.work import Work

LEAST = 1e-9
"""Errors of a step are never taken for smaller than this, mm."""


class Usual(NamedTuple):
    """The hand's own errors of what led to a reading: their root mean squares, mm, step by step.

    ``scatter``: of the largest error measured by these. Of a length that is calculated: as it is read off the
    paper; as it is calculated it has no slip but its digits.
    """

    sizes: tuple[float, ...]
    scatter: Scatter

    def worst(self, errors: Sequence[tuple[Step, float, float]]) -> tuple[float, Step, float]:
        """Return how many times its usual size the largest error is as the hand goes, its step, and it.

        ``errors``: each a step, its error, and how much of it may be rounding.
        """
        times = [
            max(abs(error) - grain, 0.0) / size
            for (_, error, grain), size in zip(errors, self.sizes, strict=True)
        ]
        k = times.index(max(times))
        return times[k], errors[k][0], errors[k][1]


def usual_errors(
    work: Work, found: Found, by: Reader, limits: Limits
) -> dict[tuple[Mark, int], Usual]:
    """Return how far off the hand's own steps are, by mark and position (its index), where they were read."""
    if not found:
        return {}
    drawn = work.drawn_by(by.hand)
    again = {mark: _read(drawn, mark, there, by) for mark, there in found.items()}
    errors = run(work, again, {}).errors
    return {
        (mark, int(place)): _usual(errors[mark], int(place), limits)
        for mark, there in found.items()
        for place in np.flatnonzero(~np.isnan(there[0]))
    }


def _usual(errors: Sequence[Own], place: int, limits: Limits) -> Usual:
    sizes, times = [], []
    for own in errors:
        usual = _at(own.usual, place)
        size = max(float(np.sqrt(np.mean(usual**2))), LEAST) if usual.size else LEAST
        sizes.append(size)
        times.append(np.nan_to_num(np.abs(own.error[:, place])) / size)
    return Usual(tuple(sizes), limited(np.sort(np.max(times, axis=0)), limits))


def _at(values: Reals, place: int) -> Reals:
    row = values[:, place]
    return row[np.isfinite(row)]


def _read(drawn: Work, mark: Mark, there: Any, by: Reader) -> Any:
    """Return what the hand would read of a mark, (trial, position); NaN where it was not read."""
    row = _drawn(drawn, mark)
    key = f"{mark.view}|{mark.letter}"
    if mark.kind is Point:
        row = by.pointed(row, key)
    elif mark.kind is Length:
        log = drawn.project.construction
        step = next(step for step in log.steps if step.it == mark)
        row = np.abs(row) if step.op.reads else by.measured(np.abs(row), key)
    return np.where(np.isnan(there), np.nan, row)


def _drawn(drawn: Work, mark: Mark) -> Any:
    """Return the values of a mark in all drawings, (trial, position); NaN where it was not drawn."""
    project = drawn.project
    shape = (drawn.hand.trials, len(project.names))
    if mark.view != "accelerations":
        return np.broadcast_to(drawn.reading[mark], shape).copy()
    assert drawn.accelerated is not None
    value = drawn.accelerated[mark]
    row = np.full(shape, np.nan, value.dtype)
    row[:, list(project.accelerated)] = value
    return row
