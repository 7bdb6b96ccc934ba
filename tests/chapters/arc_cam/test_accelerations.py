"""d²S/dφ² by the arcs' centres against derivatives, in 30 digits, of the follower on circles and lines."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mp
from support.arc_cams import FLANKS, FLATS, KINDS, random_order

import graphic_tmm
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.task import ARC_CAM, FLAT, FLAT_ROCKER, ROCKER, ArcTask, Flank
from graphic_tmm.project import record
from graphic_tmm.scene.records import Scene

Motion = Callable[[Any], Any]
INCH = 0.0254


def motion(order: ArcTask, flank: Flank | None, side: int) -> list[Motion]:
    """The follower's place over the cam's angle (radians) on an arc; of a lever all branches there are.

    The cam turns clockwise, its nose downward. ``flank``: None for the nose; ``side``: 1 for that on the left.
    """
    nose, e, r = mp.mpc(0, -order.distance), mp.mpf(order.offset), mp.mpf(order.roller)
    if flank is None:
        centre, reach, sign = nose, mp.mpf(order.nose) + r, 1
    elif flank.radius is None:
        return _straight(order, side)
    else:
        sign = -1 if flank.hollow else 1
        near, far = (abs(mp.mpf(flank.radius) - sign * mp.mpf(x)) for x in (order.base, order.nose))
        down = (near**2 + mp.mpf(order.distance) ** 2 - far**2) / (2 * mp.mpf(order.distance))
        centre = mp.mpc(side * sign * mp.sqrt(near**2 - down**2), -down)
        reach = mp.mpf(flank.radius) + sign * r

    def way(phi: Any) -> Any:
        return mp.mpc(0, 1) * mp.expj(phi)

    if order.follower == FLAT:
        return [lambda phi: (centre * mp.conj(way(phi))).real + reach]
    if order.follower in (ROCKER, FLAT_ROCKER):
        return _swings(order, lambda phi: _triangle(order, centre, reach, way(phi)))

    def rod(phi: Any) -> Any:
        seen = centre * mp.conj(way(phi))
        return seen.real + sign * mp.sqrt(reach**2 - (seen.imag - e) ** 2)

    return [rod]


def _triangle(order: ArcTask, centre: Any, reach: Any, way: Any) -> tuple[Any, Any]:
    """At the lever's pivot: the angle from O to the arc's centre, and from there to the roller's centre."""
    pivot, arm = order.centres * way, mp.mpf(order.lever or 0)
    far = abs(centre - pivot)
    if order.follower == FLAT_ROCKER:
        return mp.arg((centre - pivot) / -way), mp.asin(reach / far)
    return mp.arg((centre - pivot) / -way), mp.acos((arm**2 + far**2 - reach**2) / (2 * arm * far))


def _swings(order: ArcTask, angles: Callable[[Any], tuple[Any, Any]]) -> list[Motion]:
    def of(one: int, other: int) -> Motion:
        return lambda phi: one * (angles(phi)[0] + other * angles(phi)[1])

    return [of(one, other) for one in (1, -1) for other in (1, -1)]


def _straight(order: ArcTask, side: int) -> list[Motion]:
    lift = (mp.mpf(order.base) - mp.mpf(order.nose)) / mp.mpf(order.distance)
    normal = mp.mpc(-side * mp.sqrt(1 - lift**2), -lift)
    high, e = mp.mpf(order.base) + mp.mpf(order.roller), mp.mpf(order.offset)

    def rod(phi: Any) -> Any:
        seen = mp.mpc(0, 1) * mp.expj(phi) * mp.conj(normal)
        return (high + e * seen.imag) / seen.real

    def angles(phi: Any) -> tuple[Any, Any]:
        way = mp.mpc(0, 1) * mp.expj(phi)
        gap = high - (order.centres * way * mp.conj(normal)).real
        return mp.arg(normal / -way), mp.acos(gap / mp.mpf(order.lever))

    return _swings(order, angles) if order.follower == ROCKER else [rod]


def lowest(order: ArcTask) -> Any:
    """The follower's place on the base circle."""
    reach = mp.mpf(order.base) + mp.mpf(order.roller)
    if order.follower == FLAT_ROCKER:
        return mp.asin(reach / mp.mpf(order.centres))
    if order.follower == ROCKER:
        a, arm = mp.mpf(order.centres), mp.mpf(order.lever)
        return mp.acos((a**2 + arm**2 - reach**2) / (2 * a * arm))
    return mp.sqrt(reach**2 - mp.mpf(order.offset) ** 2)


