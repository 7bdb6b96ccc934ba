"""Cams with a cusp or an undercut; wheels of six teeth, pointed teeth, shifts at their limit."""

from __future__ import annotations

from functools import cache

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from support.cams import C6, Made, made
from support.each import each
from support.teeth import pair

from graphic_tmm.board.findings import examine
from graphic_tmm.board.geometry import EPS
from graphic_tmm.chapters.cam.findings import cam_findings
from graphic_tmm.chapters.cam.task import CamTask, FlatFollower
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.errors import StructureError

R0 = 0.0521
DRAWN = 2e-3
"""By so much of itself the least radius as drawn may be off: it is taken at and between the positions."""


@cache
def least_radius() -> float:
    """Least radius of curvature of the windrower's theoretical profile (on its return), m, by 50 digits."""
    with mp.workdps(50):
        h, b = mp.mpf(C6["stroke"]), mp.radians(mp.mpf(C6["fall"]))

        def curvature(u: mp.mpf) -> mp.mpf:
            w = 2 * mp.pi * u
            s = mp.mpf(R0) + h - h * (u - mp.sin(w) / (2 * mp.pi))
            v, a = -h / b * (1 - mp.cos(w)), -2 * mp.pi * h / b**2 * mp.sin(w)
            return (s * s + 2 * v * v - s * a) / mp.sqrt(s * s + v * v) ** 3

        top = max((curvature(mp.mpf(k) / 400), mp.mpf(k) / 400) for k in range(1, 400))[1]
        at = mp.findroot(lambda u: mp.diff(curvature, u), top)
        return float(1 / curvature(at))


def _with(share: float) -> Made:
    order = CamTask(**C6, r0=R0, roller=least_radius() * share, share_of_r0=0.95)
    return made(order)


@pytest.mark.slow
@pytest.mark.parametrize("share", [1 + DRAWN, 1.1, 1.15])
def test_a_roller_larger_than_the_least_radius_undercuts_and_is_named(share: float) -> None:
    of = _with(share)
    (found,) = [f for f in cam_findings(of.reading, of.cam) if f.kind == "undercut"]
    assert found.limit == pytest.approx(1000 * least_radius(), rel=DRAWN)


@pytest.mark.parametrize("share", [1 - DRAWN, 0.9])
def test_a_roller_smaller_than_the_least_radius_does_not_undercut(share: float) -> None:
    of = _with(share)
    assert {f.kind for f in cam_findings(of.reading, of.cam)} == {"roller by curvature"}


@pytest.mark.parametrize("off", [-1e-6, -1e-12, 0.0, 1e-12, 1e-6])
def test_a_profile_with_a_cusp_is_drawn_or_named(off: float) -> None:
    """The roller as large as the least radius: the profile has a cusp, whatever rounding makes of it."""
    of = _with(1.0 + off)
    kinds = {f.kind for f in cam_findings(of.reading, of.cam)}
    assert kinds & {"undercut", "roller by curvature"}
    wanted = [step.it for step in of.log.steps]
    named = {
        k for f in examine(of.log, of.given, wanted) if f.kind == "undrawn" for k in f.positions
    }
    points = of.reading[of.cam.profile.working.points][0]
    assert set(np.flatnonzero(~np.isfinite(points)).tolist()) <= named


def _flat_limit() -> float:
    """The r0 at which a flat face meets a cusp: the largest of −(S + S″), in closed form by digits."""
    with mp.workdps(50):
        h, rise, fall = mp.mpf(C6["stroke"]), mp.radians(100), mp.radians(90)

        def falling(u: mp.mpf) -> mp.mpf:
            w = 2 * mp.pi * u
            return -(h - h * (u - mp.sin(w) / (2 * mp.pi))) + 2 * mp.pi * h / fall**2 * mp.sin(w)

        def rising(u: mp.mpf) -> mp.mpf:
            w = 2 * mp.pi * u
            return -h * (u - mp.sin(w) / (2 * mp.pi)) - 2 * mp.pi * h / rise**2 * mp.sin(w)

        found = []
        for f in (falling, rising):
            top = max((f(mp.mpf(k) / 400), mp.mpf(k) / 400) for k in range(1, 400))[1]
            found.append(f(mp.findroot(lambda u, f=f: mp.diff(f, u), top)))
        return float(max(found))


@pytest.mark.parametrize(("share", "hollow"), [(1 + 2e-3, False), (1 - 2e-3, True), (0.5, True)])
def test_a_flat_face_at_its_cusp(share: float, hollow: bool) -> None:
    of = made(CamTask(**C6, follower=FlatFollower(), r0=_flat_limit() * share))
    assert bool(cam_findings(of.reading, of.cam)) == hollow


# gears


