"""What is drawn says in Python what the commands print: tables, results, scales, steps, sheets, pages."""

from __future__ import annotations

import base64
import hashlib
import math
import pickle
from pathlib import Path

import numpy as np
import pytest
from support.command import invoke, printed, tabled
from support.drives import BOOM, scene
from support.each import each
from support.gallery import EVERYDAY, SHEETS

import graphic_tmm as tmm
from graphic_tmm.face import work
from graphic_tmm.studio import sheet_files

NAME = "crank-rocker"


def tidy(x: float) -> float | None:
    return None if math.isnan(x) else float(f"{x:.12g}") + 0.0


def told(drawn: tmm.Drawn, trial: int = 0) -> list[dict[str, object]]:
    """What the command writes as JSON, put together from the arrays."""
    return [
        {
            "plan": plan,
            "segment": name,
            "unit": one.unit,
            "positions": list(one.positions),
            "mm": [tidy(x) for x in one.mm[trial]],
            "value": [tidy(x) for x in one.value[trial]],
        }
        for plan in drawn.tables
        for name, one in drawn.table(plan).items()
    ]


@each("name", EVERYDAY)
@pytest.mark.slow
def test_tables_results_and_scales_are_those_of_the_command(name) -> None:
    due, drawn = tabled(name), tmm.draw(name)
    columns = {(one["plan"], one["segment"]): one for one in due["columns"]}
    assert len(columns) == len(due["columns"])
    assert {(one["plan"], one["segment"]): one for one in told(drawn)} == columns
    results = {key: {"value": one.value, "unit": one.unit} for key, one in drawn.results.items()}
    printed = {
        key: {name: one[name] for name in ("value", "unit")} if isinstance(one, dict) else one
        for key, one in due["results"].items()
    }
    told_bare = {key: {"value": one, "unit": ""} for key, one in printed.items() if key == "W"}
    assert {**drawn.facts, **results} == {**printed, **told_bare}
    scales = {key: {"value": one.value, "unit": one.unit} for key, one in drawn.scales.items()}
    assert scales == due["scales"]


def test_another_hand_and_exact_figures_are_those_of_the_command() -> None:
    hand = tmm.draw(NAME, hand="student", seed=7)
    assert told(hand) == tabled(NAME, "--hand", "student", "--seed", "7")["columns"]
    assert told(tmm.draw(NAME, exact=True)) == tabled(NAME, "--exact")["columns"]


def test_angles_run_along_the_positions() -> None:
    table = tmm.draw(NAME).table("velocities")
    due = tabled(NAME)["positions"]
    assert list(table.positions) == [one["number"] for one in due]
    assert table.angles == pytest.approx([one["angle_deg"] for one in due])


@pytest.mark.slow
def test_many_drawings_are_arrays_of_which_the_first_is_that_of_one() -> None:
    one = tmm.draw(NAME, hand="student", seed=7)
    many = tmm.draw(NAME, hand="student", seed=7, trials=1200)
    assert told(many) == told(one)
    ab = many.table("velocities")["ab"]
    assert ab.value.shape == ab.mm.shape == (1200, len(ab))
    assert ab.at(1).trials.shape == (1200,)
    due = {
        row["segment"]: row
        for row in tabled(NAME, "--hand", "student", "--seed", "7", "--trials", "1200")["columns"]
        if row["plan"] == "velocities"
    }
    assert np.median(ab.value, axis=0) == pytest.approx(due["ab_median"]["value"], rel=1e-9)
    records = many.table("velocities").to_records()
    assert len(records) == sum(
        np.isfinite(one.value).sum() for one in many.table("velocities").values()
    )
    assert records[1]["trial"] == 0
    assert records[-1]["trial"] == 1199


def test_results_hold_every_drawing() -> None:
    found = tmm.draw("planetary", hand="student", trials=20).results
    assert found
    assert all(one.trials.shape == (20,) and one.value == one.trials[0] for one in found.values())


