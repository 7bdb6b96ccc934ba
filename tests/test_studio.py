"""The whole road: what comes out of it as paper, as scale factors, as warnings."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from support.boards import drawn_of
from support.gallery import NAMES, SHEETS, paper

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Row, Side
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.packaged import packaged, scene_name, scene_path
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scales, Scene, SheetOrder
from graphic_tmm.studio import sheet_files, sheets

SVG = "{http://www.w3.org/2000/svg}"
ROUNDING = 1e-6


def views(name: str) -> Iterator[tuple[Sheet, bool, tuple[Drawing, ...]]]:
    """Every sheet, whether it is the first, and its views without the frame."""
    for index, sheet in enumerate(paper(name)[1]):
        yield sheet, index == 0, sheet.drawings[1:]


def ink(view: Drawing) -> list[Any]:
    return [*map(shape, view.strokes), *map(box, view.labels)]


# the paper


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_sheet_is_an_svg_in_true_millimetres(name: str) -> None:
    for sheet in paper(name)[1]:
        root = ElementTree.fromstring(svg(sheet))
        assert root.tag == f"{SVG}svg"
        width, height = {"A1": (841, 594), "A2": (594, 420), "A4": (210, 297)}[sheet.format]
        assert (root.get("width"), root.get("height")) == (f"{width}mm", f"{height}mm")
        assert root.get("viewBox") == f"0 0 {width} {height}"
        assert (sheet.width, sheet.height) == (width, height)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_all_ink_of_a_view_lies_inside_the_frame(name: str) -> None:
    language = paper(name)[0].scene.language
    for sheet, first, plans in views(name):
        area = drawing_area(sheet.format, language, first)
        inside = shapely.box(*area.inner)
        taken = shapely.union_all([shapely.box(*block) for block in area.occupied])
        for view in plans:
            for piece in ink(view):
                assert shapely.covers(inside, piece), (view.name, piece.bounds)
                assert not shapely.intersects(taken, piece), (view.name, piece.bounds)


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_inked_beyond_the_paper(name: str) -> None:
    for sheet in paper(name)[1]:
        area = shapely.box(0, 0, sheet.width, sheet.height)
        for view in sheet.drawings:
            for piece in ink(view):
                assert shapely.covers(area, piece), (view.name, piece.bounds)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_views_do_not_overlap(name: str) -> None:
    for _, _, plans in views(name):
        for one, other in combinations(plans, 2):
            shared = shapely.intersection(shapely.box(*bounds(one)), shapely.box(*bounds(other)))
            assert shared.area <= ROUNDING, (one.name, other.name)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_view_keeps_its_ink_within_the_room_it_takes(name: str) -> None:
    for _, _, plans in views(name):
        for view in plans:
            room = shapely.buffer(shapely.box(*bounds(view)), ROUNDING)
            for piece in ink(view):
                assert shapely.covers(room, piece), view.name


@pytest.mark.parametrize("name", NAMES)
def test_no_letter_stands_on_another(name: str) -> None:
    for _, _, plans in views(name):
        for view in plans:
            boxes = [box(label) for label in view.labels]
            tree = shapely.STRtree(boxes)
            for i, j in tree.query(boxes, predicate="intersects").T:
                if i < j:
                    shared = shapely.intersection(boxes[i], boxes[j]).area
                    assert shared <= ROUNDING, (view.name, view.labels[i], view.labels[j])


@pytest.mark.parametrize("name", NAMES)
def test_every_plan_asked_for_is_on_a_sheet_with_its_scale(name: str) -> None:
    whole, papers = paper(name)
    made = whole.mechanism
    plans = {view.name: view for sheet in papers for view in sheet.drawings}
    placed = {plan for order in made.scene.sheets for plan in order.place}
    due = {"positions"} if "positions" in placed else set()
    if "velocities" in placed:
        names = made.project.names
        common = made.scene.common_pole
        turn = names[: KINEMATICS_PLAN.on(made).in_turn]  # of later turns the plans are the same
        due |= {"velocities"} if common else {f"velocities-{k}" for k in turn}
    if "accelerations" in placed:
        due |= {
            f"accelerations-{made.project.names[k]}" for k in KINEMATICS_PLAN.on(made).accelerated
        }
    assert due <= set(plans)
    for view in due:
        symbol = {"p": "μ_l", "v": "μ_v", "a": "μ_a"}[view[0]]
        (sheet,) = (one for one in papers if plans[view] in one.drawings)
        lines = [label.text for label in plans[view].labels]
        # of several plans the title above their row tells it once
        above = (one for one in sheet.drawings if one.name.startswith("heading-"))
        lines += [label.text for one in above for label in one.labels]
        assert any(re.search(rf"(^|, ){symbol} = ", text) for text in lines), view


@pytest.mark.parametrize("name", NAMES)
def test_the_plans_fit_on_the_sheets_ordered(name: str) -> None:
    whole, papers = paper(name)
    made = whole.mechanism
    due = [order.format for order in made.scene.sheets]
    assert [sheet.format for sheet in papers] == due


def test_sheets_are_named_after_their_folder() -> None:
    _, texts = sheet_files(read(SHEETS / "crank-rocker"))
    assert list(texts) == [f"crank-rocker-{k + 1}.svg" for k in range(len(texts))]


# scale factors


def four_bar(*, left: int = 1, r: float = 0.1, d: float = 0.45) -> Mechanism:
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(d, 0)}),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j, "B": 0.4 + 0j, "S2": 0.2 + 0.05j}),
            Link(3, {"C": 0j, "B": 0.3 + 0j}, side=Side(left, ("A", "C"))),
        ),
        Drive(1, 10.0, 20.0),
    )


def scene(**changes: Any) -> Scene:
    made = Scene("", "Test", "en", four_bar(), Row(6, accelerations=("1", "2")))
    return replace(made, **changes)


def drawn_length(made: Drawn, view: str, letter: str) -> float:
    """The drawn distance, mm, of a point of a plan from the plan's pole or pivot, at position 1."""
    log = made.project.construction
    mark = next(step.it for step in log.steps if (step.it.view, step.it.letter) == (view, letter))
    reading = made.of("accelerations") if view == "accelerations" else made.reading
    assert reading is not None
    row = np.ravel(reading[mark])
    return float(abs(row[min(1, row.size - 1)]))


