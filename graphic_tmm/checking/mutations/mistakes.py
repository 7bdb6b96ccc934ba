"""The mistakes that a scene offers: givens taken amiss, mutations of its boards; executed once for all."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board import roles
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.checking.cells import Key, figures, spots
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.mutations.calculated import BY_UNIT, POWERS_OF_TEN
from graphic_tmm.checking.mutations.execution import (
    AssumedLog,
    Executed,
    Sparse,
    executed,
    figures_of,
)
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mutation import (
    CRANK,
    EXCHANGED,
    FACTOR,
    GIVEN,
    LEFT_OUT,
    MEETING,
    SENSE,
    WRONG_END,
    Amiss,
    Mutation,
    measured_last,
)
from graphic_tmm.checking.mutations.words import (
    ANOTHER_PLACE,
    COUNTED,
    DIVIDED,
    EXCHANGED_WITH,
    GIVEN_TIMES,
    NO_GIVEN,
    OPPOSITE_GIVEN,
    OTHER_END,
    OTHER_WAY,
    STANDS,
)
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.readers.columns import Readings

Given = Mapping[Mark, object]
PARTS = (6, 8, 10, 12, 16, 24)
"""Into so many parts circles are divided."""
DIGITS = 6
"""What has so many digits nobody has written down."""
LOADS = ("N", "N·m")
"""Units of what may be left out altogether."""
SENSED = ("1/s", "1/s²", *LOADS)
"""Units of what has a sense; a length has one only where it is a coordinate, and below zero."""


def mistaken(log: Construction, given: Given) -> Iterator[Mutation]:
    """Yield what becomes of a log if what is given is taken amiss; what is free is in `free`."""
    for marks in _named(log, given).values():
        yield from _of(marks, given[marks[0]])
    yield from _exchanged(log, given)


def free(log: Construction, given: Given) -> tuple[tuple[Mark, ...], ...]:
    """Return what may have been misread: lengths, masses, speeds, none of them 0; not scale factors.

    Each as the marks that stand for it in the plans where it is calculated with.
    """
    return tuple(
        tuple(marks)
        for marks in _named(log, given).values()
        if marks[0].role != roles.ROW and np.all(np.asarray(given[marks[0]]) != 0.0)
    )


def _named(log: Construction, given: Given) -> dict[tuple[str, str], list[Mark]]:
    """Return the marks of quantities that are given, by letter and unit; the angles of the crank, too."""
    found: dict[tuple[str, str], list[Mark]] = {}
    for mark in log.given:
        angle = mark.role == roles.ROW
        size = mark.kind in (Number, Length) and bool(mark.unit) and not mark.unit.endswith("/mm")
        size = size or (mark.kind is Angle and bool(mark.name))
        if mark in given and (angle or (size and _single(given[mark]))):
            found.setdefault((mark.name, mark.unit), []).append(mark)
    return found


def _from_other_end(
    one: Sequence[Mark], other: Sequence[Mark], first: float, second: float
) -> Iterator[Mutation]:
    """Yield the shorter of two lengths of a link as if it were counted from the other end of the longer."""
    short, long = (one, other) if abs(first) < abs(second) else (other, one)
    begins = (re.match(r"l_\{?(\D)", marks[0].name) for marks in (short, long))
    letters = [found[1] if found else "" for found in begins]
    if letters[0] and letters[0] == letters[1]:
        whole = max(first, second, key=abs)
        yield _all(WRONG_END, OTHER_END, short, -1.0, whole, now=long[0])


def _single(value: object) -> bool:
    return not isinstance(value, tuple) and np.size(np.asarray(value)) == 1


def misread(marks: Sequence[Mark], factor: float) -> Mutation:
    """Return the mutation of a given that was taken so many times as large."""
    return _all(GIVEN, GIVEN_TIMES, marks, factor, times=factor, usual=2.0)


def amiss_by(marks: Sequence[Mark], angles: float | NDArray[np.float64]) -> Mutation:
    """Return the mutation of a crank that stands amiss by angles, degrees (position,) or one for all."""
    plus = angles if isinstance(angles, float) else angles[None]
    amiss = {mark.slot: Amiss(mark, 1.0, plus) for mark in marks}
    times = float(np.round(np.ravel(angles)[0]))
    return Mutation(CRANK, STANDS, {}, amiss, was=marks[0], times=times)


def _all(
    family: str, says: str, marks: Sequence[Mark], factor: float, plus: float = 0.0, **told: Any
) -> Mutation:
    amiss = {mark.slot: Amiss(mark, factor, plus) for mark in marks}
    return Mutation(family, says, {}, amiss, was=marks[0], **told)


def _of(marks: Sequence[Mark], value: object) -> Iterator[Mutation]:
    if marks[0].role == roles.ROW and marks[0].kind is not Angle:
        return
    if marks[0].role == roles.ROW:
        yield _all(CRANK, OTHER_WAY, marks, -1.0)
        for plus in (180.0, 90.0, -90.0, *_interval(value)):
            yield _all(CRANK, COUNTED, marks, 1.0, plus, times=plus)
        yield from _divided(marks, value)
        return
    if marks[0].unit in SENSED or np.all(np.asarray(value) < 0.0):
        yield _all(SENSE, OPPOSITE_GIVEN, marks, -1.0)
    if marks[0].unit in LOADS:
        yield _all(LEFT_OUT, NO_GIVEN, marks, 0.0)
    for factor in (2.0, 0.5, *POWERS_OF_TEN, *BY_UNIT.get(marks[0].unit, ())):
        yield _all(FACTOR, GIVEN_TIMES, marks, factor, times=factor)
    for factor in digits_exchanged(float(np.ravel(np.asarray(value))[0])):
        yield _all(GIVEN, GIVEN_TIMES, marks, factor, times=factor)


def digits_exchanged(value: float) -> Iterator[float]:
    """Yield how many times as large a number is with two digits exchanged that stand beside one another."""
    digits = f"{abs(value):.{DIGITS - 1}e}".partition("e")[0].replace(".", "").rstrip("0")
    if not np.isfinite(value) or len(digits) == DIGITS:
        return  # calculated, not given as a round number
    for one, other in pairwise(digits):
        changed = digits.replace(one + other, other + one, 1)
        if one != other and changed[0] != "0":
            yield float(f"0.{changed}") / float(f"0.{digits}")


def _divided(marks: Sequence[Mark], value: object) -> Iterator[Mutation]:
    """Yield the circle divided into another usual number of parts, from where the first position stands."""
    first, step = float(np.ravel(np.asarray(value))[0]), _interval(value)
    for parts in PARTS if step else ():
        factor = 360.0 / parts / abs(step[0])
        if abs(factor - 1.0) > 0.01:
            plus = (1.0 - factor) * first
            yield _all(CRANK, DIVIDED, marks, factor, plus, times=float(parts), usual=2.0)


def _interval(value: object) -> tuple[float, ...]:
    """Return by how far positions are apart, forwards and backwards, degrees: one number further or too few."""
    row = np.ravel(np.asarray(value, dtype=np.float64))
    steps = np.diff(row)
    step = float(np.median(steps)) if steps.size else 0.0
    return (step, -step) if step else ()


def _exchanged(log: Construction, given: Given) -> Iterator[Mutation]:
    for one, other in combinations(free(log, given), 2):
        if one[0].unit != other[0].unit:
            continue
        first, second = (np.asarray(given[marks[0]]) for marks in (one, other))
        if np.abs(first) == np.abs(second):
            continue
        amiss = {mark.slot: Amiss(other[0]) for mark in one}
        amiss |= {mark.slot: Amiss(one[0]) for mark in other}
        yield from _from_other_end(
            one, other, float(np.ravel(first)[0]), float(np.ravel(second)[0])
        )
        yield Mutation(EXCHANGED, EXCHANGED_WITH, {}, amiss, was=one[0], now=other[0])


PART = 2000
"""So many mutations are executed together: the fewer, the less memory that takes."""
NONE = Mutation("", "", {}, {})
"""The log as it is."""


class _Part:
    """Some mutations of a board, executed together when it is asked what they move.

    ``rows``: which of all; ``reached``: the slots of what they change and of all that hangs on it.
    """

    def __init__(self, offered: Offered, rows: NDArray[np.intp]) -> None:
        self.offered, self.rows = offered, rows

    @cached_property
    def reached(self) -> frozenset[int]:
        """The slots that any of them may move."""
        found = {slot for k in self.rows for slot in self.offered.mutations[k].slots}
        for step in self.offered.base.log.steps:
            if any(mark.slot in found for mark in step.uses):
                found.add(step.it.slot)
        return frozenset(found)

    @cached_property
    def figures(self) -> Mapping[tuple[Key, bool], Sparse]:
        """All figures, without readings, in the rows that differ from what is due; of steps nothing is kept."""
        offered = self.offered
        beside = offered.run((NONE, *(offered.mutations[k] for k in self.rows)))
        every = np.arange(beside.size)
        told = figures_of(offered.made, offered.board, beside, every, offered.keys)
        found: dict[tuple[Key, bool], Sparse] = {}
        for at, row in told.items():
            other = np.flatnonzero((row != row[0]) & ~(np.isnan(row) & np.isnan(row[0])))
            found[at] = Sparse(self.rows[other - 1], row[other])
        return found


class Offered:
    """The mutations of a board; the first is none at all."""

    def __init__(self, made: DrawnScene, board: Drawn) -> None:
        self.made, self.board = made, board

    @cached_property
    def base(self) -> AssumedLog:
        """The board as it should be drawn."""
        return AssumedLog(self.board, measured_last(self.board.construction), self.board.given)

    @cached_property
    def mutations(self) -> tuple[Mutation, ...]:
        """All of them."""
        log, given = self.base.log, self.base.given
        return (NONE, *mutations(log), *mistaken(log, given), *self._elsewhere())

    def _elsewhere(self) -> Iterator[Mutation]:
        """Yield what was laid in another of its places."""
        given = self.base.given
        for chapter in self.board.project.chapters:
            for one in Readings.of(chapter).elsewhere(self.board):
                amiss = {
                    mark.slot: Amiss(mark, 1.0, row - np.asarray(given[mark]))
                    for mark, row in one.given.items()
                }
                yield Mutation(MEETING, ANOTHER_PLACE, {}, amiss, was=one.mark)

    @cached_property
    def shares(self) -> Mapping[str, float]:
        """How usual the mutations of a family are together: by this the share of one is told."""
        found: Counter[str] = Counter()
        for one in self.mutations[1:]:
            found[one.family] += 1.0 / one.usual  # type: ignore[assignment]
        return found

    @cached_property
    def free(self) -> tuple[tuple[Mark, ...], ...]:
        """What may have been misread."""
        return free(self.base.log, self.base.given)

    @cached_property
    def keys(self) -> tuple[tuple[Key, bool], ...]:
        """Every figure of the scene, by key and whether in mm."""
        named = spots(self.made)
        both = ((mm, figures(self.made, in_mm=mm)) for mm in (True, False))
        return tuple((key, mm) for mm, of in both for key in {**of, **named})

    @cached_property
    def _parts(self) -> tuple[_Part, ...]:
        """All of them in parts, in the order of the steps that they change: the later move little."""
        first = [min(one.slots) for one in self.mutations[1:]]
        rows = 1 + np.argsort(first, kind="stable")
        return tuple(_Part(self, rows[k : k + PART]) for k in range(0, rows.size, PART))

    @cached_property
    def _due(self) -> Mapping[tuple[Key, bool], Any]:
        one = np.arange(1)
        return figures_of(self.made, self.board, self.run([NONE]), one, self.keys)

    @cached_property
    def _slots(self) -> Mapping[tuple[str, str], int]:
        """What is measured, and what is marked, by plan and name."""
        steps = steps_of(self.board if self.board is self.made.mechanism else None)
        return {at: step.it.slot for at, step in steps.items()}

    def figures(
        self, wanted: Iterable[tuple[Key, bool]], rows: NDArray[np.intp] | None = None
    ) -> dict[tuple[Key, bool], Any]:
        """Return figures of the board with all of them, or some ``rows``, executed without readings."""
        found: dict[tuple[Key, bool], Any] = {}
        parts = [one for one in self._parts if rows is None or np.isin(one.rows, rows).any()]
        for at in wanted:
            if at not in self._due:
                continue
            whole = np.full(len(self.mutations), self._due[at])
            slot = (
                self._slots.get(at[0][:2]) if at[1] else None
            )  # a quantity is of other steps, too
            for part in parts:
                if slot is None or slot in part.reached:
                    sparse = part.figures[at]
                    whole[sparse.rows] = sparse.value
            found[at] = whole if rows is None else whole[rows]
        return found

    def run(self, some: Sequence[Mutation], base: AssumedLog | None = None) -> Executed:
        """Execute mutations without readings."""
        base = base or self.base
        return executed(base.log, base.given, some, base.marks)

    def moving(
        self,
        wanted: Mapping[tuple[Key, bool], float],
        beside: Executed | None = None,
        signed: Container[tuple[Key, bool]] = (),
    ) -> NDArray[np.intp]:
        """Return the rows that move one of some figures by more than a least; the first row always.

        ``wanted``: figures, by key and whether in mm, and by how much they must move; ``signed``: the lengths
        among them that bear signs.
        """
        size = len(self.mutations) if beside is None else beside.size
        moves = np.zeros(size, dtype=bool)
        moves[0] = True
        for _, moved in self.moved(wanted, beside, signed):
            moves |= moved
        return np.flatnonzero(moves)

    def moved(
        self,
        wanted: Mapping[tuple[Key, bool], float],
        beside: Executed | None,
        signed: Container[tuple[Key, bool]] = (),
    ) -> Iterator[tuple[tuple[Key, bool], NDArray[np.bool_]]]:
        """Yield each figure of the board with the rows that move it; ``wanted`` as in `moving`."""
        if beside is None:
            told = self.figures(wanted)
        else:
            rows = np.arange(beside.size)
            told = figures_of(self.made, self.board, beside, rows, tuple(wanted))
        for at, row in told.items():
            with np.errstate(all="ignore"):
                off = np.abs(row - row[0])
                if at[1] and not np.iscomplexobj(row) and at not in signed:
                    off = np.abs(np.abs(row) - np.abs(row[0]))  # a length has no sign of its own
                yield at, ~(off <= wanted[at]) & np.isfinite(row[0])


class Mistakes:
    """What a scene offers, board by board; kept for all its drawings."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self.boards = tuple(Offered(made, board) for board in made.boards)

    def base_of(self, board: int) -> AssumedLog:
        """Return a board as it should be drawn."""
        return self.boards[board].base
