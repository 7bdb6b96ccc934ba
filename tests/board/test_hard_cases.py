"""Figures that barely touch, lines that are barely not parallel, angles that must be exact."""

from __future__ import annotations

import cmath
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from support.each import each
from support.examples import most

from graphic_tmm.board.geometry import EPS, cis, degrees, root
from graphic_tmm.board.operations.instruments import (
    bearing,
    cross,
    cut,
    incline,
    meet,
    ray,
    tangent,
    touch,
)
from graphic_tmm.board.values import Arc, Line

TINY = st.integers(-40, 40).map(lambda k: k * 1e-16)
UNIT = st.integers(1, 1000).map(lambda n: n / 1000)
TURN = st.integers(0, 6283).map(lambda n: cmath.rect(1.0, n / 1000))
POWER = st.integers(-6, 6).map(lambda k: 10.0**k)
AWAY = st.sampled_from((0j, 1 + 2j, -30 + 7j))
SIDE = st.sampled_from((1.0, -1.0))


def _at(value: Any) -> Any:
    return np.array([[value]])


def _run(op: Any, *args: Any) -> complex:
    """Run one position; return the point, or the direction of the line."""
    with np.errstate(all="ignore"):
        found = op.run(*args)
    return complex((found[1] if isinstance(found, tuple) else found)[0, 0])


def _judge(found: complex, gap: Any, size: float, exact: Any, bound: Any) -> None:
    """A figure that exists is drawn within the bound; one short by more than rounding is not."""
    if gap >= 0:
        assert cmath.isfinite(found), float(gap)
    if gap < -200 * EPS * size:
        assert cmath.isnan(found), float(gap)
    if cmath.isfinite(found):
        assert abs(mp.mpc(found) - exact) <= bound, (found, exact, float(bound))


def _mp(z: complex) -> Any:
    return mp.mpc(z.real, z.imag)


@pytest.mark.slow
@settings(max_examples=most(300), deadline=None)
@given(r=UNIT, s=UNIT, off=TINY, scale=POWER, turn=TURN, away=AWAY, side=SIDE, inner=st.booleans())
def test_arcs_tangent_to_the_last_bit(
    r: float,
    s: float,
    off: float,
    scale: float,
    turn: complex,
    away: complex,
    side: float,
    inner: bool,
) -> None:
    r, s = scale * r, scale * s
    d = (abs(r - s) if inner else r + s) * (1 + off)
    if d < 1e-3 * scale:
        return
    c, e = scale * away, scale * away + d * turn
    found = _run(cross, Arc(_at(c), _at(r)), Arc(_at(e), _at(s)), _at(side))
    with mp.workdps(50):
        base, p, q = _mp(e) - _mp(c), mp.mpf(r), mp.mpf(s)
        long = abs(base)
        gap = min(p + q - long, long - abs(p - q))
        x = (long**2 + p**2 - q**2) / (2 * long)
        y = mp.sqrt(max(p**2 - x**2, mp.mpf(0)))
        exact = _mp(c) + mp.mpc(x, side * y) * base / long
        size = r + s + d
        condition = p * q / (long * y) if y else mp.inf
        bound = min(16 * EPS * condition, 32 * mp.sqrt(EPS)) * size + EPS * (
            8 * size + 2 * abs(exact)
        )
        _judge(found, gap, size, exact, bound)


@pytest.mark.slow
@settings(max_examples=most(300), deadline=None)
@given(r=UNIT, off=TINY, scale=POWER, turn=TURN, far=st.integers(-300, 300), away=AWAY, side=SIDE)
@example(r=1.0, off=0.0, scale=1.0, turn=cmath.rect(1, 0.3), far=-300, away=0j, side=1.0)
def test_a_line_that_touches_an_arc(
    r: float, off: float, scale: float, turn: complex, far: int, away: complex, side: float
) -> None:
    r = scale * r
    centre = scale * away
    start = centre + r * (1 + off) * 1j * turn + far * scale * turn
    found = _run(cut, Line(_at(start), _at(turn)), Arc(_at(centre), _at(r)), _at(side))
    with mp.workdps(50):
        u, c, radius = _mp(turn) / abs(_mp(turn)), _mp(centre) - _mp(start), mp.mpf(r)
        height = abs(mp.im(mp.conj(u) * c))
        gap, size = radius - height, abs(c) + radius
        half = mp.sqrt(max(radius**2 - height**2, mp.mpf(0)))
        exact = _mp(start) + (mp.re(mp.conj(u) * c) + side * half) * u
        root_bound = min(
            16 * EPS * size * radius / half if half else mp.inf, 32 * mp.sqrt(EPS * size * radius)
        )
        _judge(found, gap, size, exact, root_bound + EPS * (8 * size + 2 * abs(exact)))


