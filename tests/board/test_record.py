"""The log is checked while it is written: kinds, choices, letters."""

from __future__ import annotations

import pytest
from support.each import each

from graphic_tmm.board.grammar import OPERATIONS, operation
from graphic_tmm.board.operations.instruments import join, lay_off, meet, parallel, ray
from graphic_tmm.board.record import TALLY, Board
from graphic_tmm.board.values import Angle, Length, Number, Point
from graphic_tmm.errors import ConstructionError


def _board() -> tuple[Board, dict[str, object]]:
    board = Board()
    board.open("positions")
    marks = {
        "O": board.take(Point, "O"),
        "φ": board.take(Angle, "φ", "°"),
        "l": board.take(Length, "l"),
    }
    return board, marks


def test_a_wrong_kind_is_refused_where_it_is_written() -> None:
    board, marks = _board()
    line = board.draw(ray, "(OA)", marks["O"], marks["φ"])
    with pytest.raises(ConstructionError) as caught:
        board.draw(lay_off, "A", line, marks["φ"])
    told = str(caught.value)
    for part in ("positions", "step 2", "'A'", "lay_off", "(Line, Length)", "(Line, Angle)"):
        assert part in told, told


@pytest.mark.parametrize("count", [0, 1, 3])
def test_a_wrong_number_of_marks_is_refused(count: int) -> None:
    board, marks = _board()
    with pytest.raises(ConstructionError, match=r"step 1: join '\(AB\)' takes \(Point, Point\)"):
        board.draw(join, "(AB)", *[marks["O"]] * count)


def test_an_unknown_choice_is_refused() -> None:
    board, marks = _board()
    line = board.draw(ray, "(OA)", marks["O"], marks["φ"])
    with pytest.raises(ConstructionError, match=r"step 2: parallel 'm' has no choice \['side'\]"):
        board.draw(parallel, "m", marks["O"], line, side=1)


def test_a_point_bears_its_letter_alone_in_a_view() -> None:
    board, marks = _board()
    line = board.draw(ray, "m", marks["O"], marks["φ"])
    with pytest.raises(ConstructionError, match="positions, step 2: the letter 'O' stands in this"):
        board.draw(lay_off, "O", line, marks["l"])
    board.open("velocities")
    mark = board.draw(lay_off, "O", line, marks["l"])
    assert (mark.view, mark.letter) == ("velocities", "O")
    assert board.free("O") == f"O{TALLY}"
    assert board.free("Q") == "Q"


def test_two_bodies_may_share_a_line_or_a_length() -> None:
    board, marks = _board()
    first, second, third = (board.draw(ray, "m", marks["O"], marks["φ"]) for _ in range(3))
    made = (first, second, third)
    assert len({mark.letter for mark in made}) == len(set(made)) == 3
    assert [mark.name for mark in made] == ["m", "m", "m"]


def test_a_point_may_be_told_to_stand_beside_others_of_its_letter() -> None:
    board, marks = _board()
    line = board.draw(ray, "m", marks["O"], marks["φ"])
    first = board.draw(lay_off, "A", line, marks["l"], free=True)
    second, third = (board.draw(lay_off, "A", line, marks["l"], free=True) for _ in range(2))
    assert [mark.letter for mark in (first, second, third)] == [
        "A",
        f"A{TALLY}",
        f"A{TALLY}{TALLY}",
    ]
    assert {mark.name for mark in (first, second, third)} == {"A"}
    with pytest.raises(ConstructionError, match="the letter 'A' stands in this plan already"):
        board.draw(lay_off, "A", line, marks["l"])


def test_marks_are_found_by_their_role_in_a_view() -> None:
    board, marks = _board()
    given = board.take(Length, "h", role="ordinate")
    line = board.draw(ray, "m", marks["O"], marks["φ"], role="normal")
    ends = tuple(board.draw(lay_off, x, line, given, role="ordinate") for x in "AB")
    board.open("velocities")
    other = board.draw(lay_off, "A", line, given, role="ordinate")
    log = board.construction()
    assert log.roles("positions", "ordinate") == (given, *ends)
    assert log.roles("velocities", "ordinate") == (other,)
    assert log.roles("positions", "normal") == (line,)
    assert log.roles("positions", "pole") == log.roles("forces", "normal") == ()
    assert marks["O"].role == ""


def test_what_was_refused_is_not_in_the_log() -> None:
    board, marks = _board()
    line = board.draw(ray, "m", marks["O"], marks["φ"])
    for op, letter, uses in (
        (ray, "A", (marks["O"],)),
        (lay_off, "O", (line, marks["l"])),
        (lay_off, "A", (line, marks["φ"])),
    ):
        with pytest.raises(ConstructionError):
            board.draw(op, letter, *uses)
    mark = board.draw(lay_off, "A", line, marks["l"])
    log = board.construction()
    assert [step.it for step in log.steps] == [line, mark]
    assert log.step(mark) is log.steps[1]
    assert log.step(marks["O"]) is None


def test_a_remark_stands_before_the_next_step_only() -> None:
    board, marks = _board()
    board.say("v_A = ω·l")
    board.say("⊥ OA")
    line = board.draw(ray, "m", marks["O"], marks["φ"])
    other = board.draw(parallel, "n", marks["O"], line)
    board.draw(meet, "X", line, other)
    assert [step.note for step in board.construction().steps] == ["v_A = ω·l\n⊥ OA", "", ""]


def test_what_is_recorded_does_not_change_when_the_board_goes_on() -> None:
    board, marks = _board()
    before = board.construction()
    board.draw(ray, "m", marks["O"], marks["φ"])
    assert before.steps == ()
    assert len(board.construction().steps) == 1


def test_views_keep_their_pole_and_scale() -> None:
    board, marks = _board()
    mu = board.take(Number, "μ_l", "m/mm")
    board.lay_out(marks["O"], mu)
    board.figure("link", "1", marks["O"])
    log = board.construction()
    view = log.view("positions")
    assert view is not None
    assert (view.pole, view.scale) == (marks["O"], mu)
    assert log.view("velocities") is None
    assert log.figures[0].marks == (marks["O"],)


def test_an_operation_needs_kinds_and_a_name_of_its_own() -> None:
    def odd(start: Point, by: int) -> Point:
        """Move {start}."""
        return start

    def measure(start: Point, end: Point) -> Length:
        """Measure something else."""
        return start.real

    before = dict(OPERATIONS)
    with pytest.raises(TypeError, match=r"odd: \['by'\] has no kind"):
        operation()(odd)
    with pytest.raises(TypeError, match="two operations called measure"):
        operation()(measure)
    assert before == OPERATIONS


@each("op", list(OPERATIONS.values()))
def test_sentences_name_all_arguments_and_nothing_else(op: object) -> None:
    import string

    parsed = string.Formatter().parse(op.sentence)  # type: ignore[attr-defined]
    assert {name for _, name, _, _ in parsed if name} <= {*op.arguments, *op.choices, "it"}  # type: ignore[attr-defined]
