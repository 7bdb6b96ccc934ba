"""The error that each step of a hand-made plan made itself: earlier readings are taken as they were found.

The log is run once more; every segment that was read replaces what the log measured or calculated, every point
that was read the point that the log marked: a later step starts from what was found. All values are arrays
(trial, position), so that one run judges a sheet of readings, or all drawings of a hand.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.geometry import along, wedge
from graphic_tmm.board.operations.instruments import cross, cut, lay_off, meet
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Line, Point, Reals, Side
from graphic_tmm.board.values import given as as_value
from graphic_tmm.drawn import Drawn

MET = (meet, cut, cross)
"""Operations that mark where two lines or arcs meet."""
Found = Mapping[Mark, Any]
"""What was read of marks: arrays (trial, position), of a point x + iy; NaN where it was not read."""


class Grain(NamedTuple):
    """How far a figure may be off by rounding alone, (1, position).

    As it was ``read``, and as it was ``used`` to calculate others.
    """

    read: Reals
    used: Reals


class Own(NamedTuple):
    """The error of one step: of a length or a rate how much too large, of a point or a line how far it is off.

    All are arrays (trial, position), in mm, of a rate in its unit. ``sized_by``: of what the root mean
    square tells how large a hand makes it; ``grain``: so much of it may be the rounding of what was read.
    """

    step: Step
    error: Reals
    sized_by: Reals
    grain: Reals | float = 0.0


class Run(NamedTuple):
    """A log run with what was read: the errors by mark, and what each mark that was read should have been."""

    errors: Mapping[Mark, tuple[Own, ...]]
    due: Mapping[Mark, Any]


def run(work: Drawn, found: Found, grain: Mapping[Mark, Grain]) -> Run:
    """Run a log with what was read in the place of what it measured, calculated and marked.

    Parameters
    ----------
    work
        The scene as the exact hand draws it.
    found
        What was read.
    grain
        How far each figure that was read may be from what was meant, by rounding alone.
    """
    log = work.construction
    values: dict[int, Any] = {
        mark.slot: as_value(work.given[mark], mark.kind) for mark in log.given if mark in work.given
    }
    errors: dict[Mark, tuple[Own, ...]] = {}
    due: dict[Mark, Any] = {}
    lines = {step.it: step for step in log.steps}
    with np.errstate(all="ignore"):
        for step in needed(log, found):
            drawn = [values[mark.slot] for mark in step.uses]
            value = _of(step)(*drawn)
            if (read := found.get(step.it)) is not None:
                due[step.it] = value
                if step.it.kind is Point:
                    parts = _parts(work, lines, step, read, value, values, due)
                    whole = grain[step.it].read if step.it in grain else 0.0
                    errors[step.it] = tuple(part._replace(grain=whole) for part in parts)
                else:
                    error = apart(read, value)
                    errors[step.it] = (Own(step, error, error, _grain(step, value, drawn, grain)),)
                    read = np.where(read < 0.0, read, np.copysign(read, value))
                value = np.where(np.isnan(read), value, read)
            values[step.it.slot] = value
    return Run(errors, due)


def apart(found: Any, due: Any) -> Any:
    """Return by how much a figure exceeds its due; a segment without a sign is a magnitude."""
    if isinstance(found, float) and isinstance(due, float):
        return found - due if found < 0.0 else found - abs(due)
    return np.where(np.asarray(found) < 0.0, found - due, found - np.abs(due))


def read_of(log: Construction, step: Step, found: Found) -> tuple[Mark, ...]:
    """Return the marks that were read and that a step starts from, nothing read being between."""
    steps = {one.it: one for one in log.steps}
    seen: dict[Mark, None] = {}
    ahead, looked = list(step.uses), set()
    while ahead:
        mark = ahead.pop(0)
        if mark in looked:
            continue
        looked.add(mark)
        if mark in found:
            seen[mark] = None
        elif mark in steps:
            ahead += steps[mark].uses
    return tuple(seen)


def alone(log: Construction) -> Iterator[Step]:
    """Yield the steps whose results follow from their own position only."""
    tied: set[int] = set()
    for step in log.steps:
        if step.op.across or any(mark.slot in tied for mark in step.uses):
            tied.add(step.it.slot)
        else:
            yield step


def _of(step: Step) -> Any:
    return partial(step.op.run, **step.choice) if step.choice else step.op.run


def _grain(step: Step, value: Any, drawn: list[Any], grain: Mapping[Mark, Grain]) -> Any:
    """Return how far a figure may be off by the rounding of what it was found from, and by its own."""
    whole = np.asarray(grain[step.it].read if step.it in grain else 0.0)
    for k, mark in enumerate(step.uses):
        if mark in grain and mark.kind is not Point:
            moved = [*drawn[:k], drawn[k] + grain[mark].used, *drawn[k + 1 :]]
            whole = whole + np.nan_to_num(np.abs(_of(step)(*moved) - value))
    return whole


def exact(work: Drawn, mark: Mark) -> Any:
    """Return the numbers of a mark as drawn, along all positions (1, position); NaN where it is not drawn."""
    reading = work.of(mark.view)
    reading, places = (reading, work.row(mark.view)) if reading else (work.reading, work.all)
    value = reading[mark]
    row = np.full((value.shape[0], len(work.names)), np.nan, value.dtype)
    row[:, list(places)] = value
    return row


def _parts(
    work: Drawn,
    lines: Mapping[Mark, Step],
    step: Step,
    found: Any,
    due: Any,
    values: dict[int, Any],
    measured: Mapping[Mark, Any],
) -> Iterator[Own]:
    """Yield how far a point is off each line and arc that it should lie on, or off its own place."""
    drawn = [(lines.get(mark), values[mark.slot]) for mark in step.uses]
    if step.op in MET:
        for by, value in drawn:
            if isinstance(value, Line | Arc):
                yield _even(by or step, _off(value, found))
        if Side in step.op.takes:
            yield _met(step, found, due, [value for _, value in drawn])
    elif step.op is lay_off:
        by, line = drawn[0]
        yield _even(by or step, _off(line, found))
        long = along(found - line.at, line.along)
        # whether the length was laid off right, and read wrongly, or the other way round
        off = np.abs(long - drawn[1][1])
        if (mark := step.uses[1]) in measured:
            for length in (measured[mark], exact(work, mark)):
                off = np.fmin(off, np.abs(long - length))
        yield _even(step, off)
    else:
        yield _even(step, np.abs(found - due))


def _even(step: Step, error: Reals) -> Own:
    return Own(step, error, error)


def _met(step: Step, found: Any, due: Any, drawn: list[Any]) -> Own:
    """Return how far a point is off the due meeting of two lines or arcs, where it is nearer to the other.

    A hand's size of it is told by how far it is off that meeting: where the two are near, a hand takes one for
    the other.
    """
    off = np.abs(found - due)
    place = step.op.takes.index(Side)
    other = _of(step)(*drawn[:place], -drawn[place], *drawn[place + 1 :])
    return Own(step, np.where(np.abs(found - other) < off, off, 0.0), off)


def _off(figure: Line | Arc, found: Any) -> Any:
    """Return how far a point is off a line or an arc, mm."""
    if isinstance(figure, Line):
        return np.abs(wedge(figure.along, found - figure.at))
    return np.abs(np.abs(found - figure.centre) - figure.radius)
