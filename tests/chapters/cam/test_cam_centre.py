"""The centre of a cam: least r0 by tangents to the curve, pressure angles, curvature; against closed forms.

A spline through N parts of a phase is off by 5/384·(1/N)⁴·max|f⁗| (f over the share of the phase); for dS/dφ
of the sine law f⁗ is (2π)⁴ h/Φ, for the others it is less. The least r0 of a tangent at [α] is off by that
over tan [α].
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.cams import (
    C6,
    EXACT_R0,
    SHAPES,
    Made,
    curvatures,
    least_radius,
    made,
    motion,
    pressure_angles,
)
from support.each import each

from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)

ROCKING = {**C6, "stroke": 0.35}
FOLLOWERS: dict[str, tuple[Follower, float]] = {
    "central": (RollerFollower(), 30.0),
    "offset": (RollerFollower(0.01), 30.0),
    "offset back": (RollerFollower(-0.008), 30.0),
    "rocker": (RockerFollower(0.08, 0.1), 40.0),
    "rocker along": (RockerFollower(0.08, 0.1, same_sense=True), 40.0),
    "long centres": (RockerFollower(0.08, 0.12), 35.0),
    "long lever": (RockerFollower(0.12, 0.1, same_sense=True), 60.0),
}


def order(name: str, law: str = "sine", **more: object) -> CamTask:
    follower, pressure = FOLLOWERS[name]
    data = ROCKING if isinstance(follower, RockerFollower) else C6
    laws = {"rise_law": Law(law), "return_law": Law(law)}
    return CamTask(**{**data, **laws, "follower": follower, "pressure": pressure, **more})  # type: ignore[arg-type]


@cache
def drawn(name: str, law: str = "sine", divisions: int = 24, turns: str = "clockwise") -> Made:
    return made(order(name, law, divisions=divisions, turns=turns))


def bound(of: CamTask) -> float:
    """How far the least r0 may be off, m."""
    scale = of.follower.lever if isinstance(of.follower, RockerFollower) else 1.0
    speed = of.stroke * scale / np.radians(min(of.rise, of.fall))
    return float(
        5 / 384 * (2 * np.pi / of.divisions) ** 4 * speed / np.tan(np.radians(of.pressure))
    )


def test_the_least_r0_of_the_windrower() -> None:
    exact = least_radius(CamTask(**C6))
    assert exact == pytest.approx(EXACT_R0, abs=1e-7)
    assert exact == pytest.approx(0.04903, abs=0.000005)
    found = made(CamTask(**C6))
    assert found.one(found.cam.least) == pytest.approx(0.04903, abs=0.00005)
    assert abs(found.one(found.cam.least) - exact) < bound(found.cam.order)
    assert found.one(found.cam.r0) == 0.05  # in whole millimetres


@pytest.mark.parametrize(
    ("phi", "points_only"),
    [(120.0 + np.arange(13) * 7.5, 0.04817), (np.arange(36) * 10.0, 0.04897)],
    ids=["12 in a phase", "36 in a turn"],
)
def test_the_tangency_lies_on_the_curve_not_at_the_positions(
    phi: np.ndarray, points_only: float
) -> None:
    s, v, _ = motion(CamTask(**C6), phi)
    assert (np.abs(v) / np.tan(np.radians(30)) - s).max() == pytest.approx(points_only, abs=5e-6)


@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_the_document_s_radius_passes(turns: str) -> None:
    found = made(CamTask(**C6, r0=0.0521, turns=turns))
    assert found.one(found.cam.r0) > found.one(found.cam.least)
    assert found.one(found.cam.centre.radius) == pytest.approx(0.0521 / 0.00056)
    alpha = pressure_angles(found.cam.order, 0.0521, np.arange(0, 360, 0.5))
    assert np.abs(alpha).max() < 30.0


@pytest.mark.slow
@pytest.mark.parametrize("name", FOLLOWERS)
@each("law", SHAPES)
def test_the_least_r0_by_brute_force(name: str, law: str) -> None:
    found = drawn(name, law)
    due = least_radius(found.cam.order)
    assert abs(found.one(found.cam.least) - due) < bound(found.cam.order) + 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["central", "offset", "rocker along"])
def test_the_limits_of_rise_and_return_may_differ(name: str) -> None:
    for pressure, back in ((35.0, 50.0), (50.0, 35.0)):
        of = order(name, pressure=pressure, pressure_return=back, divisions=24)
        found = made(of)
        assert abs(found.one(found.cam.least) - least_radius(of)) < 3 * bound(of) + 1e-6


@pytest.mark.slow
def test_the_least_of_all_stands_where_both_limits_meet() -> None:
    """With the offset of the apex the least r0 is that of the apex; no other offset allows a smaller one."""
    free = made(CamTask(**C6, divisions=24))
    centre = free.cam.centre
    apex = free.reading[centre.apex][0, 0] * free.one(centre.mu)
    offset = -apex.real  # the cam turns counter-clockwise
    own = made(CamTask(**C6, divisions=24, follower=RollerFollower(offset)))
    assert own.one(own.cam.least) == pytest.approx(free.one(centre.apex_radius), rel=1e-9)
    for other in offset + np.linspace(-0.01, 0.01, 9):
        least = least_radius(CamTask(**C6, follower=RollerFollower(other)), 0.1)
        assert least > free.one(centre.apex_radius) - bound(own.cam.order)


@each("name", FOLLOWERS)
@each("turns", ["clockwise", "counterclockwise"])
def test_the_pressure_angle_is_that_of_velocities(name: str, turns: str) -> None:
    found = drawn(name, "sine", 12, turns)
    angles = np.array(found.cam.diagrams.turn.angles)
    due = pressure_angles(found.cam.order, found.one(found.cam.r0), angles)
    np.testing.assert_allclose(found.reading[found.cam.centre.pressure][0], due, atol=1e-9)


@pytest.mark.parametrize("name", FOLLOWERS)
@each("law", SHAPES)
def test_the_pressure_angle_never_passes_the_limit(name: str, law: str) -> None:
    """With r0 in whole millimetres above the least one; the drawn extremes are those of the turn."""
    found = drawn(name, law)
    limit = found.cam.order.pressure
    alpha = pressure_angles(found.cam.order, found.one(found.cam.r0), np.arange(720) * 0.5)
    # the least r0 is uncertain by its bound: as much as that turns a ray as long as r0
    slack = np.degrees(bound(found.cam.order) / found.one(found.cam.least))
    assert np.abs(alpha).max() <= limit + slack
    told = [found.one(extreme.value) for extreme in found.cam.pressure.extremes]
    dense = pressure_angles(found.cam.order, found.one(found.cam.r0), np.arange(0, 360, 0.02))
    corner = 0.1 if law == "constant acceleration" else 0.02
    np.testing.assert_allclose(told, [dense.max(), dense.min()], atol=corner)


@each("name", FOLLOWERS)
@each("law", ["sine", "3-4-5"])
def test_the_least_radius_of_curvature_and_its_place(name: str, law: str) -> None:
    found = drawn(name, law)
    angles = np.arange(0.0, 360.0, 0.05)
    kappa = curvatures(found.cam.order, found.one(found.cam.r0), angles)
    extreme = found.cam.curvature.extremes[0]
    assert found.one(extreme.value) == pytest.approx(1 / kappa.max(), rel=1e-3)
    assert found.one(extreme.angle) == pytest.approx(angles[np.argmax(kappa)], abs=0.5)


@pytest.mark.parametrize("law", ["cosine", "constant acceleration"])
def test_the_curvature_on_both_sides_of_a_jump(law: str) -> None:
    found = drawn("central", law)
    diagram = found.cam.curvature
    for mark, (phase, first, last) in zip(
        diagram.chart.ordinates, found.cam.diagrams.stretches, strict=True
    ):
        angles = np.array(found.cam.diagrams.turn.angles)[first : last + 1]
        inside = angles + np.linspace(1, -1, angles.size) * 0.02
        due = curvatures(found.cam.order, found.one(found.cam.r0), inside)
        read = found.reading[mark][0, first : last + 1] * found.one(diagram.chart.mu)
        # 0.02° away from a boundary: by then it has changed by less than the share that 0.02° is of a phase
        np.testing.assert_allclose(read, due, rtol=1e-2, atol=0.02), phase.name


@pytest.mark.parametrize("law", SHAPES)
@pytest.mark.parametrize("least", [0.0, 0.006])
def test_the_least_r0_of_a_flat_face(law: str, least: float) -> None:
    follower = FlatFollower(least)
    of = CamTask(**C6, rise_law=Law(law), return_law=Law(law), follower=follower, divisions=24)
    found = made(of)
    s, _, a = motion(of, np.arange(0.0, 360.0, 0.01) + 0.005)
    due = least - min((s + a).min(), 0.0)
    # a spline through d²S/dφ²: (2π)⁴·2π·h/Φ² for the sine law; the sampling adds the rest
    error = 5 / 384 * (2 * np.pi / 24) ** 4 * 2 * np.pi * of.stroke / np.radians(90) ** 2
    assert abs(found.one(found.cam.least) - due) < error + 1e-5
    rho = found.cam.curvature.extremes[0]
    assert found.one(rho.value) == pytest.approx(
        found.one(found.cam.r0) + least - due, abs=error + 1e-5
    )
    assert found.one(rho.value) >= least - 1e-9


def test_a_scale_of_its_own_changes_nothing_but_millimetres() -> None:
    one, two = made(CamTask(**C6)), made(CamTask(**C6, mu_l=0.0005, mu_V=0.001))
    for mark in ("least", "r0"):
        first, second = (found.one(getattr(found.cam, mark)) for found in (one, two))
        assert first == pytest.approx(second, rel=1e-12)
    assert two.one(two.cam.centre.radius) == pytest.approx(100.0)
