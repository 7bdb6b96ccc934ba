"""The command line of accuracy and of budgets, and tables of minutes."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from support.command import invoke
from support.each import each

from graphic_tmm.accuracy.cost import MINUTES
from graphic_tmm.accuracy.geometrography import read_minutes
from graphic_tmm.errors import SceneError


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_accuracy_prints_json_and_draws_the_figure(tmp_path: Path) -> None:
    file = tmp_path / "minutes.toml"
    file.write_text("".join(f"{name} = 0\n" for name in MINUTES if name != "N1") + "N1 = 2.0\n")
    found = invoke(
        *("accuracy", "cam", "--trials", "10", "--no-time", "-f", "json"),
        *("-o", tmp_path / "out", "--minutes", file),
    )
    assert found.exit_code == 0, found.output
    told = json.loads(found.stdout)
    assert told["scene"] == "cam"
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "cam-accuracy.json",
        "cam-accuracy.svg",
        "cam-accuracy.png",
    }
    for one in told["runs"]:
        formulas = sum(
            int(t.removesuffix("N1") or 1) for t in one["symbol"].split(" + ") if "N1" in t
        )
        assert one["minutes"] == 2.0 * formulas


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_the_exact_hand_s_runs_along_the_number_of_positions_are_timed() -> None:
    """And what a user asks for."""
    found = invoke("accuracy", "oscillating-cylinder", "--trials", "10", "-f", "json")
    assert found.exit_code == 0, found.output
    told = json.loads(found.stdout)
    timed = [one for one in told["runs"] if "seconds" in one]
    assert {(one["hand"], one["axis"]) for one in timed} >= {("exact", "positions")}
    assert not any(one["hand"] == "student" for one in timed)
    for one in timed:
        low, high = one["seconds_quartiles"]
        assert 0.0 < one["seconds"] <= low <= high
    assert {one["what"] for one in told["machine"]} == {"log", "table", "sheets", "drawings"}


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_accuracy_without_time_speaks_of_no_seconds() -> None:
    found = invoke("accuracy", "cam", "--trials", "10", "--no-time")
    assert found.exit_code == 0, found.output
    assert "r₀ min кулачка" in found.stdout
    assert "квартили" not in found.stdout


@each(
    "text, words",
    [
        ("R9 = 1.0", ["R9", "no such elementary operation", "R1"]),
        ("R1 = -1", ["R1", "a number 0 to 1000000"]),
        ("R1 = true", ["R1", "a number 0 to 1000000"]),
        ("R1 = inf", ["R1", "a number 0 to 1000000"]),
        ('R1 = "long"', ["R1", "a number 0 to 1000000"]),
        ("R1 =", [":1: R1: ", "not TOML", "a value is missing"]),
        ("R1 = " + "9" * 5000, ["a value cannot be read"]),
        (f"R1 = {10**400}", ["R1", "a number 0 to 1000000"]),
        ("R1 = " + "[" * 5000, ["nested too deep"]),
        ("R1 = " + "[" * 20 + "]" * 20, ["nested too deep"]),
        ("R1." * 3000 + "R1 = 1", ["nested too deep"]),
        ("# \xff", ["not in UTF-8"]),
    ],
)
def test_a_table_of_minutes_is_refused_with_its_key(
    tmp_path: Path, text: str, words: list[str]
) -> None:
    file = tmp_path / "minutes.toml"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(SceneError) as refused:
        read_minutes(str(file))
    assert all(word in str(refused.value) for word in [*words, str(file)])
    found = invoke("accuracy", "cam", "--minutes", file)
    assert found.exit_code == 2
    assert "Traceback" not in found.output


def test_a_table_of_minutes_that_is_not_there_is_told(tmp_path: Path) -> None:
    found = invoke("accuracy", "cam", "--minutes", tmp_path / "none.toml")
    assert found.exit_code == 2
    assert "none.toml" in found.stderr


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_a_table_within_a_budget_says_which_setting_was_taken() -> None:
    found = invoke("table", "slider-diagrams", "--budget", "3%", "-f", "json")
    assert found.exit_code == 0, found.output
    told = json.loads(found.stdout)
    taken = re.search(r"допуск 3 %: (\d+) положений", found.stderr)
    assert taken
    columns = {c["segment"]: c["value"] for c in told["columns"] if c["plan"] == "diagrams"}
    assert len(columns["V"]) == int(taken[1])


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_a_sheet_within_a_budget_is_drawn(tmp_path: Path) -> None:
    found = invoke("draw", "cam", "--budget", "0,5 %", "-o", tmp_path / "out")
    assert found.exit_code == 0, found.output
    assert "6 частей" in found.stderr
    assert (tmp_path / "out" / "cam.svg").exists()


@pytest.mark.parametrize("budget", ["0", "-1%", "two", "", "nan"])
def test_a_budget_is_a_percentage(budget: str, tmp_path: Path) -> None:
    found = invoke("draw", "cam", f"--budget={budget}", "-o", tmp_path / "out")
    assert found.exit_code == 2
    assert "--budget 2%" in found.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_a_budget_that_nothing_keeps_draws_nothing(tmp_path: Path) -> None:
    found = invoke("draw", "cam", "--budget", "0.0001%", "-o", tmp_path / "out")
    assert found.exit_code == 2
    assert "ничто из испытанного" in found.stderr
    assert not (tmp_path / "out").exists()


def test_a_study_of_nothing_is_refused() -> None:
    found = invoke("accuracy", "lettering")
    assert found.exit_code == 2
    assert "lettering" in found.stderr


def test_the_package_is_imported_without_matplotlib_and_rich() -> None:
    code = (
        "import sys, graphic_tmm, graphic_tmm.__main__\n"
        "sys.exit(any(m in sys.modules for m in ('matplotlib', 'rich', 'graphic_tmm.accuracy')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.slow
def test_nearest_draws_the_best_where_nothing_keeps_a_budget(tmp_path: Path) -> None:
    found = invoke("draw", "cam", "--budget", "0.0001%", "--nearest", "-o", tmp_path / "out")
    assert found.exit_code == 0, found.output
    assert "ближе всего" in found.stderr
    assert "Мешает" in found.stderr
    assert (tmp_path / "out" / "cam.svg").exists()


@pytest.mark.turns(2, "budgets")
@pytest.mark.slow
def test_the_runs_are_a_table_for_a_spreadsheet() -> None:
    found = invoke("accuracy", "cam", "--trials", "10", "--no-time", "-f", "csv")
    assert found.exit_code == 0, found.output
    rows = list(csv.DictReader(found.stdout.splitlines()))
    assert {row["hand"] for row in rows if row["axis"] == "parts"} >= {"exact", "student"}
    assert all(float(row["minutes"]) > 0.0 for row in rows)
    refused = invoke("accuracy", "cam", "--effects", "-f", "csv")
    assert refused.exit_code == 2


def test_nearest_without_a_budget_is_refused(tmp_path: Path) -> None:
    found = invoke("draw", "cam", "--nearest", "-o", tmp_path / "out")
    assert found.exit_code == 2
    assert "--budget" in found.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_the_answer_comes_first_in_lines_of_eighty_characters_and_a_short_table() -> None:
    found = invoke("accuracy", "slider-diagrams", "--no-time")
    assert found.exit_code == 0, found.output
    lines = found.stdout.splitlines()
    assert max(map(len, lines)) <= 80
    text = " ".join(lines)
    places = [text.index(word) for word in ("Этот чертёж", "Вдвое точнее", "Не окупается")]
    assert places == sorted(places)
    rows = [line for line in lines if re.match(r"[●◆ ]{1,3} +\d+ ", line)]
    assert 3 <= len(rows) <= 12
    assert sum("●" in row for row in rows) == 1
    assert all(mark in text for mark in ("● как в задании", "◆ перелом", "× во сколько раз"))


def test_hard_cases_are_printed_and_written(tmp_path: Path) -> None:
    found = invoke("accuracy", "offset-slider", "--hard", "-o", tmp_path)
    assert found.exit_code == 0, found.output
    assert max(map(len, found.stdout.splitlines())) <= 80
    assert (tmp_path / "offset-slider-hard.txt").read_text("utf-8") == found.stdout
    told = invoke("accuracy", "offset-slider", "--hard", "-f", "json")
    assert [place["kind"] for place in json.loads(told.stdout)["places"]] == ["still", "still"]


def test_hard_cases_of_a_scene_without_a_mechanism_are_refused() -> None:
    found = invoke("accuracy", "gear-pair", "--hard")
    assert found.exit_code == 2
    assert "--hard" in found.stderr
    assert not found.stdout
