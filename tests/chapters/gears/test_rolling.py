"""Arcs, turns, reflections and meetings of curves against complex arithmetic and known crossings."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import graphic_tmm.chapters.gears.rolling as r
from graphic_tmm.board.values import Arc, Curve, Line

EPS = float(np.finfo(float).eps)
numbers = st.floats(-100, 100)
spots = st.complex_numbers(max_magnitude=100, allow_nan=False, allow_infinity=False)


def one(z: complex) -> np.ndarray:
    return np.array([[z]], dtype=complex)


def length(x: float) -> np.ndarray:
    return np.array([[x]], dtype=float)


def arc_of(centre: complex, radius: float) -> Arc:
    return Arc(one(centre), length(radius))


def circle(centre: complex, radius: float, count: int = 24, sweep: float = np.pi) -> Curve:
    """A smooth curve through points of an arc of a circle."""
    turns = np.linspace(0.0, sweep, count)
    return r.smooth_through.run((centre + radius * np.exp(1j * turns))[None, :], row=count)


@pytest.mark.slow
@given(spots, st.floats(0.1, 100), st.floats(-3, 3), st.floats(0, 6))
def test_an_arc_laid_off_is_measured_again(
    centre: complex, radius: float, turn: float, at: float
) -> None:
    arc, start = arc_of(centre, radius), one(centre + radius * np.exp(1j * at))
    for sense in (1, -1):
        end = r.along_arc.run(start, arc, length(radius * turn), sense=sense)
        due = centre + radius * np.exp(1j * (at + sense * turn))
        slack = 16 * EPS * (abs(centre) + radius)
        assert abs(end[0, 0] - due) <= slack
        found = r.measure_arc.run(start, end, arc, sense=sense)[0, 0]
        assert found == pytest.approx(radius * turn, abs=4 * slack)


def test_an_arc_without_a_radius_bears_no_length() -> None:
    with np.errstate(all="ignore"):
        assert np.isnan(r.along_arc.run(one(1j), arc_of(1j, 0.0), length(1.0))).all()


@given(spots, spots, st.floats(-180, 180))
def test_a_turn_is_measured_as_the_angle_at_its_centre(
    of: complex, about: complex, by: float
) -> None:
    if abs(of - about) < 1e-3:
        return
    angle = length(by)
    turned = r.turn_about.run(one(of), one(about), angle)
    back = r.turn_about.run(turned, one(about), angle, sense=-1)
    slack = 16 * EPS * (abs(of) + abs(about))
    assert abs(back[0, 0] - of) <= slack
    found = r.angle_at.run(one(about), one(of), turned)[0, 0]
    assert abs((found - by + 180) % 360 - 180) <= np.degrees(4 * slack / abs(of - about)) + 1e-12


@given(spots, spots, st.floats(0, 6))
def test_a_reflection_keeps_the_axis_and_is_its_own_inverse(
    of: complex, at: complex, way: float
) -> None:
    axis = Line(one(at), one(np.exp(1j * way)))
    image = r.reflect.run(one(of), axis)
    middle = (image[0, 0] + of) / 2
    slack = 16 * EPS * (abs(of) + abs(at))
    assert abs(((middle - at) * np.exp(-1j * way)).imag) <= slack  # halfway, on the axis
    assert abs(r.reflect.run(image, axis)[0, 0] - of) <= 2 * slack


def test_a_smooth_curve_goes_through_its_row_only_and_begins_with_it() -> None:
    row = np.array([[0, 1 + 1j, 2 + 1j, 3, 4 - 1j, np.nan, np.nan]])
    curve = r.smooth_through.run(row, row=5)
    np.testing.assert_array_equal(curve.knots, row[:, :5])
    assert np.isfinite(curve.tangents).all()
    assert r.beginning.run(curve)[0, 0] == 0
    hole = np.array([[0, 1 + 1j, np.nan, 3, 4 - 1j]])
    assert np.isnan(r.smooth_through.run(hole, row=5).tangents[0, 2])


def test_a_curve_meets_arcs_where_its_points_lie_at_their_radius() -> None:
    curve = circle(10 + 0j, 5.0)  # from 15 over the top to 5, seen from the origin
    radii = np.array([[14.9, 15.0, 12.0, 7.0, 5.0, 5.1]])
    found = r.curve_meets_arc.run(curve, Arc(one(0), radii))
    assert found.shape == radii.shape
    np.testing.assert_allclose(np.abs(found), radii, rtol=4 * EPS)
    # on the circle about 10, as nearly as the spline through 24 points: (π/23)⁴/384 of the radius, ends more
    np.testing.assert_allclose(np.abs(found - 10), 5.0, atol=5.0 * (np.pi / 23) ** 4 / 384 * 20)
    assert found[0, 1] == 15.0
    assert abs(found[0, 4] - 5.0) < 1e-12


def test_what_a_curve_does_not_reach_is_missing_and_so_is_a_gap() -> None:
    curve = circle(10 + 0j, 5.0)
    found = r.curve_meets_arc.run(curve, Arc(one(0), np.array([[4.9, 15.1, np.nan]])))
    assert np.isnan(found).all()
    row = circle(10 + 0j, 5.0).knots.copy()
    row[0, 10] = np.nan
    broken = r.smooth_through.run(row, row=24)
    with np.errstate(all="ignore"):
        at_gap = r.curve_meets_arc.run(broken, Arc(one(0), np.abs(curve.knots[:, 10:11])))
        before = r.curve_meets_arc.run(broken, Arc(one(0), np.array([[14.0]])))
    assert np.isnan(at_gap).all()
    assert abs(before[0, 0]) == pytest.approx(14.0)


def test_trials_of_a_curve_and_of_an_arc_go_together() -> None:
    row = np.concatenate([circle(10, 5.0).knots, circle(10, 4.0).knots])
    curve = r.smooth_through.run(row, row=24)
    found = r.curve_meets_arc.run(curve, arc_of(0, 12.0))
    assert found.shape == (2, 1)
    np.testing.assert_allclose(np.abs(found), 12.0)
    radii = np.array([[12.0], [13.0]])
    many = r.curve_meets_arc.run(circle(10, 5.0), Arc(np.zeros((1, 1), complex), radii))
    np.testing.assert_allclose(np.abs(many), radii)


@given(st.floats(1.0, 9.0), st.floats(-0.4, 0.4))
def test_curves_cross_where_their_circles_do(apart: float, low: float) -> None:
    first, second = circle(0, 5.0), circle(apart + low * 1j, 5.0)
    with np.errstate(all="ignore"):  # as `execute` runs
        found = r.curves_cross.run(first, second)[0, 0]
        swapped = r.curves_cross.run(second, first)[0, 0]
    base = complex(apart, low)
    due = base / 2 + 1j * base / abs(base) * np.sqrt(25 - abs(base) ** 2 / 4)
    sine = np.sqrt(1 - abs(base) ** 2 / 100) * abs(base) / 5  # of the angle at which they cross
    assert abs(found - due) < 4 * 5.0 * (np.pi / 23) ** 4 / 384 * 20 / sine
    assert abs(found - swapped) <= 64 * EPS * 10


def test_curves_that_do_not_cross_leave_nothing() -> None:
    with np.errstate(all="ignore"):
        assert np.isnan(r.curves_cross.run(circle(0, 5.0), circle(0, 4.0))).all()
