"""Cams in ink: what the log drew; letters clear of each other; what is missing leaves no ink."""

from __future__ import annotations

import math
from functools import cache
from itertools import combinations

import numpy as np
import pytest
import shapely
from support.cams import C6, Made, made, outline

from graphic_tmm.chapters.cam.centre import Convexity
from graphic_tmm.chapters.cam.flat_rocker import FaceRegion
from graphic_tmm.chapters.cam.ink import ProfileNames, draw_profile_ink
from graphic_tmm.chapters.cam.ink_centre import CentreNames, draw_centre_ink, draw_rocker_ink
from graphic_tmm.chapters.cam.ink_flat import draw_convexity_ink
from graphic_tmm.chapters.cam.ink_flat_rocker import draw_face_ink
from graphic_tmm.chapters.cam.ink_rules import DIAGRAM_RULES
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Law,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.graph import Names, Span, draw_graph
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, flat, shape
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

WALL = HEIGHTS["A1"]
ROCKING = {**C6, "stroke": 0.35, "pressure": 40.0}
FACE = {**C6, "stroke": 0.25}
TRIANGLES = Law("diagram", ((0, 0), (0.25, 1), (0.75, -1), (1, 0)))
ORDERS = {
    "central": CamTask(**C6, r0=0.0521, roller=0.0168),
    "clockwise offset": CamTask(**C6, follower=RollerFollower(0.01), turns="clockwise"),
    "cosine": CamTask(**C6, rise_law=Law("cosine"), return_law=Law("constant acceleration")),
    "given": CamTask(**C6, rise_law=TRIANGLES, return_law=Law("3-4-5")),
    "rocker": CamTask(**ROCKING, follower=RockerFollower(0.08, 0.1)),
    "rocker along": CamTask(
        **ROCKING, follower=RockerFollower(0.08, 0.1, same_sense=True), turns="clockwise"
    ),
    "flat": CamTask(**C6, follower=FlatFollower(0.005)),
    "flat rocker": CamTask(**FACE, follower=FlatRockerFollower(0.09, 0.01, 0.004)),
    "flat rocker along": CamTask(
        **FACE, follower=FlatRockerFollower(0.09, same_sense=True), turns="clockwise"
    ),
    "no dwells": CamTask(0.02, 180, 0, 180, 0),
}


@cache
def drawn(name: str) -> Made:
    return made(ORDERS[name])


def positions(of: Made) -> list[str]:
    return [str(k) for k in range(of.cam.diagrams.turn.positions)]


def graph(of: Made, view: str, lettered: bool = True) -> Drawing:
    phases = (("φ_{1}", 100.0), ("φ_{2}", 120.0), ("φ_{3}", 210.0), ("φ_{4}", 360.0))
    ends = [0.0, *(end for _, end in phases)]
    spans = [
        Span(a * 240 / 360, b * 240 / 360, text) for a, (text, b) in zip(ends, phases, strict=False)
    ]
    names = Names(positions(of), "S", "φ", spans=spans if view == "cam S" else ())
    on = Subject(of.log, of.reading, "X")
    drawn = draw_graph(on, view, of.reading.positions, names, DIAGRAM_RULES)
    return finished(drawn, lettered)


def centre(of: Made, lettered: bool = True) -> Drawing:
    names = CentreNames(positions(of), "S", "dS/dφ", "r_{min}", "r_{0}")
    on = Subject(of.log, of.reading, "X", WALL)
    if isinstance(of.cam.centre, FaceRegion):
        return finished(draw_face_ink(on, of.cam, names), lettered)
    if isinstance(of.cam.centre, Convexity):
        return finished(draw_convexity_ink(on, of.cam, names), lettered)
    draw = draw_rocker_ink if isinstance(of.cam.path, Lever) else draw_centre_ink
    return finished(draw(on, of.cam, names), lettered)


def bare_profile(of: Made) -> Drawing:
    names = ProfileNames(positions(of), "r_{0}", "r", "theoretical", "working")
    return draw_profile_ink(Subject(of.log, of.reading, "X", WALL), of.cam, names)


def profile(of: Made, lettered: bool = True) -> Drawing:
    return finished(bare_profile(of), lettered)


def graphs(of: Made) -> list[str]:
    found = [figure.view for figure in of.log.figures if figure.kind == "axes"]
    return sorted(set(found))


