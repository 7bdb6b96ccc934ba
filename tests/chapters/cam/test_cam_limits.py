"""Limits that a cam passes are named with the angle of the cam, and only those."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from support import gallery
from support.cams import C6, Made, curvatures, least_radius, made, motion, pressure_angles

from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import Hand
from graphic_tmm.chapters.cam.findings import CamFinding, cam_findings
from graphic_tmm.chapters.cam.task import CamTask, FlatFollower, RockerFollower, RollerFollower
from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.paper.pens import DASHED
from graphic_tmm.paper.shapes import box, shape

FINE = np.arange(0.0, 360.0, 0.02)


def findings(of: Made) -> tuple[CamFinding, ...]:
    return cam_findings(of.reading, of.cam)


@pytest.mark.parametrize(
    "order",
    [
        CamTask(**C6),
        CamTask(**C6, r0=0.0521),
        CamTask(**C6, follower=RollerFollower(0.012)),
        CamTask(**C6, follower=FlatFollower(0.005)),
        CamTask(**{**C6, "stroke": 0.35}, follower=RockerFollower(0.08, 0.1), pressure=40.0),
    ],
)
def test_a_cam_within_its_limits_has_no_findings(order: CamTask) -> None:
    assert not findings(made(order))


def test_r0_too_small_is_named_with_the_angle() -> None:
    found = made(CamTask(**C6, r0=0.044))
    (one,) = [f for f in findings(found) if f.kind == "pressure"]
    alpha = pressure_angles(found.cam.order, 0.044, FINE)
    assert one.angle == pytest.approx(FINE[np.argmin(alpha)], abs=0.5)
    assert one.value == pytest.approx(-alpha.min(), abs=0.05)
    assert one.limit == 30.0
    assert one.least == pytest.approx(49.03, abs=0.05)
    assert "φ = 169" in one.says("en")
    assert "49,03" in one.says("ru"), "49.0201 is rounded up"


def test_r0_too_small_for_both_phases_is_named_twice() -> None:
    found = made(CamTask(**C6, r0=0.03))
    assert [f.kind for f in findings(found)][:2] == ["pressure", "pressure"]
    rise, fall = findings(found)[:2]
    assert 0 < rise.angle < 100
    assert 120 < fall.angle < 210


def test_rollers_too_large_are_named() -> None:
    by_r0 = findings(made(CamTask(**C6, r0=0.0521, roller=0.022)))
    assert [f.kind for f in by_r0] == ["roller by r0"]
    assert by_r0[0].limit == pytest.approx(20.84)
    loose = {"share_of_r0": 0.9, "r0": 0.0521}
    found = made(CamTask(**C6, roller=0.031, **loose))
    (one,) = findings(found)
    kappa = curvatures(found.cam.order, 0.0521, FINE)
    assert one.kind == "roller by curvature"
    assert one.limit == pytest.approx(0.7e3 / kappa.max(), rel=1e-3)
    assert one.angle == pytest.approx(FINE[np.argmax(kappa)], abs=0.5)
    (cut,) = findings(made(CamTask(**C6, roller=0.043, **loose)))
    assert cut.kind == "undercut"
    assert cut.limit == pytest.approx(1e3 / kappa.max(), rel=1e-3)
    assert cut.angle == pytest.approx(FINE[np.argmax(kappa)], abs=0.5)
    assert "143" in cut.says("en")
    assert "срезает" in cut.says("ru")


def test_the_roller_chosen_is_the_largest_allowed_in_whole_millimetres() -> None:
    found = made(CamTask(**C6, r0=0.0521))
    size = found.cam.roller
    assert size is not None
    assert found.one(size.by_r0) == pytest.approx(0.4 * 0.0521)
    kappa = curvatures(found.cam.order, 0.0521, FINE)
    assert found.one(size.by_curvature) == pytest.approx(0.7 / kappa.max(), rel=1e-3)
    assert found.one(size.radius) == 0.02


def test_a_flat_face_on_a_hollow_is_named_with_the_angle() -> None:
    found = made(CamTask(**C6, follower=FlatFollower(), r0=0.04))
    (one,) = findings(found)
    s, _, a = motion(found.cam.order, FINE)
    rho = 1e3 * (0.04 + s + a)
    assert one.kind == "hollow"
    assert one.angle == pytest.approx(FINE[np.argmin(rho)], abs=0.5)
    assert one.value == pytest.approx(rho.min(), abs=0.05)
    assert "φ = 143" in one.says("en")


def test_a_rocker_whose_centre_stands_too_far_down_is_told_to_move_it() -> None:
    """On a given circle of centres the allowed region has an end on either side."""
    rocking = {**C6, "stroke": 0.35, "follower": RockerFollower(0.08, 0.1), "pressure": 34.0}
    assert not findings(made(CamTask(**rocking)))
    found = made(CamTask(**rocking, r0=0.12))
    assert found.one(found.cam.r0) > found.one(found.cam.least)
    (one,) = findings(found)
    alpha = pressure_angles(found.cam.order, 0.12, FINE)
    assert one.kind == "path"
    assert one.value == pytest.approx(alpha.max(), abs=0.05)
    assert "no larger r0 helps" in one.says("en")


def test_a_rocker_that_finds_no_centre_is_named_with_the_angle() -> None:
    order = CamTask(**{**C6, "stroke": 0.5}, follower=RockerFollower(0.08, 0.1), pressure=34.0)
    assert np.isnan(least_radius(order, 1.0))
    found = made(order)
    (one,) = findings(found)
    assert one.kind == "no centre"
    assert one.angle == pytest.approx(
        50.0, abs=9.0
    )  # in the middle of the rise the roller is fastest
    assert "increase the distance of the centres" in one.says("en")


def test_a_ruler_of_half_a_millimetre_gives_nearly_the_same_cam() -> None:
    """Readings are off by 0.25 mm at most; S and dS/dφ both, so r0 by (1 + 1/tan 30°) of that, and one more."""
    found = made(CamTask(**C6))
    read = execute(found.log, found.given, hand=Hand(0.5))
    due = found.one(found.cam.least)
    bound = 0.25 * (2 + 1 / np.tan(np.radians(30))) * 0.00056
    assert abs(float(read[found.cam.least][0, 0]) - due) < bound


@pytest.mark.slow
def test_the_limits_of_the_pressure_angle_bear_their_signs_clear_of_their_lines() -> None:
    """A stroke of a dashed line that ran up to "[α] = 30°" would read as a minus."""
    (work,) = gallery.made("cam").boards
    view = next(one for one in cam_views(work, True) if one.name == "cam-limits")
    named = {"[α] = 30°", "−[α] = −30°"}
    told = {label.text: label for label in view.labels if label.text in named}
    assert told.keys() == named
    ends = [shape(one).bounds[2] for one in view.strokes if one.part == "limit"]
    for label in told.values():
        assert box(label).bounds[0] > max(ends) + DASHED[1] + 1.0


def test_every_diagram_tells_the_scale_of_its_own_quantity() -> None:
    (work,) = gallery.made("cam").boards
    view = next(one for one in cam_views(work, True) if one.name == "cam-diagrams")
    told = [label.text.split(" = ")[0] for label in view.labels if label.text.startswith("μ_")]
    assert told == ["μ_S", "μ_{S′}", "μ_{S″}"]


@pytest.mark.parametrize("follower", [RollerFollower(0.01), RollerFollower(edge=True)], ids=repr)
def test_a_least_radius_of_curvature_of_the_theoretical_profile(follower: RollerFollower) -> None:
    """Judged against the curvature by differences; below it, and with a larger r0, nothing is said."""
    of = CamTask(**C6, r0=0.0521, follower=follower)
    rho = 1.0 / curvatures(of, 0.0521, np.arange(0.0, 360.0, 0.05)).max()
    for share, kinds in ((0.99, []), (1.01, ["sharp"])):
        found = made(replace(of, least_rho=share * rho))
        told = cam_findings(found.reading, found.cam)
        assert [one.kind for one in told if one.kind == "sharp"] == kinds
        for one in told:
            if one.kind == "sharp":
                assert one.value == pytest.approx(1000.0 * rho, rel=1e-3)
                assert "take a larger r0" in one.says("en")
    wider = made(replace(of, least_rho=1.01 * rho, r0=0.06))
    assert not [f for f in cam_findings(wider.reading, wider.cam) if f.kind == "sharp"]
