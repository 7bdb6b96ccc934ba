"""The log becomes numbers: a backward slice of it, in blocks of positions, for all trials at once.

Pointwise steps run in blocks of positions, so that a million of them stay in cache and in memory; a step
that works across positions (a French curve) runs on whole arrays, between two strata of pointwise steps.
Whether steps are compiled depends on what is asked for and on nothing that went before: the same scene gives
the same bytes. The few positions of sheets never are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache, partial
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graphic_tmm.board.blocks import Calls, Values, in_blocks, part_of, ready, spread, stored
from graphic_tmm.board.hand import EXACT, Hand, Slipping, Streams, trials_in_block
from graphic_tmm.board.record import ByIdentity, Construction, Mark, Step
from graphic_tmm.board.values import Curve, at, blank
from graphic_tmm.board.values import given as as_value
from graphic_tmm.board.values import places as positions_of
from graphic_tmm.errors import ConstructionError

if TYPE_CHECKING:
    from graphic_tmm.board.doubt import Doubts

InParts = Callable[..., None]
"""What runs pointwise steps: `in_blocks`, or another that is called as it is."""
BLOCK = 16384
"""Positions in one block: what numpy's calls cost is little against it, and the arrays in use stay in cache."""
PAYS = 20_000_000
"""Steps times positions that take numpy as long as it takes to load the translator and to compile."""


@dataclass(frozen=True)
class Reading:
    """The numbers of the marks asked for, by mark; ``positions`` is the length of the position axis.

    ``doubts``: how far rounding moves them; None where nobody asked. ``places``: where the positions stand
    among those that are doubted; None for all of them.
    """

    values: Mapping[int, Any]
    positions: int
    doubts: Doubts | None = None
    places: tuple[int, ...] | None = None

    def __getitem__(self, mark: Mark) -> Any:
        """Return the value of ``mark``, axes (trial, position), size 1 where it does not vary."""
        return self.values[mark.slot]

    def figure(self, mark: Mark, by: Mark | None = None) -> Any:
        """Return the value of ``mark``, times a scale factor, as a figure that may be told; see `doubt`."""
        times = 1.0 if by is None else self[by]
        if self.doubts is None:
            return self[mark] * times
        key = mark.slot, by.slot if by is not None else None
        found = self._figures.get(key)
        if found is None:
            found = self.doubts.figure(mark, self[mark], times, self.places)
            if found.shape[0] == 1:  # of many drawings each is told once
                self._figures[key] = found
        return found

    @cached_property
    def kept(self) -> dict[Any, Any]:
        """What readers keep of these numbers, each by a key of its own."""
        return {}

    @cached_property
    def _figures(self) -> dict[tuple[int, int | None], Any]:
        return {}

    def doubted(self, doubts: Doubts, places: tuple[int, ...] | None = None) -> Reading:
        """Return the same numbers beside how far rounding moves them."""
        return replace(self, doubts=doubts, places=places)

    def without(self, lost: Mapping[int, Any], places: tuple[int, ...] | None = None) -> Reading:
        """Return the same numbers, NaN where a mark is lost; ``lost``: by slot, (1, position)."""
        gone = {slot: mask for slot, mask in lost.items() if slot in self.values}
        if not gone:
            return self
        values = dict(self.values)
        for slot, mask in gone.items():
            values[slot] = blank(values[slot], at(mask, places))
        return replace(self, values=values)

    def only(self, marks: Iterable[Mark]) -> Reading:
        """Return the numbers of some marks, of those that are there."""
        values = self.values
        slots = sorted({mark.slot for mark in marks} & values.keys())
        return replace(self, values={slot: values[slot] for slot in slots})

    def cut(self, places: Sequence[int]) -> Reading:
        """Return the numbers at some positions (indices)."""
        values = {slot: cut(value, places) for slot, value in self.values.items()}
        return replace(self, values=values, positions=len(places))

    def trial(self, k: int) -> Reading:
        """Return the numbers of one trial."""
        return replace(self, values=_Trial(self.values, k))

    def __contains__(self, mark: object) -> bool:
        """Whether the value of ``mark`` was asked for."""
        return isinstance(mark, Mark) and mark.slot in self.values


