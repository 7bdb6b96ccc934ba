"""Tables read off the log: millimetres times μ, rates with their sign, null where nothing is drawn."""

from __future__ import annotations

import csv
import io
import json
import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console
from support import gallery
from support.boards import in_usual_size
from support.columns import along
from support.command import column, invoke, tabled
from support.command import rows as csv_rows
from support.gallery import NAMES, drawn
from support.scenes import edited

from graphic_tmm.board.record import segment_name
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import plan_columns
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import columns_of, table
from graphic_tmm.readers.text import text_tables
from graphic_tmm.readers.writing import as_csv, as_json
from graphic_tmm.scene.chapter import MECHANISM, places
from graphic_tmm.scene.read import read

OWN_BOARDS = {name for name, (one, _) in places().items() if one.board not in ("", MECHANISM)}
ALONE = [name for name in NAMES if not gallery.scene(name).called & OWN_BOARDS]
"""Scenes of a mechanism alone: what stands on a board of its own has its own positions and scales."""
GRAPHS = (
    "diagrams", "flywheel", "forces", "engine", "motion_law", "balance", "curvature", "bresse", "ball",
    "hodograph", "analogues", "klein", "ritterhaus", "centres", "centrodes 2",
)  # fmt: skip
"""Plans told in test_chart_tables.py, test_flywheel_tables.py, test_force_tables.py, test_shaking.py,
test_curvature_sheets.py, test_klein.py, test_hodograph.py, test_centres.py,
test_centrodes.py."""
OTHER_MU = {
    "mu_diagram_S", "mu_diagram_V", "mu_diagram_a", "mu_base", "mu_p", "mu_M", "mu_A", "mu_T", "mu_J",
    "mu_lever", "mu_motor", "mu_motor_speeds", "mu_Phi", "mu_M_Phi",
    "mu_v_klein", "mu_a_klein", "mu_v_ritterhaus", "mu_a_ritterhaus",
}  # fmt: skip
FORCE_UNITS = ("N", "kgf", "kgf·m")
MU = {"positions": "mu_l", "velocities": "mu_v", "accelerations": "mu_a"}
# reference A2: exact mm at positions 1..12
X = [0, 42.53, 65.29, 60, 38.64, 17.47, 0, 17.47, 38.64, 60, 65.29, 42.53]
S = [39.38, 48.37, 59.87, 60, 51.31, 42.70, 39.38, 42.70, 51.31, 60, 59.87, 48.37]
H = [60, 53.45, 32.83, 0, 32.83, 53.45, 60, 53.45, 32.83, 0, 32.83, 53.45]
COLUMN = Column("velocities", "pb", "pb", "m/s", along(1.0, -0.0, None), along(0.25, -0.0, None))


@cache
def printed_of(name: str) -> dict[str, Any]:
    text = table(gallery.made(name), "json")
    assert isinstance(text, str)
    return json.loads(text)


