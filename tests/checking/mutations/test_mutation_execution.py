"""Mutations executed together are what each of them is alone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from support.each import each
from support.gallery import ALL, exact
from support.turns import in_turn

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Curve, arrays
from graphic_tmm.checking.mutations import mutation
from graphic_tmm.checking.mutations.execution import executed
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mistakes import mistaken
from graphic_tmm.checking.mutations.mutation import measured_last

SOME = ("arc-cam", "crank-rocker", "engine", "oscillating-cylinder", "planetary", "slider-diagrams")
"""Scenes of all chapters but few steps; two of them by turns; with ``--measured`` it is every scene."""
EVERY = 1597
"""Of the mutations of a scene every so manieth is executed alone, too: a prime, so that all kinds are met."""


def alike(one: object, other: object) -> bool:
    """Whether two values agree to 1e-8 of a mm or of themselves, NaN where the other is."""
    return all(
        np.allclose(*np.broadcast_arrays(a, b), rtol=1e-7, atol=1e-8, equal_nan=True)
        for a, b in zip(arrays(one), arrays(other), strict=True)
    )


@pytest.mark.slow
@each("name", ALL)
def test_each_is_what_it_is_alone(name: str, many: Callable[[int, int], int]) -> None:
    for board in exact(name).boards if many(1, 0) or name in in_turn(SOME, 2) else ():
        log = measured_last(board.construction)
        some = (*mutations(log), *mistaken(log, board.given))
        marks = [step.it for step in log.steps]
        beside = executed(log, board.given, some, marks)
        for row in range(0, len(some), EVERY):
            other, given = mutation.changed_log(log, board.given, some[row])
            alone = execute(other, given, marks)
            for mark in marks:
                told, due = beside.whole(mark.slot), alone[mark]
                if isinstance(due, Curve):
                    continue
                mine = tuple(a if a.shape[0] == 1 else a[row : row + 1] for a in arrays(told))
                told = type(due)(*mine) if isinstance(due, tuple) else mine[0]
                assert alike(told, due), (some[row].family, some[row].at, mark)


def test_the_base_is_the_drawing() -> None:
    (board,) = exact("crank-rocker").boards
    log = measured_last(board.construction)
    marks = [step.it for step in log.steps if not step.op.across]
    beside = executed(log, board.given, (), marks)
    right = execute(log, board.given, marks)
    assert all(alike(beside.whole(mark.slot), right[mark]) for mark in marks)


def test_a_row_without_effect_is_dropped() -> None:
    (board,) = exact("crank-rocker").boards
    log = measured_last(board.construction)
    some = tuple(mutations(log))
    beside = executed(log, board.given, some, [step.it for step in log.steps])
    for slot, sparse in beside.rows.items():
        assert (np.diff(sparse.rows) > 0).all()
        for mine, due in zip(arrays(sparse.value), arrays(beside.base[slot]), strict=True):
            moved = ~np.isclose(mine, due, rtol=1e-9, atol=1e-9, equal_nan=True)
            assert mine.shape[0] == sparse.rows.size
            assert moved.any() or isinstance(sparse.value, tuple)
