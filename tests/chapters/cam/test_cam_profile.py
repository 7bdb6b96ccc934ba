"""Profiles of cams: turned under the follower they give back S(φ); the working one envelops the rollers."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import shapely
from support.cams import C6, SHAPES, Made, displaced, made, motion, outline, polygon

from graphic_tmm.board.findings import examine
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)

HUNDREDTH = 1e-5
"""0.01 mm, m."""
TRAPEZOID = Law("diagram", ((0, 0), (1 / 8, 1), (3 / 8, 1), (5 / 8, -1), (7 / 8, -1), (1, 0)))
FOLLOWERS: dict[str, Follower] = {
    "central": RollerFollower(),
    "offset": RollerFollower(0.01),
    "knife edge": RollerFollower(0.01, edge=True),
    "rocker": RockerFollower(0.08, 0.1),
    "rocker along": RockerFollower(0.08, 0.1, same_sense=True),
    "flat": FlatFollower(0.005),
    "flat rocker": FlatRockerFollower(0.09, 0.012, 0.004),
}
ANGLES = np.arange(720) * 0.5


@cache
def drawn(name: str, law: Law, turns: str = "counterclockwise") -> Made:
    follower = FOLLOWERS[name]
    swing = {RockerFollower: 0.35, FlatRockerFollower: 0.2}.get(type(follower))
    data = {**C6, "stroke": swing} if swing else C6
    pressure = 40.0 if isinstance(follower, RockerFollower) else 30.0
    return made(
        CamTask(
            **data, rise_law=law, return_law=law, follower=follower, turns=turns, pressure=pressure
        )
    )


def off(of: Made) -> float:
    """How far the follower is from S(φ) at most over 720 angles, m along the roller's path."""
    follower = of.cam.order.follower
    lever = follower.lever if isinstance(follower, RockerFollower) else 1.0
    lever = follower.centres if isinstance(follower, FlatRockerFollower) else lever
    due = motion(of.cam.order, ANGLES)[0]
    return float(np.abs(displaced(of, ANGLES) - due).max() * lever)


@pytest.mark.slow
@pytest.mark.parametrize("law", [*map(Law, SHAPES), TRAPEZOID], ids=lambda law: law.name)
def test_the_profile_gives_back_the_law(law: Law) -> None:
    assert off(drawn("central", law)) < HUNDREDTH


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in FOLLOWERS if name != "central"])
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_every_follower_is_moved_by_its_profile(name: str, turns: str) -> None:
    assert off(drawn(name, Law("sine"), turns)) < HUNDREDTH


@pytest.mark.slow
@pytest.mark.parametrize(
    "phases", [(120, 0, 120, 120), (180, 0, 180, 0), (90, 180, 90, 0)], ids=repr
)
@pytest.mark.parametrize("follower", [RollerFollower(), FlatFollower(0.004)], ids=repr)
def test_dwells_may_be_left_out(phases: tuple[float, ...], follower: Follower) -> None:
    found = made(CamTask(0.02, *phases, follower=follower))
    assert off(found) < HUNDREDTH


@pytest.mark.slow
def test_the_document_s_cam_with_its_roller() -> None:
    found = made(CamTask(**C6, r0=0.0521, roller=0.0168))
    assert off(found) < HUNDREDTH
    assert found.one(found.cam.profile.roller) == pytest.approx(30.0)
    assert not cam_findings(found.reading, found.cam)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["central", "offset", "rocker", "rocker along"])
@pytest.mark.parametrize("law", [Law("sine"), Law("constant acceleration")], ids=lambda x: x.name)
def test_the_working_profile_is_equidistant_and_the_envelope_of_the_rollers(
    name: str, law: Law
) -> None:
    """Every point of the one is the roller's radius away from the other; no roller anywhere is cut."""
    found = drawn(name, law)
    profile, radius = found.cam.profile, found.one(found.cam.roller.radius)
    assert profile.theoretical is not None
    rollers, edge = outline(found, profile.theoretical), outline(found, profile.working)
    for spots, other in ((rollers, edge), (edge, rollers)):
        ring = polygon(other).exterior
        points = shapely.points(spots[::7].real, spots[::7].imag)
        assert np.abs(shapely.distance(ring, points) - radius).max() < HUNDREDTH
    discs = [shapely.Point(z.real, z.imag).buffer(radius, quad_segs=256) for z in rollers[::97]]
    overlap = polygon(edge).intersection(shapely.union_all(discs)).area
    assert overlap < HUNDREDTH * radius


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_dwells_are_circles_about_the_centre(name: str) -> None:
    found = drawn(name, Law("sine"))
    working = found.cam.profile.working
    mu = found.one(found.cam.profile.mu)
    for arc, at in ((working.upper, found.cam.diagrams.turn.rise.last), (working.lower, -1)):
        circle = found.reading[arc]
        assert circle.centre[0, 0] == 0
        spot = found.reading[working.points][0, at]
        assert abs(spot) == pytest.approx(circle.radius[0, 0])
    radius = found.one(found.cam.roller.radius) if found.cam.roller is not None else 0.0
    reach = found.one(found.cam.r0) - radius
    if name in ("central", "flat"):
        assert found.reading[working.lower].radius[0, 0] * mu == pytest.approx(reach)


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_profile_closes_smoothly(name: str) -> None:
    """Where a dwell follows, the profile is square to the ray from the centre."""
    found = drawn(name, Law("3-4-5"))
    working = found.cam.profile.working
    for mark, (_, first, last) in zip(working.curves, found.cam.diagrams.stretches, strict=True):
        curve = found.reading[mark]
        points = found.reading[working.points][0]
        np.testing.assert_array_equal(curve.knots[0], points[first : last + 1])
        for k in (0, -1):
            ray, way = curve.knots[0, k], curve.tangents[0, k]
            cosine = (ray * np.conj(way)).real / abs(ray) / abs(way)
            assert abs(cosine) < 1e-12


def test_a_roller_too_large_leaves_the_place_undrawn_and_names_it() -> None:
    found = made(CamTask(**C6, r0=0.0521, roller=0.045))
    told = examine(found.log, found.given, [found.cam.profile.working.curves[1]])
    gone = [f for f in told if f.kind == "undrawn"]
    assert [f.step.op.name for f in gone] == ["equidistant_pace"]
    angles = np.array(found.cam.diagrams.turn.angles)[list(gone[0].positions)]
    (undercut,) = [f for f in cam_findings(found.reading, found.cam) if f.kind == "undercut"]
    assert np.abs(angles - undercut.angle).min() < 7.5  # one part of the return
