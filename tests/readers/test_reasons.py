"""Why a step is done: told below it where it is asked for, in the language of the reader."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from support.command import invoke
from support.gallery import ALL, PLANS, drawn, made

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.findings import Finding
from graphic_tmm.board.operations.instruments import homologous, join, similar
from graphic_tmm.board.record import Board, Construction
from graphic_tmm.board.values import Point
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.catalogue import SOURCE, speaking
from graphic_tmm.readers.equations import Term, equations
from graphic_tmm.readers.findings import why_of
from graphic_tmm.readers.protocol import synthesis
from graphic_tmm.readers.sentences import calculation, reason

CYRILLIC = re.compile("[а-яё]")


def test_reasons_are_told_only_where_they_are_asked_for() -> None:
    plain = invoke("steps", "engine", "-p", "velocities").output
    told = invoke("steps", "engine", "-p", "velocities", "--why").output
    assert "Почему: " not in plain
    assert "Почему: " in told
    assert [line for line in told.splitlines() if "Почему: " not in line] == plain.splitlines()


def test_a_step_has_its_own_reason_before_that_of_its_operation() -> None:
    board = Board()
    board.open("plan")
    marks = [board.take(Point, letter) for letter in "abABS"]
    general = board.draw(similar, "s", *marks)
    own = board.draw(similar, "t", *marks, why="for {it} is wanted")
    steps = {step.it: step for step in board.construction().steps}
    assert steps[general].reason == similar.why != ""
    assert steps[own].reason == "for {it} is wanted"


def test_a_proportion_is_told_with_its_numbers() -> None:
    log, told = drawn("windrower").construction, 0
    reading = drawn("windrower").reading
    for step in log.steps:
        if step.op not in (similar, homologous) or step.it.view != "velocities":
            continue
        a, b, image = (complex(reading[m][0, -1]) for m in (*step.uses[:2], step.it))
        if step.op is similar:
            line = calculation(step, reading, reading.positions - 1, "en")
            length = abs(image - a)
            if abs(b - a) < 1e-9:
                assert line == ""  # the link stands still there: nothing is similar to it
                continue
            assert line.endswith(f" = {length:.4g} mm")
            assert f"{abs(b - a):.4g}·" in line
            told += 1
    assert told > 0


@pytest.mark.slow
@pytest.mark.parametrize(("name", "plan"), PLANS)
def test_terms_of_equations_know_the_ends_of_their_segments(name: str, plan: str) -> None:
    """Along each side the segments follow one another, from the pole to the point that is sought."""
    log = drawn(name).construction
    for equation in equations(log, plan):
        pole, point = equation.marks
        for side in equation.sides:
            assert [term.marks[0] for term in side[1:]] == [term.marks[1] for term in side[:-1]]
            assert side[0].marks[0] == pole
            assert side[-1].marks[1] == point
        if isinstance(equation.sought, Term):
            assert equation.sought.marks == (pole, point)


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_step_of_every_plan_has_a_reason(name: str, language: str) -> None:
    """Every kind of step: of whatever plan, whatever operation leaves whatever role."""
    speech = speaking(language)
    for log, reading in logs(name):
        for step in log.steps:
            kind = step.it.view, step.op.name, step.it.role
            assert step.reason, kind
            assert language == SOURCE or speech.knows(step.reason), (kind, step.reason)
            told = reason(step, language, reading, 0)
            assert told.endswith("."), told
            assert not set("{}#") & set(told), told
            assert bool(CYRILLIC.search(told)) == (language == "ru") or CYRILLIC.search(
                step.it.name
            ), told


def logs(name: str) -> Iterator[tuple[Construction, Reading]]:
    """Yield the logs of a scene: of its boards, of the choice of their scale factors, of its synthesis."""
    for board in made(name).boards:
        yield board.construction, board.numbers.drawn
        found = choices(board)
        yield found.construction, execute(found.construction, found.given)
    lengths = synthesis(made(name).scene)
    if lengths is not None:
        yield lengths.construction, execute(lengths.construction, lengths.given)


def test_letters_that_several_marks_have_are_told_once_and_plain() -> None:
    board = Board()
    board.open("plan")
    line = board.draw(join, "(e)", *(board.take(Point, letter) for letter in "ab"))
    other = board.draw(join, "(e)", *(board.take(Point, letter) for letter in "cd"))
    assert line.letter != other.letter
    (step, _) = board.construction().steps
    lost = Finding("lost", step, 1, (0,), 0.0, marks=(line, other))
    assert why_of(lost, speaking(SOURCE)).endswith("left out: (e)")
