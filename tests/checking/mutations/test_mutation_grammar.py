"""The grammar of mistakes: many for each step, read off kinds alone, so that a new operation brings its own."""

from __future__ import annotations

import pytest
from support.gallery import exact

from graphic_tmm.board.grammar import OPERATIONS, operation
from graphic_tmm.board.operations.instruments import lay_off, ray
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Angle, Length, Line, Number, Point, Side
from graphic_tmm.checking.mutations.givens import free, mistaken
from graphic_tmm.checking.mutations.grammar import count, mutations
from graphic_tmm.checking.mutations.mutation import FAMILIES, GIVEN, MEETING, OPERAND, TABLE
from graphic_tmm.checking.mutations.scope import late


def test_a_log_has_thousands() -> None:
    (board,) = exact("windrower").boards
    log = late(board.construction)
    found = [*mutations(log), *mistaken(log, board.given)]
    assert len(found) >= 9_000
    assert {one.family for one in found} == {*FAMILIES} - {TABLE, GIVEN}
    places = {"positions", "extremes", "velocities", "accelerations"}
    drawn = [step for step in log.steps if step.it.view in places]
    assert sum(count(list(mutations(log, drawn))).values()) >= 20 * len(drawn)


def test_every_one_is_of_a_mark_of_its_kind_that_is_there() -> None:
    (board,) = exact("crank-rocker").boards
    log = late(board.construction)
    turn = {mark.slot: -1 for mark in log.given} | {s.it.slot: k for k, s in enumerate(log.steps)}
    for one in mutations(log):
        if one.family == OPERAND and one.was is not None and one.now is not None:
            assert one.was.kind is one.now.kind
            assert one.at is not None
            assert turn[one.now.slot] < turn[one.at.it.slot]


def test_readings_of_the_ruler_are_taken_late() -> None:
    log = exact("windrower").boards[0].construction
    moved = late(log)
    assert sorted(s.it.slot for s in moved.steps) == sorted(s.it.slot for s in log.steps)
    known = {mark.slot for mark in log.given}
    for step in moved.steps:
        assert all(mark.slot in known for mark in step.uses)
        known.add(step.it.slot)
    velocities = [step for step in moved.steps if step.it.view == "velocities"]
    first = next(k for k, step in enumerate(velocities) if step.op.reads)
    assert {s.it.letter for s in velocities[:first]} >= {"a", "a3", "c", "s3"}


def test_a_new_operation_brings_its_mistakes() -> None:
    def laid_twice_over(on: Line, length: Length, side: Side) -> Point:
        """On {on} lay off {length} twice, {side}; mark {it}."""
        return Point(on.at + side * 2.0 * length * on.along)

    try:
        op = operation()(laid_twice_over)
        board = Board()
        board.open("plan")
        start, angle = board.take(Point, "O"), board.take(Angle, "φ")
        short, long = board.take(Length, "s"), board.take(Length, "l")
        side = board.take(Side, "±")
        line = board.draw(ray, "x", start, angle)
        other = board.draw(lay_off, "B", line, long)
        it = board.draw(op, "A", line, short, side)
        found = [
            one for one in mutations(board.construction()) if one.at is not None and one.at.it == it
        ]
    finally:
        del OPERATIONS["laid_twice_over"]
    families = {one.family for one in found}
    assert {OPERAND, MEETING} <= families
    assert any(one.now == long for one in found)
    assert other.kind is Point


@pytest.mark.parametrize("name", ["windrower", "engine", "cam"])
def test_what_is_given_may_be_misread(name: str) -> None:
    board = exact(name).boards[0]
    letters = {marks[0].name for marks in free(board.construction, board.given)}
    assert letters
    assert not any(letter.startswith("μ") for letter in letters)
    assert all(
        m.kind in (Number, Length, Angle)
        for ms in free(board.construction, board.given)
        for m in ms
    )
