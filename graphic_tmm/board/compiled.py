"""The log as one loop over positions, compiled by numba: a line a step, each calling its own operation.

A log is a straight-line program. Steps that do not vary with the position run before the loop; those that numba
cannot compile (curves, searches) run by numpy, between two loops.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, lru_cache, partial
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.blocks import Call, Calls, Room, Values, in_blocks, part_of, parted, run
from graphic_tmm.board.hand import Hand, rounded
from graphic_tmm.board.scalars import numba, scalar
from graphic_tmm.board.source import NotCompiled, defaults
from graphic_tmm.board.values import Curve, arrays

STRIP = 256
"""Positions that a compiled loop takes at a time: their numbers stay in the first-level cache."""


class Part(NamedTuple):
    """Calls of one stratum that run together, in a loop or by numpy, and the slots they leave behind."""

    compiled: bool
    calls: Calls
    leaves: frozenset[int]


def in_loops(
    calls: Calls, values: Values, count: int, block: int, hand: Hand, kept: frozenset[int]
) -> None:
    """Run pointwise calls at ``count`` positions as `in_blocks` does, in compiled loops where these exist."""
    still, moving = parted(calls, values)
    run(still, values, hand)
    if not moving:
        return
    sample = {i: part_of(value, slice(0, 2), slice(0, 2)) for i, value in values.items()}
    run(moving, sample, hand)
    for part in _parts(moving, sample, kept):
        if part.compiled:
            _loop(part, values, sample, count, hand)
        else:
            in_blocks(part.calls, values, count, block, hand, part.leaves)


def _parts(calls: Calls, sample: Values, kept: frozenset[int]) -> Iterator[Part]:
    """Yield calls in turns: all that can be compiled and stand ready, then all others that do."""
    waiting = list(calls)
    missing = {call.fills for call in calls}
    compiled = {call.fills: _compiles(call, sample) for call in calls}
    turn = True
    while waiting:
        taken, rest = [], []
        for call in waiting:
            if compiled[call.fills] is turn and missing.isdisjoint(call.takes):
                taken.append(call)
                missing.discard(call.fills)
            else:
                rest.append(call)
        waiting = rest
        later = {i for call in waiting for i in call.takes}
        if taken:
            yield Part(turn, tuple(taken), frozenset({c.fills for c in taken} & (kept | later)))
        turn = not turn


def _compiles(call: Call, sample: Values) -> bool:
    """Whether numba can compile a call for values as those of the sample, to such a result."""
    values = [sample[i] for i in (*call.takes, call.fills)]
    if any(isinstance(value, Curve) for value in values):
        return False
    function, choices = _function(call)
    *types, due = map(_type, values)
    return bool(_result(function, (*types, *map(numba().typeof, choices))) == due)


def _function(call: Call) -> tuple[Callable[..., Any], tuple[int, ...]]:
    """Return the function of an operation and its choices in the order of its arguments."""
    if not isinstance(call.op, partial):
        return call.op, defaults(call.op, {})
    return call.op.func, defaults(call.op.func, call.op.keywords)


def _type(value: Any) -> Any:
    """Return numba's type of one number, or line, or arc, of a value."""
    numbers = [array.flat[0].item() for array in arrays(value)]
    return numba().typeof(type(value)(*numbers) if isinstance(value, tuple) else numbers[0])


@cache
def _result(function: Callable[..., Any], types: tuple[Any, ...]) -> Any:
    """Return the type of what a compiled function returns; None if it cannot be compiled."""
    from numba.core.errors import NumbaError

    try:
        made = scalar(function)
        made.compile(types)
        return made.overloads[types].signature.return_type
    except (NumbaError, NotCompiled):
        return None


def _loop(part: Part, values: Values, sample: Values, count: int, hand: Hand) -> None:
    """Fill the values that a part leaves behind by one compiled loop over trials and positions."""
    fills = {call.fills for call in part.calls}
    takes = sorted({i for call in part.calls for i in call.takes} - fills)
    leaves = sorted(part.leaves)
    text = _Text(hand.ruler is not None)
    for i in takes:
        text.take(i, values[i])
    for call in part.calls:
        text.call(call)
    for i in leaves:
        text.leave(i, sample[i])
    entering = [np.ascontiguousarray(array) for i in takes for array in arrays(values[i])]
    room = Room(sum(len(arrays(sample[i])) for i in leaves))
    trials = max((array.shape[0] for array in entering), default=1)
    for i in leaves:
        found = [
            room.empty((trials if a.shape[0] > 1 else 1, count if a.shape[1] > 1 else 1), a.dtype)
            for a in arrays(sample[i])
        ]
        values[i] = type(sample[i])(*found) if isinstance(sample[i], tuple) else found[0]
    leaving = [array for i in leaves for array in arrays(values[i])]
    run = _compile(text.whole(), tuple(text.functions))
    run(trials, count, hand.ruler or 1.0, *entering, *leaving)