def views(of: Made, lettered: bool = True) -> list[Drawing]:
    return [
        *(graph(of, view, lettered) for view in graphs(of)),
        centre(of, lettered),
        profile(of, lettered),
    ]


def sheet(of: list[Drawing]) -> str:
    return svg(Sheet("x", "x", "A1", 841.0, 594.0, tuple(of)))


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ORDERS)
def test_letters_stand_clear_of_each_other_and_number_every_position(name: str) -> None:
    """On the diagrams every position has its tick; where the numbers have no room every second bears one."""
    of = drawn(name)
    for view in views(of):
        boxes = [box(label) for label in view.labels]
        for a, b in combinations(range(len(boxes)), 2):
            pair = (view.labels[a].text, view.labels[b].text)
            assert boxes[a].disjoint(boxes[b]), (view.name, pair)
        texts = ", ".join(label.text for label in view.labels).split(", ")
        every = 2 if view.name in graphs(of) and "1" not in texts else 1
        assert set(positions(of)[::every]) <= set(texts), view.name
        if view.name in graphs(of):
            (feet,) = {
                f.marks[3] for f in of.log.figures if f.view == view.name and f.kind == "axes"
            }
            ticks = {s.position for s in view.strokes if s.of == (feet.slot,)}
            assert ticks == set(range(of.reading.positions))


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ORDERS)
def test_unlettered_views_take_about_the_room_of_lettered_ones(name: str) -> None:
    for bare, view in zip(views(drawn(name), False), views(drawn(name)), strict=True):
        assert bare.cell is not None
        room = shapely.box(*bare.cell).buffer(1e-6)
        ink = [stroke for stroke in view.strokes if stroke.part != "leader"]
        assert all(room.covers(shape(stroke)) for stroke in ink), view.name
        assert all(room.buffer(15.0).covers(box(label)) for label in view.labels), view.name


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ORDERS)
def test_the_same_cam_gives_the_same_ink_and_all_of_it_is_finite(name: str) -> None:
    first = sheet(views(drawn(name)))
    assert "nan" not in first
    assert first == sheet(views(made(ORDERS[name])))


@pytest.mark.parametrize("name", [n for n in ORDERS if n != "no dwells"])
def test_the_diagrams_are_drawn_over_the_whole_turn(name: str) -> None:
    """Curves, dwells and jumps join: every end of one is the beginning of another."""
    of = drawn(name)
    for view in ("cam S", "cam dS", "cam ddS"):
        ink = [s for s in graph(of, view, False).strokes if s.pen == "main"]
        ends: list[complex] = []
        for stroke in ink:
            if isinstance(stroke, Bezier):
                ends += [stroke.controls[0], stroke.controls[-1]]
            elif not stroke.closed:
                ends += [complex(*stroke.path[0][:2]), complex(*stroke.path[-1][:2])]
        loose = [z for z in ends if sum(abs(z - w) < 0.31 for w in ends) < 2]
        assert all(min(abs(z), abs(z - 240.0)) < 0.31 for z in loose), (view, loose)
        assert max(z.real for z in ends) == pytest.approx(240.0)
        assert min(z.real for z in ends) == pytest.approx(0.0)


@pytest.mark.slow
@pytest.mark.parametrize("name", ORDERS)
def test_the_profiles_in_ink_are_those_that_were_proven(name: str) -> None:
    of = drawn(name)
    mu = of.one(of.cam.profile.mu)
    contours = {"main": of.cam.profile.working}
    if of.cam.profile.theoretical is not None:
        contours["medium"] = of.cam.profile.theoretical
    for pen, contour in contours.items():
        inked = [s for s in profile(of, False).strokes if isinstance(s, Bezier) and s.pen == pen]
        assert len(inked) == len(contour.curves)
        ring = shapely.LinearRing([(z.real, z.imag) for z in outline(of, contour) / mu])
        for stroke in inked:
            for z in flat(stroke.controls):
                assert ring.distance(shapely.Point(z.real, z.imag)) < 1e-3


