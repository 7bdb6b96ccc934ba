"""A composition that is given: kept where it fits, mended where it does not, told either way."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from support.each import each
from support.gallery import SHEETS, paper

from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.composition import (
    Composition,
    composition_file,
    distinct_names,
    read_composition,
    text,
)
from graphic_tmm.paper.compose import search, sheets
from graphic_tmm.paper.compose.restored import restored
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.packing import GAP, Room, bounds
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

ROOM = Room((20.0, 5.0, 836.0, 589.0), ((651.0, 5.0, 836.0, 60.0), (20.0, 575.0, 90.0, 589.0)))
BOXES = (Outline("a", 100.0, 80.0), Outline("b", 200.0, 90.0), Outline("c", 50.0, 50.0))
ORDER = sheets.Order(BOXES, (ROOM, ROOM), "A1")


def test_boxes_stand_where_they_are_wanted() -> None:
    wanted = {0: 100 + 100j, 1: 300 + 100j, 2: 600 + 400j}
    found = restored([ORDER], [(0, wanted)])
    assert found is not None
    assert found.sheets[0][1] == wanted
    assert found.moved == found.added == ()


@pytest.mark.parametrize("wrong", [0 + 0j, 700 + 20j, 330 + 120j, 25 + 560j])
def test_a_box_that_does_not_fit_goes_to_the_nearest_free_place(wrong: complex) -> None:
    found = restored([ORDER], [(0, {0: 100 + 100j, 1: 300 + 100j, 2: wrong})])
    assert found is not None
    places = found.sheets[0][1]
    assert found.moved == (2,)
    assert places[0] == 100 + 100j
    assert abs(places[2] - wrong) < 120
    box = (places[2].real, places[2].imag, places[2].real + 50, places[2].imag + 50)
    for k in (0, 1):
        other = (
            places[k].real,
            places[k].imag,
            places[k].real + BOXES[k].width,
            places[k].imag + BOXES[k].height,
        )
        across = max(box[0] - other[2], other[0] - box[2])
        down = max(box[1] - other[3], other[1] - box[3])
        assert max(across, down) >= GAP - 1e-9


def test_what_it_does_not_name_is_added_and_what_has_no_room_makes_it_useless() -> None:
    found = restored([ORDER], [(0, {0: 100 + 100j})])
    assert found is not None
    assert found.added == (1, 2)
    large = sheets.Order(
        (Outline("a", 700.0, 400.0), Outline("b", 700.0, 400.0)), (ROOM, ROOM), "A1"
    )
    assert restored([large], [(0, {0: 30 + 100j})]) is None


def test_names_are_told_apart() -> None:
    assert distinct_names(["a", "b", "a", "a"]) == ["a", "b", "a 2", "a 3"]


def test_a_sheet_drawn_by_its_composition_is_the_same_to_the_byte(tmp_path: Path) -> None:
    shutil.copytree(SHEETS / "offset-slider", tmp_path / "s")
    scene = read(tmp_path / "s")
    _, first = composed_sheets(scene)
    (tmp_path / "s" / "composition.toml").write_text(text(first.composition), encoding="utf-8")
    given = read_composition(composition_file(scene.source))
    assert given == first.composition
    _, again = composed_sheets(scene, given)
    assert [svg(sheet) for sheet in again.sheets] == [svg(sheet) for sheet in first.sheets]
    assert again.remarks == ()


def test_nothing_is_searched_for_what_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = read(SHEETS / "offset-slider")
    _, first = composed_sheets(scene)
    tried: list[object] = []
    monkeypatch.setattr(search, "placed", lambda *told: tried.append(told))
    composed_sheets(scene, first.composition)
    assert tried == []


def test_a_view_moved_by_hand_stays_there() -> None:
    scene = read(SHEETS / "offset-slider")
    _, first = composed_sheets(scene)
    (sheet,) = first.composition.sheets
    name = next(view for view in sheet.views if view.startswith("table"))
    by = 0.5 - 0.25j
    moved = {**sheet.views, name: sheet.views[name] + by, "ghost": 1 + 1j}
    given = Composition(first.composition.sizes, (sheet._replace(views=moved),))
    made, again = composed_sheets(scene, given)
    boxes = {view.name: bounds(view) for view in again.sheets[0].drawings}
    assert complex(*boxes[name][:2]) == pytest.approx(moved[name], abs=1e-6)
    assert [text for text in made.scene.remarks if "ghost" in text]


@pytest.mark.turns(1, "other sheets")
@pytest.mark.slow
def test_a_composition_of_other_sheets_is_told_and_not_used() -> None:
    scene = read(SHEETS / "offset-slider")
    _, first = composed_sheets(scene)
    (sheet,) = first.composition.sheets
    given = Composition(first.composition.sizes, (sheet._replace(format="A2"),))
    made, again = composed_sheets(scene, given)
    assert again.sheets[0].format == "A1"
    assert again.composition.sheets == first.composition.sheets
    assert any("composed anew" in text for text in made.scene.remarks)


@pytest.mark.turns(1, "other sheets")
@pytest.mark.slow
def test_a_composition_is_the_start_of_a_variant(tmp_path: Path) -> None:
    shutil.copytree(SHEETS / "offset-slider", tmp_path / "s")
    file = tmp_path / "s" / "scene.toml"
    _, first = composed_sheets(read(file))
    scene = file.read_text(encoding="utf-8")
    assert "positions     = 12" in scene
    file.write_text(scene.replace("positions     = 12", "positions = 10"), encoding="utf-8")
    made, again = composed_sheets(read(file), first.composition)
    (before,), (after,) = first.composition.sheets, again.composition.sheets
    gone = set(before.views) - set(after.views)
    assert gone
    assert all(any(f"'{view}'" in text for text in made.scene.remarks) for view in gone)
    kept = [view for view, at in after.views.items() if abs(at - before.views.get(view, 0j)) < 0.05]
    assert len(kept) > len(after.views) / 2
    placed = [bounds(view) for view in again.sheets[0].drawings[1:]]
    for k, one in enumerate(placed):
        for other in placed[:k]:
            across = max(one[0] - other[2], other[0] - one[2])
            assert max(across, one[1] - other[3], other[1] - one[3]) > -0.05


@pytest.mark.turns(1, "other sheets")
@pytest.mark.slow
def test_a_composition_of_other_views_is_of_no_use() -> None:
    scene = read(SHEETS / "offset-slider")
    _, first = composed_sheets(scene)
    (sheet,) = first.composition.sheets
    few = dict(list(sheet.views.items())[:3])
    given = Composition({"velocities": 20.0}, (sheet._replace(views=few),))
    made, again = composed_sheets(scene, given)
    assert again.composition == first.composition
    assert any("composed anew" in text for text in made.scene.remarks)


def test_the_file_tells_people_the_scale_factors() -> None:
    scene = read(SHEETS / "offset-slider")
    made, found = composed_sheets(scene)
    lines = text(found.composition, found.scales).splitlines()
    for view, scale in made.mechanism.scales.items():
        assert f"# {view}: {scale.symbol} = {scale.value:g} {scale.unit}" in lines


HUGE = "9" * 400
"""A number that no arithmetic holds."""
WRONG = {
    "order = 0\nformat = 'A1'\n[sheet.views]\n": "order",
    "order = 1\nformat = 'A9'\n[sheet.views]\n": "format",
    "order = 1\nformat = 'A1'\n[sheet.views]\na = [1]\n": "views.a",
    "order = 1\nformat = 'A1'\n[sheet.views]\na = [1, nan]\n": "views.a",
    "order = true\nformat = 'A1'\n[sheet.views]\na = [1, 'x']\n": "order",
    "order = 1\nformat = {}\n": "format",
    "order = 1\nformat = ['A1']\n": "format",
    "order = 1\nformat = 'A1'\nviews = 3\n": "views",
    f"order = 1\nformat = 'A1'\n[sheet.views]\na = [{HUGE}, 0]\n": "views.a",
    f"order = 1.5\nformat = 'A1'\n[sizes]\nb = {HUGE}\n": "sizes.b",
    "order = 1\nformat = 'A1'\n[sizes]\nb = 1e-300\n": "sizes.b",
    "order = 1\nformat = 'A1'\n[sizes]\nb = inf\n": "sizes.b",
    "order = 1\nformat = 'A1'\n[sizes]\nb = {}\n": "sizes.b",
}


@each("says, key", WRONG.items())
def test_a_file_that_is_no_composition_is_refused(tmp_path: Path, says: str, key: str) -> None:
    file = tmp_path / "composition.toml"
    file.write_text(f"[[sheet]]\n{says}", encoding="utf-8")
    with pytest.raises(SceneError) as told:
        read_composition(file)
    assert key in told.value.faults[0].key
    assert read_composition(tmp_path / "nothing.toml") is None


def test_every_composition_of_the_package_can_be_written_and_read(tmp_path: Path) -> None:
    _, papers = paper("windrower")
    views = {
        f'{n} "{view.name}"': 1.25 + 2j for n, one in enumerate(papers) for view in one.drawings
    }
    from graphic_tmm.fitting.composition import Placed

    one = Composition({"plan of \\ é": 0.123456789012345}, (Placed(0, "A4 landscape", views),))
    file = tmp_path / "composition.toml"
    file.write_text(text(one), encoding="utf-8")
    assert read_composition(file) == one
