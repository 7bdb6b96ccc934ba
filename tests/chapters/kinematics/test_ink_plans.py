"""Plans in ink: the vectors of the log have their ends; a vector of no length has no arrow."""

from __future__ import annotations

import math
import re
from functools import cache

import numpy as np
import pytest
import shapely
from support.each import each
from support.gallery import NAMES, NO_PLANS, PLANS, drawn

from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.ink_plans import (
    Place,
    draw_plan,
    vectors,
)
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import kinematic_columns
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.rules import BEYOND
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box
from graphic_tmm.paper.symbols.kinematic import POLE_RADIUS

PLANNED = [name for name in NAMES if name not in NO_PLANS]
"""Scenes with plans of velocities."""


@cache
def plan(name: str, which: str, index: int, lettered: bool = True) -> Drawing:
    work = drawn(name, exact=True)
    reading = work.of("accelerations") if which == "accelerations" else work.reading
    assert reading is not None
    log, mu = work.project.construction, work.scales[which].value
    view = draw_plan(Subject(log, reading, "X"), which, [Place(index)], mu, "m/s")
    return finished(view, lettered)


def arrows(view: Drawing) -> dict[str, Stroke]:
    return {dict(s.data)["segment"]: s for s in view.strokes if isinstance(s, Stroke) and s.data}


def ends(stroke: Stroke) -> tuple[complex, complex]:
    (x0, y0, _), (x1, y1, _) = stroke.path
    return complex(x0, y0), complex(x1, y1)


def heads(view: Drawing) -> list[Stroke]:
    """The filled triangles; the pole is a filled circle."""
    return [s for s in view.strokes if isinstance(s, Stroke) and s.filled and len(s.path) == 3]


def test_vectors_of_the_engine_are_those_of_its_plans() -> None:
    log = drawn("engine").project.construction
    found = [(v.start.letter, v.end.letter, v.segment) for v in vectors(log, "velocities")]
    assert found == [("p", "a", "pa"), ("a", "b", "ab"), ("p", "b", "pb"), ("p", "s2", "ps2")]
    found = [(v.start.letter, v.end.letter, v.segment) for v in vectors(log, "accelerations")]
    assert ("a", "n2", "an2") in found
    assert ("n2", "b", "n2b") in found
    assert [v.absolute for v in vectors(log, "velocities")] == [True, False, True, True]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "which"), PLANS)
def test_a_vector_runs_between_its_points_as_long_as_its_segment(name: str, which: str) -> None:
    work = drawn(name, exact=True)
    reading = work.of("accelerations") if which == "accelerations" else work.reading
    assert reading is not None
    log = work.project.construction
    lengths = {m.letter: m for m in work.project.marks(which) if m.kind.__name__ == "Length"}
    pole = log.view(which)
    assert pole is not None
    for vector in vectors(log, which):
        span = np.abs(reading[vector.end] - reading[vector.start])
        due = np.abs(reading[lengths[vector.segment]])
        assert np.allclose(span, due, rtol=0, atol=1e-9), vector.segment
        assert vector.absolute == (vector.start == pole.pole)


def test_an_arrow_points_at_its_point_and_tells_its_length() -> None:
    work = drawn("engine")
    found = arrows(plan("engine", "velocities", 1))
    assert set(found) == {"pa", "ab", "pb", "ps2"}
    log = work.project.construction
    for vector in vectors(log, "velocities"):
        start, end = (
            complex(np.ravel(work.reading[m])[-1 if np.ravel(work.reading[m]).size == 1 else 1])
            for m in (vector.start, vector.end)
        )
        stroke = found[vector.segment]
        first, shaft = ends(stroke)
        assert abs(first - start) < 1e-9
        assert 0 < abs(end - shaft) < 4.5
        assert abs(((end - start).conjugate() * (end - shaft)).imag) < 1e-6
        data = dict(stroke.data)
        assert data["mm"] == f"{abs(end - start):.2f}"
        assert float(data["value"]) == pytest.approx(0.25 * abs(end - start), rel=1e-5)
        assert stroke.pen == ("main" if vector.absolute else "medium")
        tips = [complex(*head.path[0][:2]) for head in heads(plan("engine", "velocities", 1))]
        assert min(abs(tip - end) for tip in tips) < 1e-9


