"""A slice of a log prepared to run at any angles: constants are computed once; readings in SI."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.compile.run import LAYOUTS, LEAST, Bound, bound, picked
from graphic_tmm.board.execute import Program, execute, prepare
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Construction, Mark, Step, again
from graphic_tmm.board.values import Complexes, Kind, Length, Number, Point, Reals, Vector
from graphic_tmm.board.values import given as as_value
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import ConstructionError
from graphic_tmm.language.said import said
from graphic_tmm.readers.any_angles.turn import VECTORS, Key, Quantity, TurnQuantity

VIEW = "SI"


def _times(spot: Complexes, mu: Reals) -> Complexes:
    return spot * mu


def _placed(spot: Complexes, mu: Reals, origin: Complexes) -> Complexes:
    return spot * mu + origin


def _vector(start: Complexes, end: Complexes, mu: Reals) -> Complexes:
    return (end - start) * mu


def _long(length: Reals, mu: Reals) -> Reals:
    return length * mu


KINDS: Mapping[str, Kind] = {"mu": Number, "length": Length}


def _reading(run: Any, *arguments: str, leaves: Kind = Vector) -> Operation:
    kinds = tuple(KINDS.get(name, Point) for name in arguments)
    # no pencil pricks it, and nothing is calculated with few digits
    return Operation(run.__name__, run, kinds, arguments, leaves, (), "")


READINGS = (
    _reading(_times, "spot", "mu"),
    _reading(_placed, "spot", "mu", "origin"),
    _reading(_vector, "start", "end", "mu"),
    _reading(_long, "length", "mu", leaves=Number),
)
"""Of a vector from the pole, of a place from the origin, of a vector from elsewhere, of a length read.

