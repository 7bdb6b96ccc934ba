"""The section of a note on accuracy: it says what the answer says, in both languages, if it is asked for."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.tasks import answered

from graphic_tmm.__main__ import main
from graphic_tmm.accuracy.answer_text import costs, parts
from graphic_tmm.accuracy.note_section import accuracy_section
from graphic_tmm.note.document import Heading, Paragraph, ReadyPicture, Runs, Table, Text

SCENE = "slider-diagrams"


def words(runs: Runs) -> str:
    return "".join(run.text for run in runs if isinstance(run, Text))


@pytest.mark.parametrize(
    ("language", "head"), [("en", "Accuracy of the constructions"), ("ru", "Точность построений")]
)
@pytest.mark.slow
def test_sentences_sources_front_and_figure_stand_in_it(language: str, head: str) -> None:
    of = answered(SCENE, language)
    first, *blocks = accuracy_section(of)
    assert isinstance(first, Heading)
    assert words(first.runs) == head
    told = [words(one.runs) for one in blocks if isinstance(one, Paragraph)]
    assert told[:4] == list(costs(of))
    sources, front = (one for one in blocks if isinstance(one, Table))
    student = of.origins[0]
    assert student.hand == "student", "the scene's own hand leaves nothing to chance"
    assert len(sources.rows) == len(parts(student.of[of.worst]))
    assert len(front.rows) == len(of.rows)
    named = [k for k, row in enumerate(front.rows) if words(row[0])]
    assert named == [k for k, row in enumerate(of.rows) if row.way is of.own.way or row is of.knee]
    (figure,) = (one for one in blocks if isinstance(one, ReadyPicture))
    assert figure.svg.startswith("<svg")
    assert len(figure.svg.encode()) < 120_000


def test_a_main_quantity_has_a_column_of_its_own() -> None:
    """Where the worst quantity is not the one that the drawing is made for, both are told."""
    of = answered(SCENE, "en")
    other = next(name for name in of.own.errors if name != of.worst)
    errors = {name: error for name, error in of.own.errors.items() if name != other}
    of = replace(of, own=of.own._replace(errors={**errors, other: of.own.errors[other]}))
    sources = next(one for one in accuracy_section(of) if isinstance(one, Table))
    assert of.main == other
    assert len(sources.heads) == 3
    assert {len(row) for row in sources.rows} == {3}


@pytest.mark.slow
def test_a_note_has_it_only_if_it_is_asked_for(tmp_path: Path) -> None:
    def noted(*more: str) -> str:
        done = CliRunner().invoke(
            main, ["note", SCENE, "-l", "en", "-f", "md", "-o", str(tmp_path), *more]
        )
        assert done.exit_code == 0, done.output
        return (tmp_path / f"{SCENE}-note.md").read_text(encoding="utf-8")

    plain, more = noted(), noted("--accuracy")
    assert "Accuracy of the constructions" not in plain
    assert more.index("Accuracy of the constructions") < more.index("# Conclusions")
    assert more == noted("--accuracy"), "the same bytes"
    assert len(list(tmp_path.glob("*.svg"))) > 0
