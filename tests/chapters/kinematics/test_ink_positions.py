"""The plan of positions in ink: one position heavy, the others thin, every letter and number there."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from support.boards import drawn_of
from support.each import each
from support.gallery import NAMES, SHEETS, drawn

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.ink_positions import (
    SWEEP,
    PositionsFigure,
    PositionsInk,
    clear_start,
    draw_positions_ink,
)
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.kinematics.views import position_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, outline, shape
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, round_arrow
from graphic_tmm.scene.read import read

ROOM = 14.0
"""A letter stands at most so far from where its place was guessed, mm."""


def crank(name: str) -> tuple[Mark, Mark]:
    return KINEMATICS_PLAN.on(drawn(name, exact=True)).led


@cache
def plan(
    name: str, main: int = 1, skipped: tuple[int, ...] = (), sense: int = 1, lettered: bool = True
) -> Drawing:
    work = drawn(name, exact=True)
    made = KINEMATICS_PLAN.on(work)
    (pair,) = made.pairs
    drive = replace(pair.drive, speed=sense * abs(pair.drive.speed))
    pair = replace(pair, driven=pair.driven._replace(drive=drive))
    shown = PositionsFigure(work.project.names, main, skipped, crank(name))
    on = Subject(work.project.construction, work.reading, "Plan")
    view = draw_positions_ink(on, reaches(work), shown, [pair], made.positions)
    return finished(view, lettered)


def circled(label: Label, view: Drawing) -> bool:
    """Whether a label stands in a circle: it is the number of a link."""
    mid = box(label).centroid
    rings = [s for s in strokes(view, "thin") if s.closed and s.part == "number"]
    return any(abs(sum(spots(s)) / 2 - complex(mid.x, mid.y)) < 0.3 for s in rings)


def at(name: str, mark: Mark, index: int) -> complex:
    row = np.ravel(drawn(name, exact=True).reading[mark])
    return complex(row[index if row.size > 1 else 0])


def strokes(view: Drawing, pen: str) -> list[Stroke]:
    return [s for s in view.strokes if isinstance(s, Stroke) and s.pen == pen]


def spots(stroke: Stroke) -> list[complex]:
    return [complex(x, y) for x, y, _ in stroke.path]


@pytest.mark.parametrize("main", [0, 1, 5])
def test_the_main_position_is_drawn_with_rods_and_the_others_thin(main: int) -> None:
    view = plan("engine", main)
    body = KINEMATICS_PLAN.on(drawn("engine")).positions.bodies
    o, a = crank("engine")
    rods = [{(round(z.real, 6), round(z.imag, 6)) for z in spots(s)} for s in strokes(view, "rod")]
    b = body[2].marks["B"]
    for first, second in ((o, a), (a, b)):
        due = {
            (round(z.real, 6), round(z.imag, 6))
            for z in (at("engine", first, main), at("engine", second, main))
        }
        assert due in rods
    assert len(rods) == 2
    thin = shapely.union_all(
        [shapely.LineString([(z.real, z.imag) for z in spots(s)]) for s in strokes(view, "thin")]
    )
    for index in range(12):
        if index != main:
            middle = (at("engine", a, index) + 3 * at("engine", o, index)) / 4
            near = shapely.Point(middle.real, middle.imag)
            letters = shapely.union_all([box(label) for label in view.labels])
            assert thin.distance(near) < 1e-6 or letters.distance(near) < 1.0


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_every_position_has_its_number_outside_the_crank_circle(name: str) -> None:
    view, names = plan(name), drawn(name, exact=True).project.names
    o, a = crank(name)
    centre = at(name, o, 0)
    radius = abs(at(name, a, 0) - centre)
    for index, number in enumerate(names):
        pin = shapely.Point(at(name, a, index).real, at(name, a, index).imag)
        # the same number stands at sliders and at ends of rockers
        told = [
            one
            for one in view.labels
            if one.size in (3.5, 5.0) and number in one.text.strip(a.name + "_{}").split(", ")
        ]
        found = min((box(one) for one in told if not circled(one, view)), key=pin.distance)
        assert found.distance(pin) < 14.0
        mid = found.centroid
        assert abs(complex(mid.x, mid.y) - centre) > 0.5 * radius


@pytest.mark.parametrize("name", NAMES)
def test_every_letter_of_the_mechanism_stands_once(name: str) -> None:
    mechanism = KINEMATICS_PLAN.on(drawn(name, exact=True)).mechanism
    texts = [label.text for label in plan(name).labels if label.size == 5.0]
    found = [part.replace("_{", "").replace("}", "") for t in texts for part in t.split(", ")]
    due = {letter for link in mechanism.links for letter in link.points}
    assert due <= set(found)
    assert len(found) == len(set(found))


@pytest.mark.parametrize(
    ("name", "due"),
    [("windrower", "7, 7*"), ("tangent-mechanism", "6, 5*"), ("crank-rocker", "3*")],
)
def test_a_position_besides_the_row_shares_a_label_where_its_pin_is_the_same(
    name: str, due: str
) -> None:
    """7* two millimetres from 7 has no number of its own that had to stand far off; 3* is 5 mm from 4."""
    _, pin = crank(name)
    texts = [one.text for one in plan(name).labels if one.of == (pin.slot,)]
    assert texts.count(due) == 1
    assert len([text for text in texts if due[-2:] in text]) == 1


def test_positions_that_are_skipped_have_no_number_and_no_link() -> None:
    whole, part = plan("engine"), plan("engine", 1, (2, 3, 4))
    texts = [label.text for label in part.labels if not circled(label, part)]
    assert not {"3", "4", "5"} & set(texts)
    assert {"1", "2", "6"} <= set(texts)
    assert len(strokes(part, "thin")) < len(strokes(whole, "thin"))


@pytest.mark.parametrize("sense", [1, -1])
def test_the_arrow_of_the_drive_turns_with_the_crank(sense: int) -> None:
    view = plan("engine", 1, (), sense)
    heads = [s for s in strokes(view, "thin") if s.filled and len(s.path) == 3]
    assert len(heads) == 1
    tip, left, right = spots(heads[0])
    pivot = at("engine", crank("engine")[0], 0)
    along = tip - (left + right) / 2
    turning = ((tip - pivot).conjugate() * along).imag
    assert turning * sense > 0


def test_trajectories_are_smooth_curves_through_their_points() -> None:
    view = plan("engine")
    curves = [s for s in view.strokes if isinstance(s, Bezier)]
    assert curves
    assert all(curve.title.startswith("(S2") for curve in curves)
    controls = [z for curve in curves for z in curve.controls]
    mark = KINEMATICS_PLAN.on(drawn("engine")).positions.bodies[2].marks["S2"]
    for index in range(12):
        assert min(abs(z - at("engine", mark, index)) for z in controls) < 1e-6
    assert not [s for s in plan("windrower").strokes if isinstance(s, Bezier)]


def paths(scene: str, *letters: str) -> tuple[Drawn, list[Ink]]:
    """The paths of points on a plan of positions, by a hand without error."""
    work = drawn_of(replace(read(SHEETS / scene), trajectories=letters), exact=True)
    (view,) = position_views(work, True)
    named = {f"({letter}–{letter})" for letter in letters}
    return work, [s for s in view.strokes if isinstance(s, Stroke | Bezier) and s.title in named]


@each(
    "scene, letter, pivot, whole",
    [
        ("tipper", "S1", "O", False),
        ("tipper", "N", "O", False),
        ("crank-rocker", "A", "O", True),
        ("crank-rocker", "B", "C", False),
    ],
)
def test_the_path_of_a_point_about_a_pivot_is_an_arc_of_the_compass(
    scene: str, letter: str, pivot: str, whole: bool
) -> None:
    """Over the row, a circle of what turns all round; the signs of pins stand upon it."""
    work, pieces = paths(scene, letter)
    assert all(isinstance(piece, Stroke) for piece in pieces)
    positions = KINEMATICS_PLAN.on(work).positions
    row = work.reading[positions.point(letter)][0]
    centre = complex(work.reading[positions.point(pivot)].item())
    on = [z - centre for piece in pieces for z in outline(piece)]
    radius = abs(row[0] - centre)
    assert max(abs(abs(z) - radius) for z in on) < 1e-6
    ink = shapely.union_all([shape(piece) for piece in pieces])
    assert max(ink.distance(shapely.Point(z.real, z.imag)) for z in row) < 2.0
    far = [abs(np.angle(z / y)) for z in row - centre for y in row - centre]
    due = 2.0 * math.pi * radius if whole else max(far) * radius
    assert due - 8.0 < ink.length < due + 0.01


def test_a_point_between_moving_links_goes_by_the_french_curve() -> None:
    _, (path,) = paths("crank-rocker", "E")
    assert isinstance(path, Bezier)


def test_a_guide_is_hatched_over_the_travel_of_its_slider() -> None:
    view, mark = plan("engine"), KINEMATICS_PLAN.on(drawn("engine")).positions.bodies[2].marks["B"]
    travel = [at("engine", mark, k).real for k in range(12)]
    level = [
        s
        for s in strokes(view, "main")
        if len(s.path) == 2 and all(abs(z.imag) < 1e-6 for z in spots(s))
    ]
    reach = [(min(z.real for z in spots(s)), max(z.real for z in spots(s))) for s in level]
    assert any(low < min(travel) - 6 and high > max(travel) + 6 for low, high in reach)
    slanted = [
        s
        for s in strokes(view, "thin")
        if len(s.path) == 2
        and math.isclose(abs(math.degrees(cmath.phase((spots(s)[1] - spots(s)[0]) ** 4))), 180.0)
    ]
    assert len(slanted) > 20


def test_a_rocker_runs_through_its_stone() -> None:
    body = KINEMATICS_PLAN.on(drawn("windrower")).positions.bodies
    pivot, pin = body[3].marks["B"], crank("windrower")[1]
    a, b = at("windrower", pin, 1), at("windrower", pivot, 1)
    rods = [
        shapely.LineString([(z.real, z.imag) for z in spots(s)])
        for s in strokes(plan("windrower"), "main")
        if not s.filled
    ]
    behind = a + (a - b) / abs(a - b) * 5.5
    assert min(rod.distance(shapely.Point(behind.real, behind.imag)) for rod in rods) < 1e-6


def test_a_mass_centre_is_a_small_circle() -> None:
    mark = KINEMATICS_PLAN.on(drawn("engine")).positions.bodies[2].marks["S2"]
    centre = at("engine", mark, 1)
    round_ones = [
        s
        for s in strokes(plan("engine"), "joint")
        if abs(sum(spots(s)) / 2 - centre) < 1e-6 and s.closed
    ]
    assert [abs(spots(s)[1] - spots(s)[0]) for s in round_ones] == pytest.approx([1.8])


@pytest.mark.parametrize("name", NAMES)
def test_an_unlettered_plan_takes_about_the_room_of_a_lettered_one(name: str) -> None:
    full, bare = bounds(plan(name)), bounds(plan(name, lettered=False))
    assert all(circled(label, plan(name)) for label in plan(name, lettered=False).labels)
    assert all(abs(x - y) < ROOM for x, y in zip(full, bare, strict=True))


@each("scene, turned", [("gripper", "M"), ("toggle-press", "C"), ("windrower", "B")])
def test_no_link_runs_through_the_support_of_its_pivot(scene: str, turned: str) -> None:
    """In any position; that of a crank, which runs through every side, hangs down."""
    work = drawn_of(read(SHEETS / scene), exact=True)
    made = KINEMATICS_PLAN.on(work)
    ink = PositionsInk(work.construction, work.reading, reaches(work), [0])
    pin = work.reading[made.positions.point(turned)].item()
    foot = [one for one in ink.pivots() if one.of == (made.positions.point(turned).slot,)]
    stands = shapely.union_all([shape(one) for one in foot]).convex_hull
    stands = stands.difference(shapely.Point(pin.real, pin.imag).buffer(2.5))
    for name in ink.names:
        for k in range(len(work.names)):
            lines = [shape(one) for one in ink.lines(name, k, ("thin", "thin"))]
            assert not shapely.union_all(lines).intersects(stands), (name, k)
    assert all(ink.supports[crank] == 0.0 for crank, _ in made.arms)


def test_the_number_of_the_frame_stands_at_a_turned_support() -> None:
    work = drawn_of(read(SHEETS / "toggle-press"), exact=True)
    (view,) = position_views(work, True)
    (frame,) = [one for one in view.labels if one.text == "6" and circled(one, view)]
    c = work.reading[KINEMATICS_PLAN.on(work).positions.point("C")].item()
    assert 0.0 < (frame.at - c).imag < 12.0


@each("sense", [1, -1])
@each("bearing", range(-180, 180, 15))
def test_the_arrow_of_the_crank_stands_clear_of_the_foot_of_its_pivot(
    bearing: int, sense: int
) -> None:
    start = clear_start(10.0, float(bearing), sense)
    arrow = [shape(s) for s in round_arrow(0j, 10.0, start, sense * SWEEP)]
    foot = [shape(s) for s in fixed_pivot(0j)]
    assert min(a.distance(b) for a in arrow for b in foot) > 0.5
    ahead = (start - bearing) * sense
    assert 20 <= ahead <= 340 - SWEEP  # it neither begins nor ends on the crank
