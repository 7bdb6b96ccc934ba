"""What the task of a note says besides its table: in words, from the scene alone; nothing that is found."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import in_usual, scene
from support.scenes import edited

from graphic_tmm.note.document import Symbol, Table
from graphic_tmm.note.section_task import given_table
from graphic_tmm.readers.task_sheet import TaskSheet, given_rows
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene


def stated(asked: Scene, language: str) -> list[str]:
    return [one for chapter in chapters() for one in TaskSheet.of(chapter).stated(asked, language)]


def test_the_task_of_the_project_is_told_in_words_as_its_document_does() -> None:
    assert stated(scene("project"), "ru") == [
        "За начало отсчёта принято крайнее левое положение точки D.",
        "Планы ускорений строятся в положениях 2, 6, 8.",
        "Учитываются силы тяжести и силы инерции звеньев.",
        "Силовой расчёт выполняется в положении 8.",
        "Толкатель центральный, роликовый.",
        "Зацепление неравносмещённое, сумма коэффициентов смещения положительна.",
    ]


@pytest.mark.parametrize(
    ("shifts", "told"),
    [
        ((0.0, 0.0), "without shift"),
        ((0.3, -0.3), "equal and opposite"),
        ((0.3, 0.1), "sum is positive"),
        ((0.3, -0.4), "sum is negative"),
    ],
)
def test_shifts_tell_the_kind_of_meshing(
    shifts: tuple[float, float], told: str, tmp_path: Path
) -> None:
    lines = {line.split("=")[0].strip(): line for line in _text("gear-pair").splitlines()}
    edits = [(lines[f"x{k}"], f"x{k} = {x}") for k, x in enumerate(shifts, 1)]
    (one,) = stated(read(edited(tmp_path, *edits, name="gear-pair")), "en")
    assert told in one


def _text(name: str) -> str:
    return Path(scene(name).source).read_text(encoding="utf-8")


def test_a_scene_that_asks_for_nothing_special_says_nothing() -> None:
    assert stated(scene("slider-diagrams"), "ru") == []


def test_lengths_that_the_synthesis_finds_are_not_given() -> None:
    table = given_table(in_usual("windrower"), "ru")
    assert isinstance(table, Table)
    told = {
        run.markup for row in table.rows for cell in row for run in cell if isinstance(run, Symbol)
    }
    assert {"K_v", "l_{OB}", "l_{CD}"} <= told
    assert not told & {"l_{OA}", "l_{BC}"}


def test_the_task_of_a_gripper_tells_where_its_rod_is_counted_from_and_where_forces_act() -> None:
    """Without both nobody else could draw it."""
    told = stated(scene("gripper"), "en")
    assert "s is counted along x; K stands at s = 60 mm." in told
    assert "F_3 acts at E of link 3, at the angle 90° to the x axis." in told
    assert "F_5 acts at D of link 5, at the angle −90° to the x axis." in told


def test_the_stroke_of_a_rod_is_called_by_both_its_pins() -> None:
    """Of two cylinders a letter without an index tells neither."""
    names = [one.symbol for one in given_rows(scene("excavator"))]
    assert "l_{GN}" in names
    assert "l" not in names