def test_scale_factors_that_a_scene_fixes_are_kept() -> None:
    fixed = Scales(mu_l=0.004, mu_v=0.03, mu_a=0.7)
    made = drawn_of(scene(scales=fixed), exact=True)
    assert [scale.value for scale in made.scales.values()] == [0.004, 0.03, 0.7]
    assert math.isclose(drawn_length(made, "positions", "A"), 25.0)
    assert math.isclose(drawn_length(made, "velocities", "a"), 1.0 / 0.03)
    pull = 0.1 * abs(complex(20.0, 100.0))
    assert math.isclose(drawn_length(made, "accelerations", "a"), pull / 0.7)


def test_segments_that_a_scene_fixes_come_out_so_long() -> None:
    made = drawn_of(scene(scales=Scales(OA=37.0, pa=41.0, pi_a=53.0)), exact=True)
    assert math.isclose(drawn_length(made, "positions", "A"), 37.0)
    assert math.isclose(drawn_length(made, "velocities", "a"), 41.0)
    assert math.isclose(drawn_length(made, "accelerations", "a"), 53.0)


@pytest.mark.parametrize("speed", [10.0, -10.0])
def test_mu_l_omega_makes_pa_as_long_as_the_crank(speed: float) -> None:
    mechanism = replace(four_bar(), drive=Drive(1, speed))
    made = drawn_of(scene(mechanism=mechanism, scales=Scales(mu_v_is_mu_l_omega=True)), exact=True)
    crank = drawn_length(made, "positions", "A")
    assert math.isclose(drawn_length(made, "velocities", "a"), crank)
    assert made.scales["velocities"].value > 0


@pytest.mark.parametrize("name", NAMES)
def test_chosen_scale_factors_are_standard(name: str) -> None:
    made = paper(name)[0].mechanism
    wanted = made.scene.scales
    fixed = {
        "positions": wanted.mu_l or wanted.OA,
        "velocities": wanted.mu_v or wanted.pa or wanted.mu_v_is_mu_l_omega,
        "accelerations": wanted.mu_a or wanted.pi_a,
    }
    for plan, scale in made.scales.items():
        if plan in fixed and not fixed[plan]:
            digits = scale.value / 10 ** math.floor(math.log10(scale.value) + 1e-9)
            assert any(math.isclose(digits, due) for due in (1, 1.5, 2, 2.5, 4, 5, 7.5, 8)), scale