None is of the board.
"""


def in_si(
    log: Construction, rows: Iterable[TurnQuantity], given: Mapping[Mark, object]
) -> tuple[Construction, dict[TurnQuantity, Mark], dict[Mark, complex]]:
    """Return the log that ends in SI, where it has each quantity, and what more is given in it.

    At a scale of 1 SI unit per millimetre a mark is in SI already; a mark of several links stands once.
    """
    times, placed, vector, long = READINGS
    steps, begun = list(log.steps), list(log.given)
    made: dict[tuple[Any, ...], Mark] = {}
    origins: dict[Mark, complex] = {}
    found: dict[TurnQuantity, Mark] = {}
    size = log.size

    def mark(letter: str, kind: Kind) -> Mark:
        nonlocal size
        size += 1
        return Mark(size - 1, letter, kind, VIEW)

    for row in rows:
        drawn = row.mark
        if row.scale is None or (
            row.start is None and row.origin == 0 and bool(np.all(given.get(row.scale) == 1.0))
        ):
            found[row] = drawn
            continue
        key = (drawn.slot, row.start, row.scale, row.origin)
        if key not in made:
            op = times
            uses: tuple[Mark, ...] = (drawn, row.scale)
            if row.start is not None:
                op, uses = vector, (row.start, drawn, row.scale)
            elif row.origin != 0:
                origin = mark("O", Point)
                origins[origin] = row.origin
                begun.append(origin)
                op, uses = placed, (drawn, row.scale, origin)
            elif drawn.kind is Length:
                op = long
            made[key] = mark(drawn.letter, op.leaves)
            steps.append(Step(op, made[key], uses, {}, ""))
        found[row] = made[key]
    return log._replace(given=tuple(begun), steps=tuple(steps), size=size), found, origins


QUANTITIES: tuple[Quantity, ...] = get_args(Quantity)
Known = Callable[[Reals], Mapping[Mark, Any]]
"""What is given at angles (1, angle), and nowhere else."""
Arrays = Sequence[NDArray[Any]]
Table = tuple[tuple[Key, ...], tuple[int, ...]]
"""The owners of a quantity (points, links, columns), each with the number of its array."""


@dataclass(frozen=True, eq=False)
class Ready:
    """A slice of a log, its constants, and where its quantities are in the output.

    ``values``: by slot, values that are the same at all angles. ``entering``: the given marks that vary, and
    ``plain``: whether each is the direction of the crank itself. ``moving``: the outputs: the slot of each, and
    of the number without which it is unknown (−1: none). ``fixed``: the bytes and the type of outputs that are
    one number at all angles. ``tables``: by quantity; arrays are numbered, the moving ones first.
    """

    program: Program
    hand: Hand
    values: Mapping[int, Any]
    entering: tuple[Mark, ...]
    plain: bool
    moving: tuple[tuple[int, int], ...]
    fixed: tuple[tuple[bytes, type], ...]
    tables: tuple[Table, ...]

    def results(
        self, angles: Reals, known: Known, *, fast: bool, threads: int | None
    ) -> list[dict[Any, NDArray[Any]]]:
        """Return the quantities at angles, arrays (angle,)."""
        count = angles.size
        at = angles if count else np.full(1, np.nan)
        arrays = self._known(self._arrays(at, known, fast=fast, threads=threads))
        if not count:
            arrays = [array[:0] for array in arrays]
        whole = (*arrays, *(self._standing.get(count) or self._stands(count)))
        return [
            dict(zip(keys, pick(whole), strict=True)) if keys else {} for keys, pick in self._tables
        ]

    def _arrays(self, at: Reals, known: Known, *, fast: bool, threads: int | None) -> Arrays:
        """Return what the program leaves behind, (angle,)."""
        count = at.size
        loop = self._loop if fast and count < LEAST else None
        if loop is not None and self.plain:
            return loop.run(count, [at] * len(loop.feeds))
        row = at[None, :]
        given = dict.fromkeys(self.entering, row) if self.plain else _quietly(known, row)
        entering = {mark.slot: as_value(given[mark], mark.kind) for mark in self.entering}
        if loop is not None:
            return loop.run(count, [feed.of(entering)[0] for feed in loop.feeds])
        values = {**self.values, **entering}
        reading = self.program.go_on(values, count, hand=self.hand, fast=fast, threads=threads)
        found = [reading.values[slot][0] for slot in self._slots]
        # a mark of a hand that slips may be the same at all of them
        return [np.broadcast_to(one, at.shape) if one.size != count else one for one in found]

    def _known(self, found: Arrays) -> Arrays:
        """Return the quantities from the outputs, NaN where the number that they need is NaN."""
        if not self._unknown:
            return found
        told = list(found[: len(self.moving)])
        for k, by in self._unknown:
            told[k] = np.where(np.isnan(found[by]), np.nan, told[k])
        return told

    def _stands(self, count: int) -> Arrays:
        """Return a constant as an array (angle,) that takes no memory and cannot be written to."""
        found = tuple(np.ndarray((count,), kind, value, 0, (0,)) for value, kind in self.fixed)
        if len(self._standing) >= LAYOUTS:
            self._standing.clear()
        self._standing[count] = found
        return found

    @cached_property
    def _standing(self) -> dict[int, Arrays]:
        return {}

    @cached_property
    def _tables(self) -> list[tuple[tuple[Key, ...], Any]]:
        return [(keys, picked(numbers)) for keys, numbers in self.tables]

    @cached_property
    def _slots(self) -> tuple[int, ...]:
        """The slots to compute: of moving outputs, then of the numbers without which they are unknown."""
        return (*(slot for slot, _ in self.moving), *(by for _, by in self.moving if by >= 0))

    @cached_property
    def _unknown(self) -> tuple[tuple[int, int], ...]:
        """The outputs that are unknown where another array is NaN."""
        some = [k for k, (_, by) in enumerate(self.moving) if by >= 0]
        return tuple((k, len(self.moving) + n) for n, k in enumerate(some))

    @cached_property
    def _loop(self) -> Bound | None:
        """All of it as one loop; None where it is none."""
        if self.hand.slips or self.hand.digits is not None or len(self.program.strata) > 1:
            return None
        two = {mark.slot: as_value(np.zeros((1, 2)), mark.kind) for mark in self.entering}
        (calls, _), *_ = self.program.strata
        return bound(calls, {**self.values, **two}, self.hand, self._slots)


def _quietly(known: Known, row: Reals) -> Mapping[Mark, Any]:
    with np.errstate(all="ignore"):
        return known(row)


def made_ready(
    sheet: Drawn, still: Mapping[Mark, Any], known: Known, rows: Sequence[TurnQuantity]
) -> Ready:
    """Return the slice of a log that gives some rows.

    Parameters
    ----------
    sheet
        The drawing at the positions of its scene.
    still
        Values given, or drawn across the positions, that are the same at all angles.
    known
        Those that vary.
    rows
        The wanted quantities.
    """
    probe = np.zeros((1, 1))
    varying = known(probe)
    whole, marks, origins = in_si(sheet.construction, rows, sheet.given)
    still = {**still, **origins}
    log = again(whole, {**still, **varying})
    needed = {row.known for row in rows if row.known is not None}
    if not sheet.hand.slips:
        log, still = _folded(log, still, {*marks.values(), *needed}, sheet.hand)
    there = {*log.given, *(step.it for step in log.steps)}
    moving: dict[tuple[int, int], int] = {}
    fixed: dict[tuple[bytes, type], int] = {}
    places: dict[Quantity, dict[Key, Any]] = {quantity: {} for quantity in QUANTITIES}
    for row in rows:
        mark = marks[row]
        one: Any
        if mark in still:
            kind = np.complex128 if row.quantity in VECTORS else np.float64
            one = np.ravel(np.asarray(still[mark], dtype=kind))[:1].tobytes(), kind
            fixed.setdefault(one, len(fixed))
        elif mark in there:
            one = (mark.slot, -1 if row.known is None else row.known.slot)
            moving.setdefault(one, len(moving))
        else:
            raise ConstructionError(
                said(
                    "motion: {name} hangs on the positions of the sheet, and is known at no other angle",
                    name=str(row.key),
                )
            )
        places[row.quantity][row.key] = one
    number: dict[Any, int] = {**moving, **{one: len(moving) + k for one, k in fixed.items()}}
    left = {mark for mark in marks.values() if mark not in still}
    program = prepare(log, left | needed)
    entering = tuple(mark for mark in program.given if mark not in still)
    return Ready(
        program,
        sheet.hand,
        program._replace(given=tuple(m for m in program.given if m in still)).begun(still),
        entering,
        all(varying[mark] is probe for mark in entering),
        tuple(moving),
        tuple(fixed),
        tuple((tuple(one), tuple(number[at] for at in one.values())) for one in places.values()),
    )


def _folded(
    log: Construction, still: Mapping[Mark, Any], wanted: set[Mark], hand: Hand
) -> tuple[Construction, dict[Mark, Any]]:
    """Return the log without what is the same at all angles, and that, with axes (trial, position)."""
    constant, first, rest = set(still), [], []
    for step in log.steps:
        if constant.issuperset(step.uses):
            constant.add(step.it)
            first.append(step)
        else:
            rest.append(step)
    used = {mark for step in rest for mark in step.uses} | wanted
    left = tuple(mark for mark in used if mark in constant)
    found = execute(log._replace(given=tuple(still), steps=tuple(first)), still, left, hand=hand)
    values = {mark: found[mark] for mark in left}
    varying = tuple(mark for mark in log.given if mark not in still)
    return log._replace(given=(*left, *varying), steps=tuple(rest)), values
