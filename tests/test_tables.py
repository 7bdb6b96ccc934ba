"""Tables read off the log: millimetres times μ, rates with their sign, null where nothing is drawn."""

from __future__ import annotations

import csv
import io
import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from graphic_tmm.scene.read import read
from graphic_tmm.studio import fitted, table, table_columns
from graphic_tmm.tables import Column, as_csv, as_json, columns, rich_tables, segment_name
from graphic_tmm.work import Work

SHEETS = Path(__file__).parent.parent / "sheets"
NAMES = sorted(path.parent.name for path in SHEETS.glob("*/scene.toml"))
MU = {"positions": "mu_l", "velocities": "mu_v", "accelerations": "mu_a"}
COLUMN = Column("velocities", "pb", "pb", "m/s", (1.0, -0.0, None), (0.25, -0.0, None))


@cache
def drawn(name: str) -> Work:
    return fitted(read(SHEETS / name))


@cache
def document(name: str) -> dict[str, Any]:
    text = table(drawn(name), "json")
    assert isinstance(text, str)
    return json.loads(text)


@pytest.mark.parametrize(
    ("letter", "due"),
    [
        ("pb", "pb"),
        ("ps2", "ps2"),
        ("n_{ab}", "nab"),
        ("k_{aa3}", "kaa3"),
        ("πs2", "πs2"),
        ("ω_2", "omega2"),
        ("ε_{12}", "epsilon12"),
        ("l_{OA}", "lOA"),
    ],
)
def test_a_segment_is_named_by_its_letters(letter: str, due: str) -> None:
    assert segment_name(letter) == due


@pytest.mark.parametrize("name", NAMES)
def test_the_document_has_its_shape(name: str) -> None:
    made = document(name)
    assert list(made) == ["scene", "scales", "positions", "columns", "results"]
    assert made["scene"] == name
    assert set(made["results"]) == {"W", "formula"}
    assert made["results"]["W"] == 1
    for plan, scale in made["scales"].items():
        assert plan in MU.values()
        assert set(scale) == {"value", "unit"}
        assert scale["value"] > 0
    count = len(made["positions"])
    for place in made["positions"]:
        assert set(place) == {"number", "angle_deg"}
        assert isinstance(place["number"], str)
        assert 0 <= place["angle_deg"] < 360
    for one in made["columns"]:
        assert list(one) == ["plan", "segment", "unit", "mm", "value"]
        assert one["unit"] in {"m", "m/s", "m/s²", "1/s", "1/s²"}
        assert len(one["mm"]) == len(one["value"]) == count
    named = [(one["plan"], one["segment"]) for one in made["columns"]]
    assert len(named) == len(set(named))


@pytest.mark.parametrize("name", NAMES)
def test_a_value_is_its_segment_times_mu(name: str) -> None:
    made = document(name)
    for one in made["columns"]:
        if one["segment"].startswith(("omega", "epsilon")):
            assert one["mm"] == [None] * len(one["mm"])
            assert any(value is not None for value in one["value"])
            continue
        mu = made["scales"][MU[one["plan"]]]["value"]
        for mm, value in zip(one["mm"], one["value"], strict=True):
            assert (mm is None) == (value is None)
            if mm is not None:
                assert mm >= 0
                assert value == pytest.approx(mm * mu, rel=1e-11, abs=0)


@pytest.mark.parametrize("name", NAMES)
def test_accelerations_are_null_where_they_have_no_plan_and_nothing_else_is(name: str) -> None:
    made, places = document(name), drawn(name).project.accelerated
    for one in made["columns"]:
        there = [k for k, value in enumerate(one["value"]) if value is not None]
        due = places if one["plan"] == "accelerations" else range(len(made["positions"]))
        assert there == list(due), one["segment"]


def test_every_turning_link_has_its_rates_with_their_sign() -> None:
    made = {one["segment"]: one for one in document("engine")["columns"]}
    assert made["omega1"]["value"] == [50.0] * 12
    omega = made["omega2"]["value"]
    assert omega[0] < 0 < omega[6]  # the rod turns against the crank at the dead centre 1
    assert omega[3] == omega[9] == 0
    assert "omega3" not in made


