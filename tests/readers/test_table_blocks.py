"""Tables that fit a terminal and a spreadsheet: blocks of positions, decimal commas, meaningful digits."""

from __future__ import annotations

import io
import json
import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rich.console import Console
from support.columns import along
from support.command import invoke, printed
from support.command import rows as csv_rows
from support.examples import most
from support.scenes import calling, source, written

from graphic_tmm.checking.readings.csv_cells import decoded
from graphic_tmm.readers.columns import (
    Column,
)
from graphic_tmm.readers.table import scene_columns, table
from graphic_tmm.readers.text import Framed, text_tables
from graphic_tmm.readers.writing import as_csv, decimals_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SCENES = ("windrower", "engine", "crank-press", "cam", "gear-pair", "planetary")


@cache
def text(name: str, width: int) -> str:
    return printed("table", name, "--width", width)


def rows_of(printed: str) -> list[list[str]]:
    """The cells of every line of a printed table."""
    lines = [line for line in printed.splitlines() if line[:1] in "│┃"]
    return [[cell.strip() for cell in re.split("[│┃]", line)[1:-1]] for line in lines]


@pytest.mark.slow
@pytest.mark.parametrize("width", [60, 80, 132])
@pytest.mark.parametrize("name", SCENES)
def test_no_line_of_a_table_is_wider_than_the_terminal_and_nothing_is_cut(
    name: str, width: int
) -> None:
    printed = text(name, width)
    assert "…" not in printed
    framed = [line for line in printed.splitlines() if line[:1] in "│┃┏└┡"]
    assert framed
    assert max(map(len, framed)) <= width


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_a_narrow_table_holds_every_figure_of_a_wide_one(name: str) -> None:
    def figures(width: int) -> list[tuple[str, str, str]]:
        found: list[tuple[str, str, str]] = []
        heads: list[str] = []
        for row in rows_of(text(name, width)):
            if row[0] in ("Отрезок", "Segment", "Результаты", "Results"):
                heads = row
            found += [(row[0], head, cell) for head, cell in zip(heads, row, strict=True)]
        return sorted(found)

    narrow, wide = figures(80), figures(1000)
    # heads and names are repeated in each block; no figure is lost or new
    assert set(narrow) == set(wide)


def test_a_single_column_that_is_wider_than_the_terminal_is_printed_whole() -> None:
    column = Column(
        "velocities", "pb", "pb", "m/s", along(1.0, 1.0, 1.0), along(123456.0, 1.0, 2.0)
    )
    positions = tuple((f"{k}" * 12, 0.0) for k in range(3))
    parts = text_tables([column], positions, "en", "T", 1, 20)
    tables = [part for part in parts if isinstance(part, Framed)]
    assert len(tables) == 3
    out = io.StringIO()
    for one in tables:
        Console(file=out, width=200).print(one)
    assert all(name in out.getvalue() for name, _ in positions)


@pytest.mark.slow
@settings(max_examples=most(40), deadline=None)
@given(st.integers(1, 40), st.integers(30, 200), st.integers(0, 6))
def test_blocks_hold_as_many_positions_as_fit(count: int, width: int, digits: int) -> None:
    value = float(10**digits)
    column = Column("velocities", "pb", "pb", "m/s", *[along(*[value] * count)] * 2)
    positions = tuple((str(k), 0.0) for k in range(count))
    tables = [
        p for p in text_tables([column], positions, "en", "T", 1, width) if isinstance(p, Framed)
    ]
    heads = [one.rows[0][2:] for one in tables]
    assert [name for block in heads for name in block] == [name for name, _ in positions]
    console = Console(width=1000)
    for one, block in zip(tables, heads, strict=True):
        wide = console.measure(one.parts()[1]).maximum
        assert wide <= width or len(block) == 1
        # one more of the next would not have fitted
        if one is not tables[-1]:
            assert wide + len(f"{value:.1f}") + 3 > width


# CSV


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("ruler", [0.1, 0.5])
def test_csv_tells_lengths_to_the_ruler_and_quantities_to_what_that_stands_for(
    name: str, ruler: float, tmp_path: Path
) -> None:
    text = re.sub(r"(?ms)^\[hand\].*?(?=^\[|\Z)", "", source(name))
    path = written(tmp_path, f'{text}\n[hand]\nruler = "{ruler} mm"\n')
    made = make(read(path))
    printed = table(made, "csv")
    assert isinstance(printed, str)
    rows = csv_rows(printed)
    whole = {
        (c.plan, c.segment, at): (mm, value)
        for c in scene_columns(made)
        for at, mm, value in zip(_names(made, c), *c.first_figures, strict=True)
    }
    assert rows
    for row in rows:
        mm, value = whole[row["plan"], row["segment"], row["position"]]
        if row["mm"]:
            assert mm is not None
            assert re.fullmatch(r"-?\d+\.\d", row["mm"]), row
            assert abs(float(row["mm"]) - mm) <= 0.05 + 1e-9
        if row["value"] and row["mm"]:
            assert mm is not None
            assert value is not None
            share = abs(value / mm) * ruler if mm and value else None
            half = 0.5 * 10 ** -len(row["value"].partition(".")[2])
            assert abs(float(row["value"]) - value) <= half * 1.000001
            assert share is None or half <= 0.5 * max(share, 1.0) * 1.000001, (
                row
            )  # no digit too few
            assert share is None or half > 0.05 * min(share, 1.0) * 0.999, row  # nor too many
        elif row["value"]:
            assert value is not None
            assert math.isclose(float(row["value"]), value, rel_tol=5.001e-4), row
            assert (
                len(row["value"].strip("-0.").replace(".", "").lstrip("0")) <= 4
                or abs(value) >= 1e4
            )


