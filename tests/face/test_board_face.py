"""A construction of one's own: figures against plain geometry, words, ink, the hand, what is refused."""

from __future__ import annotations

import cmath
import math
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.each import each

import graphic_tmm as tmm
from graphic_tmm.board.execute import execute


def linkage(board: tmm.Board, angle: object = 60.0) -> dict[str, object]:
    """A four-bar with O at 0, C at 60: OA 20, AB 55, CB 40."""
    o, c = board.point("O", 0, 0), board.point("C", 60, 0)
    a = board.lay_off("A", board.ray("OA", o, angle), 20)
    b = board.cross("B", board.strike("a", a, 55), board.strike("c", c, 40), +1)
    return {"O": o, "C": c, "A": a, "B": b}


@given(st.floats(0.0, 360.0))
def test_figures_are_those_of_plain_geometry(angle: float) -> None:
    board = tmm.Board()
    marks = linkage(board, angle)
    a, b = board.where(marks["A"]), board.where(marks["B"])
    assert a == pytest.approx(cmath.rect(20, math.radians(angle)), abs=1e-9)
    assert abs(b - a) == pytest.approx(55)
    assert abs(b - 60) == pytest.approx(40)
    assert ((b - a) * (60 - a).conjugate()).imag > 0
    assert board.value(board.measure("OB", marks["O"], marks["B"])) == pytest.approx(abs(b))


def test_a_row_of_angles_is_drawn_at_once() -> None:
    angles = np.arange(0.0, 360.0, 30.0)
    board = tmm.Board()
    marks = linkage(board, angles)
    assert board.positions == 12
    assert board.array(marks["B"]).shape == (1, 12)
    assert board.array(marks["O"]).shape == (1, 12)
    for k in (0, 5):
        one = tmm.Board()
        assert board.where(marks["B"], k) == pytest.approx(one.where(linkage(one, angles[k])["B"]))


def test_what_is_drawn_later_is_there_when_asked() -> None:
    board = tmm.Board()
    marks = linkage(board)
    assert board.value(board.measure("OA", marks["O"], marks["A"])) == pytest.approx(20.0)
    assert board.value(board.measure("CB", marks["C"], marks["B"])) == pytest.approx(40.0)


def test_the_log_is_that_of_the_package() -> None:
    board = tmm.Board()
    marks = linkage(board)
    log = board.construction
    assert [step.op.name for step in log.steps] == ["ray", "lay_off", "strike", "strike", "cross"]
    assert execute(log, board._draft.given)[marks["B"]][0, 0] == board.where(marks["B"])


def test_a_hand_slips_as_often_as_it_draws() -> None:
    board = tmm.Board(hand="student", seed=3, trials=400)
    marks = linkage(board)
    found = board.value(board.measure("OB", marks["O"], marks["B"]))
    exact = tmm.Board()
    exact_marks = linkage(exact)
    due = exact.value(exact.measure("OB", exact_marks["O"], exact_marks["B"]))
    assert found.trials.shape == (400,)
    assert 0.2 < found.trials.std() < 3.0
    assert abs(found.trials.mean() - due) < 0.3
    assert np.allclose(
        found.trials * 2, np.round(found.trials * 2)
    )  # half a mm, the student's ruler
    again = tmm.Board(hand="student", seed=3, trials=400)
    same = linkage(again)
    assert (
        again.value(again.measure("OB", same["O"], same["B"])).trials.tolist()
        == found.trials.tolist()
    )


def test_formulas_calculate_with_units() -> None:
    board = tmm.Board()
    marks = linkage(board)
    board.open("velocities")
    p = board.point("p", 0, 0)
    a = board.lay_off("a", board.ray("pa", p, 150), board.length("pa", 40))
    mu = board.number("μ_v", 0.05, "(m/s)/mm")
    speed = board.draw("in_si", "v_A", board.measure("pa'", p, a), mu, unit="m/s")
    assert (board.value(speed), board.value(speed).unit) == (pytest.approx(2.0), "m/s")
    assert "μ_v = 40·0.05 = 2 m/s" in str(board.steps())
    assert [part.title for part in board.steps().parts] == ["Construction", "Velocity plan"]
    assert board.where(marks["A"]) != board.where(a)


def test_the_path_of_a_point_is_a_curve() -> None:
    board = tmm.Board()
    marks = linkage(board, np.arange(0.0, 360.0, 10.0))
    before = board.sheet().svg
    path = board.curve("path", marks["B"])
    (knots, _, closed) = execute(board.construction, board._draft.given)[path]
    assert knots == pytest.approx(board.array(marks["B"]))
    assert closed
    assert 'class="pen main"' in board.sheet().svg
    assert 'class="pen main"' not in before