@pytest.mark.parametrize(
    ("letter", "due"),
    [
        ("pb", "pb"),
        ("ps2", "ps2"),
        ("P_{i3}", "Pi3"),
        ("n3a3", "n3a3"),
        ("πs2", "πs2"),
        ("ω_2", "omega2"),
        ("ε_{12}", "epsilon12"),
        ("l_{OA}", "lOA"),
    ],
)
def test_a_segment_is_named_by_its_letters(letter: str, due: str) -> None:
    assert segment_name(letter) == due


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONE)
def test_the_document_has_its_shape(name: str) -> None:
    made = printed_of(name)
    assert list(made) == ["scene", "scales", "positions", "columns", "results"]
    assert made["scene"] == name
    assert {"W", "formula"} <= set(made["results"])
    assert made["results"]["W"] == 1
    for plan, scale in made["scales"].items():
        known = plan in MU.values() or plan in OTHER_MU
        parts = ("mu_F_", "mu_l_", "mu_phi_", "mu_S_", "mu_D_")
        assert known or plan.startswith(parts) or plan.endswith(("_engine", "_motion"))
        assert set(scale) == {"value", "unit"}
        assert scale["value"] > 0
    count = len(made["positions"])
    for place in made["positions"]:
        assert set(place) in ({"number", "angle_deg"}, {"number", "parameter"})
        assert isinstance(place["number"], str)
        assert 0 <= place.get("angle_deg", 0) < 360
    for one in made["columns"]:
        assert list(one) == ["plan", "segment", "unit", "positions", "mm", "value"]
        assert one["unit"] in {
            "s",
            "m",
            "m/s",
            "m/s²",
            "1/s",
            "1/s²",
            "°",
            "%",
            "Pa",
            "N·m",
            "J",
            "kg·m²",
            "",
            *FORCE_UNITS,
        }
        assert len(one["mm"]) == len(one["value"]) == count
    named = [(one["plan"], one["segment"]) for one in made["columns"]]
    assert len(named) == len(set(named))


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONE)
def test_a_value_is_its_segment_times_mu(name: str) -> None:
    made = printed_of(name)
    for one in (c for c in made["columns"] if c["plan"] not in GRAPHS):
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


@pytest.mark.parametrize("name", ALONE)
def test_accelerations_are_null_where_they_have_no_plan_and_nothing_else_is(name: str) -> None:
    made, places = printed_of(name), KINEMATICS_PLAN.on(drawn(name)).accelerated
    for one in made["columns"]:
        if one["plan"] in GRAPHS:
            continue  # test_chart_tables.py
        there = [k for k, value in enumerate(one["value"]) if value is not None]
        due = places if one["plan"] == "accelerations" else range(len(made["positions"]))
        assert there == list(due), one["segment"]


def test_every_turning_link_has_its_rates_with_their_sign() -> None:
    made = {one["segment"]: one for one in printed_of("engine")["columns"]}
    assert made["omega1"]["value"] == [50.0] * 12
    omega = made["omega2"]["value"]
    assert omega[0] < 0 < omega[6]  # the rod turns against the crank at the dead centre 1
    assert omega[3] == omega[9] == 0
    assert "omega3" not in made


@pytest.mark.slow
def test_what_is_nothing_but_rounding_is_zero_and_has_no_sign() -> None:
    text = table(gallery.exact("windrower"), "json")
    assert isinstance(text, str)
    rows = [one for one in json.loads(text)["columns"] if one["plan"] == "velocities"]
    found = {one["segment"]: one["mm"] for one in rows}
    assert found["pd"][0] == found["pd"][-1] == 0
    assert not re.search(r"-0\.0\b", text)
    every = [abs(mm) for one in rows for mm in one["mm"] if mm]
    assert min(every) > 1e-12 * max(every)


def test_columns_of_a_plan_that_was_not_drawn() -> None:
    made = drawn("engine")
    assert plan_columns(made, "forces") == ()


def test_a_column_without_some_positions() -> None:
    made = COLUMN.without((0,))
    assert made.first_figures == ([None, -0.0, None],) * 2
    assert COLUMN.without(()) is COLUMN


def test_json_keeps_text_tidies_figures_and_refuses_what_json_has_not() -> None:
    text = as_json('<"&\n', {}, (("7*", 1.5),), [COLUMN], {})
    made = json.loads(text)
    assert made["scene"] == '<"&\n'
    assert made["positions"] == [{"number": "7*", "angle_deg": 1.5}]
    assert made["columns"][0]["mm"] == [1.0, 0.0, None]
    assert "-0" not in text
    with pytest.raises(ValueError, match="JSON"):
        as_json("", {}, (), [replace(COLUMN, mm=along(float("inf"), 0.0, 0.0))], {})


def test_twelve_digits_are_kept() -> None:
    made = json.loads(as_json("", {}, (), [replace(COLUMN, mm=along(1 / 3, 0.1 + 0.2, None))], {}))
    assert made["columns"][0]["mm"] == [0.333333333333, 0.3, None]