def test_a_vector_of_no_length_has_no_arrow_and_its_ends_share_a_letter() -> None:
    view = plan("engine", "velocities", 3)  # position 4: the rod moves without turning
    assert set(arrows(view)) == {"pa", "pb", "ps2"}
    assert len(heads(view)) == 3
    assert sorted(label.text for label in view.labels) == ["a, b, s_{2}", "p"]
    dead = plan("engine", "velocities", 0)  # position 1: the piston stands
    assert set(arrows(dead)) == {"pa", "ab", "ps2"}
    assert "p, b" in {label.text for label in dead.labels}


@pytest.mark.slow
@pytest.mark.parametrize("name", PLANNED)
def test_every_point_of_a_plan_is_lettered_once(name: str) -> None:
    work = drawn(name, exact=True)
    points = [m for m in work.project.marks("velocities") if m.kind.__name__ == "Point"]
    for index in range(len(work.project.names)):
        texts = ", ".join(label.text for label in plan(name, "velocities", index).labels).split(
            ", "
        )
        assert sorted(texts) == sorted(["p", *(markup(m.letter) for m in points)])


@pytest.mark.parametrize("name", PLANNED)
def test_construction_lines_go_on_behind_their_intersection(name: str) -> None:
    work, view = drawn(name, exact=True), plan(name, "velocities", 1)
    log = work.project.construction
    thin = shapely.union_all(
        [
            shapely.LineString([(x, y) for x, y, _ in s.path])
            for s in view.strokes
            if isinstance(s, Stroke) and s.pen == "thin"
        ]
    )
    boxes = shapely.union_all([shapely.buffer(box(label), 0.5) for label in view.labels])
    by_mark = {step.it: step for step in log.steps}
    tried = 0
    for step in log.steps:
        if step.it.view != "velocities" or step.op.name != "meet":
            continue
        for used in step.uses:
            at = [np.ravel(work.reading[m]) for m in (by_mark[used].uses[0], step.it)]
            start, end = (complex(row[1 if row.size > 1 else 0]) for row in at)
            if abs(end - start) < 2.0:
                continue
            behind = end + (end - start) / abs(end - start) * (BEYOND - 0.01)
            spot = shapely.Point(behind.real, behind.imag)
            assert thin.distance(spot) < 0.02 or boxes.distance(spot) < 1.0
            tried += 1
    assert tried


def test_the_pole_is_a_dot() -> None:
    dots = [
        s
        for s in plan("engine", "velocities", 2).strokes
        if isinstance(s, Stroke) and s.filled and len(s.path) == 2
    ]
    assert len(dots) == 1
    (x0, y0, _), (x1, y1, _) = dots[0].path
    assert math.dist((x0, y0), (x1, y1)) == pytest.approx(2 * POLE_RADIUS)


@pytest.mark.parametrize("name", PLANNED)
def test_an_unlettered_plan_takes_about_the_room_of_a_lettered_one(name: str) -> None:
    for index in range(3):
        bare = plan(name, "velocities", index, False)
        assert bare.cell is not None
        room = shapely.box(*bare.cell)
        full = plan(name, "velocities", index)
        arrows_only = [
            shapely.LineString([(x, y) for x, y, _ in s.path]) for s in arrows(full).values()
        ]
        assert all(room.covers(one) for one in arrows_only)


@each(
    "letter, due",
    [
        ("a", "a"),
        ("s2", "s_{2}"),
        ("a3", "a_{3}"),
        ("ps2", "ps_{2}"),
        ("pa12", "pa_{12}"),
        ("d3d", "d_{3}d"),
        ("b2c3", "b_{2}c_{3}"),
        ("b′", "b′"),
        ("n_{ab}", "n_{ab}"),
        ("ω_2", "ω_2"),
        ("12", "12"),
        ("", ""),
    ],
)
def test_figures_at_the_end_of_a_letter_become_an_index(letter: str, due: str) -> None:
    assert markup(letter) == due


def test_plans_from_a_common_pole_are_those_of_the_single_positions() -> None:
    work = drawn("crank-rocker")
    log, mu = work.project.construction, work.scales["velocities"].value
    places = [Place(k, name) for k, name in enumerate(work.project.names)]
    view = finished(draw_plan(Subject(log, work.reading, "X"), "velocities", places, mu, "m/s"))
    lengths = sorted(dict(s.data)["mm"] for s in view.strokes if isinstance(s, Stroke) and s.data)
    single = [
        dict(s.data)["mm"]
        for k in range(len(places))
        for s in arrows(plan("crank-rocker", "velocities", k)).values()
    ]
    assert set(lengths) <= set(single)
    assert len(single) - len(lengths) <= 1  # too short beside the longest of all positions
    texts = ", ".join(label.text for label in view.labels).split(", ")
    assert texts.count("p") == 1
    # the rocker's extreme: an image without velocity lies in the pole, and is named there
    assert any(label.text.startswith("b_{0}, ") for label in view.labels)
    for name in work.project.names:
        assert f"a_{{{name}}}" in texts
        assert f"s_{{2,{name}}}" in texts
    pens = {s.pen for s in view.strokes if isinstance(s, Stroke) and s.data}
    assert pens <= {"medium", "thin"}


