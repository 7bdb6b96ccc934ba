"""A loop bound to all that is the same at every call: rows enter it then, and one room holds what it leaves.

What can be prepared is: the numbers that do not vary, and for so many positions where everything stands in the
room. A call takes a room, copies the rows into it, and hands out views. Nothing of a call is kept, so threads
may call at once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from ctypes import addressof, c_char
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import Calls
from graphic_tmm.board.compiled import address
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.loop_parts import Part, part_of_loop
from graphic_tmm.board.loop_passes import WIDTH
from graphic_tmm.board.sources import RULER
from graphic_tmm.board.values import Reals, arrays

LAYOUTS = 64
"""Numbers of positions whose layouts are kept."""
_BYTES = 8
_char_of = c_char.from_buffer


def picked(places: Sequence[int]) -> Callable[[Sequence[Any]], tuple[Any, ...]]:
    """Return what picks things at some places; there are fast ways for none, one and several."""
    if len(places) > 1:
        return itemgetter(*places)
    return lambda things: tuple([things[k] for k in places])


class Layout(NamedTuple):
    """Where everything stands in a room for so many positions, each by its first number of the room.

    ``size``: how many numbers it holds; ``entering``: of each row, and ``ends``: of what repeats its last
    number where there are fewer positions than a loop works in step. ``complex``, ``real``: the shape of all
    results of a kind, and their first byte; ``alone``: the type and the first byte of those that do not vary.
    ``frame``: see `Loop`; ``at``: its address.
    """

    size: int
    entering: tuple[slice, ...]
    ends: tuple[slice, ...]
    complex: tuple[tuple[int, int], int]
    real: tuple[tuple[int, int], int]
    alone: tuple[tuple[type, int], ...]
    frame: NDArray[np.int64]
    at: int


class Bound:
    """A loop, the numbers that do not vary, and which of its results are asked for; ``feeds``: what enters."""

    def __init__(
        self, part: Part, values: Mapping[int, Any], hand: Hand, asked: Sequence[int]
    ) -> None:
        loop, feeds = part.loop, part.feeds
        self.feeds = tuple(feeds[k] for k in loop.rows)
        self._part, self._run = part, part.run.call
        still = [None if feeds[k] is RULER else feeds[k].of(values).item() for k in loop.still]
        self._numbers = np.array([hand.ruler or 1.0 if one is None else one for one in still])
        leaves = [(leaf.varies, len(leaf.parts)) for leaf in loop.leaves]
        self._complex = [k for k, leaf in enumerate(leaves) if leaf == (True, 2)]
        self._real = [k for k, leaf in enumerate(leaves) if leaf == (True, 1)]
        self._alone = {k: parts for k, (varies, parts) in enumerate(leaves) if not varies}
        place = {k: n for n, k in enumerate([*self._complex, *self._real, *self._alone])}
        of = {result.slot: place[result.leaves[0]] for result in part.results}
        self._in_order = picked([of[slot] for slot in asked])
        self._layouts: dict[int, Layout] = {}

    def run(self, count: int, rows: Sequence[Reals]) -> tuple[NDArray[Any], ...]:
        """Return what is asked for at ``count`` positions, (position,), in the order in which it was.

        ``rows``: what enters, by ``feeds``.
        """
        here = self._layouts.get(count) or self._laid_out(count)
        room = np.empty(here.size)
        for part, row in zip(here.entering, rows, strict=True):
            room[part] = row
        for part, row in zip(here.ends, rows, strict=False):
            room[part] = row[-1]
        self._run(here.at, addressof(_char_of(room)))  # type: ignore[arg-type]
        complexes = np.ndarray(here.complex[0], np.complex128, room, here.complex[1])
        reals = np.ndarray(here.real[0], np.float64, room, here.real[1])
        if here.ends:
            complexes, reals = complexes[:, :count], reals[:, :count]
        found: list[NDArray[Any]] = [*complexes, *reals]
        for kind, first in here.alone:
            found.append(np.ndarray((count,), kind, room, first, (0,)))
            found[-1].flags.writeable = False
        return self._in_order(found)

    def _laid_out(self, count: int) -> Layout:
        wide, room = max(count, WIDTH), _Measured()
        rows = [room.take(wide) for _ in self.feeds]
        places = {k: room.take(2 * wide) for k in self._complex}
        places |= {k: room.take(wide) for k in self._real}
        places |= {k: room.take(parts) for k, parts in self._alone.items()}
        first = [_BYTES * places[kind[0]] if kind else 0 for kind in (self._complex, self._real)]
        table = [_BYTES * one for one in (*rows, *(places[k] for k in range(len(places))))]
        frame = np.array([0, wide, address(self._numbers), *table], np.int64)
        made = Layout(
            room.size,
            tuple(slice(one, one + count) for one in rows),
            tuple(slice(one + count, one + wide) for one in rows if count < wide),
            ((len(self._complex), wide), first[0]),
            ((len(self._real), wide), first[1]),
            tuple(
                (np.complex128 if parts == 2 else np.float64, _BYTES * places[k])
                for k, parts in self._alone.items()
            ),
            frame,
            address(frame),
        )
        if len(self._layouts) >= LAYOUTS:
            self._layouts = {}
        self._layouts[count] = made
        return made


class _Measured:
    """A room while it is measured."""

    def __init__(self) -> None:
        self.size = 0

    def take(self, numbers: int) -> int:
        """Return where so many more numbers begin."""
        self.size += numbers
        return self.size - numbers


def bound(
    calls: Calls, values: Mapping[int, Any], hand: Hand, asked: Sequence[int]
) -> Bound | None:
    """Return pointwise calls as one loop, bound to the values that do not vary.

    Parameters
    ----------
    calls
        The calls.
    values
        What enters them, by slot; of what varies at some positions, two or more.
    hand
        Who reads; none that slips.
    asked
        The slots that are asked for.

    Returns
    -------
    Bound or None
        None where the calls are no one loop of one trial, or something is asked for that it does not leave as
        one array.
    """
    if any(array.shape[0] > 1 for value in values.values() for array in arrays(value)):
        return None
    part = part_of_loop(calls, values, hand, frozenset(asked))
    if part is None or part.others or part.rest:
        return None
    plain = {result.slot for result in part.results if result.kind is np.ndarray}
    return Bound(part, values, hand, asked) if plain.issuperset(asked) else None
