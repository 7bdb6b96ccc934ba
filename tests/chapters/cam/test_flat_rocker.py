"""A flat face on a lever: lowered onto the profile it gives back the law; curvature, contact, least r0."""

from __future__ import annotations

import random
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.cams import (
    C6,
    SHAPES,
    Made,
    made,
    motion,
    outline,
    polygon,
    swung,
)
from support.flat_faces import least_under_face, radii_under_face
from support.scenes import written

from graphic_tmm.board.findings import examine
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.task import CamTask, FlatFollower, Follower, Law
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.scene.read import read

ANGLES = np.arange(720) * 0.5
THIN = 2.5e-4
"""A thin line on a drawing in full size, m: what differs by less is the same on paper."""
FOLLOWERS = {
    "through the pivot": FlatRockerFollower(0.09, 0.0, 0.004),
    "nearer the cam": FlatRockerFollower(0.09, 0.012, 0.004),
    "along": FlatRockerFollower(0.09, 0.0, 0.004, same_sense=True),
    "nearer and along": FlatRockerFollower(0.09, 0.012, 0.004, same_sense=True),
}


@cache
def drawn(name: str, turns: str = "counterclockwise", parts_: int = 12) -> Made:
    order = CamTask(
        np.radians(15.0), 120.0, 30.0, 100.0, 110.0, rise_law=Law("3-4-5"), return_law=Law("sine"),
        follower=FOLLOWERS[name], turns=turns, divisions=parts_,
    )  # fmt: skip
    return made(order)


def off(of: Made) -> float:
    """How far the lowered lever is from its law at most, m at the contact."""
    angles, places = swung(of, ANGLES)
    return float(np.abs((angles - motion(of.cam.order, ANGLES)[0]) * places).max())


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_face_lowered_onto_the_profile_gives_back_the_law(name: str, turns: str) -> None:
    """The profile is a smooth curve of the fourth order: with twice the positions it is 16 times as near."""
    coarse, fine = (off(drawn(name, turns, n)) for n in (12, 24))
    assert coarse < 1e-5
    assert fine < coarse / 8 + 1e-7


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_contact_is_where_the_face_meets_the_profile(name: str) -> None:
    of = drawn(name, parts_=24)
    _, places = swung(of, ANGLES)
    farthest, nearest = (of.one(one.value) for one in of.cam.contact.extremes)
    assert (farthest, nearest) == pytest.approx((places.max(), places.min()), abs=THIN / 2)
    assert of.one(of.cam.face) == pytest.approx(farthest - nearest)


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_radius_of_curvature_is_that_of_the_support_of_the_face(name: str) -> None:
    of = drawn(name)
    r0, angles = of.one(of.cam.r0), np.array(of.cam.diagrams.turn.angles)
    mu = of.one(of.cam.curvature.chart.mu)
    for mark, (_, first, last) in zip(
        of.cam.curvature.chart.ordinates, of.cam.diagrams.stretches, strict=True
    ):
        inside = slice(first + 1, last)
        due = radii_under_face(of.cam.order, r0, angles[inside])
        np.testing.assert_allclose(of.reading[mark][0, inside] * mu, due, atol=1e-7)
    rest = radii_under_face(of.cam.order, r0, np.array([135.0, 300.0]))
    level = of.reading[of.cam.centre.rest][0, [12, -1]] * of.one(of.cam.profile.mu)
    np.testing.assert_allclose(level, rest, atol=1e-7)


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_least_radius_is_that_at_which_the_profile_is_just_convex_enough(name: str) -> None:
    of = drawn(name, parts_=96)
    assert of.one(of.cam.least) == pytest.approx(least_under_face(of.cam.order), abs=5e-5)


def test_a_dwell_too_wants_its_least_radius() -> None:
    """A slow small swing is convex anywhere: then the circle of the lower dwell decides."""
    follower = FlatRockerFollower(0.1, 0.01, 0.02)
    laws = {"rise_law": Law("cosine"), "return_law": Law("cosine")}
    of = made(CamTask(np.radians(2.0), 150.0, 20.0, 150.0, 40.0, follower=follower, **laws))
    assert of.one(of.cam.least) == pytest.approx(0.02, abs=1e-9)
    assert of.one(of.cam.profile.mu) * of.reading[of.cam.profile.working.lower].radius[
        0, 0
    ] == pytest.approx(of.one(of.cam.r0))


@pytest.mark.parametrize("follower", [FlatRockerFollower(0.1), FlatFollower()], ids=repr)
def test_where_any_radius_will_do_a_millimetre_is_taken(follower: Follower) -> None:
    stroke = 0.03 if isinstance(follower, FlatRockerFollower) else 0.002
    laws = {"rise_law": Law("cosine"), "return_law": Law("cosine")}
    of = made(CamTask(stroke, 170.0, 10.0, 170.0, 10.0, follower=follower, **laws))
    assert of.one(of.cam.least) <= 1e-9
    assert of.one(of.cam.r0) == 0.001
    assert not cam_findings(of.reading, of.cam)