def _tip(z: tuple[int, int], x: tuple[float, float], m: float = 0.01) -> tuple[mp.mpf, mp.mpf]:
    """Tip thickness of wheel 1 (m) and its working pressure angle, 50 digits."""
    with mp.workdps(50):
        alpha = mp.radians(20)
        shift = [mp.mpf(s) for s in x]

        def inv(a: mp.mpf) -> mp.mpf:
            return mp.tan(a) - a

        due = inv(alpha) + 2 * sum(shift) / sum(z) * mp.tan(alpha)
        alpha_w = mp.findroot(
            lambda a: inv(a) - due, (mp.mpf("0.1"), mp.mpf("1.2")), solver="anderson"
        )
        a_w = mp.mpf(m) * sum(z) / 2 * mp.cos(alpha) / mp.cos(alpha_w)
        dy = sum(shift) - (a_w / mp.mpf(m) - mp.mpf(sum(z)) / 2)
        r, r_a = mp.mpf(m) * z[0] / 2, mp.mpf(m) * (mp.mpf(z[0]) / 2 + 1 + shift[0] - dy)
        alpha_a = mp.acos(r * mp.cos(alpha) / r_a)
        s = mp.mpf(m) * (mp.pi / 2 + 2 * shift[0] * mp.tan(alpha))
        return 2 * r_a * (s / (2 * r) + inv(alpha) - inv(alpha_a)), alpha_w


@cache
def pointed(z1: int, z2: int) -> float:
    """The shift x1 at which the tooth of wheel 1 comes to a point, x2 = 0."""
    with mp.workdps(30):
        found = mp.findroot(
            lambda x: _tip((z1, z2), (x, 0.0))[0], (mp.mpf("0.3"), mp.mpf("0.9")), solver="anderson"
        )
        return float(found)


@each("z", [(6, 40), (7, 30), (10, 25)])
@each("off", [-0.05, -1e-9, 0.0, 1e-9, 0.05])
@pytest.mark.slow
def test_teeth_about_the_shift_that_makes_them_pointed(z: tuple[int, int], off: float) -> None:
    x = pointed(*z) + off
    of = pair(GearTask(*z, 0.01, x, 0.0))
    due, alpha_w = _tip(z, (x, 0.0))
    found = of.results()["s_a1"][0]
    # some forty roundings; the working angle is found from its involute function, whose slope is tan² α_w
    bound = 64 * EPS * 0.01 * sum(z) / float(mp.tan(alpha_w)) ** 2
    assert abs(found - due) <= bound
    if abs(due) > bound:
        assert (("pointed tooth", 1) in of.failed()) == (due < 0)


@each("x", [(0.0, 0.0), (0.65, 0.65), (1.0, 1.0), (0.3, -0.3)])
@each("m", [1e-6, 0.01, 10.0])
def test_wheels_of_six_teeth(x: tuple[float, float], m: float) -> None:
    """Drawn at every module; of each fault there is, the verdict, and what is not drawn is named."""
    of = pair(GearTask(6, 6, m, *x))
    least = 1 - 3 * np.sin(np.radians(20.0)) ** 2
    for wheel, shift in enumerate(x, 1):
        assert (("undercut", wheel) in of.failed()) == (shift < least)
    due, alpha_w = _tip((6, 6), x, m)
    bound = 64 * EPS * 12 * m / float(mp.tan(alpha_w)) ** 2
    assert abs(of.results()["s_a1"][0] - due) <= bound
    # contact begins and ends on the tips, but within both feet N of the normals to the line of action
    whole = 12 * mp.mpf(m) / 2 * mp.cos(mp.radians(20)) * mp.tan(alpha_w)
    feet = [
        min(
            whole,
            mp.sqrt(
                mp.mpf(of.results()[f"r_a{k}"][0]) ** 2 - mp.mpf(of.results()[f"r_b{k}"][0]) ** 2
            ),
        )
        for k in (1, 2)
    ]
    ratio = (sum(feet) - whole) / (mp.pi * mp.mpf(m) * mp.cos(mp.radians(20)))
    assert (("contact ratio", 0) in of.failed()) == (ratio < 1)


@pytest.mark.parametrize("off", [1e-3, 1e-9, 1e-15])
def test_shifts_near_the_least_sum_have_an_angle_or_are_refused(off: float) -> None:
    """At x1 + x2 = −(z1 + z2)·inv α/(2·tan α) the working angle is 0: the condition 1/α_w² has no end."""
    with mp.workdps(50):
        alpha = mp.radians(20)
        least = -mp.mpf(80) * (mp.tan(alpha) - alpha) / (2 * mp.tan(alpha))
        half = float(least / 2)
    order = GearTask(40, 40, 0.01, half * (1 - off), half * (1 - off))
    try:
        of = pair(order)
    except StructureError as error:
        assert "x1" in str(error) or "angle" in str(error) or "circle" in str(error)  # noqa: PT017
        return
    found = of.results()["alpha_w"][0]
    with mp.workdps(50):
        due = (mp.tan(alpha) - alpha) + 2 * 2 * mp.mpf(order.x1) / 80 * mp.tan(alpha)
        true = mp.degrees(mp.findroot(lambda a: mp.tan(a) - a - due, mp.cbrt(3 * due)))
    assert abs(found - true) <= 64 * EPS / float(mp.radians(true)) ** 2
