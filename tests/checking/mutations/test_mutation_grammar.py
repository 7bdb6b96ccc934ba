"""The grammar of mistakes: many for each step, read off kinds alone, so that a new operation brings its own."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import exact
from support.own_told import checker

from graphic_tmm.board import roles
from graphic_tmm.board.execute import execute
from graphic_tmm.board.grammar import OPERATIONS, operation
from graphic_tmm.board.operations.instruments import lay_off, ray
from graphic_tmm.board.record import Board, Construction, Step
from graphic_tmm.board.values import Angle, Arc, Length, Line, Number, Point, Side
from graphic_tmm.checking.mutations import mutation, words
from graphic_tmm.checking.mutations.grammar import count, mutations
from graphic_tmm.checking.mutations.mistakes import digits_exchanged, free, mistaken
from graphic_tmm.checking.mutations.mutation import (
    DIRECTION,
    EXCHANGED,
    FAMILIES,
    LEFT_OUT,
    MEETING,
    OPERAND,
    PREVIOUS,
    SCALE,
    SENSE,
    START,
    TABLE,
    Mutation,
    measured_last,
)


def test_a_log_has_thousands() -> None:
    (board,) = exact("windrower").boards
    log = measured_last(board.construction)
    found = [*mutations(log), *mistaken(log, board.given)]
    assert len(found) >= 9_000
    assert {one.family for one in found} == {*FAMILIES} - {TABLE}
    places = {"positions", "extremes", "velocities", "accelerations"}
    drawn = [step for step in log.steps if step.it.view in places]
    assert sum(count(list(mutations(log, drawn))).values()) >= 20 * len(drawn)


def test_every_one_is_of_a_mark_of_its_kind_that_is_there() -> None:
    (board,) = exact("crank-rocker").boards
    log = measured_last(board.construction)
    turn = {mark.slot: -1 for mark in log.given} | {s.it.slot: k for k, s in enumerate(log.steps)}
    for one in mutations(log):
        if one.family == OPERAND and one.was is not None and one.now is not None:
            assert one.was.kind is one.now.kind
            assert one.at is not None
            assert turn[one.now.slot] < turn[one.at.it.slot]


def test_nothing_meets_itself() -> None:
    """Where two lines, points or arcs are used none is taken for the other: any place would be on both."""
    log = measured_last(exact("windrower").boards[0].construction)
    found = [one for one in mutations(log) if one.family == OPERAND and one.at is not None]
    drawn = [one for one in found if one.was is not None and one.was.kind in (Point, Line, Arc)]
    assert len(drawn) > 500
    for one in drawn:
        assert one.at is not None
        assert len(one.at.uses) > 3 or one.now not in one.at.uses, one.at.it


def test_readings_of_the_ruler_are_taken_late() -> None:
    log = exact("windrower").boards[0].construction
    moved = measured_last(log)
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


@pytest.mark.parametrize("value", [0.28, -0.28, 72.0, 31.25, 1.05, 0.3, 31.4159, 0.0])
def test_digits_that_stand_beside_one_another_are_exchanged(value: float) -> None:
    """By the text of the number: every two neighbours, none of a number that was calculated."""
    text = f"{abs(value):g}".replace(".", "").strip("0")
    pairs = range(len(text) - 1) if len(text) < 6 else ()
    texts = {text[:k] + text[k + 1] + text[k] + text[k + 2 :] for k in pairs} - {text}
    wanted = {float(f"0.{one}") / float(f"0.{text}") for one in texts if one[0] != "0"}
    assert sorted(digits_exchanged(value)) == pytest.approx(sorted(wanted))


def test_two_arcs_are_struck_with_one_another_s_opening() -> None:
    board = exact("crank-rocker").boards[0]
    (one,) = [
        m
        for m in mutations(measured_last(board.construction))
        if m.family == EXCHANGED and m.at is not None and m.at.op.name == "cross"
    ]
    assert one.was is not None
    assert one.now is not None
    log, given = mutation.changed_log(board.construction, board.given, one, None)
    arcs = [s.it for s in log.steps if s.it.slot in one.changes]
    ends = [s.uses[0] for s in board.construction.steps if s.it in arcs]
    assert one.at is not None
    drawn = execute(log, given, [*ends, one.at.it, one.was, one.now])
    lengths = execute(board.construction, board.given, [one.was, one.now])
    openings = [np.abs(drawn[one.at.it] - drawn[end]) for end in ends]
    assert openings[0] == pytest.approx(np.broadcast_to(lengths[one.now], openings[0].shape))
    assert openings[1] == pytest.approx(np.broadcast_to(lengths[one.was], openings[1].shape))
    assert drawn[one.was] == lengths[one.was], "it is calculated with the right ones"


def test_a_circle_is_divided_into_another_number_of_parts() -> None:
    """About where the first position stands, all others at the distance of the parts told."""
    board = exact("crank-rocker").boards[0]
    log = measured_last(board.construction)
    found = [one for one in mistaken(log, board.given) if "divided" in one.says]
    assert len(found) >= 4
    for one in found:
        assert one.was is not None
        _, given = mutation.changed_log(log, board.given, one, None)
        angles = np.ravel(np.asarray(given[one.was]))
        assert angles[0] == pytest.approx(float(np.ravel(np.asarray(board.given[one.was]))[0]))
        steps = np.abs(np.diff(angles))
        assert np.median(steps) == pytest.approx(360.0 / one.times)


def test_an_angular_velocity_is_taken_for_an_angular_acceleration() -> None:
    log = measured_last(exact("crank-press").boards[0].construction)
    found = [
        (one.was.unit, one.now.unit)
        for one in mutations(log)
        if one.was is not None and one.now is not None and one.family == OPERAND
    ]
    assert ("1/s²", "1/s") in found
    assert ("1/s", "1/s²") not in found


def test_a_wrong_scale_factor_is_taken_wherever_the_right_one_should_be() -> None:
    log = measured_last(exact("cam").boards[0].construction)
    wide = [one for one in mutations(log) if one.family == SCALE and one.wide and one.now]
    assert any(len({step.op.name for step in _steps(log, one)}) > 1 for one in wide)


def _steps(log: Construction, one: Mutation) -> list[Step]:
    return [step for step in log.steps if step.it.slot in one.changes]


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


def _of_forces() -> list[Mutation]:
    (board,) = checker("frc").made.boards
    return list(mutations(measured_last(board.construction)))


def test_inertia_forces_are_turned_all_at_once_each_by_its_line_alone() -> None:
    """A force turned in its size and in its line would stand as it should."""
    found = [one for one in _of_forces() if one.wide and one.family == mutation.SENSE]
    turned = [one for one in found if one.at is not None and one.at.it.role == roles.INERTIA]
    letters = [sorted(change.step.it.letter for change in one.changes.values()) for one in turned]
    forces = ["(P_{i2})", "(P_{i3})"]
    assert forces in letters
    assert ["(P_{i2})", "(P_{i3})", "M_{i2}"] in letters
    assert all(len({name.strip("()") for name in some}) == len(some) for some in letters)


def test_moments_are_taken_about_another_point_all_at_once() -> None:
    found = [one for one in _of_forces() if one.wide and one.family == OPERAND]
    about = [one for one in found if one.was is not None and one.was.letter == "B"]
    names = {one.now.letter for one in about if one.now is not None and len(one.changes) == 2}
    assert "A" in names


def test_ordinates_are_counted_from_another_zero() -> None:
    """The displacement alone is so: by as many zeros as there are other positions."""
    found = [one for one in _of_forces() if one.family == START and "zero" in str(one.says)]
    assert [one.times for one in found] == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]
    assert {one.at.it.letter for one in found if one.at is not None} == {"y_S"}
    (change,) = found[2].changes.values()
    row = np.array([[1.0, 5.0, 2.0, 7.0]])
    shifted = change.step.op.run(row, np.array([[1.0]]), np.array([[1.0]]))
    assert shifted.tolist() == [[-6.0, -2.0, -5.0, 0.0]]


def test_chords_are_those_of_another_graph_or_stand_at_ends_of_intervals() -> None:
    found = _of_forces()
    chords = [one for one in found if one.now is not None and one.now.letter == "(s,s+1)"]
    assert "diagram a" in {one.at.it.view for one in chords if one.at is not None}
    ends = [one for one in found if one.wide and one.family == START and one.was is not None]
    feet = [(one.was.letter, one.now.letter) for one in ends if one.was and one.now]
    assert ("m", "i") in feet


def offered(name: str) -> list[Mutation]:
    return [*mutations(measured_last(checker(name).made.boards[0].construction))]


def test_one_term_is_left_out_of_a_sum_or_taken_with_the_other_sign() -> None:
    for family in (LEFT_OUT, SENSE):
        found = [one for one in offered("frc") if one.says == words.OF_SUM[family]]
        named = {(one.was.letter, one.at.it.view) for one in found if one.was and one.at}
        assert {("M(F_3)", "lever"), ("M_{i2}", "group 2-3")} <= named


def test_lengths_are_taken_as_they_are_on_the_paper() -> None:
    """Arms in all equations of moments at once; what is drawn by a calculation is no such length."""
    found = [one for one in offered("frc") if one.says == words.ON_PAPER and one.at is not None]
    wide = [one for one in found if one.wide and one.at and one.at.op.name == "moment"]
    assert max(len(one.changes) for one in wide) == 3
    assert not [one for one in found if one.at and one.at.op.name == "to_board"]


def test_a_point_is_found_by_the_ratio_upside_down_or_half_as_far_off() -> None:
    made = checker("rpr").made.boards[0]
    log = measured_last(made.construction)
    due = execute(log, made.given)
    step = next(s for s in log.steps if s.it.view == "velocities" and s.op.name == "similar")
    base, end, B, A, C = (due[mark] for mark in step.uses)
    found = {(one.says, one.times): one for one in mutations(log, [step])}
    ratio = (C - B) / (A - B)
    for says, times, by in (
        (words.UPSIDE_DOWN, 1.0, 1.0 / ratio),
        (words.AS_FAR, 0.5, 0.5 * ratio),
        (words.SENSE, 1.0, -ratio),
    ):
        (change,) = found[says, times].changes.values()
        where = change.step.op.run(base, end, B, A, C)
        np.testing.assert_allclose(where, base + (end - base) * by)


def test_a_plan_is_drawn_by_that_of_the_position_before() -> None:
    """All lines of a plan at once, each by its own."""
    found = [one for one in offered("sc") if one.family == PREVIOUS and one.wide]
    views = [{c.step.it.view for c in one.changes.values()} for one in found]
    assert {"velocities"} in views
    assert all(c.before >= 0 for one in found for c in one.changes.values())


def test_whole_vectors_are_taken_for_what_is_left_beside_their_normal_components() -> None:
    (one,) = (one for one in offered("fb") if one.wide and one.family == OPERAND and len(one.changes) == 2
              and {c.step.it.letter for c in one.changes.values()} == {"ε_2", "ε_3"})  # fmt: skip
    taken = {c.step.it.letter: [m.letter for m in c.step.uses] for c in one.changes.values()}
    assert taken["ε_2"][:2] == ["a", "b"]
    assert taken["ε_3"][0] == "πb"


def test_a_load_may_be_left_out_altogether() -> None:
    board = checker("frc").made.boards[0]
    found = [one for one in mistaken(board.construction, board.given) if one.family == LEFT_OUT]
    assert [
        (one.was.letter, [a.factor for a in one.amiss.values()]) for one in found if one.was
    ] == [("|F_3|", [0.0])]


def test_a_plan_of_the_lever_that_is_not_turned_is_more_usual() -> None:
    some = [one for one in offered("frc") if one.at is not None and one.at.op.name == "carry"]
    turned = {one.times: one.usual for one in some if one.family == DIRECTION and one.wide}
    assert min(turned, key=lambda times: turned[times]) == 90.0
