"""The log as loops over positions: its formulas taken down once, worked as machine code.

A log is a straight-line program, so its operations noted on a tape (`traced`) are the whole calculation, each
intermediate once. What cannot be noted (curves, searches) runs by numpy, between two loops.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import Call, Calls, Room, Values, in_blocks, run
from graphic_tmm.board.hand import Hand, rounded
from graphic_tmm.board.loop_passes import WIDTH
from graphic_tmm.board.loop_text import End, Loop, loop_of
from graphic_tmm.board.machine import Run, made
from graphic_tmm.board.record import ByIdentity
from graphic_tmm.board.sources import RULER, Source, assembled, sources, taken_apart
from graphic_tmm.board.tape import INPUT, Tape
from graphic_tmm.board.threads import shared
from graphic_tmm.board.traced import REFUSED, plainly_traced
from graphic_tmm.board.unknown import NotTraced, Value
from graphic_tmm.board.values import Curve, complexes


class Form(NamedTuple):
    """What a value is apart from its numbers: its type, which of its arrays are complex, which vary."""

    kind: type
    complex: tuple[bool, ...]
    varies: tuple[bool, ...]


class Result(NamedTuple):
    """What a loop leaves in a slot: its kind, and where its arrays stand among the leaves of the loop."""

    slot: int
    kind: type
    leaves: tuple[int, ...]


class Part(NamedTuple):
    """A loop, what enters it and what it leaves; the calls that numpy has to do after it, and those after.

    ``depends``: of each leaf of the loop, as bits, the inputs that it comes from.
    """

    loop: Loop
    run: Run
    feeds: tuple[Source, ...]
    depends: tuple[int, ...]
    results: tuple[Result, ...]
    others: Calls
    left: frozenset[int]
    rest: Calls


def at_hand(calls: Calls) -> bool:
    """Whether a loop of these calls stands in memory already."""
    return ByIdentity(calls) in _MADE


def in_loops(
    calls: Calls,
    values: Values,
    count: int,
    block: int,
    hand: Hand,
    kept: frozenset[int],
    threads: int | None = None,
) -> None:
    """Run pointwise calls at ``count`` positions as `in_blocks` does, in compiled loops where these exist."""
    while calls:
        forms = tuple([_form(values.get(i)) for i in _outer(ByIdentity(calls))])
        if not any(form is not None and any(form.varies) for form in forms):
            run(calls, values, hand)
            return
        part = _part(ByIdentity(calls), forms, hand.ruler is not None, kept)
        if part.results:
            _fill(part, values, count, hand, threads)
        if part.others:
            in_blocks(part.others, values, count, block, hand, part.left)
        calls = part.rest


@lru_cache(maxsize=256)
def _outer(same: ByIdentity[Calls]) -> tuple[int, ...]:
    """Return the slots that calls take and do not fill."""
    fills = {call.fills for call in same.it}
    return tuple(sorted({i for call in same.it for i in call.takes} - fills))


def _form(value: Any) -> Form | None:
    """Return the form of a value; None of a curve."""
    if isinstance(value, tuple):
        if isinstance(value, Curve):
            return None
        return Form(
            type(value),
            tuple([array.dtype.kind == "c" for array in value]),
            tuple([array.shape[1] > 1 for array in value]),
        )
    return Form(np.ndarray, (value.dtype.kind == "c",), (value.shape[1] > 1,))


_MADE: dict[ByIdentity[Calls], None] = {}
"""Calls of which a loop was made; the oldest go."""


@lru_cache(maxsize=64)
def _part(
    same: ByIdentity[Calls], forms: tuple[Form | None, ...], reads: bool, kept: frozenset[int]
) -> Part:
    """Make the loop of all calls that can be noted and do not wait for one that cannot."""
    tape, feeds = Tape(), list[Source]()
    found: dict[int, Any] = {}
    for slot, form in zip(_outer(same), forms, strict=True):
        if form is not None:
            each = sources(slot, form.complex)
            feeds += chain(*each)
            parts = [
                [tape.input(varies) for _ in numbers]
                for numbers, varies in zip(each, form.varies, strict=True)
            ]
            found[slot] = assembled(form.kind, tape, parts)
    ruler = None
    if reads:
        ruler = Value(tape, tape.input(moving=False))
        feeds.append(RULER)
    taken, others, rest = _sorted(same.it, found, ruler)
    later = {i for call in (*others, *rest) for i in call.takes}
    results: list[Result] = []
    leaves: list[tuple[End, ...]] = []
    for call in sorted(taken, key=lambda call: call.fills):
        if call.fills in kept | later:
            value = found[call.fills]
            ends = [
                tuple(tape.plain(part) for part in parts)
                for parts in taken_apart(value, complexes(call.kind))
            ]
            places = tuple(range(len(leaves), len(leaves) + len(ends)))
            kind = type(value) if isinstance(value, tuple) else np.ndarray
            results.append(Result(call.fills, kind, places))
            leaves += ends
    loop = loop_of(tape, leaves)
    after = {i for call in rest for i in call.takes}
    left = frozenset({call.fills for call in others} & (kept | after))
    while len(_MADE) >= 1024:
        del _MADE[next(iter(_MADE))]
    _MADE[same] = None
    return Part(
        loop,
        made(loop.text),
        tuple(feeds),
        _depends(tape, leaves),
        tuple(results),
        others,
        left,
        rest,
    )


def _depends(tape: Tape, leaves: Sequence[Sequence[End]]) -> tuple[int, ...]:
    """Return the inputs that numbers come from, as bits."""
    bits: list[int] = []
    inputs = 0
    for node in tape.nodes:
        own = 0
        if node.does == INPUT:
            own, inputs = 1 << inputs, inputs + 1
        bits.append(_together(node.takes, bits, own))
    return tuple(_together(ends, bits) for ends in leaves)


def _together(ends: Sequence[End], bits: Sequence[int], found: int = 0) -> int:
    for end in ends:
        if isinstance(end, int):
            found |= bits[end]
    return found


def _sorted(calls: Calls, found: dict[int, Any], ruler: Value | None) -> tuple[Calls, Calls, Calls]:
    """Return calls that can be noted, that cannot, that wait for these; enter what is noted."""
    taken: list[Call] = []
    others: list[Call] = []
    rest: list[Call] = []
    missing: set[int] = set()
    for call in calls:
        if not missing.isdisjoint(call.takes):
            rest.append(call)
        else:
            try:
                found[call.fills] = _noted(call, found, ruler)
                taken.append(call)
                continue
            except REFUSED:
                others.append(call)
        missing.add(call.fills)
    return tuple(taken), tuple(others), tuple(rest)


def _noted(call: Call, found: dict[int, Any], ruler: Value | None) -> Any:
    if not all(i in found for i in call.takes):
        raise NotTraced("a curve")
    value = plainly_traced(call.op)(*[found[i] for i in call.takes])
    if ruler is not None and call.reads:
        value = plainly_traced(rounded)(value, ruler)
    taken_apart(value, complexes(call.kind))
    return value


def _fill(part: Part, values: Values, count: int, hand: Hand, threads: int | None) -> None:
    """Fill the values that a part leaves behind, for all trials."""
    loop = part.loop
    ruler = np.array([[hand.ruler or 1.0]])
    entering = {
        k: ruler if (feed := part.feeds[k]) is RULER else feed.of(values)
        for k in (*loop.rows, *loop.still)
    }
    trials = max([array.shape[0] for array in entering.values()], default=1)
    by_trial = sum(1 << k for k, array in entering.items() if array.shape[0] > 1)
    stop = count if any(leaf.varies for leaf in loop.leaves) else WIDTH
    wide = max(stop, WIDTH)
    rows = [_row(entering[k], wide) for k in loop.rows]
    room = Room(len(loop.leaves))
    leaving = [
        room.empty(
            (trials if depends & by_trial else 1, wide if leaf.varies else 1),
            np.complex128 if len(leaf.parts) == 2 else np.float64,
        )
        for leaf, depends in zip(loop.leaves, part.depends, strict=True)
    ]
    still = _still([entering[k] for k in loop.still], trials)
    addresses = _addresses([*rows, *leaving], trials)
    steps = [
        (_at(still) + t * still.strides[0], _at(addresses) + t * addresses.strides[0])
        for t in range(trials)
    ]

    def work(start: int, end: int) -> None:
        for numbers, table in steps:
            part.run(start, end, numbers, table)

    shared(work, wide, WIDTH, threads)
    if wide > count:
        leaving = [
            np.ascontiguousarray(array[:, :count]) if leaf.varies else array
            for leaf, array in zip(loop.leaves, leaving, strict=True)
        ]
    for slot, kind, places in part.results:
        found = [leaving[k] for k in places]
        values[slot] = found[0] if kind is np.ndarray else kind(*found)


def _row(array: NDArray[np.float64], wide: int) -> NDArray[np.float64]:
    """Return numbers in rows of at least so many, as they lie in memory."""
    if array.shape[1] < wide:
        array = np.pad(array, ((0, 0), (0, wide - array.shape[1])), mode="edge")
    return np.ascontiguousarray(array, dtype=np.float64)


def _still(numbers: Sequence[NDArray[np.float64]], trials: int) -> NDArray[np.float64]:
    """Return the numbers that do not vary with the position, (trial, input)."""
    if trials == 1:
        return np.array([[array.item() for array in numbers]])
    whole = np.empty((trials, len(numbers)))
    for k, array in enumerate(numbers):
        whole[:, k] = array[:, 0]
    return whole


def _at(array: NDArray[Any]) -> int:
    """Return the address of an array."""
    found: int = array.__array_interface__["data"][0]
    return found


def _addresses(rows: Sequence[NDArray[Any]], trials: int) -> NDArray[np.int64]:
    """Return the addresses of rows in each trial."""
    first = np.array([[_at(row) for row in rows]], dtype=np.int64)
    if trials == 1:
        return first
    step = np.array([row.strides[0] if row.shape[0] > 1 else 0 for row in rows], dtype=np.int64)
    return np.ascontiguousarray(first + np.arange(trials)[:, None] * step)