@pytest.mark.slow
@pytest.mark.parametrize("name", ALONE)
def test_csv_holds_what_json_holds(name: str) -> None:
    drawing = gallery.exact(name)
    text, whole = table(drawing, "csv"), table(drawing, "json")
    assert isinstance(text, str)
    assert isinstance(whole, str)
    rows = csv_rows(text)
    made = json.loads(whole)
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
    text = as_csv((('a,"b', 0.0), ("c", 1.0), ("d", 2.0)), [COLUMN])
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [row["position"] for row in rows] == ['a,"b', "c"]


def printed(*tables: Any) -> str:
    console = Console(file=io.StringIO(), width=200)
    for one in tables:
        console.print(one)
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


def test_a_table_for_people_says_what_the_scene_says_literally() -> None:
    positions = (("1", 0.0), ("[red]2", 1.0), ("3", 2.0))
    text = printed(*text_tables([COLUMN], positions, "en", "[bold]T[/bold] [/]", 1, 200))
    assert "[bold]T[/bold] [/]. Velocity plan" in text
    assert "[red]2" in text


def test_a_table_for_people_shows_only_positions_that_have_a_plan() -> None:
    positions = (("1", 0.0), ("2", 1.0), ("3", 2.0))
    text = printed(*text_tables([COLUMN], positions, "ru", "T", 1, 200))
    assert "План скоростей" in text
    head = next(line for line in text.splitlines() if "Отрезок" in line)
    assert [word for word in head.replace("┃", " ").split() if word.isdigit()] == ["1", "2"]
    assert "1,0" in text
    assert "0,25" in text
    assert "−0" not in text


def test_text_and_figures_of_a_scene_agree() -> None:
    parts = table(gallery.made("engine"), "text")
    assert isinstance(parts, list)
    text = printed(*parts)
    due = next(c for c in columns_of(drawn("engine")) if c.segment == "pb").first_figures[0]
    row = next(line for line in text.splitlines() if line.split()[1:2] == ["pb"])
    cells = [cell.strip() for cell in row.strip("│").split("│")][2:]
    assert cells == [f"{mm:.1f}".replace(".", ",") for mm in due if mm is not None]


# the command line


def test_the_exact_table_of_the_engine_is_the_reference() -> None:
    document = tabled("engine", "--exact")
    assert [p["number"] for p in document["positions"]] == [str(k) for k in range(1, 13)]
    assert [p["angle_deg"] for p in document["positions"]] == [30.0 * k for k in range(12)]
    for segment, due in (("pb", X), ("ps2", S), ("ab", H)):
        found = column(document, "velocities", segment)
        assert found["mm"] == pytest.approx(due, abs=0.01)
        assert found["value"] == pytest.approx(
            [0.25 * mm for mm in found["mm"]], rel=1e-9, abs=1e-12
        )
    assert document["scales"]["mu_v"] == {"value": 0.25, "unit": "(m/s)/mm"}
    assert document["results"]["W"] == 1
    assert document["results"]["formula"] == "I(1) → II(2-3)"
    assert document["results"]["J_fly"]["value"] == pytest.approx(1.7707, abs=0.0001)
    assert document["results"]["J_fly"]["unit"] == "kg·m²"


@pytest.mark.slow
def test_the_default_table_differs_by_the_rulers_rounding_only() -> None:
    exact, read = tabled("engine", "--exact"), tabled("engine")
    for segment in ("pa", "pb", "ps2", "ab"):
        pairs = zip(
            column(exact, "velocities", segment)["mm"],
            column(read, "velocities", segment)["mm"],
            strict=True,
        )
        for due, found in pairs:
            assert abs(due - found) <= 0.05 + 1e-9
            assert found * 10 == pytest.approx(round(found * 10), abs=1e-6)
    # ω2 = ab·μ_v/(AB·μ_l): only ab is read
    bound = 0.05 * 0.25 / (128 * 0.005) + 1e-9
    pairs = zip(*(column(d, "velocities", "omega2")["value"] for d in (exact, read)), strict=True)
    assert all(abs(due - found) <= bound for due, found in pairs)


