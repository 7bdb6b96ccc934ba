"""The figures of a cam read its log: every step leaves ink, pictures add up to the views."""

from __future__ import annotations

import random

import numpy as np
import pytest
from support.cams import made
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact

from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.cam.centre import Convexity
from graphic_tmm.chapters.cam.flat_rocker import FaceRegion
from graphic_tmm.chapters.cam.ink import ProfileNames, draw_profile_ink
from graphic_tmm.chapters.cam.ink_centre import CentreNames, draw_centre_ink, draw_rocker_ink
from graphic_tmm.chapters.cam.ink_flat import draw_convexity_ink
from graphic_tmm.chapters.cam.ink_flat_rocker import draw_face_ink
from graphic_tmm.chapters.cam.ink_rules import TRACELESS
from graphic_tmm.chapters.cam.ink_scheme import SchemeNames, draw_scheme_ink, position_of
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)
from graphic_tmm.chapters.cam.views import cam_views, scheme_views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import pictures
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject

WALL = HEIGHTS["A1"]
LAWS = ("sine", "cosine", "constant acceleration", "3-4-5")


def views(order: CamTask) -> tuple[Construction, list[Drawing]]:
    of = made(order)
    on = Subject(of.log, of.reading, "X", WALL)
    names = [str(k) for k in range(of.cam.diagrams.turn.positions)]
    told = CentreNames(names, "S", "dS/dφ", "r_{min}", "r_{0}")
    if isinstance(of.cam.centre, FaceRegion):
        centre = draw_face_ink(on, of.cam, told)
    elif isinstance(of.cam.centre, Convexity):
        centre = draw_convexity_ink(on, of.cam, told)
    else:
        draw = draw_rocker_ink if isinstance(of.cam.path, Lever) else draw_centre_ink
        centre = draw(on, of.cam, told)
    letters = ProfileNames(names, "r_{0}", "r", "theoretical", "working")
    profile = draw_profile_ink(on, of.cam, letters)
    return of.log, [finished(centre), finished(profile)]


def assert_laws(log: Construction, drawn: list[Drawing]) -> None:
    assert not without_ink(log, drawn, TRACELESS)
    for view in drawn:
        assert not without_source(view)
        assert_pictures_make_the_view(log, view)


def random_order(draw: random.Random, kind: str) -> CamTask:
    """A cam that can be drawn: four phases that make a turn, laws at random."""
    cuts = sorted(draw.sample(range(8, 28), 3))
    phases = [12.0 * n for n in (cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1])]
    phases = [max(phase, least) for phase, least in zip(phases, (70.0, 0.0, 70.0), strict=True)]
    phases = [phase * min(1.0, 330.0 / sum(phases)) for phase in phases]
    follower: Follower
    stroke, pressure = draw.uniform(0.01, 0.03), 35.0
    if kind == "rocker":
        follower = RockerFollower(0.1, 0.13, same_sense=draw.random() < 0.5)
        stroke, pressure = draw.uniform(0.15, 0.3), 45.0
    elif kind == "flat rocker":
        follower = FlatRockerFollower(0.12, draw.choice((0.0, 0.01)), 0.004, draw.random() < 0.5)
        stroke = draw.uniform(0.1, 0.2)
    elif kind == "flat":
        follower = FlatFollower(0.004)
    else:
        follower = RollerFollower(0.006 if kind == "offset" else 0.0)
    return CamTask(
        stroke,
        *(round(phase, 3) for phase in phases),
        round(360.0 - sum(round(phase, 3) for phase in phases), 3),
        rise_law=Law(draw.choice(LAWS)),
        return_law=Law(draw.choice(LAWS)),
        follower=follower,
        turns=draw.choice(("clockwise", "counterclockwise")),
        pressure=pressure,
    )


def test_steps_of_the_scene_are_its_ink() -> None:
    (work,) = (work for work in exact("cam").boards if "cam" in work.recorded)
    own = {"cam centre", "cam profile"}
    drawn = [view for view in cam_views(work, True) if own & set(view.shows)]
    assert {name for view in drawn for name in view.shows} == own
    assert_laws(work.construction, drawn)


@pytest.mark.parametrize("kind", ["central", "offset", "rocker", "flat", "flat rocker"])
def test_the_scheme_shows_the_follower_as_it_stands(kind: str) -> None:
    """The roller's centre of a rod stands above its guide's foot; angles are those that the log measured."""
    order = random_order(random.Random(f"scheme {kind}"), kind)
    of = made(order)
    on = Subject(of.log, of.reading, "X", WALL)
    view = finished(draw_scheme_ink(on, of.cam, SchemeNames("α", "r")))
    assert not without_source(view)
    assert_pictures_make_the_view(of.log, view)
    k = position_of(of.reading, of.cam)
    rollers = [stroke for stroke in view.strokes if stroke.part == "roller"]
    if kind.startswith("flat"):
        assert not rollers
        return
    (rim,) = [stroke for stroke in rollers if stroke.pen == "main"]
    centre = complex(sum(x for x, _, _ in rim.path), sum(y for _, y, _ in rim.path)) / 2
    profile = of.cam.profile
    assert profile.theoretical is not None
    at = complex(of.reading[profile.theoretical.points][0, k])
    assert abs(centre) == pytest.approx(abs(at))
    angle = of.reading.figure(of.cam.diagrams.angle)[0, k]
    assert centre == pytest.approx(at * np.exp(1j * of.cam.sense * np.radians(angle)), abs=1e-9)
    offset = 0.006 if kind == "offset" else 0.0
    if kind != "rocker":
        mu = of.reading[profile.mu].item()
        assert centre.real * mu == pytest.approx(of.cam.sense * offset, abs=1e-9)


def test_the_scheme_of_the_scene_shows_the_largest_pressure_angle() -> None:
    (work,) = (work for work in exact("cam").boards if "cam" in work.recorded)
    (view,) = scheme_views(work, True)
    assert any("α = 25,9°" in label.text for label in view.labels)
    assert {"contour", "roller", "follower", "normal", "circle"} <= {s.part for s in view.strokes}


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["central", "offset", "rocker", "flat", "flat rocker"])
def test_steps_of_random_cams_are_their_ink(kind: str) -> None:
    draw = random.Random(kind)
    for _ in range(4):
        assert_laws(*views(random_order(draw, kind)))


def test_a_cam_is_drawn_position_by_position_and_its_dwells_when_both_curves_are_there() -> None:
    log, (_, profile) = views(CamTask(0.02, 100.0, 30.0, 90.0, 140.0))
    made_ = pictures(log, profile)
    again = [picture.position for picture in made_ if picture.again]
    assert set(again) == set(range(1, max(n for n in again if n is not None) + 1))
    dwells = [stroke for stroke in profile.strokes if stroke.part == "contour"]
    assert len(dwells) == 4, "two dwells of either profile"
    done = {n: picture for n, picture in enumerate(made_) if set(picture.ink) & set(dwells)}
    assert min(done) > 3