def cut(value: Any, places: Sequence[int]) -> Any:
    """Return a value at some positions; a curve is whole."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*(cut(array, places) for array in value))
    return value if value.shape[1] == 1 else value[:, list(places)]


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


class Program(NamedTuple):
    """A slice of a log made ready to run: strata of pointwise steps, each ended by steps across positions."""

    strata: tuple[tuple[Calls, Calls], ...]
    wanted: frozenset[int]
    given: tuple[Mark, ...]
    fast: bool | None = None

    def compiled(self) -> Program:
        """Return the same program, whose pointwise steps run in compiled loops at any number of positions.

        The numbers are the same to rounding. Hands that slip, or keep few digits, run as ever.

        Raises
        ------
        ConstructionError
            If llvmlite is not installed.
        """
        from graphic_tmm.board.compile.machine import machine

        machine()
        return self._replace(fast=True)

    def run(
        self,
        given: Mapping[Mark, object],
        *,
        hand: Hand = EXACT,
        block: int = BLOCK,
        places: Any = None,
        whole: int | None = None,
        fast: bool | None = None,
        threads: int | None = None,
    ) -> Reading:
        """Run at all positions of ``given``; see `execute`.

        ``places``: where these stand among the ``whole`` positions, for the random streams of a hand.
        ``fast``: None for what the program says.

        Raises
        ------
        ConstructionError
            If a value is missing, or ``fast`` is asked for without llvmlite.
        """
        values = self.begun(given)
        count = max(map(positions_of, values.values()), default=1)
        return self.go_on(
            values,
            count,
            hand=hand,
            block=block,
            places=places,
            whole=whole,
            fast=fast,
            threads=threads,
        )

    def begun(self, given: Mapping[Mark, object]) -> Values:
        """Return what is given as values, by slot.

        Raises
        ------
        ConstructionError
            If a value is missing.
        """
        values: Values = {}
        for mark in self.given:
            value = given.get(mark)
            if value is None:
                raise ConstructionError(f"{mark.view}: '{mark.letter}' was not given")
            values[mark.slot] = as_value(value, mark.kind)
        return values

    def go_on(
        self,
        values: Values,
        count: int,
        *,
        hand: Hand = EXACT,
        block: int = BLOCK,
        places: Any = None,
        whole: int | None = None,
        fast: bool | None = None,
        threads: int | None = None,
    ) -> Reading:
        """Run at ``count`` positions from values, as `run` does; what is found joins them."""
        if not hand.slips and hand.digits is None:
            in_parts = self._in_parts(count, self.fast if fast is None else fast, threads)
            self._run(values, count, block, hand, None, in_parts)
            return Reading({i: v for i, v in values.items() if i in self.wanted}, count)
        streams, found = Streams(hand), Values()
        whole = whole or count
        most = trials_in_block(whole)
        for start in range(0, hand.trials, most):
            trials = min(most, hand.trials - start)
            number = (hand.first + start) // most
            slipping = Slipping(hand, streams, number, trials, whole, places)
            local = dict(values)
            self._run(local, count, block, hand, slipping, in_blocks)
            part = slice(start, start + trials)
            for i in self.wanted & local.keys():
                found[i] = stored(found.get(i), local[i], part, hand.trials)
        return Reading(found, count)

    def _in_parts(self, count: int, fast: bool | None, threads: int | None) -> InParts:
        """Return what runs pointwise steps."""
        if not compiles(fast, sum(len(pointwise) for pointwise, _ in self.strata), count):
            return in_blocks
        from graphic_tmm.board.compile.run import in_loops

        return partial(in_loops, threads=threads)

    def _run(
        self,
        values: Values,
        count: int,
        block: int,
        hand: Hand,
        slipping: Slipping | None,
        in_parts: InParts,
    ) -> None:
        slips = {} if slipping is None else {"slipping": slipping}
        with np.errstate(all="ignore"):
            for pointwise, across in self.strata:
                in_parts(pointwise, values, count, block, hand, self._kept(pointwise), **slips)
                for call in across:
                    value = call.op(*[spread(values[i], count) for i in call.takes])
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
    slots = range(construction.size) if wanted is None else (mark.slot for mark in wanted)
    return _prepared(ByIdentity(construction), frozenset(slots))


@lru_cache(maxsize=64)
def _prepared(log: ByIdentity[Construction], asked: frozenset[int]) -> Program:
    construction = log.it
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
        strata.append((tuple(map(ready, pointwise)), tuple(map(ready, across))))
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
    fast: bool | None = None,
    threads: int | None = None,
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
    fast
        Whether the steps are compiled, see `Program.compiled`; None where that pays, see `compiles`.
    threads
        How many threads compiled steps take at the most; None for all cores where that pays. The numbers are
        the same for any.

    Raises
    ------
    ConstructionError
        If a value is missing, a curve across positions is asked for at some positions only, or ``fast`` is
        asked for without llvmlite.
    """
    program = prepare(construction, wanted)
    if positions is None:
        return program.run(given, hand=hand, block=block, fast=fast, threads=threads)
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
    found = program.run(
        cut, hand=hand, block=block, places=at, whole=whole, fast=fast, threads=threads
    )
    if not alone:
        return found
    return Reading({i: part_of(value, slice(0, 1)) for i, value in found.values.items()}, 1)


def compiles(fast: bool | None, steps: int, count: int) -> bool:
    """Return whether so many steps are compiled to run at so many positions.

    ``fast``: what is asked for; None: where it pays and the translator is there.
    """
    return steps * count >= PAYS and translator() if fast is None else fast


@cache
def translator() -> bool:
    """Whether that is installed which logs are compiled with."""
    return find_spec("llvmlite") is not None
