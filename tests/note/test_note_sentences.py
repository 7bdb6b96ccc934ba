"""What the sentences of a note call things: no two by one name, lengths as a ruler tells them."""

from __future__ import annotations

import pytest
from support.gallery import scene
from support.laid_out import drawn_case

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Side
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.readers.sentences import phrase
from graphic_tmm.studio import make

CASE = "slotting"


def _namesakes(drawn: DrawnScene) -> list[str]:
    """Sentences in which two lines, points or lengths of one drawing have one name."""
    found = []
    for board in drawn.boards:
        for step in board.construction.steps:
            reading = board.of(step.it.view)
            if reading is not None and not step.op.formula and _shared(step):
                template, words = phrase(step, "ru", reading, 0)
                found.append(f"{step.it.view}: {template.format(**words)}")
    return found


def _shared(step: Step) -> bool:
    marks = {mark.slot: mark for mark in (step.it, *step.uses) if _is_named(mark, step)}
    names = [(mark.name, mark.kind) for mark in marks.values()]
    return len(set(names)) < len(names)


def _is_named(mark: Mark, step: Step) -> bool:
    return bool(mark.name) and mark.kind is not Side and mark.view == step.it.view


def test_no_sentence_calls_two_things_by_one_name() -> None:
    assert _namesakes(drawn_case(CASE)) == []


@pytest.mark.parametrize("name", ["engine", "project", "slider-diagrams"])
def test_no_sentence_of_the_package_does(name: str) -> None:
    assert _namesakes(make(scene(name))) == []
