"""The log becomes numbers: a backward slice of it, in blocks of positions, for all trials at once.

Pointwise steps run in blocks of positions, so that a million of them stay in cache and in memory; a step
that works across positions (a French curve) runs on whole arrays, between two strata of pointwise steps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import EXACT, Hand, Slip, Slipping, Streams, slip_of, trials_in_block
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Curve
from graphic_tmm.board.values import given as as_value
from graphic_tmm.errors import ConstructionError

BLOCK = 4096
"""Positions in one block: some fifty arrays of it fit into a second-level cache."""

Values = dict[int, Any]


@dataclass(frozen=True)
class Reading:
    """The numbers of the marks asked for, by mark; ``positions`` is the length of the position axis."""

    values: Mapping[int, Any]
    positions: int

    def __getitem__(self, mark: Mark) -> Any:
        """Return the value of ``mark``, axes (trial, position), size 1 where it does not vary."""
        return self.values[mark.slot]

    def trial(self, k: int) -> Reading:
        """Return the numbers of one trial."""
        return Reading(_Trial(self.values, k), self.positions)

    def __contains__(self, mark: object) -> bool:
        """Whether the value of ``mark`` was asked for."""
        return isinstance(mark, Mark) and mark.slot in self.values


class _Trial(Mapping[int, Any]):
    """The values of one trial, cut out when they are asked for."""

    def __init__(self, values: Mapping[int, Any], k: int) -> None:
        self.values_, self.k = values, k

    def __getitem__(self, slot: int) -> Any:
        value = self.values_[slot]
        if isinstance(value, Curve):
            return Curve(self._cut(value.knots), self._cut(value.tangents), value.closed)
        if isinstance(value, tuple):
            return type(value)(*map(self._cut, value))
        return self._cut(value)

    def _cut(self, array: Any) -> Any:
        return array if array.shape[0] == 1 else array[self.k : self.k + 1]

    def __iter__(self) -> Iterator[int]:
        return iter(self.values_)

    def __len__(self) -> int:
        return len(self.values_)


def needed(construction: Construction, wanted: Iterable[Mark]) -> tuple[Step, ...]:
    """Return the backward slice of the log: the steps that the wanted marks need, in order."""
    alive = {mark.slot for mark in wanted}
    kept = []
    for step in reversed(construction.steps):
        if step.it.slot in alive:
            kept.append(step)
            alive.update(mark.slot for mark in step.uses)
    return tuple(reversed(kept))


class Call(NamedTuple):
    """A step made ready to run: the operation with its choice, the slots it takes, the slot it fills."""

    run: Callable[..., Any]
    takes: tuple[int, ...]
    fills: int
    reads: bool
    slip: Slip | None = None


Calls = tuple[Call, ...]


class Program(NamedTuple):
    """A slice of a log made ready to run: strata of pointwise steps, each ended by steps across positions."""

    strata: tuple[tuple[Calls, Calls], ...]
    wanted: frozenset[int]
    given: tuple[Mark, ...]

    def run(
        self,
        given: Mapping[Mark, object],
        *,
        hand: Hand = EXACT,
        block: int = BLOCK,
        places: Any = None,
        whole: int | None = None,
    ) -> Reading:
        """Run at all positions of ``given``; see `execute`.

        ``places``: where these stand among the ``whole`` positions, for the random streams of a hand.
        """
        values: Values = {}
        for mark in self.given:
            value = given.get(mark)
            if value is None:
                raise ConstructionError(f"{mark.view}: '{mark.letter}' was not given")
            values[mark.slot] = as_value(value, mark.kind)
        count = max((v.shape[1] for v in values.values()), default=1)
        if not hand.slips and hand.digits is None:
            self._run(values, count, block, hand, None)
            return Reading({i: v for i, v in values.items() if i in self.wanted}, count)
        streams, found = Streams(hand), Values()
        whole = whole or count
        most = trials_in_block(whole)
        for start in range(0, hand.trials, most):
            trials = min(most, hand.trials - start)
            number = (hand.first + start) // most
            slipping = Slipping(hand, streams, number, trials, whole, places)
            local = dict(values)
            self._run(local, count, block, hand, slipping)
            part = slice(start, start + trials)
            for i in self.wanted & local.keys():
                found[i] = _stored(found.get(i), local[i], part, hand.trials)
        return Reading(found, count)

    def _run(
        self, values: Values, count: int, block: int, hand: Hand, slipping: Slipping | None
    ) -> None:
        with np.errstate(all="ignore"):
            for pointwise, across in self.strata:
                _in_blocks(pointwise, values, count, block, hand, self._kept(pointwise), slipping)
                for call in across:
                    value = call.run(*[_spread(values[i], count) for i in call.takes])
                    if slipping is not None and call.slip is not None:
                        value = slipping.apply(call.slip, value, slice(None))
                    values[call.fills] = value

    def _kept(self, stratum: Calls) -> frozenset[int]:
        if len(self.strata) == 1:
            return self.wanted
        used = {
            i
            for pointwise, across in self.strata
            for call in (*(pointwise if pointwise is not stratum else ()), *across)
            for i in call.takes
        }
        return frozenset({call.fills for call in stratum} & (used | self.wanted))


def prepare(construction: Construction, wanted: Iterable[Mark] | None = None) -> Program:
    """Slice the log to what ``wanted`` needs (everything if None) and sort it into strata."""
    asked = (
        frozenset(range(construction.size))
        if wanted is None
        else frozenset(mark.slot for mark in wanted)
    )
    everything = (*construction.given, *(step.it for step in construction.steps))
    steps = needed(construction, (mark for mark in everything if mark.slot in asked))
    level: dict[int, int] = {}
    for step in steps:
        depth = max((level.get(mark.slot, 0) for mark in step.uses), default=0)
        level[step.it.slot] = depth + 1 if step.op.across else depth
    strata = []
    for n in range(max(level.values(), default=0) + 1):
        pointwise = (s for s in steps if not s.op.across and level[s.it.slot] == n)
        across = (s for s in steps if s.op.across and level[s.it.slot] == n + 1)
        strata.append((tuple(map(_call, pointwise)), tuple(map(_call, across))))
    alive = asked | {mark.slot for step in steps for mark in step.uses}
    return Program(tuple(strata), asked, tuple(m for m in construction.given if m.slot in alive))


def execute(
    construction: Construction,
    given: Mapping[Mark, object],
    wanted: Iterable[Mark] | None = None,
    *,
    hand: Hand = EXACT,
    positions: Sequence[int] | None = None,
    block: int = BLOCK,
) -> Reading:
    """Return the numbers of the wanted marks.

    Parameters
    ----------
    construction
        The log.
    given
        A value for each given mark that the slice needs: scalars, or arrays (trial, position).
    wanted
        The marks to find; None for all of them.
    hand
        Who draws and reads; the exact hand by default.
    positions
        Indices of the positions to run at; None for all. Not for steps across positions.
    block
        Positions a block.

    Raises
    ------
    ConstructionError
        If a value is missing, or a curve across positions is asked for at some positions only.
    """
    program = prepare(construction, wanted)
    if positions is None:
        return program.run(given, hand=hand, block=block)
    if len(program.strata) > 1:
        raise ConstructionError("a curve across positions needs all positions of its row")
    rows = {
        mark: value
        for mark, value in given.items()
        if isinstance(value, np.ndarray) and value.ndim == 2 and value.shape[1] > 1
    }
    whole = max((value.shape[1] for value in rows.values()), default=1)
    at = np.asarray(positions, dtype=np.intp)
    # a single one stands twice, so that what varies along the row is seen to vary, and slips as it does there
    alone = at.size == 1 < whole and hand.slips
    at = np.repeat(at, 2) if alone else at
    cut = {**given, **{mark: value[:, at] for mark, value in rows.items()}}
    found = program.run(cut, hand=hand, block=block, places=at, whole=whole)
    if not alone:
        return found
    return Reading({i: _part(value, slice(0, 1)) for i, value in found.values.items()}, 1)


def _call(step: Step) -> Call:
    run = partial(step.op.run, **step.choice) if step.choice else step.op.run
    slip = slip_of(step.op, step.it.view, step.it.letter)
    return Call(run, tuple(mark.slot for mark in step.uses), step.it.slot, step.op.reads, slip)


def _stored(kept: Any, value: Any, part: slice, trials: int) -> Any:
    """Put a block of trials of a value into its whole array; what does not vary by trial is kept once."""
    if isinstance(value, tuple):
        parts = (None,) * len(value) if kept is None else kept
        whole: Any = type(value)
        # whether a curve is closed is no array
        return whole(
            *(
                one if isinstance(one, bool) else _stored(old, one, part, trials)
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


def _run(calls: Calls, values: Values, read: Callable[[Any], Any] | None) -> None:
    for run, takes, fills, reads, _ in calls:
        value = run(*[values[i] for i in takes])
        values[fills] = read(value) if reads and read is not None else value


def _slip(calls: Calls, values: Values, slipping: Slipping, part: slice) -> None:
    for run, takes, fills, _, slip in calls:
        value = run(*[values[i] for i in takes])
        values[fills] = value if slip is None else slipping.apply(slip, value, part)


def _in_blocks(
    calls: Calls,
    values: Values,
    count: int,
    block: int,
    hand: Hand,
    kept: frozenset[int],
    slipping: Slipping | None,
) -> None:
    read = None if hand.ruler is None else hand.read
    # a value that varies would look in a block of one position like one that does not
    block = max(block, 2)
    if count <= block:
        if slipping is None:
            _run(calls, values, read)
        else:
            _slip(calls, values, slipping, slice(None))
        return
    whole: Values = {}
    # nor is there a last block of one position
    starts = range(0, count - 1, block)
    for start in starts:
        part = slice(start, count if start == starts[-1] else start + block)
        local = {i: _part(value, part) for i, value in values.items()}
        if slipping is None:
            _run(calls, local, read)
        else:
            _slip(calls, local, slipping, part)
        for call in calls:
            if call.fills in kept:
                _keep(whole, call.fills, local[call.fills], part, count)
    values.update(whole)


def _part(value: Any, part: slice) -> Any:
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*(_part(array, part) for array in value))
    return value if value.shape[1] == 1 else value[:, part]


def _keep(whole: Values, index: int, value: Any, part: slice, count: int) -> None:
    """Put a block of a value into its whole array; a value that does not vary is kept as it is."""
    if isinstance(value, tuple):
        columns = [{} if index not in whole else {0: array} for array in whole.get(index, value)]
        for column, array in zip(columns, value, strict=True):
            _keep(column, 0, array, part, count)
        whole[index] = type(value)(*(column[0] for column in columns))
        return
    if index not in whole:
        varies = value.shape[1] > 1
        whole[index] = np.empty((value.shape[0], count), value.dtype) if varies else value
    if whole[index].shape[1] > 1:
        whole[index][:, part] = value


def _spread(value: Any, count: int) -> Any:
    if isinstance(value, tuple):
        return (
            value if isinstance(value, Curve) else type(value)(*(_spread(v, count) for v in value))
        )
    return np.broadcast_to(value, (value.shape[0], count))