def random_order(draw: random.Random) -> CamTask:
    rise, fall = draw.uniform(80, 140), draw.uniform(90, 140)
    upper = draw.choice((0.0, draw.uniform(5, 60)))
    face = draw.choice((0.0, draw.uniform(0.002, 0.015)))
    centres, along = draw.uniform(0.08, 0.14), draw.random() < 0.5
    law, back = (Law(draw.choice(list(SHAPES))) for _ in range(2))
    follower = FlatRockerFollower(centres, face, draw.uniform(0.003, 0.008), along)
    return CamTask(
        np.radians(draw.uniform(5.0, 12.0)), rise, upper, fall, 360.0 - rise - upper - fall,
        rise_law=law, return_law=back, follower=follower,
        turns=draw.choice(("clockwise", "counterclockwise")), divisions=24,
    )  # fmt: skip


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10))
def test_random_levers_are_moved_by_their_profiles(seed: int) -> None:
    """Ten a seed. Half a thin line: near a jump of the acceleration the smooth curve is of a lower order."""
    draw = random.Random(f"flat rocker {seed}")
    for _ in range(10):
        order = random_order(draw)
        of = made(order)
        assert not cam_findings(of.reading, of.cam), order
        assert polygon(outline(of, of.cam.profile.working)).is_valid
        assert off(of) < THIN / 2, order


def test_a_radius_too_small_is_a_finding_with_the_least_one() -> None:
    order = drawn("through the pivot").cam.order
    small = made(CamTask(**{**vars(order), "r0": 0.045}))
    (hollow,) = cam_findings(small.reading, small.cam)
    assert hollow.kind == "hollow"
    assert hollow.least == pytest.approx(1000 * small.one(small.cam.least))
    dense = np.arange(150.25, 250.0, 0.5)
    worst = dense[np.argmin(radii_under_face(order, 0.045, dense))]
    assert hollow.angle == pytest.approx(worst, abs=4.0)  # half a part of the return
    assert "take 55." in hollow.says("en")


def test_where_the_least_radius_was_drawn_too_small_a_larger_one_is_the_remedy() -> None:
    """12 parts draw it 0.13 mm too small: between both a larger r0 helps; where no centre is left none does."""
    follower, laws = FlatRockerFollower(0.11, 0.0, 0.004), (Law("cosine"), Law("3-4-5"))
    angles = {"rise": 80.0, "upper_dwell": 20.0, "fall": 78.0, "lower_dwell": 182.0}
    order = CamTask(0.2, **angles, rise_law=laws[0], return_law=laws[1], follower=follower)
    due = least_under_face(order)
    of = made(replace(order, r0=due - 1e-4))
    assert of.one(of.cam.least) < of.one(of.cam.r0)
    (hollow,) = cam_findings(of.reading, of.cam)
    assert hollow.kind == "hollow"
    assert due < hollow.least / 1000.0 < due + 2e-3
    of = made(replace(order, r0=0.1095, follower=replace(follower, least=0.1)))
    assert "hollow lever" in {one.kind for one in cam_findings(of.reading, of.cam)}


def test_a_lever_that_swings_back_as_fast_as_the_cam_turns_has_no_contact_there() -> None:
    """On the return the lever falls at up to 1.9 of the cam's speed: its face does not turn on against it."""
    follower = FlatRockerFollower(0.09)
    of = made(CamTask(1.0, 120.0, 60.0, 60.0, 120.0, follower=follower, r0=0.04))
    missing = examine(of.log, of.given, [of.cam.profile.working.points])
    gone = [f for f in missing if f.kind == "undrawn"]
    assert [f.step.op.name for f in gone] == ["turning_against"]
    speed = motion(of.cam.order, np.array(of.cam.diagrams.turn.angles))[1]
    assert list(gone[0].positions) == list(np.flatnonzero(speed <= -1.0))


def test_what_a_flat_rocker_has_and_others_have_not(tmp_path: Path) -> None:
    head = '[cam]\nrise = 120\nfall = 90\nstroke = "{stroke}"\nfollower = "{follower}"\n'
    for text, key in (
        (head.format(stroke="10 mm", follower="flat rocker") + 'centres = "80 mm"\n', "stroke"),
        (head.format(stroke="10 deg", follower="flat rocker"), "centres"),
        (
            head.format(stroke="10 deg", follower="flat rocker")
            + 'centres = "80 mm"\nlever = "70 mm"\n',
            "lever",
        ),
        (head.format(stroke="10 mm", follower="flat") + 'face = "5 mm"\n', "face"),
    ):
        with pytest.raises(SceneError, match=rf"cam\.{key}"):
            read(written(tmp_path, text))


def test_a_pivot_in_the_cam_is_refused() -> None:
    follower = FlatRockerFollower(0.05, 0.01)
    with pytest.raises(StructureError, match="increase centres"):
        made(CamTask(**{**C6, "stroke": 0.2}, follower=follower, r0=0.045))
