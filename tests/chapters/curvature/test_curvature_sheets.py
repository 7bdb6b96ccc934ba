"""What sheets, tables and tasks say of curvature: refusals, positions without a drawing, the sheet as drawn."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

import graphic_tmm
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.scales import FAR
from graphic_tmm.chapters.curvature.task_sheet import asks
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.errors import TmmError
from graphic_tmm.paper.seen import Subject
from graphic_tmm.readers.table import columns_of
from graphic_tmm.studio import make

SCENE = graphic_tmm.read("coupler-curvature")
SLIDER: dict[str, Any] = {
    "title": "T", "language": "en",
    "frame": {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"}},
    "link": [
        {"number": 1, "points": {"O": [0, 0], "A": [0.1, 0]}},
        {"number": 2, "points": {"A": [0, 0], "B": [0.25, 0], "K": [0.1, 0.08]}},
        {"number": 3, "points": {"B": [0, 0]},
         "slides": {"on": "frame", "along": "x", "side": "right"}},
    ],
    "drive": {"link": 1, "speed": "10 rad/s", "turns": "counterclockwise", "zero": "0 deg",
              "positions": 12},
}  # fmt: skip


def slider(**asked: Any) -> dict[str, Any]:
    """A slider-crank in line whose curvature is asked for."""
    return {**copy.deepcopy(SLIDER), "curvature": asked}


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        ({}, "nothing is asked for"),
        ({"link": 1}, "link 1 turns about O"),
        ({"link": 3}, "link 3 does not turn"),
        ({"link": 7}, "no moving link 7"),
        ({"link": 2, "points": ["B"]}, "B slides on a straight guide"),
        ({"points": ["K", "O"]}, "no link has all of the points K, O"),
        ({"points": ["Z"]}, "no point of a moving link"),
        ({"link": 2, "ball": True}, "Ball's point wants"),
        ({"link": 2, "positions": [77]}, "no position 77"),
    ],
)
def test_what_cannot_be_found_is_refused_in_a_sentence(asked: dict[str, Any], says: str) -> None:
    with pytest.raises(TmmError, match=says):
        make(graphic_tmm.read(slider(**asked)))


def test_a_mechanism_at_rest_is_refused() -> None:
    scene = slider(link=2)
    scene["drive"]["speed"] = 0
    with pytest.raises(TmmError, match="stands still and has no plan of accelerations"):
        make(graphic_tmm.read(scene))


def test_where_the_rod_only_moves_along_nothing_is_told_but_a_finding() -> None:
    sheet = graphic_tmm.draw(slider(link=2, positions="all"), exact=True)
    table, circles = sheet.table("curvature"), sheet.table("bresse")
    for name in ("3", "9"):  # the crank is square to the guide: ω2 = 0
        at = table.positions.index(name)
        assert all(np.isnan(one.value[0, at]) for one in table.values())
        assert np.isnan(circles["WP"].value[0, at])
        assert np.isfinite(circles["xΠ"].value[0, at]), "it gains speed turning"
    assert any("lines are parallel" in one and "3, 9" in one for one in sheet.warnings)
    assert any("Centres of curvature: not drawn in positions 3, 9" in one for one in sheet.warnings)


def test_each_position_has_its_scale_and_reaches_no_farther_than_told() -> None:
    board = make(graphic_tmm.read(slider(link=2, positions="all"))).boards[0]
    made = CURVATURE_PLAN.on(board)
    for figure in made.figures:
        reach, mu = board.reach["curvature"][figure.mu], board.reading[figure.mu]
        sizes = np.array([reach[k] / mu[0, k] for k in reach])
        assert sizes.max() <= 1.02 * board.sizes["curvature"]
        assert sizes.min() > 0.35 * board.sizes["curvature"], "the next scale would do"
        assert max(reach.values()) < FAR * 0.4


def test_the_circles_meet_in_the_pole_of_accelerations() -> None:
    table = graphic_tmm.draw(SCENE, exact=True).table("bresse")
    at = table.positions.index("1")
    assert abs(table["WP"].mm[0, at] - table["WΠ"].mm[0, at]) < 1e-9


def test_any_angle_by_the_scene_s_ruler_is_near_what_is_exact() -> None:
    exact, read = (
        graphic_tmm.motion(SCENE, [30.0, 100.0], plans="curvature", exact=one)
        for one in (True, False)
    )
    for name, places in exact.centres.items():
        off = abs(read.centres[name] - places) / (1.0 + abs(places))
        assert off.max() < 3e-3, name
    with pytest.raises(TmmError, match=r"write \[curvature\]"):
        graphic_tmm.motion("crank-rocker", 0.0, plans="curvature")


def test_a_task_names_what_is_sought() -> None:
    sentences = " ".join(asks(SCENE, "ru"))
    assert "точек K" in sentences
    assert "построением Бобилье" in sentences
    assert "круги Бресса" in sentences
    assert "точку Болла" in sentences
    assert "звена 2" in " ".join(asks(graphic_tmm.read(slider(link=2)), "ru"))


def test_a_value_is_its_segment_times_mu() -> None:
    board = make(SCENE).boards[0]
    for figure in CURVATURE_PLAN.on(board).figures:
        mu = board.reading[figure.mu][0, 0]
        for column in graphic_tmm.draw(SCENE).table(figure.view).values():
            there = np.isfinite(column.mm[0])
            np.testing.assert_allclose(column.value[0, there], column.mm[0, there] * mu, rtol=1e-11)
            assert [*np.flatnonzero(np.isfinite(column.value[0]))] == [1]


def test_a_path_that_rows_ask_for_is_read_once() -> None:
    """`[rows] paths` and [curvature] of one point: the normal part stands once on the plan, ρ is the same."""
    scene = {**slider(points=["K"], positions=[1], circles=False), "rows": {"paths": ["K"]}}
    scene["drive"]["accelerations"] = [1]
    drawn = make(graphic_tmm.read(scene)).boards[0]
    named = [step.it.letter for step in drawn.construction.steps]
    assert [named.count(name) for name in ("(v_{K})", "(n_{k})", "n_{k}", "t_{k}")] == [1, 1, 1, 1]
    rows = {(one.plan, one.segment): one.value[0] for one in columns_of(drawn)}
    assert rows["curvature", "rhoK"][1] == rows["accelerations", "rhoK"][1] > 0.0


@pytest.mark.parametrize("rows", [{}, {"paths": ["K"]}], ids=["curvature", "rows"])
def test_parts_of_an_acceleration_are_drawn_on_its_plan(rows: dict[str, Any]) -> None:
    """πk is squared off on the normal to pk, from which ρ is read: to a foot with its letter; so is a row's."""
    scene = slider(link=2, positions=[2])
    scene["drive"]["accelerations"] = [2]
    if rows:
        scene |= {"rows": rows}
        del scene["curvature"]
    board = make(graphic_tmm.read(scene)).boards[0]
    log, reading = board.construction, board.of("accelerations")
    assert reading is not None
    plan = draw_plan(Subject(log, reading, "X"), "accelerations", [Place(0)], 1.0, "m/s²")
    parts = [
        one
        for one in log.steps
        if one.op.name == "measure_along" and one.it.name in ("n_{k}", "t_{k}")
    ]
    assert len(parts) == (2 if rows else 1)
    for one in parts:
        pole, end = (complex(np.ravel(reading[mark])[0]) for mark in one.uses[:2])
        way = complex(np.ravel(reading[one.uses[2]].along)[0])
        foot = pole + ((end - pole) / way).real * way
        off = abs(foot - pole) - abs(float(np.ravel(reading[one.it])[0]))
        assert abs(off) <= 0.05 + 1e-9, "half a division of the ruler"
        for start in (pole, end):
            assert any(_runs(stroke, start, foot) for stroke in plan.strokes), one.it.name
        (letter,) = (at for at in plan.wanted if at.of == (one.it.slot,))
        assert abs(letter.at - foot) < 1e-9


def _runs(stroke: Any, start: complex, end: complex) -> bool:
    """Whether a thin line goes from one place to another."""
    if stroke.pen != "thin" or len(getattr(stroke, "path", ())) != 2:
        return False
    places = [complex(*corner[:2]) for corner in stroke.path]
    return max(abs(a - b) for a, b in zip(places, (start, end), strict=True)) < 1e-9