def test_the_tangents_leave_the_curve_on_one_side_and_meet_above_the_chosen_centre() -> None:
    of = drawn("central")
    ink = centre(of, False)
    curve = of.reading[of.cam.centre.points][0]
    lines = [
        s
        for s in ink.strokes
        if isinstance(s, Stroke) and s.pen == "main" and len(s.path) == 2 and not s.closed
    ]
    assert len(lines) == 2
    for stroke in lines:
        a, b = (complex(x, y) for x, y, _ in stroke.path)
        away = ((curve - a) * np.conj(1j * (b - a) / abs(b - a))).real
        assert abs(math.degrees(math.atan2((b - a).real, (b - a).imag))) == pytest.approx(30.0)
        assert min(away.max(), -away.min()) < 0.02  # the tangency lies between positions
    apex, least, chosen = (
        complex(of.reading[mark][0, 0]).imag
        for mark in (of.cam.centre.apex, of.cam.centre.least_centre, of.cam.centre.centre)
    )
    assert chosen < max(apex, least)


@pytest.mark.parametrize("name", ["central", "cosine"])
def test_a_semicircle_is_divided_at_its_points(name: str) -> None:
    of = drawn(name)
    for view in ("cam S", "cam dS", "cam ddS"):
        steps = [s for s in of.log.steps if s.it.view == view and s.op.name == "divide_semicircle"]
        assert steps
        arcs = [shape(s) for s in graph(of, view, False).strokes if isinstance(s, Stroke)]
        whole = shapely.union_all([one for one in arcs if one.geom_type == "LineString"])
        for step in steps:
            for z in of.reading[step.it][0]:
                if np.isfinite(z):  # 20° chords stand for an arc
                    assert whole.distance(shapely.Point(z.real, z.imag)) < 1.0


@pytest.mark.parametrize("name", [n for n in ORDERS if n != "no dwells"])
def test_the_phases_on_the_profile_are_those_of_the_task(name: str) -> None:
    """Arcs about the centre, end to end, each as long as its phase; they bear the letters of the diagrams."""
    of, order = drawn(name), ORDERS[name]
    ink = bare_profile(of)
    bows = [
        s for s in ink.strokes
        if isinstance(s, Stroke) and s.part == "dimension" and s.path[0][2] and not s.closed
    ]  # fmt: skip
    turns = [sum(math.degrees(4 * math.atan(bulge)) for *_, bulge in s.path) for s in bows]
    due = (order.rise, order.upper_dwell, order.fall, order.lower_dwell)
    assert [abs(turn) for turn in turns] == pytest.approx(due)
    assert all((turn < 0) == (order.turns == "counterclockwise") for turn in turns)
    radii = {round(abs(complex(*vertex[:2])), 6) for s in bows for vertex in s.path}
    assert len(radii) == 1
    texts = {one.text for one in ink.wanted}
    assert {"φ_{1}", "φ_{2}", "φ_{3}", "φ_{4}"} <= texts


@pytest.mark.slow
def test_a_cam_that_cannot_be_drawn_leaves_what_can() -> None:
    """No centre, no profile; the diagrams stand, and no coordinate is missing on the sheet."""
    of = made(
        CamTask(**{**ROCKING, "stroke": 0.5, "pressure": 34.0}, follower=RockerFollower(0.08, 0.1))
    )
    assert np.isnan(of.one(of.cam.r0))
    assert "nan" not in sheet(views(of))
    assert len([s for s in graph(of, "cam S").strokes if isinstance(s, Bezier)]) == 2
    undercut = made(CamTask(**C6, r0=0.0521, roller=0.045))
    assert "nan" not in sheet(views(undercut))


def test_what_a_flat_cam_shows_is_lettered_as_what_it_is() -> None:
    """Its region is S over d²S/dφ², its diagram of curvature that of the radius."""
    scene = Scene("", "T", "en").asking(cam=ORDERS["flat"])
    (work,) = make(scene, exact=True).boards
    shown = [label.text for view in cam_views(work, True) for label in view.labels]
    assert "d^2S/dφ^2, m" in shown
    assert "ρ, m" in shown
    assert "Radius of curvature of the profile" in shown
    assert not any(text.startswith(("κ", "dS/dφ,")) for text in shown)


def test_positions_that_stand_close_are_numbered_by_twos_or_fives() -> None:
    small = made(CamTask(**{**C6, "mu_l": 0.003}, r0=0.0521, roller=0.0168))
    texts = ", ".join(label.text for label in centre(small).labels).split(", ")
    told = {int(text) for text in texts if text.isdigit()}
    every = min(told - {0})
    assert every in (2, 5)
    assert told == set(range(0, small.cam.diagrams.turn.positions, every))
