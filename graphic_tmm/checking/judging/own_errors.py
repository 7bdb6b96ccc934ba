"""The error that each step of a hand-made plan made itself: earlier readings are taken as they were found.

The log is run once more; every segment that was read replaces what the log measured or calculated, every point
that was read the point that the log marked: a later step starts from what was found. All values are arrays
(trial, position), so that one run judges a sheet of readings, or all drawings of a hand.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import needed
from graphic_tmm.board.operations.instruments import cross, cut, lay_off, meet
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Line, Number, Point, Reals, Side
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.judging import slips
from graphic_tmm.drawn import Drawn

MET = frozenset(op.name for op in (meet, cut, cross))
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


class Part(NamedTuple):
    """What a point may be off, each with an error of its own: of which ``kind`` it is, ``by`` which step made.

    A "line" or an "arc", ``use`` its number among what the point's step uses; the length that was "laid" off;
    the due one of two meetings ("met", the number of the side); its own "place".
    """

    kind: str
    by: Step
    use: int


def parts_of(step: Step, lines: Mapping[Mark, Step]) -> tuple[Part, ...]:
    """Return what the point of a step may be off; ``lines``: the steps of the log by their marks."""
    if step.op.name in MET:
        on = {Line: "line", Arc: "arc"}
        found = [
            Part(on[mark.kind], lines.get(mark) or step, k)
            for k, mark in enumerate(step.uses)
            if mark.kind in on
        ]
        if Side in step.op.takes:
            found.append(Part("met", step, step.op.takes.index(Side)))
        return tuple(found)
    if step.op.name == lay_off.name:
        return Part("line", lines.get(step.uses[0]) or step, 0), Part("laid", step, 1)
    return (Part("place", step, -1),)


class Run(NamedTuple):
    """A log run with what was read: the errors by mark, and what each mark that was read should have been.

    ``values``: what every step used and left, by the slot of its mark.
    """

    errors: Mapping[Mark, tuple[Own, ...]]
    due: Mapping[Mark, Any]
    values: Mapping[int, Any]


def run(
    work: Drawn,
    found: Found,
    grain: Mapping[Mark, Grain],
    wanted: Container[Mark] | None = None,
    signed: Mapping[Mark, Any] | None = None,
) -> Run:
    """Run the log of a scene with what was read in the place of what it measured, calculated and marked.

    ``grain``: how far each figure that was read may be from what was meant, by rounding alone. ``wanted``: of
    which marks the errors are told; None for all that were read. ``signed``: where a plus that was read of a
    rate means that it is positive.
    """
    log, given = work.construction, work.given
    return run_log(log, given, found, grain, partial(exact, work), wanted, signed)


def run_log(
    log: Construction,
    given: Mapping[Mark, object],
    found: Found,
    grain: Mapping[Mark, Grain],
    exact: Callable[[Mark], Any],
    wanted: Container[Mark] | None = None,
    signed: Mapping[Mark, Any] | None = None,
) -> Run:
    """Run a log with what was read in the place of what it measured, calculated and marked.

    Parameters
    ----------
    log, given
        The log, and what is given.
    found
        What was read.
    grain
        How far each figure that was read may be from what was meant, by rounding alone.
    exact
        What the exact hand has of a mark.
    wanted
        Of which marks the errors are told; None for all that were read.
    signed
        Where a plus that was read of a rate means that it is positive.
    """
    values: dict[int, Any] = {
        mark.slot: as_value(given[mark], mark.kind) for mark in log.given if mark in given
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
                told = wanted is None or step.it in wanted
                if told and step.it.kind is Point:
                    parts = errors_at(exact, lines, step, read, value, values, due)
                    whole = grain[step.it].read if step.it in grain else 0.0
                    errors[step.it] = tuple(part._replace(grain=whole) for part in parts)
                elif told:
                    error = apart(read, value)
                    errors[step.it] = (Own(step, error, error, _grain(step, value, drawn, grain)),)
                if step.it.kind is not Point:
                    sure = (
                        signed.get(step.it, False) if signed and step.it.kind is Number else False
                    )
                    read = np.where(sure, read, slips.directed(read, value))
                value = np.where(np.isnan(read), value, read)
            values[step.it.slot] = value
    return Run(errors, due, values)


def apart(found: Any, due: Any, signed: Any = False) -> Any:
    """Return by how much a figure exceeds its due; a segment without a sign is a magnitude.

    ``signed``: whether (where) a plus is a sign.
    """
    if isinstance(found, float) and isinstance(due, float):
        return found - due if found < 0.0 or signed else found - abs(due)
    found = np.asarray(found)
    return np.where(signed, found - due, slips.excess(found, due))


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


def errors_at(
    exact: Callable[[Mark], Any],
    lines: Mapping[Mark, Step],
    step: Step,
    found: Any,
    due: Any,
    values: dict[int, Any],
    measured: Mapping[Mark, Any],
) -> Iterator[Own]:
    """Yield how far a point is off each line and arc that it should lie on, or off its own place."""
    drawn = [values[mark.slot] for mark in step.uses]
    for part in parts_of(step, lines):
        if part.kind == "met":
            yield _met(step, part.use, found, due, drawn)
        elif part.kind == "laid":
            yield _even(part.by, _laid(exact, step, found, drawn, measured))
        elif part.kind == "place":
            yield _even(part.by, slips.off_place(found, due))
        else:
            off = slips.off_line if part.kind == "line" else slips.off_arc
            yield _even(part.by, off(drawn[part.use], found))


def _even(step: Step, error: Reals) -> Own:
    return Own(step, error, error)


def _laid(
    exact: Callable[[Mark], Any],
    step: Step,
    found: Any,
    drawn: list[Any],
    measured: Mapping[Mark, Any],
) -> Any:
    """Return how far a point is off the end of the length laid off.

    Whether that was laid off right, and read wrongly, or the other way round.
    """
    line, length = drawn
    off = slips.off_length(line, length, found)
    if (mark := step.uses[1]) in measured:
        for other in (measured[mark], exact(mark)):
            off = slips.nearer(off, slips.off_length(line, other, found))
    return off


def _met(step: Step, side: int, found: Any, due: Any, drawn: list[Any]) -> Own:
    """Return how far a point is off the due meeting of two lines or arcs, where it is nearer to the other.

    A hand's size of it is told by how far it is off that meeting: where the two are near, a hand takes one for
    the other.
    """
    other = _of(step)(*drawn[:side], -drawn[side], *drawn[side + 1 :])
    return Own(step, slips.off_meeting(found, due, other), slips.off_place(found, due))