def test_records_are_the_rows_of_the_csv() -> None:
    table = tmm.draw("engine", exact=True).table("velocities")
    lines = printed("table", "engine", "-f", "csv", "--exact", "-l", "en").splitlines()
    due = [line.split(",") for line in lines[1:] if line.startswith("velocities,")]
    records = table.to_records()
    assert list(records[0]) == lines[0].split(",")
    assert [(one["position"], one["segment"], one["unit"]) for one in records] == [
        (row[1], row[3], row[6]) for row in due
    ]
    assert [one["value"] for one in records] == pytest.approx([float(row[5]) for row in due])
    assert [one["mm"] is None for one in records] == [not row[4] for row in due]


def test_nothing_is_laid_out_for_figures(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*args: object, **options: object) -> None:
        raise AssertionError("a sheet was laid out")

    monkeypatch.setattr(work, "composed_sheets", refuse)
    drawn = tmm.draw(NAME)
    assert drawn.tables
    assert drawn.steps("velocities", 1)
    assert drawn.warnings == ()
    with pytest.raises(AssertionError, match="laid out"):
        _ = drawn.sheets


@each(
    "plan, position, why",
    [("accelerations", 2, True), ("all", None, False), ("scales", None, False)],
)
def test_steps_print_as_the_command_does(plan, position, why) -> None:
    options = [*([] if position is None else ["-n", position]), *(["--why"] if why else [])]
    due = printed("steps", NAME, "-p", plan, *options)
    steps = tmm.draw(NAME).steps(plan, position, why=why)
    assert f"{steps}\n" == due
    assert [step for part in steps.parts for step in part.steps] == list(steps)


def test_a_step_knows_its_figure() -> None:
    steps = tmm.draw(NAME, exact=True).steps("velocities", 1)
    table = tmm.draw(NAME, exact=True).table("velocities")
    measured = {one.letter: one for one in steps if one.text == f"Measure {one.letter}."}
    assert measured
    for letter, step in measured.items():
        assert step.unit == "mm"
        assert step.value == pytest.approx(
            table[letter].mm[0, table.positions.index("1")], rel=1e-12
        )
    assert steps[0].number == 0
    assert steps[0].value is None
    assert steps[1:3] == (steps[1], steps[2])


@each("name", ["lettering", NAME])
@pytest.mark.slow
def test_sheets_are_those_of_the_command_to_the_byte(name, tmp_path) -> None:
    due = sheet_files(tmm.read(name))[1]
    written = tmm.draw(name).save(tmp_path / f"{name}.svg")
    assert {file.name: file.read_text(encoding="utf-8") for file in written} == due
    sheets = tmm.draw(name).sheets
    assert [one.svg for one in sheets] == list(due.values())
    assert [f"{one.width:g}mm" in one.svg for one in sheets] == [True] * len(sheets)


@pytest.mark.slow
def test_a_page_a_pdf_and_a_note_are_files_as_the_commands_write_them(tmp_path: Path) -> None:
    drawn = tmm.draw("slider-diagrams")
    printed("draw", "slider-diagrams", "-f", "html,pdf", "-o", tmp_path / "due")
    printed("note", "slider-diagrams", "-f", "md", "-o", tmp_path / "due")
    for name in ("slider-diagrams.html", "slider-diagrams.pdf"):
        (file,) = drawn.save(tmp_path / "made" / name)
        assert digest(file) == digest(tmp_path / "due" / name), name
    files = drawn.note(tmp_path / "made" / "slider-diagrams-note.md")
    assert [digest(file) for file in files] == [
        digest(tmp_path / "due" / file.name) for file in files
    ]


def digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def test_warnings_are_those_of_the_command(tmp_path: Path) -> None:
    text = (SHEETS / NAME / "scene.toml").read_text(encoding="utf-8")
    assert text.count('C = ["60 mm"') == 1
    (tmp_path / "scene.toml").write_text(
        text.replace('C = ["60 mm"', 'C = ["95 mm"'), encoding="utf-8"
    )
    drawn = tmm.draw(tmp_path)
    assert any("cannot be drawn" in text for text in drawn.warnings)
    assert [f"{tmp_path / 'scene.toml'}: warning: {text}" for text in drawn.warnings] == [
        line.removeprefix("graphic-tmm: ") for line in invoke("table", tmp_path).stderr.splitlines()
    ]
    assert tmm.draw(NAME).warnings == ()


