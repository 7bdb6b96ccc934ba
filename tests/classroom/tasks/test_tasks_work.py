"""Tasks and keys as pieces of work: apart from one another, of the variant's own values, the same each time."""

from __future__ import annotations

import csv
import pickle
import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner
from support import sheet_reader
from support.command import invoke, printed
from support.command import rows as csv_rows
from support.gallery import SHEETS

from graphic_tmm.__main__ import main
from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.start import start_of
from graphic_tmm.classroom.variants.variant import Value, Variant, base
from graphic_tmm.errors import SceneError

VARIANTS = (
    Variant("7", (Value("OA", "112"), Value("drive.speed", "67")), 2),
    Variant("8а", (Value("OA", "104"),), 3),
)
BASE = base(SHEETS / "shaper")
once = cache(done)


@cache
def start() -> str:
    return start_of(BASE)


def texts(files: object) -> str:
    assert isinstance(files, dict)
    found = [sheet_reader.views(str(svg)) for svg in files.values()]
    return " ".join(word for view in found for one in view.values() for word in one.words)


@pytest.mark.slow
def test_tasks_and_keys_stand_in_folders_of_their_own() -> None:
    found = works(BASE, VARIANTS)
    assert [work.name for work in found] == ["tasks/7", "keys/7", "tasks/8а", "keys/8а"]
    for work in found:
        folder = work.name if work.name.startswith("keys/") else "tasks"
        files = once(work).files
        assert files
        assert all(name.startswith(f"{folder}/") for name in files)
    assert [work.name for work in works(BASE, VARIANTS, keys=())] == ["tasks/7", "tasks/8а"]


@pytest.mark.slow
def test_a_task_tells_the_values_of_its_variant() -> None:
    first, second = (texts(once(work).files) for work in works(BASE, VARIANTS, keys=()))
    assert "Вариант 7" in first
    assert " 112 " in first
    assert " 67 " in first
    assert " 67 " not in second
    assert " 104 " in second


@pytest.mark.slow
def test_a_key_holds_the_scene_of_its_variant() -> None:
    key = works(BASE, VARIANTS[:1], keys=("table",), start=start())[1]
    files = once(key).files
    doc = tomllib.loads(str(files["keys/7/scene.toml"]))
    assert doc["lengths"]["OA"] == "112 mm"
    assert str(doc["drive"]["speed"]).startswith("67")
    names = ("composition.toml", "scene.toml", "shaper-7.csv")
    assert sorted(files) == [f"keys/7/{name}" for name in names]
    # it travels, and comes to the same
    assert done(pickle.loads(pickle.dumps(key))) == once(key)


@pytest.mark.slow
@pytest.mark.parametrize("begun", [True, False])
def test_a_key_is_what_the_commands_make_of_its_scene(begun: bool, tmp_path: Path) -> None:
    key = works(BASE, VARIANTS[:1], start=start() if begun else "")[1]
    files = once(key).files
    for name in ("scene.toml", "composition.toml"):
        (tmp_path / name).write_text(str(files[f"keys/7/{name}"]), encoding="utf-8")
    assert printed("table", tmp_path, "-f", "csv") == files["keys/7/shaper-7.csv"]
    printed("draw", tmp_path, "-o", tmp_path / "out")
    drawn = [one.read_text(encoding="utf-8") for one in sorted((tmp_path / "out").iterdir())]
    assert drawn == [text for name, text in sorted(files.items()) if name.endswith(".svg")] != []


def test_a_value_that_cannot_be_set_is_told_with_its_variant() -> None:
    with pytest.raises(SceneError, match="OZ"):
        works(BASE, (Variant("1", (Value("OZ", "1"),), 5),), "table.csv")