class _Text:
    """The text of a loop while it is being written, and the functions f0, f1 ... that it calls.

    The numbers of some positions at a time enter and leave through ``table``, whose rows lie at constant
    distances: a compiler sees that no result falls upon another, and runs several positions in step.
    """

    def __init__(self, reads: bool) -> None:
        self.reads = reads
        self.functions: dict[Callable[..., Any], str] = {}
        self.arguments: list[str] = []
        self.before: list[str] = []
        self.enter: list[str] = []
        self.steps: list[str] = []
        self.exit: list[str] = []
        self.rows = 0

    def named(self, function: Callable[..., Any]) -> str:
        """Return the name of a function in the text."""
        return self.functions.setdefault(function, f"f{len(self.functions)}")

    def place(self) -> str:
        """Return a new row of the table, at the position ``i``."""
        self.rows += 1
        return f"table[{(self.rows - 1) * STRIP} + i]"

    def argument(self, name: str) -> None:
        """Write a row of an array, that of the trial, as an argument."""
        self.arguments.append(f"_{name}")
        self.before.append(f"{name} = _{name}[t % _{name}.shape[0]]")

    def take(self, slot: int, value: Any) -> None:
        """Write that a value enters."""
        parts = []
        for k, array in enumerate(arrays(value)):
            name = f"a{slot}_{k}"
            self.argument(name)
            if array.shape[1] == 1:
                self.before.append(f"{name}c = {name}[0]")
                parts.append(f"{name}c")
            elif np.iscomplexobj(array):
                x, y = self.place(), self.place()
                self.enter += [f"{x} = {name}[at + i].real", f"{y} = {name}[at + i].imag"]
                parts.append(f"complex({x}, {y})")
            else:
                x = self.place()
                self.enter.append(f"{x} = {name}[at + i]")
                parts.append(x)
        whole = f"{self.named(type(value))}({', '.join(parts)})"
        self.steps.append(f"v{slot} = {whole if isinstance(value, tuple) else parts[0]}")

    def call(self, call: Call) -> None:
        """Write a step."""
        function, choices = _function(call)
        taken = ", ".join([*(f"v{i}" for i in call.takes), *map(repr, choices)])
        line = f"{self.named(function)}({taken})"
        if self.reads and call.reads:
            line = f"{self.named(rounded)}({line}, ruler)"
        self.steps.append(f"v{call.fills} = {line}")

    def leave(self, slot: int, value: Any) -> None:
        """Write that a value, shaped as this one, is left behind."""
        for k, array in enumerate(arrays(value)):
            name = f"o{slot}_{k}"
            self.argument(name)
            field = f"v{slot}[{k}]" if isinstance(value, tuple) else f"v{slot}"
            at = f"{name}[at + i]" if array.shape[1] > 1 else f"{name}[0]"
            if np.iscomplexobj(array):
                x, y = self.place(), self.place()
                self.steps += [f"{x} = {field}.real", f"{y} = {field}.imag"]
                self.exit.append(f"{at} = complex({x}, {y})")
            else:
                x = self.place()
                self.steps.append(f"{x} = {field}")
                self.exit.append(f"{at} = {x}")

    def whole(self) -> str:
        """Return the text."""
        lines = [f"def loop(trials, count, ruler, {', '.join(self.arguments)}):"]
        lines.append(f"  table = empty({self.rows * STRIP})")
        lines.append("  for t in range(trials):")
        lines += [f"    {line}" for line in self.before]
        lines.append(f"    for at in range(0, count, {STRIP}):")
        lines.append(f"      strip = min({STRIP}, count - at)")
        for line in (*self.enter, None, *self.exit):
            lines.append("      for i in range(strip):")
            lines += [f"        {one}" for one in (self.steps if line is None else [line])]
        return "\n".join(lines) + "\n"


@lru_cache(maxsize=64)
def _compile(source: str, functions: tuple[Callable[..., Any], ...]) -> Callable[..., None]:
    space: dict[str, Any] = {
        f"f{k}": function if isinstance(function, type) else scalar(function)
        for k, function in enumerate(functions)
    }
    space["empty"] = np.empty
    exec(source, space)
    return numba().njit(error_model="numpy")(space["loop"])  # type: ignore[no-any-return]
