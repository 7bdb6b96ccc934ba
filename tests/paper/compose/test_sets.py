"""Sets of sheets: what is left over, formats that are found, what a format too large is told."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most
from support.gallery import SHEETS
from support.order import gap
from support.sheets_of_random import scenes

from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.formats import oversized, room_on
from graphic_tmm.paper.compose import search
from graphic_tmm.paper.compose.sheets import Order, composed, shared
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Stand
from graphic_tmm.paper.formats import FORMATS, growing
from graphic_tmm.paper.packing import GAP
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

A1, NEXT = room_on("A1", "ru", True), room_on("A1", "ru", False)
ROW, TABLE = Stand("velocities", "row"), Stand(kind="table")


def order(*outlines: Outline) -> Order:
    return Order(outlines, (A1, NEXT), "A1")


def box(outline: Outline, at: complex) -> tuple[float, float, float, float]:
    return at.real, at.imag, at.real + outline.width, at.imag + outline.height


stands = st.sampled_from(
    [ROW, TABLE, Stand(), Stand("pair", "pair"), Stand("b", "row", "velocities")]
)
outlines = st.lists(
    st.builds(
        Outline,
        st.sampled_from("abcdef"),
        st.floats(5, 300),
        st.floats(30, 250),
        stands,
        st.floats(0, 25),
    ),
    min_size=1,
    max_size=14,
)


@settings(max_examples=most(40), deadline=None)
@given(outlines, st.sampled_from(["A1", "A1 portrait", "A2"]), st.booleans())
def test_whatever_stands_on_sheets_stands_free(
    boxes: list[Outline], format: str, russian: bool
) -> None:
    language = "ru" if russian else "en"
    rooms = room_on(format, language, True), room_on(format, language, False)
    found = composed([Order(tuple(boxes), rooms, format)])
    assert sorted(k for _, places in found for k in places) == list(range(len(boxes)))
    for sheet, places in found:
        placed = [box(boxes[k], at) for k, at in places.items()]
        inner = sheet.room.inner
        for one in placed:
            assert one[0] >= inner[0] + GAP - 0.02
            assert one[1] >= inner[1] + GAP - 0.02
            assert one[2] <= inner[2] - GAP + 0.02
            assert one[3] <= inner[3] - GAP + 0.02
            assert all(gap(one, taken) >= GAP - 0.02 for taken in sheet.room.occupied)
        assert all(gap(a, b) >= GAP - 0.02 for a, b in itertools.combinations(placed, 2))


def test_a_table_left_over_goes_to_a_sheet_that_has_room() -> None:
    full = [Outline(f"v{k}", 190.0, 130.0, ROW) for k in range(15)]
    table = Outline("table", 100.0, 120.0, TABLE)
    other = Outline("diagrams", 400.0, 300.0)
    assert len(shared([order(*full)])) == 1
    alone = shared([order(*full, table)])
    assert len(alone) == 2
    found = shared([order(*full, table), order(other)])
    assert [sheet.order for sheet in found] == [0, 1]
    assert found[1].boxes == (16, 15)


def test_a_plan_left_over_does_not_go_to_foreign_sheets() -> None:
    full = [Outline(f"v{k}", 190.0, 130.0, ROW) for k in range(16)]
    found = shared([order(*full), order(Outline("diagrams", 400.0, 300.0))])
    assert [sheet.order for sheet in found] == [0, 0, 1]
    sizes = sorted(len(sheet.boxes) for sheet in found)
    assert sizes == [1, 8, 8]


def test_a_polygon_stays_with_its_group() -> None:
    groups = [
        Outline(f"{name}{k}", 250.0, 200.0, Stand(f"g{k}", "pair"))
        for k in range(5)
        for name in "gf"
    ]
    for sheet, places in composed([order(*groups)]):
        for k in places:
            assert k ^ 1 in sheet.boxes
            assert gap(box(groups[k], places[k]), box(groups[k ^ 1], places[k ^ 1])) <= 25.0


def test_formats_are_tried_from_the_smallest() -> None:
    areas = [FORMATS[name].width * FORMATS[name].height for name in growing()]
    assert areas == sorted(areas)
    assert set(growing()) == set(FORMATS)


def test_a_format_far_too_large_is_told() -> None:
    few = order(Outline("a", 250.0, 150.0), Outline("b", 150.0, 100.0))
    (said,) = oversized([few], composed([few]), "ru")
    assert "A1 is far too large" in said
    assert 'format = "A3"' in said
    assert search.fits(few.outlines, room_on("A3", "ru", True)) is not None
    many = order(*(Outline(f"v{k}", 190.0, 120.0, ROW) for k in range(12)))
    assert oversized([many], composed([many]), "ru") == ()


@pytest.mark.parametrize("name", ["crank-rocker", "offset-slider"])
def test_a_format_is_found_for_auto_that_holds_all(name: str, tmp_path: Path) -> None:
    text = (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
    file = tmp_path / "scene.toml"
    for one in ("A1", "A4"):
        text = text.replace(f'format = "{one}"', 'format = "auto"')
    file.write_text(text, encoding="utf-8")
    scene = read(file)
    assert {sheet.format for sheet in scene.sheets} == {"auto"}
    found = formatted(scene)
    made, drawn = composed_sheets(scene)
    assert [sheet.format for sheet in drawn.sheets] == [sheet.format for sheet in found.sheets]
    assert made.scene.sheets == found.sheets
    assert not [told for told in drawn.remarks if "far too large" in told]
    again = formatted(scene, drawn.composition)
    assert again.sheets == found.sheets


def _taken(text: str, folder: Path) -> list[float]:
    """How full the sheets of a scene are; fails where one holds a small view alone."""
    file = folder / "random.toml"
    file.write_text(text, encoding="utf-8")
    made, drawn = composed_sheets(read(file))
    shares = []
    for index, (told, sheet) in enumerate(zip(drawn.composition.sheets, drawn.sheets, strict=True)):
        room = room_on(told.format, made.scene.language, index == 0)
        boxes = [Outline.of(view) for view in sheet.drawings[1:]]
        shares.append(sum(one.width * one.height for one in boxes) / room.area)
        assert len(boxes) > 1 or shares[-1] > 0.1, (sheet.name, boxes)
    return shares


@pytest.mark.slow
def test_random_mechanisms_choose_formats_that_they_fill(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    shares = [share for text in scenes(many(5, 2)) for share in _taken(text, tmp_path)]
    assert sum(shares) / len(shares) >= 0.45


def test_a_table_stands_beside_the_last_of_a_row() -> None:
    plans = [Outline(f"a{k}", w, h, ROW) for k, (w, h) in enumerate([(55, 88), (67, 68), (55, 89)])]
    boxes = [*plans, Outline("table", 87.0, 128.0, TABLE)]
    found = search.composed(boxes, room_on("A4", "en", False))
    assert found is not None
    tops = [at.imag + boxes[k].height for k, at in sorted(found.items())]
    assert max(tops[2:]) < min(found[0].imag, found[1].imag)
    assert found[3].real > found[2].real + boxes[2].width


@settings(max_examples=most(40), deadline=None)
@given(st.floats(20, 140), st.floats(0, 3))
def test_a_millimetre_decides_on_a_small_sheet(wide: float, left: float) -> None:
    room = room_on("A4", "en", False)
    whole = room.inner[2] - room.inner[0] - 3 * GAP
    boxes = [Outline("a", wide, 200.0), Outline("b", whole - wide - 1.0 - left, 200.0)]
    assert search.fits(boxes, room) is not None
    boxes[1] = boxes[1]._replace(width=whole - wide + 0.1)
    assert search.fits(boxes, room) is None
