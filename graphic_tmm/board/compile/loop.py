"""The loop of steps, made once: what of them can be noted, what enters it, what it leaves.

Steps are known by what they do, so that a mechanism of other lengths finds the loop of the first. Where the
real numbers of values stand is a `Source`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache, partial
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import Call, Calls
from graphic_tmm.board.compile.llvm import End, Loop, loop_of
from graphic_tmm.board.compile.machine import Run, function_of
from graphic_tmm.board.compile.tape import INPUT, Part, Sign, Tape
from graphic_tmm.board.compile.trace import REFUSED, NotTraced, Value, traced
from graphic_tmm.board.hand import Hand, rounded
from graphic_tmm.board.record import ByIdentity
from graphic_tmm.board.values import Curve, complexes


class Source(NamedTuple):
    """Where real numbers come from: the slot of a value, which of its arrays, "real" or "imag" of it."""

    slot: int
    array: int
    part: str

    def of(self, values: Mapping[int, Any]) -> NDArray[np.float64]:
        """Return the numbers, (trial, position)."""
        value = values[self.slot]
        array = value[self.array] if isinstance(value, tuple) else value
        found: NDArray[np.float64] = getattr(array, self.part) if array.dtype.kind == "c" else array
        return found


RULER = Source(-1, 0, "real")
"""Stands for the division of a ruler, which is no value."""


def sources(slot: int, complexes: Sequence[bool]) -> list[list[Source]]:
    """Return where the numbers of a value come from, by array; ``complexes``: which of these are complex."""
    return [
        [Source(slot, k, part) for part in (("real", "imag") if two else ("real",))]
        for k, two in enumerate(complexes)
    ]


def assembled(kind: type, tape: Tape, parts: Sequence[Sequence[Part]]) -> Any:
    """Return a value on a tape of the parts of its arrays; ``kind``: its type."""
    found = [Value(tape, *each) for each in parts]
    return kind(*found) if issubclass(kind, tuple) else found[0]


def taken_apart(value: Any, complexes: Sequence[bool]) -> list[tuple[Part, ...]]:
    """Return the parts of the arrays of a value on a tape.

    Raises
    ------
    NotTraced
        If it is none, or complex where it should be real.
    """
    found = value if isinstance(value, tuple) else (value,)
    if len(found) != len(complexes) or not all(isinstance(one, Value) for one in found):
        raise NotTraced("no number")
    if any(one.im is not None and not two for one, two in zip(found, complexes, strict=True)):
        raise NotTraced("a complex number")
    return [
        (one.re, one.im) if two else (one.re,) for one, two in zip(found, complexes, strict=True)
    ]


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


class LoopOfSteps(NamedTuple):
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


class Alike:
    """Calls that are known by what they do: their functions and choices, the slots that they take and fill."""

    def __init__(self, calls: Calls) -> None:
        self.calls = calls
        self._does = tuple(_does(call) for call in calls)
        self._hash = hash(self._does)

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Alike) and (self is other or self._does == other._does)


def _does(call: Call) -> tuple[object, ...]:
    op: Any = call.op
    of = (op.func, *op.keywords.items()) if isinstance(op, partial) else (op,)
    return of, call.takes, call.fills, call.kind, call.reads


@lru_cache(maxsize=256)
def _alike(same: ByIdentity[Calls]) -> Alike:
    return Alike(same.it)


@lru_cache(maxsize=256)
def outer(same: ByIdentity[Calls]) -> tuple[int, ...]:
    """Return the slots that calls take and do not fill."""
    fills = {call.fills for call in same.it}
    return tuple(sorted({i for call in same.it for i in call.takes} - fills))


def form(value: Any) -> Form | None:
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


def part_of_loop(
    calls: Calls, values: Mapping[int, Any], hand: Hand, kept: frozenset[int]
) -> LoopOfSteps | None:
    """Return the loop of calls, as long as any can be noted; None where nothing that enters them varies."""
    same = ByIdentity(calls)
    forms = tuple([form(values.get(i)) for i in outer(same)])
    if not any(one is not None and any(one.varies) for one in forms):
        return None
    return _part(_alike(same), forms, hand.ruler is not None, kept)


@lru_cache(maxsize=64)
def _part(
    same: Alike, forms: tuple[Form | None, ...], reads: bool, kept: frozenset[int]
) -> LoopOfSteps:
    """Make the loop of all calls that can be noted and do not wait for one that cannot."""
    tape, feeds = Tape(), list[Source]()
    found: dict[int, Any] = {}
    for slot, form in zip(outer(ByIdentity(same.calls)), forms, strict=True):
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
        ruler = Value(tape, tape.input(moving=False, sign=Sign.POSITIVE))
        feeds.append(RULER)
    taken, others, rest = _sorted(same.calls, found, ruler)
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
    return LoopOfSteps(
        loop,
        function_of(loop.text),
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
    value = traced(call.op)(*[found[i] for i in call.takes])
    if ruler is not None and call.reads:
        value = traced(rounded)(value, ruler)
    taken_apart(value, complexes(call.kind))
    return value