def test_what_is_nothing_but_rounding_is_zero_and_has_no_sign() -> None:
    exact = table(fitted(read(SHEETS / "windrower"), exact=True), "json")
    assert isinstance(exact, str)
    rows = [one for one in json.loads(exact)["columns"] if one["plan"] == "velocities"]
    found = {one["segment"]: one["mm"] for one in rows}
    assert found["pd"][0] == found["pd"][-1] == 0
    assert "-0.0" not in exact
    every = [abs(mm) for one in rows for mm in one["mm"] if mm]
    assert min(every) > 1e-12 * max(every)


def test_columns_of_a_plan_that_was_not_drawn() -> None:
    made = drawn("engine")
    assert columns(made.project.construction, made.reading, "forces", [0], 12) == ()


def test_a_column_without_some_positions() -> None:
    made = COLUMN.without((0,))
    assert made.mm == made.value == (None, -0.0, None)
    assert COLUMN.without(()) is COLUMN


def test_json_keeps_text_tidies_figures_and_refuses_what_json_has_not() -> None:
    text = as_json('<"&\n', {}, [("7*", 1.5)], [COLUMN], {})
    made = json.loads(text)
    assert made["scene"] == '<"&\n'
    assert made["positions"] == [{"number": "7*", "angle_deg": 1.5}]
    assert made["columns"][0]["mm"] == [1.0, 0.0, None]
    assert "-0" not in text
    with pytest.raises(ValueError, match="JSON"):
        as_json("", {}, [], [COLUMN._replace(mm=(float("inf"), 0.0, 0.0))], {})


def test_twelve_digits_are_kept() -> None:
    made = json.loads(as_json("", {}, [], [COLUMN._replace(mm=(1 / 3, 0.1 + 0.2, None))], {}))
    assert made["columns"][0]["mm"] == [0.333333333333, 0.3, None]


@pytest.mark.parametrize("name", NAMES)
def test_csv_holds_what_json_holds(name: str) -> None:
    text = table(drawn(name), "csv")
    assert isinstance(text, str)
    rows = list(csv.DictReader(io.StringIO(text)))
    made = document(name)
    due = [
        (one["plan"], place["number"], one["segment"], mm, value, one["unit"])
        for one in made["columns"]
        for place, mm, value in zip(made["positions"], one["mm"], one["value"], strict=True)
        if value is not None
    ]
    found = [
        (
            row["plan"],
            row["position"],
            row["segment"],
            float(row["mm"]) if row["mm"] else None,
            float(row["value"]),
            row["unit"],
        )
        for row in rows
    ]
    assert sorted(found, key=str) == sorted(due, key=str)


def test_csv_quotes_what_would_break_its_lines() -> None:
    text = as_csv([('a,"b', 0.0), ("c", 1.0), ("d", 2.0)], [COLUMN])
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [row["position"] for row in rows] == ['a,"b', "c"]


def printed(*tables: Any) -> str:
    console = Console(file=io.StringIO(), width=200)
    for one in tables:
        console.print(one)
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


def test_a_table_for_people_says_what_the_scene_says_literally() -> None:
    text = printed(*rich_tables([COLUMN], ["1", "[red]2", "3"], "en", "[bold]T[/bold] [/]"))
    assert "[bold]T[/bold] [/]. Velocity plan" in text
    assert "[red]2" in text


def test_a_table_for_people_shows_only_positions_that_have_a_plan() -> None:
    text = printed(*rich_tables([COLUMN], ["1", "2", "3"], "ru", "T"))
    assert "План скоростей" in text
    head = next(line for line in text.splitlines() if "Отрезок" in line)
    assert [word for word in head.replace("┃", " ").split() if word.isdigit()] == ["1", "2"]
    assert "1,0" in text
    assert "0,25" in text
    assert "−0" not in text


def test_text_and_figures_of_a_scene_agree() -> None:
    parts = table(drawn("engine"), "text")
    assert isinstance(parts, list)
    text = printed(*parts)
    due = next(c for c in table_columns(drawn("engine")) if c.segment == "pb").mm
    row = next(line for line in text.splitlines() if line.split()[1:2] == ["pb"])
    cells = [cell.strip() for cell in row.strip("│").split("│")][2:]
    assert cells == [f"{mm:.1f}".replace(".", ",") for mm in due if mm is not None]
