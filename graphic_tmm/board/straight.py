"""The log as one straight line of passes over real arrays, written from the operations' own functions.

The steps that vary with the position are noted on a `tape`; their passes become a function (`passage`) that
works on slots of a small arena, which stays in cache. The numbers are those of the steps run one by one, to
rounding.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.blocks import Calls, Values, part_of, parted, run
from graphic_tmm.board.hand import Hand, rounded
from graphic_tmm.board.passage import Passage, passage
from graphic_tmm.board.room import Room
from graphic_tmm.board.signs import Sign
from graphic_tmm.board.sources import RULER, Source, assembled, sources, taken_apart
from graphic_tmm.board.tape import Part, Tape
from graphic_tmm.board.traced import REFUSED, traced
from graphic_tmm.board.unknown import NotTraced, Value
from graphic_tmm.board.values import Curve, arrays

LINE = 8
"""Numbers in a line of the cache."""


class _Same:
    """Calls that are known by being these ones; what they are made ready by is no part of that."""

    def __init__(self, calls: Calls, still: Calls, moving: Calls, values: Values) -> None:
        self.calls, self.moving, self.values = calls, moving, values
        self._known = (id(calls), *(call.fills for call in still))

    def __hash__(self) -> int:
        return hash(self._known)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Same) and self._known == other._known


class Row(NamedTuple):
    """An array that is left behind: its type, which rows are its parts, or which single numbers."""

    complex: bool
    moving: bool
    parts: tuple[int, ...]


class Straight(NamedTuple):
    """Calls ready to run as one line: the line, where its numbers come from and where they go to.

    ``left``: a slot, the type of its value and its arrays; ``asked``: how many rows or numbers these are.
    """

    line: Passage
    inputs: tuple[Source, ...]
    left: tuple[tuple[int, Any, tuple[Row, ...]], ...]
    asked: int


def in_line(
    calls: Calls, values: Values, count: int, block: int, hand: Hand, kept: frozenset[int]
) -> bool:
    """Run pointwise calls at ``count`` positions as `in_blocks` does, if they can be written as a line.

    Leaves everything as it was and returns False where they cannot: where there are several trials, or an
    operation does what no pass over real numbers does.
    """
    if any(array.shape[0] > 1 for value in values.values() for array in arrays(value)):
        return False
    still, moving = parted(calls, values)
    local = dict(values)
    run(still, local, hand)
    same = _Same(calls, still, moving, local)
    made = _made(same, _plain(moving, local), kept, hand.ruler is not None)
    same.values = {}
    if made is None:
        return False
    _fill(made, local, count, hand, min(block, count))
    values.update(local)
    return True


Plain = tuple[tuple[Source, float], ...]
"""Numbers that do not vary and are 0, 1 or −1, as directions and sides are: with these a pass is spared."""


def _plain(moving: Calls, values: Values) -> Plain:
    """Return the plain numbers that enter calls."""
    found = []
    for slot in sorted({i for call in moving for i in call.takes} & values.keys()):
        for source in chain(*_sources(slot, values[slot])):
            number = _entering(values, source)
            if np.ndim(number) == 0 and number in (0.0, 1.0, -1.0):
                found.append((source, float(number)))
    return tuple(found)


def _sources(slot: int, value: Any) -> list[list[Source]]:
    """Return where the real numbers of a value come from, by array."""
    if isinstance(value, Curve):
        return []
    return sources(slot, [np.iscomplexobj(array) for array in arrays(value)])


@lru_cache(maxsize=64)
def _made(same: _Same, plain: Plain, kept: frozenset[int], reads: bool) -> Straight | None:
    sample = {i: part_of(value, slice(0, 2)) for i, value in same.values.items()}
    run(same.moving, sample, Hand())
    try:
        return _traced(same.moving, sample, dict(plain), kept, reads)
    except REFUSED:
        return None


def _traced(
    moving: Calls, sample: Values, plain: dict[Source, float], kept: frozenset[int], reads: bool
) -> Straight:
    tape, inputs = Tape(), [RULER]
    ruler = Value(tape, tape.input(moving=False, sign=Sign.POSITIVE))
    known: Values = {}
    for call in moving:
        for i in call.takes:
            if i not in known:
                known[i] = _unknown(tape, inputs, plain, i, sample[i])
        found = traced(call.op)(*(known[i] for i in call.takes))
        known[call.fills] = traced(rounded)(found, ruler) if reads and call.reads else found
    asked: list[Part] = []
    left = []
    for call in moving:
        if call.fills in kept:
            rows = tuple(_rows(asked, known[call.fills], sample[call.fills]))
            left.append((call.fills, type(sample[call.fills]), rows))
    apart = [row.complex for _, _, rows in left for row in rows for _ in row.parts]
    return Straight(passage(tape, asked, apart), tuple(inputs), tuple(left), len(asked))


def _unknown(
    tape: Tape, inputs: list[Source], plain: dict[Source, float], slot: int, value: Any
) -> Any:
    """Return a value of which only the plain numbers are known; where the others come from joins ``inputs``."""
    if isinstance(value, Curve):
        raise NotTraced("a curve")
    parts: list[list[Part]] = []
    for array, each in zip(arrays(value), _sources(slot, value), strict=True):
        parts.append([])
        for source in each:
            part: Part = plain.get(source)
            if part is None:
                inputs.append(source)
                part = tape.input(array.shape[1] > 1)
            parts[-1].append(part)
    return assembled(type(value), tape, parts)


def _rows(asked: list[Part], value: Any, sample: Any) -> Iterator[Row]:
    """Yield the arrays of a value that is asked for; its parts join those that are."""
    complexes = [np.iscomplexobj(array) for array in arrays(sample)]
    for parts, array in zip(taken_apart(value, complexes), arrays(sample), strict=True):
        places = tuple(range(len(asked), len(asked) + len(parts)))
        yield Row(np.iscomplexobj(array), array.shape[1] > 1, places)
        asked.extend(parts)


def _fill(made: Straight, values: Values, count: int, hand: Hand, block: int) -> None:
    """Run a line and leave its values behind."""
    line = made.line
    ruler = np.float64(hand.ruler or 1.0)
    sources = [made.inputs[n] for n in line.entering]
    entering = [ruler if one is RULER else _entering(values, one) for one in sources]
    room = Room(sum(row.moving for _, _, rows in made.left for row in rows))
    parts: list[Any] = [None] * made.asked
    for slot, kind, rows in made.left:
        found = []
        for row in rows:
            dtype = np.complex128 if row.complex else np.float64
            array = room.empty((1, count if row.moving else 1), dtype)
            found.append(array)
            halves = (array.real, array.imag) if row.complex else (array,)
            for k, half in zip(row.parts, halves, strict=True):
                parts[k] = half[0]
        values[slot] = kind(*found) if issubclass(kind, tuple) else found[0]
    arena, masks = _arena(line.slots, block), np.empty((line.masks, block), np.bool_)
    single = iter(line.run(count, block, arena, masks, *entering, *(parts[k] for k in line.rows)))
    for k, part in enumerate(parts):
        if k not in line.rows:
            part[:] = next(single)


def _arena(slots: int, block: int) -> Any:
    """Return rows of numbers, each at the beginning of a line of the cache."""
    wide = -(-block // LINE) * LINE
    room = np.empty(slots * wide + LINE)
    first = -(room.ctypes.data // room.itemsize) % LINE
    return room[first : first + slots * wide].reshape(slots, wide)


def _entering(values: Values, source: Source) -> Any:
    """Return a row of real numbers, or the only number of it."""
    row = source.of(values)[0]
    return row if row.size > 1 else row[0]