def test_words_tell_what_was_done_in_the_language_asked_for() -> None:
    english, russian = tmm.Board(), tmm.Board(language="ru", title="Механизм")
    for board in (english, russian):
        linkage(board)
    assert english.steps()[1].text == "On OA lay off 20 mm from its beginning; mark A."
    assert re.search("[а-я]", russian.steps()[1].text)
    assert len(english.steps()) == len(russian.steps()) == 5
    assert "Why: " in str(english.steps(why=True))
    english.say("the rocker")
    english.join("CB", english.point("D", 1, 1), english.point("E", 2, 2))
    assert [one.number for one in english.steps()][-2:] == [0, 6]


def test_the_picture_is_true_to_the_millimetre_and_links_are_heavy(tmp_path: Path) -> None:
    board = tmm.Board(title="Four-bar & more")
    marks = linkage(board)
    before = board.sheet().svg
    board.link(marks["O"], marks["A"])
    board.link(marks["A"], marks["B"])
    board.vector(marks["C"], marks["B"])
    sheet = board.sheet()
    assert 'class="pen main"' not in before
    assert 'class="pen main"' in sheet.svg
    assert 'class="pen medium"' in sheet.svg
    width = re.match(r'.*?<svg [^>]*width="([\d.]+)mm"', sheet.svg, re.DOTALL)
    assert width
    assert float(width[1]) == pytest.approx(sheet.width, abs=0.001)
    assert sheet.width > 60.0
    assert "Four-bar &amp; more" in sheet.svg
    assert len(board.sheet(helping=False).svg) < len(sheet.svg)
    assert board._repr_html_() == sheet._repr_html_()
    assert board.save(tmp_path / "board.svg").read_text(encoding="utf-8") == sheet.svg


def test_what_cannot_be_drawn_is_nan_and_told() -> None:
    board = tmm.Board()
    o = board.point("O", 0, 0)
    far = board.point("C", 200, 0)
    b = board.cross("B", board.strike("a", o, 50), board.strike("c", far, 40), +1)
    assert cmath.isnan(board.where(b))
    assert math.isnan(board.value(board.measure("OB", o, b)))
    (told,) = board.warnings
    assert told.startswith("Construction, step 3 'B': the arcs do not meet")
    assert ">B<" not in board.sheet().svg
    assert ">C<" in board.sheet().svg


def test_an_empty_board_has_no_picture() -> None:
    with pytest.raises(tmm.SheetError):
        tmm.Board().sheet()
    assert tmm.Board()._repr_html_() is None


def refused() -> list[tuple[object, type[Exception], str]]:
    board = tmm.Board()
    marks = linkage(board)
    o, a = marks["O"], marks["A"]
    line = board.join("l", o, a)
    return [
        (lambda: board.meet("Q", o, a), tmm.ConstructionError, r"takes \(Line, Line\)"),
        (lambda: board.join("m", 0, a), tmm.ConstructionError, "takes a mark here"),
        (lambda: board.draw("mett", "Q", line, line), tmm.AbsentError, 'did you mean "meet"'),
        (lambda: board.point("A", 1, 2), tmm.ConstructionError, "letter 'A' stands in this plan"),
        (lambda: board.value(a), tmm.ConstructionError, "is a point"),
        (lambda: board.where(line), tmm.ConstructionError, "is no figure"),
        (lambda: board.angle("φ", "three"), tmm.ConstructionError, "a number is wanted"),
        (lambda: board.angle("φ", [[1, 2]]), tmm.ConstructionError, "a number is wanted"),
        (lambda: [board.angle("φ", k * [1]) for k in (2, 3)], tmm.ConstructionError, "give as many"),
        (lambda: tmm.Board(hand="studnt"), tmm.AbsentError, 'did you mean "student"'),
        (lambda: tmm.Board(language="xx"), tmm.AbsentError, "there are"),
        (lambda: tmm.Board(trials=0), tmm.SheetError, "^trials"),
    ]  # fmt: skip


@each("ask, error, says", refused())
def test_what_a_board_does_not_take_is_refused(ask, error, says) -> None:
    with pytest.raises(error, match=says):
        ask()


@pytest.mark.slow
def test_formulas_of_chapters_are_known_whatever_was_done_before() -> None:
    """In a process that has drawn nothing: a known name takes other marks, another one is absent."""
    code = (
        "import graphic_tmm as tmm\n"
        "for name in ('mass_of_share', 'mass_of_shares'):\n"
        "    try:\n"
        "        tmm.Board().draw(name, 'm')\n"
        "    except tmm.TmmError as error:\n"
        "        print(type(error).__name__)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["ConstructionError", "AbsentError"]
