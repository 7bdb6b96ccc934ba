"""The tables of gears and trains: what their sheet tells stands in columns, and a template asks for it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from typing import Any

import pytest
from support.gallery import exact, scene

from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE
from graphic_tmm.checking.template import template_of
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.table import table

TABLES = {
    ("gear-pair", "gears", "table-gear"): "gear-dimensions",
    ("gear-pair", "gears", "table-sliding"): "sliding-table",
    ("planetary", "planetary", "table-planetary-rates"): "planetary-rates",
    ("planetary", "planetary", "table-planetary"): "planetary-conditions",
    ("planetary", "planetary", "table-trains"): "planetary-trains",
}
"""Scene, place and view of a table of a sheet; the plan of its columns."""
_NUMBER = re.compile(r"(?<![\w{])−?\d+(?:,\d+)?(?![\w}])")


def document(name: str) -> dict[str, Any]:
    return json.loads(table(exact(name), "json"))


def views(name: str, place: str) -> Iterable[Drawing]:
    (board,) = exact(name).boards
    return drawing_of(place)(board, True)


def shown(drawing: Drawing) -> list[str]:
    """Return the figures of a table's cells; a result of a written out formula stands last."""
    cells = [label.text for label in drawing.labels][1:]
    found = [_NUMBER.findall(cell.split(" = ")[-1]) for cell in cells]
    return [figures[0] for figures in found if figures]


@pytest.mark.parametrize("where", TABLES, ids=lambda where: where[2])
def test_every_figure_of_a_sheets_table_stands_in_a_column(where: tuple[str, str, str]) -> None:
    name, place, view = where
    drawing = next(one for one in views(name, place) if one.name == view)
    told = [one for one in document(name)["columns"] if one["plan"] == TABLES[where]]
    there = {x for one in told for row in (one["mm"], one["value"]) for x in row if x is not None}
    there |= {1000.0 * x for x in there}
    heads = {head for one in told for head in (*one["positions"], one["segment"].strip("szH"))}
    figures = [text for text in shown(drawing) if text not in heads]
    assert len(figures) > 3
    for text in figures:
        value = float(text.replace("−", "-").replace(",", "."))
        unit = 0.5 * 10.0 ** -len(text.partition(",")[2]) + 1e-9
        assert any(abs(value - x) <= unit for x in there), text


@pytest.mark.parametrize("name", ["gear-pair", "planetary"])
def test_a_template_asks_for_all_columns_and_takes_their_own_figures(
    name: str, tmp_path: Any
) -> None:
    """Filled in with what the table tells, nothing is wrong; every figure of it is asked for."""
    asked = [line.split(";") for line in template_of(scene(name)).splitlines()]
    figures = {
        (one["plan"], head, one["segment"]): value
        for one in document(name)["columns"]
        for head, value in zip(one["positions"], one["value"], strict=True)
        if value is not None
    }
    assert figures.keys() <= {tuple(row[:3]) for row in asked}
    for row in asked[1:]:
        value = figures.get((row[0], row[1], row[2]))
        row[4] = "" if value is None else repr(value).replace(".", ",")
    file = tmp_path / "readings.csv"
    file.write_text("\n".join(";".join(row) for row in asked), encoding="utf-8")
    readings = read_readings(file)
    assert len(readings) >= len(figures)
    assert {one.verdict for one in check(scene(name), readings, trials=40).readings} == {FINE}
