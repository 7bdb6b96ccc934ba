from __future__ import annotations

import cmath
import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import LineString, Point, Polygon

from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.symbols import kinematic as symbols

ANGLES = st.floats(-360, 360)
POINTS = st.builds(complex, st.floats(-300, 300), st.floats(-300, 300))


def points(stroke: Stroke) -> list[complex]:
    return [complex(x, y) for x, y, _ in stroke.path]


def everything(at: complex, angle: float) -> list[Stroke]:
    u = cmath.rect(1, math.radians(angle))
    return [
        *symbols.turning_pair(at),
        *symbols.fixed_pivot(at, angle),
        *symbols.guide(at, at + 40 * u, sides=(1, -1)),
        *symbols.channel(at, angle, 30),
        *symbols.slider(at, angle),
        *symbols.stone(at, angle, pin=False),
        *symbols.rigid_joint(at, u, 1j * u),
        *symbols.plate(at, at + 30 * u, at + 20j * u),
        *symbols.arrowhead(at, u),
        *symbols.round_arrow(at, 10, angle, -100),
        *symbols.pole(at),
    ]


@given(POINTS, ANGLES)
def test_symbols_use_known_pens(at: complex, angle: float) -> None:
    assert {stroke.pen for stroke in everything(at, angle)} <= set(pens("A1"))


@given(POINTS, ANGLES)
def test_a_fixed_pivot_is_moved_and_turned_rigidly(at: complex, angle: float) -> None:
    turn = cmath.rect(1, math.radians(angle))
    foot, home = symbols.fixed_pivot(at, angle), symbols.fixed_pivot(0j)
    assert len(foot) == len(home)
    for moved, still in zip(foot[:-1], home[:-1], strict=True):
        for a, b in zip(points(moved), points(still), strict=True):
            assert abs(a - (at + b * turn)) < 1e-9


@given(POINTS, ANGLES, st.floats(3, 200), st.sampled_from([1, -1]))
def test_hatching_stays_on_its_side_between_the_ends(
    at: complex, angle: float, length: float, side: int
) -> None:
    u = cmath.rect(1, math.radians(angle))
    strokes = symbols.hatching(at, at + length * u, side)
    roots = []
    for stroke in strokes:
        a, b = ((z - at) / u for z in points(stroke))
        assert abs(a.imag) < 1e-9
        assert b.imag * side == pytest.approx(symbols.HATCH_DEPTH)
        assert abs(math.degrees(cmath.phase(b - a))) == pytest.approx(135)
        assert -1e-9 <= min(a.real, b.real) <= max(a.real, b.real) <= length + 1e-9
        roots.append(a.real)
    gaps = [b - a for a, b in itertools.pairwise(roots)]
    assert all(gap == pytest.approx(symbols.HATCH_PITCH) for gap in gaps)
    assert symbols.HATCH_PITCH * math.sin(math.pi / 4) >= 0.8
    assert len(strokes) >= length / symbols.HATCH_PITCH - 3


def test_a_line_shorter_than_the_hatching_has_none() -> None:
    assert symbols.hatching(0j, 1 + 0j, 1) == ()


@given(POINTS, st.builds(cmath.rect, st.floats(0.01, 50), st.floats(-4, 4)))
def test_an_arrowhead_points_at_its_tip(tip: complex, direction: complex) -> None:
    (head,) = symbols.arrowhead(tip, direction)
    a, b, c = points(head)
    assert a == tip
    middle = (b + c) / 2
    assert abs(tip - middle) == pytest.approx(symbols.ARROW_LENGTH)
    assert abs(b - c) == pytest.approx(symbols.ARROW_WIDTH)
    assert ((tip - middle) / direction).imag == pytest.approx(0, abs=1e-9)
    assert ((tip - middle) / direction).real > 0
    assert head.filled
    assert Polygon([(z.real, z.imag) for z in (a, b, c)]).exterior.is_ccw


@given(st.floats(3, 60), ANGLES, st.floats(5, 330), st.sampled_from([1, -1]))
def test_a_round_arrow_ends_on_its_circle(
    radius: float, start: float, sweep: float, sense: int
) -> None:
    bow, head = symbols.round_arrow(0j, radius, start, sense * sweep)
    tip, *wings = points(head)
    base = sum(wings) / 2
    assert tip == pytest.approx(cmath.rect(radius, math.radians(start + sense * sweep)))
    assert abs(base) == pytest.approx(radius)
    assert points(bow)[-1] == pytest.approx(base)
    assert sense * (tip / base).imag > 0


def test_a_rigid_joint_fills_the_corner_between_the_rods() -> None:
    for first, second in ((1, 1j), (1j, 1), (2, -1 + 1j), (1, -1 + 0.05j), (1j, 3j)):
        (corner,) = symbols.rigid_joint(5 + 5j, complex(first), complex(second))
        shape = Polygon([(z.real, z.imag) for z in points(corner)])
        assert corner.filled
        assert shape.exterior.is_ccw
        assert shape.area > 1
        assert shape.distance(Point(5, 5)) < 1e-9


@pytest.mark.parametrize(
    "corners",
    [
        (0j, 40 + 0j, 15 + 25j),
        (0j, 40 + 0j, 40 + 30j, 20 + 8j, 30j),
        (0j, 10 + 10j, 20 + 0j, 10 - 10j),
    ],
)
def test_a_plate_is_hatched_inside_only(corners: tuple[complex, ...]) -> None:
    outline, *hatches = symbols.plate(*corners)
    shape = Polygon([(z.real, z.imag) for z in points(outline)])
    assert hatches
    for stroke in hatches:
        a, b = points(stroke)
        assert shape.buffer(1e-6).covers(LineString([(a.real, a.imag), (b.real, b.imag)]))
        assert ((b - a) / cmath.rect(1, math.pi / 4)).imag == pytest.approx(0, abs=1e-9)
    total = sum(abs(b - a) for a, b in map(points, hatches))
    assert total == pytest.approx(shape.area / symbols.PLATE_PITCH, rel=0.15)


def test_a_slider_is_centred_and_turned() -> None:
    box, pin = symbols.slider(10 + 20j, 30, length=12, width=6)
    u = cmath.rect(1, math.radians(30))
    local = [(z - (10 + 20j)) / u for z in points(box)]
    assert {(round(z.real, 9), round(z.imag, 9)) for z in local} == {
        (-6, -3),
        (6, -3),
        (6, 3),
        (-6, 3),
    }
    assert box.closed
    assert (box.pen, pin.pen) == ("body", "joint")
    assert len(symbols.slider(0j, pin=False)) == 1