@pytest.mark.slow
@settings(max_examples=most(200), deadline=None)
@given(r=UNIT, off=TINY, scale=POWER, turn=TURN, away=AWAY, side=SIDE)
def test_a_point_that_lies_on_the_circle_has_a_tangent(
    r: float, off: float, scale: float, turn: complex, away: complex, side: float
) -> None:
    r = scale * r
    centre = scale * away
    point = centre + r * (1 + off) * turn
    line = _run(tangent, _at(point), _at(centre), _at(r), _at(side))
    contact = _run(touch, _at(point), Arc(_at(centre), _at(r)), _at(side))
    with mp.workdps(50):
        base = _mp(point) - _mp(centre)
        d, radius = abs(base), mp.mpf(r)
        half = mp.sqrt(max(d**2 - radius**2, mp.mpf(0)))
        bound = min(16 * EPS * d / half if half else mp.inf, 32 * mp.sqrt(EPS)) + 8 * EPS
        along = base / d * mp.mpc(side * half, -radius) / d
        _judge(line, d - radius, float(d), along, bound)
        at = _mp(centre) + radius * mp.mpc(radius, -side * half) / d * base / d
        _judge(contact, d - radius, float(d), at, bound * radius + 2 * EPS * abs(at))


@pytest.mark.slow
@settings(max_examples=most(300), deadline=None)
@given(x=UNIT, y=UNIT, off=TINY, scale=POWER, turn=TURN, back=SIDE)
def test_lines_parallel_to_the_last_bit(
    x: float, y: float, off: float, scale: float, turn: complex, back: float
) -> None:
    """NaN where rounding alone may turn one into the other, else right within the condition."""
    other = back * turn * complex(1.0, off)
    a, b = Line(_at(0j), _at(turn)), Line(_at(scale * complex(x, y)), _at(other))
    found = _run(meet, a, b)
    with mp.workdps(50):
        u, v = (_mp(z) / abs(_mp(z)) for z in (turn, other))
        sine, d = mp.im(mp.conj(u) * v), _mp(complex(b.at[0, 0]))
        if abs(sine) <= EPS:
            assert cmath.isnan(found)
        if abs(sine) >= 8 * EPS:
            assert cmath.isfinite(found)
        if cmath.isfinite(found):
            t = mp.im(mp.conj(d) * v) / sine
            # the sine has an error of its own, up to 2 ε: not small beside it
            bound = EPS * 8 * (abs(d) + abs(t)) / (abs(sine) - 2 * EPS)
            assert abs(_mp(found) - t * u) <= bound


@each("quarter", range(-8, 9))
def test_quadrants_are_exact(quarter: int) -> None:
    angle = 90.0 * quarter
    assert cis(_at(angle))[0, 0] == 1j**quarter
    line = ray.run(_at(0j), _at(angle))
    assert line.along[0, 0] == 1j**quarter
    assert incline.run(_at(0j), line, _at(-angle)).along[0, 0] == 1.0


def test_one_more_turn_changes_nothing() -> None:
    angles = np.arange(0.0, 360.0, 0.25)[None, :]
    np.testing.assert_array_equal(cis(angles), cis(angles + 360.0))
    np.testing.assert_array_equal(cis(angles), cis(angles - 720.0))
    np.testing.assert_array_equal(cis(-angles), np.conj(cis(angles)))


def test_thirds_of_a_quadrant_are_right_to_an_ulp() -> None:
    angles = np.arange(-720.0, 721.0, 30.0)[None, :]
    with mp.workdps(50):
        for angle, z in zip(angles[0], cis(angles)[0], strict=True):
            true = mp.expjpi(mp.mpf(float(angle)) / 180)
            assert abs(mp.mpf(z.real) - true.real) <= EPS * abs(true.real)
            assert abs(mp.mpf(z.imag) - true.imag) <= EPS * abs(true.imag)


@pytest.mark.parametrize("size", [1e-6, 1.0, 0.1, 3e5])
def test_the_eight_main_directions_are_exact(size: float) -> None:
    signs = np.array([[1, 1 + 1j, 1j, -1 + 1j, -1, -1 - 1j, -1j, 1 - 1j]]) * size
    due = [0.0, 45.0, 90.0, 135.0, 180.0, -135.0, -90.0, -45.0]
    assert degrees(signs)[0].tolist() == due
    assert bearing.run(np.zeros((1, 1), complex), signs)[0].tolist() == due


def test_a_point_has_no_direction() -> None:
    with np.errstate(all="ignore"):
        assert np.isnan(degrees(np.array([[0j, 1.0]]))).tolist() == [[True, False]]
        assert np.isnan(bearing.run(_at(2 + 1j), _at(2 + 1j))).all()
        assert np.isnan(degrees(_at(complex(np.nan, np.nan)))).all()


def test_the_root_touches_within_rounding_only() -> None:
    gaps = np.array([[1.0, 0.0, -8 * EPS, -1e-3, np.nan]])
    with np.errstate(all="ignore"):
        found = root(gaps * 4.0, gaps, np.ones((1, 1)))
    np.testing.assert_array_equal(found, [[2.0, 0.0, 0.0, np.nan, np.nan]])


def test_circles_about_one_centre_meet_nowhere() -> None:
    arc = Arc(_at(1 + 1j), _at(2.0))
    assert cmath.isnan(_run(cross, arc, arc, _at(1.0)))
    assert cmath.isnan(_run(cross, arc, Arc(_at(1 + 1j), _at(1.0)), _at(1.0)))


def test_an_opening_of_zero_is_a_point() -> None:
    centre, other = _at(1 + 1j), _at(4 + 5j)
    assert _run(cross, Arc(centre, _at(0.0)), Arc(other, _at(5.0)), _at(1.0)) == 1 + 1j
    line = Line(_at(1 + 1j), _at(1 + 0j))
    assert _run(cut, line, Arc(_at(3 + 1j), _at(0.0)), _at(1.0)) == 3 + 1j
