"""Figures of the page are those of the tables; nothing that nobody can read stands in its data."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest
from support.each import each
from support.gallery import ALL, paper
from support.readable import UNREADABLE, texts

from graphic_tmm.page.page import page_data
from graphic_tmm.paper.drawing import Drawing

SOME = ("arc-cam", "cam", "engine", "windrower")


@cache
def data(name: str) -> dict[str, Any]:
    return page_data(*paper(name))


def rows(view: dict[str, Any]) -> Iterator[list[Any]]:
    """Every row of figures of a view: of its small tables, and of its readings."""
    for table in view["values"].values():
        yield from table
    for picture in view["pictures"]:
        yield from (line["row"] for line in picture["lines"] if "row" in line)


def numbers(text: str) -> set[str]:
    """The numbers that stand in a text, as they are written."""
    return set(re.findall(r"−?\d+(?:[.,]\d+)?(?:·10[⁰¹²³⁴-⁹⁻]+)?", text))


def tables(name: str) -> list[Drawing]:
    """The tables on the sheets of a scene."""
    _, sheets = paper(name)
    return [one for sheet in sheets for one in sheet.drawings if one.name.startswith("table-")]


@pytest.mark.parametrize("plan", ["velocities", "accelerations"])
def test_values_are_those_of_the_table_on_the_sheet(plan: str) -> None:
    """Segment by segment, position by position: the mm and the quantity stand in the cells of that table."""
    (table,) = [one for one in tables("windrower") if one.name == f"table-{plan}"]
    cells = {label.text for label in table.labels}
    some = [view for view in data("windrower")["views"] if view["plan"] == plan]
    assert some
    told = [row for view in some for row in rows(view)]
    assert told
    for _, segment, mm, _, value, _ in told:
        assert numbers(mm) | numbers(value.partition(" ")[0]) <= cells, segment


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", SOME)
def test_a_length_times_its_scale_is_the_quantity(name: str) -> None:
    """Who takes the figures of a row as they are written gets its quantity to its last decimal."""
    met = 0
    for view in data(name)["views"]:
        for _, segment, mm, mu, value, _ in rows(view):
            if mm and mu:
                length, scale, quantity = (_number(text) for text in (mm, mu, value))
                decimals = len(value.partition(" ")[0].replace(".", ",").partition(",")[2])
                assert abs(length * scale - quantity) <= 1.01 * 10.0**-decimals, (segment, mm, mu)
                met += 1
    assert met


def _number(text: str) -> float:
    told = text.split(" ")[0].replace(",", ".").replace("−", "-")
    mantissa, _, power = told.partition("·10")
    raised = power.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"))
    return float(mantissa) * 10.0 ** int(raised or 0)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", SOME)
def test_nothing_is_told_that_nobody_can_read(name: str) -> None:
    assert_readable(name)


@pytest.mark.slow
@each("name", ALL, turns=4)
def test_nothing_is_told_in_any_scene_that_nobody_can_read(name: str) -> None:
    assert_readable(name)


def assert_readable(name: str) -> None:
    found = data(name)
    json.dumps(found, allow_nan=False)
    assert [text for text in texts(found["views"]) if UNREADABLE.search(text)] == []


def test_what_is_not_there_in_a_position_is_told_in_words() -> None:
    """A chord of the mean value beside the row has no place; the stop of that position says so."""
    (view,) = [one for one in data("windrower")["views"] if one["plan"] == "diagram a"]
    told = [
        line["text"][0]
        for one in view["pictures"]
        for line in one["lines"]
        if "it" not in line and "head" not in line
    ]
    assert told
    assert all("нет" in text for text in told)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", SOME)
def test_terms_of_equations_are_drawn_by_stops(name: str) -> None:
    """A vector lights up in the stop in which its line is drawn, then in which its end is."""
    for view in data(name)["views"]:
        for n, picture in enumerate(view["pictures"]):
            for line in picture["lines"]:
                for side in line.get("equation", {"sides": []})["sides"]:
                    for term in side:
                        assert 0 <= term["from"] <= term["to"] < len(view["pictures"])
                        assert term["of"] or term["s"] == "0"
                        if term["u"] == 1:
                            assert term["from"] >= n, "an unknown is drawn behind its equation"


POLYGONS = {
    "forces 4-5": ["G_{5}", "P_{и5}", "F_{5}", "R_{65}", "R_{34}"],
    "forces 2-3": ["G_{3}", "P_{и3}", "R_{43}", "R_{63}^{τ}", "R_{63}^{n}", "R_{12}"],
    "forces 1": ["G_{1}", "P_{и1}", "R_{21}", "P_{ур}", "R_{61}"],
}
"""The sums of forces of the windrower's groups, written down by hand: no inner reaction among them."""


def test_the_sum_of_a_polygon_names_the_forces_on_its_group() -> None:
    found = {
        view["plan"]: [term["s"] for term in line["equation"]["sides"][0]]
        for view in data("windrower")["views"]
        for picture in view["pictures"]
        for line in picture["lines"]
        if view["plan"] in POLYGONS and "equation" in line
    }
    assert found == POLYGONS


def test_what_was_read_against_its_line_bears_its_sign() -> None:
    signed = [
        line
        for view in data("windrower")["views"]
        for picture in view["pictures"]
        for line in picture["lines"]
        if "sign" in line
    ]
    assert signed
    assert all(line["read"] == f"−{line['row'][2]}" for line in signed)
