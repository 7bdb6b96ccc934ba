"""What the sentences of a note call things: no two by one name, lengths as a ruler tells them."""

from __future__ import annotations

import re

import pytest
from support.gallery import scene
from support.laid_out import drawn_case, note_of_case

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Side
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.note.document import (
    Formula,
    Number,
    Once,
    Paragraph,
    Ref,
    Run,
    Runs,
    Symbol,
    Table,
    Text,
    numbers,
)
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


def test_why_a_scale_factor_is_chosen_stands_beside_its_calculation() -> None:
    """No paragraph of reasons: the first words of a cell give the reason of what follows in it."""
    blocks = note_of_case(CASE).blocks
    table = next(one for one in blocks if isinstance(one, Table) and one.id == "table-scales")
    above = blocks[blocks.index(table) - 1]
    assert isinstance(above, Paragraph)
    assert sum(isinstance(run, Ref) for run in above.runs) == 1
    assert len(_words(above.runs)) < LINE
    reasoned = [cell for _, cell, _ in table.rows if _words(cell).count(".") > _formulas(cell)]
    assert len(reasoned) >= 4


LINE = 120
"""Letters of a line or two."""


def _words(runs: Runs) -> str:
    """The plain words of runs."""
    inside = (run.runs if isinstance(run, Once) else (run,) for run in runs)
    return "".join(run.text for some in inside for run in some if isinstance(run, Text))


def _formulas(cell: Runs) -> int:
    return sum(isinstance(run, Formula) for run in cell)


def test_lengths_are_told_as_the_ruler_reads_them() -> None:
    """To 0.1 mm, in the text and in tables."""
    lengths = [one for one in numbers(note_of_case(CASE)) if _is_length(one)]
    assert len(lengths) > 300
    assert {len(one.text.partition(",")[2]) for one in lengths if abs(one.value) >= 0.05} == {1}


def _is_length(one: Number) -> bool:
    if one.source.kind == "column":
        return one.source.factor == 0
    return one.unit == "mm" and one.source.kind in ("mark", "segment")


def test_what_is_read_in_the_text_stands_in_the_table() -> None:
    """A segment that a sentence reads off a plan has the same figure there, but for its sign."""
    rows = [row for one in note_of_case(CASE).blocks if isinstance(one, Table) for row in one.rows]
    read = dict(_reading(run) for row in rows for cell in row for run in cell if _is_reading(run))
    tabled = dict[str, set[str]]()
    for row in rows:
        if len(row) > 2 and row[1] == (Text("мм"),):
            figures = {run.text for cell in row[2:] for run in cell if isinstance(run, Number)}
            tabled.setdefault(_letter(row[0][0]), set()).update(figures)
    for name in ("BA", "pa3", "aa3", "pd", "k2a3"):
        assert read[name] in tabled[name], name


def _is_reading(run: Run) -> bool:
    sides = run.sides if isinstance(run, Formula) else ()
    return len(sides) == 2 and isinstance(sides[1], Number) and _is_length(sides[1])


def _reading(run: Run) -> tuple[str, str]:
    assert isinstance(run, Formula)
    letter, length = run.sides
    assert isinstance(length, Number)
    return _letter(letter), length.text.lstrip("−")


def _letter(side: object) -> str:
    return re.sub("[_{}]", "", side.markup) if isinstance(side, Symbol) else ""