def test_null_where_a_position_has_no_acceleration_plan() -> None:
    found = column(tabled("engine"), "accelerations", "an2")
    assert [k + 1 for k, mm in enumerate(found["mm"]) if mm is not None] == [2, 5]
    assert found["unit"] == "m/s²"


@pytest.mark.slow
def test_the_document_is_as_written_down() -> None:
    document = tabled("engine")
    assert list(document) == ["scene", "scales", "positions", "columns", "results"]
    assert document["scene"] == "engine"
    assert list(document["scales"])[:3] == ["mu_l", "mu_v", "mu_a"]
    assert document["scales"]["mu_l"] == {"value": 0.005, "unit": "m/mm"}
    assert document["scales"]["mu_a"]["unit"] == "(m/s²)/mm"
    assert document["positions"][3] == {"number": "4", "angle_deg": 90.0}
    shape = ("plan", "segment", "unit", "positions", "mm", "value")
    assert {tuple(c) for c in document["columns"]} == {shape}
    assert all(c["positions"] == [str(k) for k in range(1, 13)] for c in document["columns"])
    segments = [c["segment"] for c in document["columns"] if c["plan"] == "velocities"]
    assert segments == ["pa", "ab", "pb", "ps2", "omega1", "omega2"]
    assert all(len(c["mm"]) == len(c["value"]) == 12 for c in document["columns"])
    assert column(document, "velocities", "omega2")["mm"] == [None] * 12


def test_an_angle_is_the_direction_of_the_crank_whatever_its_zero(tmp_path: Path) -> None:
    clockwise = [
        ('"counterclockwise"', '"clockwise"'),
        ('zero          = "0 deg"', 'zero = "180 deg"'),
    ]
    made = in_usual_size(read(edited(tmp_path, *clockwise)))
    document = json.loads(table(made, "json"))
    assert [p["angle_deg"] for p in document["positions"]][:5] == [180.0, 150.0, 120.0, 90.0, 60.0]
    assert column(document, "velocities", "omega1")["value"][0] == -50


def test_positions_that_cannot_be_drawn_are_null_in_every_column(tmp_path: Path) -> None:
    path = edited(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"'), ("[2, 5]", "[2, 5]"))
    result = invoke("table", str(path), "--format", "json", "--exact", "-l", "en")
    assert result.exit_code == 0
    assert "warning: positions 3, 4, 5, 9, 10, 11 cannot be drawn" in result.stderr
    document = json.loads(result.stdout)  # the warning is not in it
    gone = [2, 3, 4, 8, 9, 10]
    for one in document["columns"]:
        assert all(one["value"][k] is None and one["mm"][k] is None for k in gone), one["segment"]
    accelerated = column(document, "accelerations", "πb")
    assert [k for k, mm in enumerate(accelerated["mm"]) if mm is not None] == [1]
    # by the vector loop: x = r·cos φ + √(l² − r²·sin² φ), 30° further than the dead centre
    r, h, phi = 0.3, 0.25, math.radians(30)
    beam = math.sqrt(h**2 - (r * math.sin(phi)) ** 2)
    speed = 50 * (r * math.sin(phi) + r * r * math.sin(phi) * math.cos(phi) / beam)
    assert column(document, "velocities", "pb")["value"][1] == pytest.approx(speed, rel=1e-9)


@pytest.mark.slow
def test_the_windrower_stands_as_its_task_says() -> None:
    document = tabled()
    assert document["scene"] == "windrower"
    assert [p["number"] for p in document["positions"]][-1] == "7*"
    assert document["results"]["formula"] == "I(1) → II(2-3) → II(4-5)"
    assert column(document, "velocities", "omega3")["value"][0] == 0
    assert column(document, "velocities", "pd")["mm"][0] == 0
    assert column(document, "velocities", "pd")["mm"][-1] == 0