def test_the_ruler_rounds_readings_and_exact_does_not() -> None:
    made, exact = drawn_of(scene(ruler=0.5)), drawn_of(scene(ruler=0.5), exact=True)
    log = made.project.construction
    reads = [s.it for s in log.steps if s.op.reads and s.it.view == "velocities"]
    assert reads
    rounded = np.concatenate([np.ravel(made.reading[mark]) for mark in reads])
    assert np.allclose(rounded * 2, np.round(rounded * 2), rtol=0, atol=1e-9)
    plain = np.concatenate([np.ravel(exact.reading[mark]) for mark in reads])
    assert not np.allclose(plain * 2, np.round(plain * 2), rtol=0, atol=1e-3)
    assert np.abs(rounded - plain).max() <= 0.25 + 1e-9


# plans that are not asked for


def test_a_plan_that_is_not_asked_for_is_not_recorded() -> None:
    made = drawn_of(scene(row=Row(6), sheets=(SheetOrder("A4", ("positions",)),)))
    assert KINEMATICS_PLAN.on(made).velocities is None
    assert KINEMATICS_PLAN.on(made).accelerations is None
    assert list(made.scales) == ["positions"]
    assert not made.project.marks("velocities")
    assert not made.project.marks("accelerations")


def test_no_acceleration_plan_without_positions_for_it() -> None:
    made = drawn_of(scene(row=Row(6)))
    assert KINEMATICS_PLAN.on(made).velocities is not None
    assert KINEMATICS_PLAN.on(made).accelerations is None


# warnings


def test_a_whole_turn_gives_no_warning() -> None:
    assert warnings(drawn_of(scene())) == ()


def test_positions_that_cannot_be_drawn_are_named_and_the_others_are_drawn() -> None:
    rocking = four_bar(r=0.3, d=0.5)  # d + r > AB + BC: no whole turn
    whole, papers = sheets(scene(mechanism=rocking, row=Row(8, accelerations=("0",))))
    made = whole.mechanism
    assert made is not None
    reach = math.degrees(math.acos((0.3**2 + 0.5**2 - 0.7**2) / (2 * 0.3 * 0.5)))
    gone = [str(k) for k in range(8) if reach < 45 * k < 360 - reach]
    assert 0 < len(gone) < 8
    assert [made.project.names[k] for k in made.undrawn] == gone
    told = "\n".join(warnings(made))
    assert f"positions {', '.join(gone)} cannot be drawn" in told
    assert f"{reach:.2f}°" in told
    inked = {view.name for sheet in papers for view in sheet.drawings}
    for k in range(8):
        assert (f"velocities-{k}" in inked) == (str(k) not in gone)


def test_no_position_at_all_is_an_error() -> None:
    rocking = four_bar(r=0.3, d=0.5)
    with pytest.raises(StructureError, match="none of the positions"):
        drawn_of(scene(mechanism=rocking, row=Row(1, zero=180.0)))


def test_an_unknown_point_or_position_is_refused_in_words() -> None:
    with pytest.raises(StructureError, match="no point Q"):
        drawn_of(scene(trajectories=("Q",)))
    with pytest.raises(StructureError, match=r"no position 9; there are 0, 1, 2, 3, 4, 5"):
        drawn_of(scene(row=Row(6, accelerations=("9",))))


# scenes by name


def test_scenes_are_found_by_name_and_the_default_is_the_windrower() -> None:
    assert {path.name for path in packaged()} >= set(NAMES)
    assert scene_path("engine").name == "engine"
    assert scene_path(None).name == "windrower"
    assert scene_name(read(scene_path("engine")).source) == "engine"


@pytest.mark.parametrize("name", ["nothing-of-this-name", "../sheets", "."])
def test_a_name_that_is_no_scene_is_refused_in_words(name: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError):
        read(scene_path(name) if not name.startswith(".") else tmp_path / name)