def derivative(
    order: ArcTask, flank: Flank | None, side: int, phi: float, place: float, n: int
) -> float:
    """The n-th derivative on an arc; of a lever on the branch where the follower stands (``place``)."""
    with mp.workdps(30):
        at, rest = mp.radians(phi), lowest(order)
        ways = motion(order, flank, side)
        best = min(ways, key=lambda way: abs(mp.re(way(at)) - rest - place))
        assert abs(best(at) - rest - place) < 1e-9
        return float(mpmath.diff(best, at, n))


CASES = [
    (kind, flank)
    for kind in KINDS
    for flank in FLANKS
    if not (kind in FLATS and flank in ("straight", "hollow"))
]


@pytest.mark.turns(14)
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("kind", "flank"), CASES)
def test_on_both_sides_of_every_change_the_linkage_gives_the_derivatives(
    kind: str, flank: str, seed: int
) -> None:
    order = random_order(random.Random(f"second {kind} {flank} {seed}"), kind, flank)
    project = record(Scene("", "T", "en").asking(arc_cam=order), ARC_CAM)
    made, plans = ARC_CAM_PLAN.on(project), BESIDE.on(project).plans
    given = {**project.given, **{chart.mu: 0.001 for chart in made.charts.values()}}
    given |= dict(zip(plans.scales, (0.0003, 0.0007), strict=True))
    reading = execute(project.construction, given)
    travel = reading[made.follower.travel][0]
    rocks = order.rocks
    travel = np.radians(travel) if rocks else travel * reading[made.contour.mu][0, 0]
    first, onto, off, last = (change - made.lie.changes[0] for change in made.lie.changes)
    arcs = ((order.rise, 1, first, onto), (None, 0, onto, off), (order.fall, -1, off, last))
    by_mark = {plans.first: (1, -1e-7), plans.second[0]: (2, -1e-7), plans.second[1]: (2, 1e-7)}
    for mark, (n, by) in by_mark.items():
        for k, angle in enumerate(made.angles):
            inside = [one for one in arcs if one[2] < angle + by < one[3]]
            phi = made.lie.changes[0] + angle
            at = (phi, float(travel[k]), n)
            due = derivative(order, *inside[0][:2], *at) if inside else 0.0
            found = float(reading[mark][0, k])
            assert found == pytest.approx(due, rel=1e-8, abs=1e-9), (k, n, by)
    names = [*project.names]
    if "I" in names:
        k = names.index("I")
        jump = reading[plans.second[0]][0, k] - reading[plans.second[1]][0, k]
        assert abs(jump) > 1e-4


def test_the_published_cam_of_circular_arcs(tmp_path: Path) -> None:
    """Bevan, 9.5: at the beginning of the lift ω²·OF₁, at the nose −ω²·d; both sides where the arcs change."""
    scene = tmp_path / "scene.toml"
    scene.write_text(
        'title = "T"\nlanguage = "en"\n[arc_cam]\nbase = "1.125 in"\ndistance = "1.5 in"\nnose = "0.125 in"\n'
        'flank = "5.60094409 in"\nfollower = "flat"\nspeed = "1200 rpm"\n'
    )
    work = graphic_tmm.draw(scene, exact=True)
    omega = 1200 * np.pi / 30
    flank, d = (5.60094409 - 1.125) * INCH, 1.5 * INCH
    assert work.results["flank_centre1"].value == pytest.approx(flank, rel=1e-9)
    assert work.results["flank_to_nose1"].value == pytest.approx(
        (5.60094409 - 0.125) * INCH, rel=1e-9
    )
    table = work.table("arc_cam")
    before, behind = (np.asarray(table[name].value, dtype=float)[0] for name in ("a", "a_after"))
    assert (before[0], behind[16]) == (0.0, 0.0)
    assert behind[0] == pytest.approx(omega**2 * flank, rel=1e-9)
    assert before[8] == pytest.approx(-(omega**2) * d, rel=1e-9)
    # where flank and nose touch OF₁C is a triangle of known sides: projections on the normal at F₁
    far = (5.60094409 - 0.125) * INCH
    cosine = (flank**2 + far**2 - d**2) / (2 * flank * far)
    assert before[17] == pytest.approx(omega**2 * flank * cosine, rel=1e-8)
    assert behind[17] == pytest.approx(omega**2 * (flank * cosine - far), rel=1e-8)
    results = work.results
    assert results["arc_v_max"].value == pytest.approx(omega * flank * sine(cosine), rel=1e-8)
    assert results["arc_a_max"].value == pytest.approx(omega**2 * flank, rel=1e-9)
    assert results["arc_a_min"].value == pytest.approx(-(omega**2) * d, rel=1e-9)


def sine(cosine: float) -> float:
    return float(np.sqrt(1.0 - cosine**2))