def _names(made: Any, column: Column) -> list[str]:
    return [name for name, _ in column.at] or list(made.mechanism.project.names)


def test_csv_has_no_noise_of_the_last_bits() -> None:
    column = Column(
        "velocities", "pb", "pb", "m/s", along(0.1 + 0.2, -1e-17), along(0.30000000000000004, -0.0)
    )
    rows = csv_rows(as_csv((("1", 1 / 3), ("2", 30.0)), [column], 0.1))
    assert [(r["angle_deg"], r["mm"], r["value"]) for r in rows] == [
        ("0.333", "0.3", "0.3"),
        ("30", "0.0", "0.0"),
    ]
    exact = csv_rows(as_csv((("1", 1 / 3), ("2", 30.0)), [replace(column, mm=along(1 / 3, None))]))
    assert exact[0]["mm"] == "0.333333333333"
    assert exact[0]["value"] == "0.3"


@pytest.mark.parametrize(
    ("division", "due"),
    [
        (0.1, 1),
        (0.5, 1),
        (1.0, 0),
        (0.01, 2),
        (0.025, 2),
        (0.02, 2),
        (20.0, 0),
        (1e-4, 4),
        (0.1 * 3, 1),
    ],
)
def test_a_division_has_so_many_decimals(division: float, due: int) -> None:
    assert decimals_of(division) == due
    assert 10.0**-due <= division * 1.000001 or due == 0


@pytest.mark.slow
def test_a_decimal_comma_comes_with_semicolons_and_a_mark_on_request() -> None:
    points = printed("table", "windrower", "-f", "csv")
    commas = printed("table", "windrower", "-f", "csv", "--decimal", "comma", "--bom")
    assert commas.startswith("\ufeff")
    assert not points.startswith("\ufeff")
    plain, other = csv_rows(points), csv_rows(commas.removeprefix("\ufeff"), ";")
    assert len(plain) == len(other) > 300
    for one, two in zip(plain, other, strict=True):
        figures = {k: one[k].replace(".", ",") for k in ("angle_deg", "mm", "value")}
        assert one | figures == two
    assert printed("table", "windrower", "-f", "text", "--bom")[0] != "\ufeff"


@pytest.mark.slow
def test_a_table_with_decimal_commas_is_read_back_by_the_check(tmp_path: Path) -> None:
    path = tmp_path / "own.csv"
    path.write_text(printed("table", "engine", "-f", "csv", "--decimal", "comma", "--bom"), "utf-8")
    assert decoded(path, path.read_bytes()).startswith("план;положение")
    done = invoke("check", "engine", path, "-f", "json")
    assert done.exit_code in (0, 1), done.output
    assert len(json.loads(done.stdout)["readings"]) > 100


# gears and trains


@pytest.mark.slow
@pytest.mark.parametrize("name", ["gear-pair", "planetary", "cam"])
def test_a_part_has_columns_in_the_shape_of_all_others(name: str) -> None:
    document = json.loads(printed("table", name, "-f", "json"))
    shape = ["plan", "segment", "unit", "positions", "mm", "value"]
    assert document["columns"]
    for column in document["columns"]:
        assert list(column) == shape
        assert len(column["positions"]) == len(column["mm"]) == len(column["value"])
    rows = csv_rows(printed("table", name, "-f", "csv"))
    due = [(c["plan"], c["segment"]) for c in document["columns"]]
    assert list(dict.fromkeys((r["plan"], r["segment"]) for r in rows)) == list(dict.fromkeys(due))


@pytest.mark.slow
def test_what_is_measured_on_a_gear_pair_is_what_its_formulas_give() -> None:
    """An own calculation: line of action and ends of the contact of the pair of the windrower's project."""
    document = json.loads(printed("table", "gear-pair", "-f", "json", "--exact"))
    found = {c["segment"]: c["value"][0] for c in document["columns"] if c["plan"] == "gear"}
    m, z1, z2, x1, x2, a = 8.0, 15, 25, 0.83, 0.445, math.radians(20)
    inv = math.tan(a) - a + 2 * (x1 + x2) * math.tan(a) / (z1 + z2)
    aw = 0.4
    for _ in range(60):
        aw -= (math.tan(aw) - aw - inv) / math.tan(aw) ** 2
    axis = m * (z1 + z2) / 2 * math.cos(a) / math.cos(aw)
    y = (axis - m * (z1 + z2) / 2) / m
    dy = x1 + x2 - y
    rb = [m * z * math.cos(a) / 2 for z in (z1, z2)]
    ra = [m * z / 2 + m * (1 + x - dy) for z, x in ((z1, x1), (z2, x2))]
    whole = axis * math.sin(aw)
    ends = [math.sqrt(r * r - b * b) for r, b in zip(ra, rb, strict=True)]
    due = {"N1N2": whole, "N1b": ends[0], "N2a": ends[1], "ab": sum(ends) - whole, "O1b": ra[0]}
    for segment, mm in due.items():
        assert 1000 * found[segment] == pytest.approx(mm, rel=1e-9), segment


@pytest.mark.slow
def test_a_part_beside_a_mechanism_keeps_positions_of_its_own(tmp_path: Path) -> None:
    document = json.loads(
        printed("table", calling(tmp_path, "diagrams", "cam", "gears"), "-f", "json")
    )
    counts = {c["plan"]: len(c["positions"]) for c in document["columns"]}
    assert counts["diagrams"] == len(document["positions"]) == 8
    assert counts["cam"] > 20
    assert counts["gear"] == 1
