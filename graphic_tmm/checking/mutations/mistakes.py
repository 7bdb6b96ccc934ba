"""The mistakes that a scene offers: the mutations of its boards, executed once for all its drawings."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.checking.cells import Key, cells
from graphic_tmm.checking.mutations.evidence import Board
from graphic_tmm.checking.mutations.execution import Beside, executed
from graphic_tmm.checking.mutations.figures import figures_of
from graphic_tmm.checking.mutations.givens import free, mistaken
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.scope import late
from graphic_tmm.drawn import Drawn, DrawnScene

NONE = Mutation("", "", {}, {})
"""The log as it is."""


class Offered:
    """The mutations of a board; the first is none at all."""

    def __init__(self, made: DrawnScene, board: Drawn) -> None:
        self.made, self.board = made, board

    @cached_property
    def base(self) -> Board:
        """The board as it should be drawn."""
        return Board(self.board, late(self.board.construction), self.board.given)

    @cached_property
    def mutations(self) -> tuple[Mutation, ...]:
        """All of them."""
        log, given = self.base.log, self.base.given
        return (NONE, *mutations(log), *mistaken(log, given))

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
    def plain(self) -> Beside:
        """All of them executed, without readings."""
        return self.run(self.mutations)

    def showing(self, wanted: Collection[Key]) -> Beside:
        """All of them executed, without readings, at least as far as some figures tell.

        Points need little of a log: what else it makes, curves above all, takes most of the time.
        """
        points = _points(self.board, wanted) if cells(self.made).keys().isdisjoint(wanted) else ()
        if "plain" in self.__dict__ or {mark.key for mark in points} != {at[:2] for at in wanted}:
            return self.plain
        log = self.base.log
        return executed(log, self.base.given, _reaching(log, self.mutations, points), points)

    def run(self, some: Sequence[Mutation], base: Board | None = None) -> Beside:
        """Execute mutations without readings."""
        base = base or self.base
        return executed(base.log, base.given, some, base.marks)

    def moving(
        self, wanted: Mapping[tuple[Key, bool], float], beside: Beside | None = None
    ) -> NDArray[np.intp]:
        """Return the rows that move one of some figures by more than a least; the first row always.

        ``wanted``: figures, by key and whether in mm, and by how much they must move.
        """
        beside = beside or self.plain
        moves = np.zeros(beside.size, dtype=bool)
        moves[0] = True
        for _, moved in self.moved(wanted, beside):
            moves |= moved
        return np.flatnonzero(moves)

    def moved(
        self, wanted: Mapping[tuple[Key, bool], float], beside: Beside
    ) -> Iterator[tuple[tuple[Key, bool], NDArray[np.bool_]]]:
        """Yield each figure of the board with the rows that move it; ``wanted`` as in `moving`."""
        rows = np.arange(beside.size)
        for at, row in figures_of(self.made, self.board, beside, rows, tuple(wanted)).items():
            with np.errstate(all="ignore"):
                off = np.abs(row - row[0])
                if at[1] and not np.iscomplexobj(row):
                    off = np.abs(np.abs(row) - np.abs(row[0]))  # a length has no sign
                yield at, ~(off <= wanted[at]) & np.isfinite(row[0])


def _points(board: Drawn, wanted: Collection[Key]) -> tuple[Mark, ...]:
    """Return the marks of a board that are called as the points of some keys are."""
    names = {at[:2] for at in wanted}
    return tuple(step.it for step in board.construction.steps if step.it.key in names)


def _reaching(
    log: Construction, mutations: Sequence[Mutation], wanted: Iterable[Mark]
) -> list[Mutation]:
    """Return for each mutation itself, or none at all if it changes no step that some marks need."""
    changes: dict[int, list[Mark]] = defaultdict(list)
    for one in mutations:
        for slot, change in one.changes.items():
            changes[slot] += change.step.uses
    alive = {mark.slot for mark in wanted}
    for step in reversed(log.steps):
        if step.it.slot in alive:
            alive.update(mark.slot for mark in (*step.uses, *changes[step.it.slot]))
    return [one if one.amiss or not alive.isdisjoint(one.changes) else NONE for one in mutations]


class Mistakes:
    """What a scene offers, board by board; kept for all its drawings."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        self.boards = tuple(Offered(made, board) for board in made.boards)

    def base_of(self, board: int) -> Board:
        """Return a board as it should be drawn."""
        return self.boards[board].base
