"""How high letters are, by the format of a sheet."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
import shapely
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.paper.drawing import Drawing, line
from graphic_tmm.paper.formats import FORMATS, HEIGHTS, heights, heights_on
from graphic_tmm.paper.lettering.letters import SIZES
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import box
from graphic_tmm.paper.views import captioned
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder
from graphic_tmm.studio import sheets


@pytest.mark.parametrize("format", [*FORMATS, "A2", "A2 portrait"])
def test_a_large_sheet_is_read_from_a_metre_and_a_half(format: str) -> None:
    found = heights_on([format])
    if format.startswith(("A1", "A2")):
        assert found == (5.0, 7.0, 3.5)
    else:
        assert found == (3.5, 5.0, 3.5)


def test_all_heights_stand_in_the_row_of_the_standard_and_none_is_too_low() -> None:
    assert all(height in SIZES and height >= 3.5 for found in HEIGHTS.values() for height in found)


def test_a_place_is_lettered_for_the_narrowest_sheet_that_shows_it() -> None:
    orders = (
        SheetOrder("A1", ("positions", "velocities")),
        SheetOrder("A4", ("positions", "structure")),
    )
    scene = replace(read(SHEETS / "engine"), sheets=orders)
    assert heights(scene, "velocities") == HEIGHTS["A1"]
    assert heights(scene, "positions") == heights(scene, "structure") == HEIGHTS["A4"]
    assert heights(scene, "equations") == heights(scene) == HEIGHTS["A4"]


def test_a_format_that_is_not_yet_chosen_is_lettered_as_the_usual_one() -> None:
    assert heights_on(["auto"]) == heights_on([]) == HEIGHTS["A1"]


@pytest.mark.parametrize("name", ["engine", "tangent-mechanism", "crank-rocker", "cam"])
def test_all_tables_have_one_height_of_title_and_one_of_head(name: str) -> None:
    for sheet in sheets(read(SHEETS / name))[1]:
        due = heights_on([sheet.format])
        for view in sheet.drawings:
            if view.stand.kind == "table":
                high = [label for label in view.labels if label.size == due.title]
                told = sorted(high, key=lambda label: -label.at.imag)  # a long one is in two lines
                assert " ".join(label.text for label in told) == view.title, view.name
                assert {k.size for k in view.labels if k not in high} == {due.number}


@pytest.mark.parametrize("format", ["A1", "A4"])
def test_titles_of_tables_and_what_stands_in_them(format: str) -> None:
    scene = replace(read(SHEETS / "engine"), sheets=(SheetOrder(format, ("structure",)),))
    due = HEIGHTS[format]
    (sheet,) = sheets(scene)[1]
    for view in sheet.drawings[1:]:
        title, others = view.title, [k.size for k in view.labels if k.text != view.title]
        assert [k.size for k in view.labels if k.text == title] == [due.title]
        assert set(others) == {due.number}


def test_the_title_of_a_caption_is_larger_and_broken_over_a_narrow_view() -> None:
    view = Drawing("plan", "", (line("main", 0j, 40 + 30j),))
    told = captioned(
        view, "План скоростей, положение 3", "μ_v = 0,1 (м/с)/мм", heights=HEIGHTS["A1"]
    )
    assert [(k.text, k.size) for k in told.labels] == [
        ("План скоростей,", 7.0),
        ("положение 3", 7.0),
        ("μ_v = 0,1 (м/с)/мм", 5.0),
    ]
    boxes = [box(label) for label in told.labels]
    assert all(a.disjoint(b) for a, b in pairwise(boxes))
    left, low, right, top = bounds(told)
    assert shapely.box(left, low, right, top).buffer(1e-9).covers(shapely.union_all(boxes))


def test_a_title_is_not_broken_above_a_line_that_is_longer() -> None:
    view = Drawing("forces", "", (line("main", 0j, 40 + 30j),))
    title, longer = "План сил группы 2-3, положение 3", " + ".join(10 * ["R_{12}^{n}"])
    told = captioned(view, title, "μ_F = 75 Н/мм", longer, heights=HEIGHTS["A1"])
    assert [label.text for label in told.labels] == [title, "μ_F = 75 Н/мм", longer]


def test_a_number_stays_with_its_word_where_a_title_is_broken() -> None:
    view = Drawing("forces", "", (line("main", 0j, 20 + 30j),))
    told = captioned(view, "План сил звена 1, положение 5", heights=HEIGHTS["A1"])
    assert [label.text for label in told.labels] == ["План сил звена 1,", "положение 5"]


@each("title", ["План скоростей, положение", "План сил, поз.", "Группа 4-5"])
@each("width", range(20, 160, 4))
def test_the_titles_of_a_series_are_all_broken_or_none(width: int, title: str) -> None:
    view = Drawing("plan", "", (line("main", 0j, width + 30j),))
    counts = set()
    for name in ("0", "7*", "11", "105°"):
        told = captioned(view, f"{title} {name}", heights=HEIGHTS["A1"])
        counts.add(len(told.labels))
    assert len(counts) == 1
