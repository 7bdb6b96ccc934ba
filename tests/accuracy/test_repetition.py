"""What is done anew at each position: against the sizes of the arrays that execution leaves."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import ALL
from support.logs import logs, sizes

from graphic_tmm.accuracy.repetition import ALONG, repeated, varying
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.graphs import following
from graphic_tmm.board.operations.instruments import join, lay_off, measure, parallel, ray, strike
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Angle, Curve, Length, Point, arrays
from graphic_tmm.errors import ConstructionError


@pytest.mark.parametrize("name", ALL)
def test_a_step_is_repeated_where_its_value_has_all_positions(name: str) -> None:
    for log, given in logs(name):
        again = repeated(log, varying(given))
        count = execute(log, given).positions
        for mark, size in sizes(log, given):
            assert size in (1, count)
            assert (size > 1) == (mark.slot in again), (mark.view, mark.letter)


@pytest.mark.slow
def test_steps_across_positions_leave_one_mark_or_one_for_each_position() -> None:
    seen = set()
    for name in ALL:
        for log, given in logs(name):
            reading = execute(log, given)
            for step in log.steps:
                if step.op.across and step.op.leaves is not Curve:
                    size = max(part.shape[1] for part in arrays(reading[step.it]))
                    assert size == (reading.positions if step.op.name in ALONG else 1), step.op
                    seen.add(step.op.name)
    assert seen >= ALONG


def test_some_scene_has_many_steps_of_either_sort() -> None:
    ((log, given),) = logs("windrower")
    again = repeated(log, varying(given))
    pointwise = [step for step in log.steps if not step.op.across]
    assert 30 < len(again) < len(pointwise) - 30


@pytest.mark.parametrize("name", ALL)
def test_what_does_not_vary_has_the_same_value_at_all_positions(name: str) -> None:
    """Run at each position alone: a step that is drawn once leaves the same there, to the bit."""
    for log, given in logs(name):
        if any(step.op.across for step in log.steps):
            continue
        again = repeated(log, varying(given))
        marks = [step.it for step in log.steps if step.it.slot not in again]
        alone = [execute(log, given, marks, positions=[k]) for k in range(3)]
        for mark in marks:
            for part, other in zip(arrays(alone[0][mark]), arrays(alone[-1][mark]), strict=True):
                np.testing.assert_array_equal(part, other)


class Small:
    """A crank, the line through its pin parallel to a fixed one, and one parallel to that through the pivot."""

    def __init__(self) -> None:
        board = Board()
        board.open("positions")
        self.o, self.c = board.take(Point, "O"), board.take(Point, "C")
        self.phi, self.r = board.take(Angle, "φ"), board.take(Length, "r")
        self.frame = board.draw(join, "(OC)", self.o, self.c)
        self.crank = board.draw(ray, "(OA)", self.o, self.phi)
        self.a = board.draw(lay_off, "A", self.crank, self.r)
        self.arc = board.draw(strike, "(O)", self.o, self.r)
        self.moving = board.draw(parallel, "(A)", self.a, self.frame)
        self.fixed = board.draw(parallel, "(O′)", self.o, self.moving)
        self.next = board.draw(following, "A′", self.a, self.o, row=2)
        self.length = board.draw(measure, "AA′", self.a, self.next)
        self.log = board.construction()


def test_a_parallel_of_a_line_that_moves_without_turning_is_drawn_once() -> None:
    small = Small()
    again = repeated(small.log, [small.phi])
    for mark in (small.crank, small.a, small.moving, small.length):
        assert mark.slot in again
    for mark in (small.frame, small.arc, small.fixed):
        assert mark.slot not in again


def test_steps_across_positions_are_repeated_by_nobody() -> None:
    small = Small()
    assert small.next.slot not in repeated(small.log, [small.phi])
    # but what they leave has a place at each position
    assert small.length.slot in repeated(small.log, [])


def test_if_nothing_varies_all_else_is_drawn_once_and_more_repeats_more() -> None:
    small = Small()
    assert repeated(small.log, []) == {small.length.slot}
    some, more = (repeated(small.log, v) for v in ([small.phi], [small.phi, small.r]))
    assert some < more
    assert small.arc.slot in more


def test_what_varies_is_what_has_a_row_of_positions() -> None:
    marks = Small()
    given = {
        marks.o: 0j,
        marks.c: np.ones((5, 1)),
        marks.phi: np.ones((1, 12)),
        marks.r: [[1.0, 2.0]],
    }
    assert varying(given) == {marks.phi, marks.r}
    assert varying({marks.phi: np.arange(3.0)}) == {marks.phi}
    assert varying({}) == frozenset()


def test_a_mark_of_another_board_is_refused() -> None:
    small = Small()
    with pytest.raises(ConstructionError, match="'A' is not given on this board"):
        repeated(small.log, [small.phi, small.a])