@pytest.mark.parametrize(("name", "plan_"), PLANS)
def test_points_in_one_place_share_a_label_by_the_alphabet(name: str, plan_: str) -> None:
    """The pole first, then images by the alphabet, then the ends of normal and Coriolis components."""
    names = drawn(name, exact=True).row(plan_)
    for k in range(len(names)):
        for label in plan(name, plan_, k).labels:
            told = label.text.split(", ")
            # by themselves these are the images of points K and N
            ends = [one for one in told if one[0] in "nk" and one not in ("k", "n")]
            assert told == sorted(told, key=lambda one: (one not in "pπ", one in ends, one))


def test_no_two_labels_of_a_plan_name_points_in_one_place() -> None:
    """Arrows that end within a millimetre end in one place: their letters are told apart by a comma."""
    view = plan("tangent-mechanism", "velocities", 7)
    assert "d_{3}, e" in {label.text for label in view.labels}


def test_the_number_of_a_position_follows_in_the_index() -> None:
    assert markup("a", "5") == "a_{5}"
    assert markup("a3", "5*") == "a_{3,5*}"


@pytest.mark.parametrize("name", ["windrower", "shaper", "oscillating-cylinder"])
def test_the_rockers_point_under_the_pin_has_its_vector(name: str) -> None:
    """Its acceleration is that of a point of a link turning about a fixed pivot: r·√(ω⁴ + ε²)."""
    work = drawn(name, exact=True)
    made = KINEMATICS_PLAN.on(work)
    pivot = work.reading[made.positions.closings[0].legs[1].pivot][0]
    reach = np.abs(work.reading[made.led[1]] - pivot)[0] * work.scales["positions"].value
    rows = {(c.plan, c.segment): c.value[0] for c in kinematic_columns(work)}
    omega, epsilon = rows["velocities", "omega3"], rows["accelerations", "epsilon3"]
    due = reach * np.sqrt(omega**4 + epsilon**2)
    found = rows["accelerations", "πa3"]
    there = np.isfinite(found)
    assert there.sum() == len(work.row("accelerations"))
    assert found[there] == pytest.approx(due[there], rel=1e-9)
    for index in range(len(work.row("accelerations"))):
        assert "πa3" in arrows(plan(name, "accelerations", index))


def test_images_found_by_similarity_stand_on_their_lines() -> None:
    work, view = drawn("crank-rocker", exact=True), plan("crank-rocker", "accelerations", 0)
    log = work.project.construction
    steps = [s for s in log.steps if s.op.name == "similar" and s.it.view == "accelerations"]
    due = [s for s in steps if s.it.name in ("s2", "e")]
    assert len(due) == 2
    for step in due:
        sides = [s for s in view.strokes if s.of == (step.it.slot,) and s.pen == "thin"]
        assert len({s.path for s in sides}) >= 2
    velocity = plan("crank-rocker", "velocities", 1)
    alike = {s.it.slot for s in log.steps if s.op.name == "similar" and s.it.view == "velocities"}
    assert not [s for s in velocity.strokes if s.pen == "thin" and not s.part and set(s.of) & alike]


@pytest.mark.parametrize(("name", "which"), PLANS)
def test_a_table_calls_a_segment_by_letters_of_the_plan(name: str, which: str) -> None:
    work = drawn(name, exact=True)
    points = {m.name for m in work.project.marks(which) if m.kind.__name__ == "Point"} | {"p", "π"}
    columns = [c for c in kinematic_columns(work) if c.plan == which and c.drawn]
    assert columns
    for column in columns:
        ends = [
            (column.segment[:k], column.segment[k:])
            for k in range(1, len(column.segment))
            if {column.segment[:k], column.segment[k:]} <= points
        ]
        assert ends, column.letter
    assert len({c.segment for c in columns}) == len(columns)
    draw = views.velocity_table if which == "velocities" else views.acceleration_table
    (table,) = draw(work, True)
    texts = {label.text for label in table.labels}
    assert {markup(c.segment) for c in columns} <= texts
    assert not [text for text in texts if re.match(r"[nktr]_\{[a-z]", text)]
