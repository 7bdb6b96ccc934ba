"""What a sheet can show: what the scene asks for, and nothing that it does not."""

from __future__ import annotations

from dataclasses import replace

import pytest
import shapely
from support.gallery import SHEETS

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import SceneError
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets


def views(scene: Scene) -> dict[str, Drawing]:
    return {view.name: view for sheet in sheets(scene)[1] for view in sheet.drawings}


def test_the_main_position_is_the_one_asked_for() -> None:
    scene = replace(read(SHEETS / "engine"), sheets=(SheetOrder("A1", ("positions",)),))
    for name in ("3", "11"):
        made, paper = sheets(replace(scene, main=name))
        work = made.mechanism
        assert work is not None
        pin = KINEMATICS_PLAN.on(work).positions.bodies[1].marks["A"]
        due = complex(work.reading[pin][0, work.project.names.index(name)])
        pivot = complex(work.reading[KINEMATICS_PLAN.on(work).positions.bodies[1].marks["O"]][0, 0])
        (view,) = (d for d in paper[0].drawings if d.name == "positions")
        (sheet_pivot,) = (
            complex(*s.path[0][:2])
            for s in view.strokes
            if isinstance(s, Stroke)
            and s.pen == "rod"
            and len(s.path) == 2
            and abs(abs(complex(*s.path[1][:2]) - complex(*s.path[0][:2])) - abs(due - pivot))
            < 1e-9
        )
        rods = [s for s in view.strokes if isinstance(s, Stroke) and s.pen == "rod"]
        ends = [complex(x, y) for s in rods for x, y, _ in s.path]
        assert min(abs(end - (sheet_pivot + due - pivot)) for end in ends) < 1e-9


@pytest.mark.slow
def test_a_common_pole_gives_one_view_for_all_positions() -> None:
    found = views(replace(read(SHEETS / "engine"), common_pole=True))
    assert [name for name in found if name.startswith("velocities")] == ["velocities"]
    assert "все положения" in found["velocities"].title
    assert any(name.startswith("accelerations-") for name in found)


def test_equations_stand_where_they_are_asked_for_only() -> None:
    scene = read(SHEETS / "engine")
    assert {"equations-velocities", "equations-accelerations"} <= set(views(scene))
    bare = replace(scene, sheets=(SheetOrder("A1", ("positions", "velocities")),))
    assert not any(name.startswith("equations") for name in views(bare))
    half = replace(scene, sheets=(SheetOrder("A1", ("velocities", "equations")),))
    found = views(half)
    assert "equations-velocities" in found
    assert "equations-accelerations" not in found


def test_tables_can_be_placed_one_by_one() -> None:
    order = SheetOrder("A1", ("positions", "accelerations", "acceleration table"))
    found = views(replace(read(SHEETS / "engine"), sheets=(order,)))
    assert "table-accelerations" in found
    assert "table-velocities" not in found


def test_a_scene_without_a_mechanism_draws_but_has_no_tables() -> None:
    scene = read(SHEETS / "lettering")
    made, paper = sheets(scene)
    work = made.mechanism
    assert work is None
    assert len(paper) == 1
    with pytest.raises(SceneError, match=r"no mechanism.*\[frame\]"):
        fitted(scene)


@pytest.mark.slow
def test_an_upright_a1_holds_a_scene_inside_its_frame() -> None:
    scene = read(SHEETS / "shaper")
    order = SheetOrder("A1 portrait", scene.sheets[0].place)
    _, (sheet,) = sheets(replace(scene, sheets=(order,)))
    assert (sheet.width, sheet.height) == (594.0, 841.0)
    area = drawing_area("A1 portrait", "ru", True)
    inside = shapely.box(*area.inner)
    taken = shapely.union_all([shapely.box(*block) for block in area.occupied])
    for view in sheet.drawings[1:]:
        for piece in (*map(shape, view.strokes), *map(box, view.labels)):
            assert inside.covers(piece)
            assert taken.disjoint(piece)