@pytest.mark.slow
def test_the_command_writes_tasks_and_keys_of_a_table(tmp_path: Path) -> None:
    table = tmp_path / "class.csv"
    table.write_text("variant,drive.speed\n1,12 1/s\n2,14 1/s\n", encoding="utf-8")
    out = tmp_path / "out"
    told = printed("task", "scotch-yoke", table, "-o", out, "--keys", "table", "-j", "0")
    assert told.split() == [str(out / "tasks"), str(out / "keys")]
    assert sorted(one.name for one in (out / "keys").iterdir()) == ["1", "2"]
    assert {one.name[0] for one in (out / "tasks").iterdir()} == {"1", "2"}
    assert {one.suffix for one in (out / "tasks").iterdir()} == {".svg"}


def test_a_bad_variant_is_told_at_its_line_and_nothing_is_written(tmp_path: Path) -> None:
    table = tmp_path / "class.csv"
    table.write_text("variant,drive.turns\n1,clockwise\n2,sideways\n", encoding="utf-8")
    found = invoke("task", "scotch-yoke", table, "-o", tmp_path / "out", "-l", "en")
    assert found.exit_code == 2
    assert f"{table}:3: drive.turns" in found.output
    assert not (tmp_path / "out").exists()


def test_the_command_makes_the_task_of_a_scene_itself(tmp_path: Path) -> None:
    out = tmp_path / "out"
    printed("task", "scotch-yoke", "-o", out, "--keys", "none", "-l", "en", "-j", "0")
    (file,) = (out / "tasks").iterdir()
    assert file.name == "scotch-yoke.svg"
    assert "To be drawn" in texts({file.name: file.read_text(encoding="utf-8")})
    assert not (out / "keys").exists()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("shaper", "-f", "dxf"), "--format: no dxf"),
        (("shaper", "--keys", "answers"), "--keys: no answers"),
        (("shaper", "--keys", "note", "--note", "odt"), "--note: no odt"),
        (("no-such-scene",), "no-such-scene"),
        (("shaper", "no-such-table.csv"), "no-such-table.csv"),
    ],
)
def test_what_cannot_be_done_is_told_and_nothing_is_written(
    arguments: tuple[str, ...], told: str, tmp_path: Path
) -> None:
    found = invoke("task", *arguments, "-o", tmp_path / "out", "-l", "en")
    assert found.exit_code == 2
    assert told in found.output
    assert not (tmp_path / "out").exists()


def test_a_scene_on_standard_input_is_read_once(tmp_path: Path) -> None:
    text = (SHEETS / "scotch-yoke" / "scene.toml").read_text(encoding="utf-8")
    out = tmp_path / "out"
    arguments = ["task", "-", "-o", str(out), "--keys", "none", "-j", "0"]
    found = CliRunner().invoke(main, arguments, input=text)
    assert found.exit_code == 0, found.output
    assert [one.name for one in (out / "tasks").iterdir()] == ["scene.svg"]


@pytest.mark.slow
def test_a_table_of_readings_goes_out_with_the_scales_of_the_key() -> None:
    """What it tells of the scale factors stands on the task, and by them the key is drawn."""
    task, key = works(BASE, VARIANTS[:1], keys=("table",), start=start(), readings=True)
    files = {**done(task).files, **once(key).files}
    (table,) = (str(text) for name, text in files.items() if name == "tasks/7-отсчёты.csv")
    told = re.findall(r"1 мм изображает ([\d,]+) (\S+)", table)
    assert len(told) == 3
    words = texts({name: text for name, text in files.items() if name.endswith(".svg")})
    for value, unit in told:
        assert f"= {value} " in words, (value, unit)
    lengths = csv_rows(str(files["keys/7/shaper-7.csv"]))
    longest = max(
        (row for row in lengths if row["segment"] == "pd"), key=lambda row: float(row["mm"])
    )
    mu = float(longest["value"]) / float(longest["mm"])
    assert mu == pytest.approx(float(told[1][0].replace(",", ".")), rel=2e-3)
    rows = [
        row for row in csv.reader(table.splitlines(), delimiter=";") if row[0][:1] not in "#\ufeff"
    ]
    assert len(rows) > 8
    assert {row[3] for row in rows} == {"мм", ""}
