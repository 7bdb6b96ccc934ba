"""Teeth: flanks against the closed form of the involute, profiles against a rack that cuts them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import shapely
from support.each import each
from support.teeth import Pair, dense, flank, meshing, pair, profile, wheel

from graphic_tmm.board.findings import examine
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.errors import StructureError

M = 8.0
TOUCH = 1e-3
"""Flanks touch to this many real mm, and never overlap by more."""
WINDROWER = GearTask(15, 25, 0.008, 0.83, 0.445)
CASES = (
    WINDROWER,
    GearTask(17, 43, 0.008, 0.1, -0.1),
    GearTask(10, 30, 0.008, 0.5, 0.0),
    GearTask(20, 200, 0.008),
    GearTask(30, 31, 0.008, -0.2, 1.0),
    GearTask(12, 12, 0.008, 0.4, 0.4, alpha=25.0, c=0.2),
    GearTask(25, 60, 0.008, c=0.4),
)
UNDERCUT = (GearTask(12, 40, 0.008), GearTask(8, 20, 0.008), GearTask(6, 25, 0.008, -0.2, 0.2))


@cache
def drawn(order: GearTask) -> Pair:
    return pair(order)


@each("order", CASES)
@each("k", [0, 1])
def test_rolled_points_are_those_of_the_involute_through_the_pitch_point(
    order: GearTask, k: int
) -> None:
    of = drawn(order)
    made = of.gear.wheels[k]
    centre, count = of.one(made.circles.centre), made.roll.count
    points = (of.row(made.points, count) - centre) * of.mm
    base = order.m * (order.z1, order.z2)[k] / 2 * np.cos(np.radians(order.alpha)) * 1000
    reach = np.abs(points)
    assert (reach >= base * (1 - 1e-12)).all()
    pole = (of.one(of.gear.line.pole) - centre) * of.mm

    def inv(reach: np.ndarray) -> np.ndarray:
        angle = np.arccos(np.minimum(1.0, base / reach))
        return np.asarray(np.tan(angle) - angle)

    # the polar angle of an involute's point runs as the involute function of its pressure angle
    np.testing.assert_allclose(np.angle(points / pole), inv(reach) - inv(np.abs(pole)), atol=1e-9)


@each("order", CASES)
@each("k", [0, 1])
def test_a_flank_between_its_points_is_the_involute_to_a_ten_thousandth_of_a_module(
    order: GearTask, k: int
) -> None:
    of = drawn(order)
    made = of.gear.wheels[k]
    centre = of.one(made.circles.centre)
    spots = (flank(of, made.teeth[1].right) - centre) * of.mm
    base = 1000 * of.real(made.sizes.r_b)
    # a point of an involute lies on the tangent of the base circle at the end of the arc unrolled
    u = np.sqrt(np.maximum(np.abs(spots) ** 2 - base**2, 0.0)) / base
    begin = (of.one(made.origin) - centre) * of.mm
    due = begin * np.exp(1j * u) * (1 - 1j * u)
    assert np.abs(spots - due).max() < 1e-4 * M


@each("order", CASES)
@each("k", [0, 1])
def test_the_tooth_is_as_thick_as_calculated_at_the_pitch_circle_and_at_the_tip(
    order: GearTask, k: int
) -> None:
    of = drawn(order)
    made, sizes = of.gear.wheels[k], of.gear.wheels[k].sizes
    centre = of.one(made.circles.centre)
    start = of.one(made.at_pitch) - centre
    half = np.angle((of.one(made.middle) - centre) / start)
    assert 2 * half * of.real(sizes.r) == pytest.approx(of.real(sizes.s), rel=1e-12)
    right, left = (of.one(side.tip) - centre for side in (made.teeth[1].right, made.teeth[1].left))
    tip = np.angle(left / right) * of.real(sizes.r_a)
    assert tip == pytest.approx(of.real(sizes.s_a), abs=1e-4 * order.m)
    assert abs(right) * of.mm == pytest.approx(1000 * of.real(sizes.r_a), rel=1e-12)


@each("order", CASES)
@each("k", [0, 1])
def test_teeth_stand_one_pitch_apart_and_are_symmetrical(order: GearTask, k: int) -> None:
    of = drawn(order)
    made = of.gear.wheels[k]
    centre, z = of.one(made.circles.centre), (order.z1, order.z2)[k]
    for name in ("flank", "fillet"):
        sides = [
            [
                of.reading[getattr(side, name)].knots[0] - centre
                for side in (tooth.right, tooth.left)
            ]
            for tooth in made.teeth
        ]
        axis = (of.one(made.middle) - centre) / abs(of.one(made.middle) - centre)
        np.testing.assert_allclose(sides[1][1], np.conj(sides[1][0] / axis) * axis, atol=1e-9)
        for sense, tooth in ((1, sides[0]), (-1, sides[2])):
            for own, middle in zip(tooth, sides[1], strict=True):
                np.testing.assert_allclose(own, middle * np.exp(2j * np.pi * sense / z), atol=1e-9)


def rack(order: GearTask, x: float) -> shapely.Polygon:
    """A tooth of the basic rack in modules, its pitch line y = 0: straight sides, corners rounded."""
    alpha, top, depth = np.radians(order.alpha), 4.0, order.ha + order.c

    def half(d: float) -> float:
        return float(np.pi / 4 - d * np.tan(alpha))

    sharp = shapely.Polygon(
        [(-half(depth), -depth), (half(depth), -depth), (half(-top), top), (-half(-top), top)]
    )
    rho = min(order.c, half(depth) * np.cos(alpha)) / (1 - np.sin(alpha))
    rho -= 1e-9  # a full rounding leaves a point of the eroded tooth
    rounded = sharp.buffer(-rho, join_style="mitre").buffer(rho, quad_segs=256)
    return shapely.affinity.translate(
        shapely.union(rounded, sharp.intersection(shapely.box(-9, 0, 9, 9))), 0, x
    )


@cache
def cut(order: GearTask, k: int) -> shapely.Geometry:
    """What a rack takes away beside a tooth of wheel k, its space upright, in modules."""
    z, x = (order.z1, order.z2)[k], (order.x1 or 0.0, order.x2 or 0.0)[k]
    tool, r = rack(order, x), z / 2
    places = []
    for t in np.arange(-6.0, 6.0, 0.01):
        c, s = np.cos(t / r), np.sin(t / r)  # rolled by t to the left: counter-clockwise
        moved = shapely.affinity.translate(tool, t, r)
        places.append(shapely.affinity.affine_transform(moved, [c, -s, s, c, 0, 0]))
    return shapely.union_all(places)


@pytest.mark.slow
@pytest.mark.parametrize("order", [*CASES[:4], *CASES[5:], *UNDERCUT])
@pytest.mark.parametrize("k", [0, 1])
def test_flank_and_fillet_are_what_a_rack_cuts(order: GearTask, k: int) -> None:
    of = drawn(order)
    made = of.gear.wheels[k]
    centre, z = of.one(made.circles.centre), (order.z1, order.z2)[k]
    # the middle of the space to the right of the middle tooth, turned upright
    space = (of.one(made.middle) - centre) * np.exp(-1j * np.pi / z)
    spots = (profile(of, made.teeth[1].right) - centre) / space * abs(space) * 1j * of.mm / M
    edge = shapely.boundary(cut(order, k))
    away = shapely.distance(edge, shapely.points(spots.real, spots.imag))
    # two splines through 13 points and more; the tool stops every 0.01 m
    assert away.max() < 2e-4
    root = np.abs(spots[0])
    assert root == pytest.approx(1000 * of.real(made.sizes.r_f) / M, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("order", CASES)
def test_turned_through_a_pitch_flanks_touch_and_never_overlap(order: GearTask) -> None:
    of = drawn(order)
    assert of.failed() <= {("tip thickness", 1), ("tip thickness", 2)}
    assert worst(of, 11) < TOUCH


def worst(of: Pair, count: int) -> float:
    """How far apart both wheels are at most, or how deep they overlap, over a pitch; real mm."""
    wheels, far = (wheel(of, 0), wheel(of, 1)), 0.0
    assert all(w.is_valid for w in wheels)
    for turn in np.linspace(-0.5, 0.5, count) * 2 * np.pi / of.gear.order.z1:
        first, second = meshing(of, turn, wheels)
        far = max(far, float(first.distance(second)))
        for part in shapely.get_parts(first.intersection(second)):
            if part.area > 0.0:  # a sliver: its width is twice its area over its perimeter
                far = max(far, 2 * part.area / part.length)
    return far


@pytest.mark.slow
def test_any_pair_is_right_or_its_fault_has_a_name(many: Callable[[int, int], int]) -> None:
    rng = np.random.default_rng(6)
    told, right = set(), 0
    for _ in range(count := many(60, 20)):
        z1, z2 = (int(v) for v in np.exp(rng.uniform(np.log(6), np.log(200), 2)).round())
        x1, x2 = rng.uniform(-0.5, 1.2, 2).round(3)
        try:
            of = pair(GearTask(z1, z2, 0.008, float(x1), float(x2)))
        except StructureError as error:
            told.add(str(error)[:30])
            continue
        faults = {name for name, _ in of.failed()} - {"tip thickness"}
        told |= faults
        if not faults:
            right += 1
            assert worst(of, 5) < TOUCH, (z1, z2, x1, x2)
            assert not [f for f in examine(of.log, of.given, [s.it for s in of.log.steps])]
    assert right > 0.4 * count
    assert {"undercut", "interference", "pointed tooth", "contact ratio"} <= told


def test_a_pointed_tooth_ends_where_its_flanks_meet() -> None:
    of = drawn(GearTask(8, 40, 0.008, 0.9, -0.2))
    assert ("pointed tooth", 1) in of.failed()
    made = of.gear.wheels[0]
    sides = made.teeth[1]
    assert of.one(sides.right.tip) == of.one(sides.left.tip)
    reach = abs(of.one(sides.right.tip) - of.one(made.circles.centre)) * of.mm
    assert reach == pytest.approx(1000 * of.real(made.sizes.pointed), abs=1e-4 * M)


def test_the_number_of_steps_is_the_orders() -> None:
    errors = []
    for steps in (6, 12, 24):
        of = pair(GearTask(15, 25, 0.008, 0.83, 0.445, steps=steps))
        made = of.gear.wheels[0]
        centre, base = of.one(made.circles.centre), 1000 * of.real(made.sizes.r_b)
        spots = (dense(of.reading[made.flank]) - centre) * of.mm
        u = np.sqrt(np.abs(spots) ** 2 - base**2) / base
        begin = (of.one(made.origin) - centre) * of.mm
        errors.append(np.abs(spots - begin * np.exp(1j * u) * (1 - 1j * u)).max())
        assert steps <= made.roll.count <= steps + 4
    ratios = np.array(errors[:-1]) / np.array(errors[1:])
    assert (ratios > 10).all()  # a cubic spline: fourth order
