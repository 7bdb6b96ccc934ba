"""Steps made ready to run, and run: at all positions at once, or in blocks of positions.

Pointwise steps run in blocks, so that a million positions stay in cache and in memory. What is the same at all
positions is found once, before the blocks; a value is freed after the last step that uses it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand, Slip, Slipping, slip_of
from graphic_tmm.board.record import Step
from graphic_tmm.board.room import Room
from graphic_tmm.board.values import Curve, Kind, arrays

Values = dict[int, Any]


class Call(NamedTuple):
    """A step made ready to run: the operation with its choice, the slots it takes, what it fills, by kind."""

    op: Callable[..., Any]
    takes: tuple[int, ...]
    fills: int
    kind: Kind
    reads: bool
    slip: Slip | None = None


Calls = tuple[Call, ...]
ALL = slice(None)
KEPT = 1 << 21
"""An array of so many numbers, made and dropped untouched, raises the size that glibc keeps for itself."""


def ready(step: Step) -> Call:
    """Return a step made ready to run."""
    op = partial(step.op.run, **step.choice) if step.choice else step.op.run
    slip = slip_of(step.op, *step.it.key)
    return Call(
        op, tuple(mark.slot for mark in step.uses), step.it.slot, step.it.kind, step.op.reads, slip
    )


def run(
    calls: Calls,
    values: Values,
    hand: Hand,
    slipping: Slipping | None = None,
    part: slice = ALL,
) -> None:
    """Run calls at the positions of the values, which are this part of the row; everything is left behind."""
    if slipping is not None:
        for op, takes, fills, _, _, slip in calls:
            value = op(*[values[i] for i in takes])
            values[fills] = value if slip is None else slipping.apply(slip, value, part)
    elif hand.ruler is None:
        for op, takes, fills, *_ in calls:
            values[fills] = op(*[values[i] for i in takes])
    else:
        for op, takes, fills, _, reads, _ in calls:
            value = op(*[values[i] for i in takes])
            values[fills] = hand.read(value) if reads else value


def in_blocks(
    calls: Calls,
    values: Values,
    count: int,
    block: int,
    hand: Hand,
    kept: frozenset[int],
    slipping: Slipping | None = None,
) -> None:
    """Run pointwise calls at ``count`` positions, in blocks; values of the slots ``kept`` are left behind."""
    # a value that varies would look in a block of one position like one that does not
    block = max(block, 2)
    if count <= block:
        run(calls, values, hand, slipping)
        return
    # so that glibc keeps what the blocks free, and does not hand it back to the system each time
    np.empty(KEPT)
    still, moving = parted(calls, values)
    run(still, values, hand, slipping)
    dying = _last_uses(moving)
    takes = {i for call in moving for i in call.takes}
    entering = {i: value for i, value in values.items() if i in takes}
    whole: Values = {}
    room = Room(len(kept & {call.fills for call in moving}))
    # nor is there a last block of one position
    starts = range(0, count - 1, block)
    for start in starts:
        part = slice(start, count if start == starts[-1] else start + block)
        local = {i: part_of(value, part) for i, value in entering.items()}
        for call, dead in zip(moving, dying, strict=True):
            run((call,), local, hand, slipping, part)
            if call.fills in kept:
                _keep(whole, call.fills, local[call.fills], part, count, room)
            for i in dead:
                del local[i]
    values.update(whole)


def parted(calls: Calls, values: Values) -> tuple[Calls, Calls]:
    """Return the calls whose results are the same at all positions, and the others."""
    still = {i for i, value in values.items() if not varies(value)}
    first, second = [], []
    for call in calls:
        if still.issuperset(call.takes):
            still.add(call.fills)
            first.append(call)
        else:
            second.append(call)
    return tuple(first), tuple(second)


def varies(value: Any) -> bool:
    """Whether a value has a position axis; a curve is the same at all positions."""
    if isinstance(value, Curve):
        return False
    return any(array.shape[1] > 1 for array in arrays(value))


def _last_uses(calls: Calls) -> list[tuple[int, ...]]:
    """Return which values each call is the last to use: their memory is free, and still in cache."""
    seen: set[int] = set()
    found: list[tuple[int, ...]] = []
    for call in reversed(calls):
        dying = {call.fills, *call.takes} - seen
        seen |= dying
        found.append(tuple(dying))
    return found[::-1]


def part_of(value: Any, part: slice, trials: slice = slice(None)) -> Any:
    """Return a value at some positions, for some trials; a curve is whole."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*(part_of(array, part, trials) for array in value))
    return value[trials] if value.shape[1] == 1 else value[trials, part]


def _keep(whole: Values, index: int, value: Any, part: slice, count: int, room: Room) -> None:
    """Put a block of a value into its whole array; a value that does not vary is kept as it is."""
    if isinstance(value, tuple):
        columns = [{} if index not in whole else {0: array} for array in whole.get(index, value)]
        for column, array in zip(columns, value, strict=True):
            _keep(column, 0, array, part, count, room)
        whole[index] = type(value)(*(column[0] for column in columns))
        return
    if index not in whole:
        varies = value.shape[1] > 1
        whole[index] = room.empty((value.shape[0], count), value.dtype) if varies else value
    if whole[index].shape[1] > 1:
        whole[index][:, part] = value


def stored(kept: Any, value: Any, part: slice, trials: int) -> Any:
    """Put a block of trials of a value into its whole array; what does not vary by trial is kept once."""
    if isinstance(value, tuple):
        parts = (None,) * len(value) if kept is None else kept
        whole: Any = type(value)
        # whether a curve is closed is no array
        return whole(
            *(
                one if isinstance(one, bool) else stored(old, one, part, trials)
                for old, one in zip(parts, value, strict=True)
            )
        )
    if kept is None:
        if value.shape[0] == 1 or value.shape[0] == trials:
            return value
        kept = np.empty((trials, *value.shape[1:]), value.dtype)
    if kept.shape[0] > 1:
        kept[part] = value
    return kept


def spread(value: Any, count: int) -> Any:
    """Return a value at ``count`` positions, also where it does not vary."""
    if isinstance(value, tuple):
        return (
            value if isinstance(value, Curve) else type(value)(*(spread(v, count) for v in value))
        )
    return value if value.shape[1] == count else np.broadcast_to(value, (value.shape[0], count))