@each(
    "ask, error, says",
    [
        (lambda: tmm.draw(NAME, hand="studnt"), tmm.AbsentError, 'did you mean "student"'),
        (lambda: tmm.draw(NAME, seed=-1), tmm.SheetError, "^seed: a number from 0 to"),
        (lambda: tmm.draw(NAME, trials=0), tmm.SheetError, "^trials: a number from 1 to"),
        (lambda: tmm.draw(NAME, exact=True, trials=2), tmm.SheetError, "leave out trials"),
        (lambda: tmm.draw(NAME).table("velocity"), tmm.AbsentError, 'did you mean "velocities"'),
        (lambda: tmm.draw(NAME).table("velocities")["pz"], tmm.AbsentError, "there are pa, ab"),
        (
            lambda: tmm.draw(NAME).table("velocities")["pa"].at(99),
            tmm.AbsentError,
            "there are 0, 1",
        ),
        (lambda: tmm.draw(NAME).results["J"], KeyError, "there are W"),
        (lambda: tmm.draw(NAME).steps("velocitys"), tmm.AbsentError, 'did you mean "velocities"'),
        (lambda: tmm.draw(NAME).steps("forces"), tmm.AbsentError, "the scene has no plan forces"),
        (lambda: tmm.draw(NAME).steps("velocities", 99), tmm.AbsentError, "there is no 99"),
        (lambda: tmm.draw(NAME).save("x.gif"), tmm.SheetError, "x.gif: .*one of .svg, .pdf"),
        (lambda: tmm.draw(NAME).note("x.svg"), tmm.SheetError, "x.svg: .*one of .pdf"),
        (lambda: tmm.draw(NAME).sheets[0].save("sheet"), tmm.SheetError, "sheet: .*one of .svg"),
    ],
)
def test_what_is_not_there_is_refused_with_what_was_meant(ask, error, says) -> None:
    with pytest.raises(error, match=says):
        ask()


def test_a_notebook_shows_tables_steps_and_sheets() -> None:
    drawn = tmm.read(NAME).with_(title="<b>A & B</b>")
    shown = tmm.draw(drawn)
    table = shown.table("velocities")
    assert "&lt;b&gt;A &amp; B&lt;/b&gt;" in table._repr_html_()
    assert table._repr_html_().count("<tr>") == 1 + len(str(table).splitlines()) - 2
    assert "<script" not in shown.steps("velocities")._repr_html_()
    assert "Calculate pa." in shown.steps("velocities", 1)._repr_html_()
    sheet = shown.sheets[0]
    image = sheet._repr_html_()
    assert "max-width:100%" in image
    assert 'alt="&lt;b&gt;A &amp; B&lt;/b&gt;' in image
    assert base64.b64decode(image.rpartition("base64,")[2].partition('"')[0]).decode() == sheet.svg


def test_what_is_drawn_goes_to_another_process() -> None:
    drawn = tmm.draw(NAME, hand="student", seed=3)
    _ = drawn.tables
    assert told(pickle.loads(pickle.dumps(drawn))) == told(drawn)
    table = drawn.table("velocities")
    for one in (
        drawn.steps("velocities", 1),
        table,
        drawn.results,
        drawn.scales["mu_l"],
        drawn.facts,
    ):
        assert repr(pickle.loads(pickle.dumps(one))) == repr(one)


def test_the_composition_beside_a_file_is_used(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text((SHEETS / NAME / "scene.toml").read_text(encoding="utf-8"))
    printed("draw", tmp_path, "-o", tmp_path / "due", "--composition")
    kept = (tmp_path / "due" / "composition.toml").read_text(encoding="utf-8")
    (tmp_path / "composition.toml").write_text(
        kept.replace('"velocities" = ', '"velocities" = 40.0  # ', 1)
    )
    by_command = tabled(tmp_path)
    assert told(tmm.draw(tmp_path)) == by_command["columns"]
    assert by_command["scales"] != tabled(NAME)["scales"]


def test_a_drive_that_slides_has_lengths() -> None:
    table = tmm.draw(scene(BOOM)).table("velocities")
    assert table.lengths == pytest.approx(np.linspace(0.6, 0.85, 6))
    assert np.isnan(table.angles).all()
    first = table.to_records()[0]
    assert first["length_m"] == pytest.approx(0.6)
    assert "angle_deg" not in first
    assert np.isnan(tmm.draw("crank-rocker").table("velocities").lengths).all()
