"""Graph operations: splines against dense systems, ordinates, tangents, successions; missing points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from graphic_tmm.board.hand import HANDS
from graphic_tmm.board.operations import graph_curves as curves
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.values import Curve, Line

N, LENGTH = 12, 96.0
STEP = LENGTH / N
X = np.arange(N) * STEP
FEET = X[None, :] + 0j
END = np.array([[LENGTH + 0j]])
OVER = np.array([[LENGTH]])
Y = 20 * np.cos(2 * np.pi * np.arange(N) / N + 0.4) + 6 * np.sin(4 * np.pi * np.arange(N) / N)
"""So smooth that no tangent of the spline is bounded."""
FINE = np.linspace(0.0, LENGTH, 241)


def dense_spline(x: np.ndarray, y: np.ndarray, kind: str) -> np.ndarray:
    """Coefficients a + b·t + c·t² + d·t³ of each arc, all conditions in one dense system."""
    n = x.size - 1
    rows, right = [], []

    def row(**at: np.ndarray) -> np.ndarray:
        made = np.zeros((n, 4))
        for key, value in at.items():
            made[int(key[1:])] = value
        return made.ravel()

    h = np.diff(x)
    for k in range(n):
        rows += [row(**{f"k{k}": [1, 0, 0, 0]}), row(**{f"k{k}": [1, h[k], h[k] ** 2, h[k] ** 3]})]
        right += [y[k], y[k + 1]]
    slope = lambda t: np.array([0, 1, 2 * t, 3 * t**2])  # noqa: E731
    bend = lambda t: np.array([0, 0, 2, 6 * t])  # noqa: E731
    for k in range(n - 1):
        for of in (slope, bend):
            rows.append(row(**{f"k{k}": of(h[k]), f"k{k + 1}": -of(0.0)}))
            right.append(0.0)
    if kind == "periodic":
        for of in (slope, bend):
            rows.append(row(**{f"k{n - 1}": of(h[-1]), "k0": -of(0.0)}))
    else:  # not a knot
        third = np.array([0, 0, 0, 1.0])
        rows += [row(k0=third, k1=-third), row(**{f"k{n - 2}": third, f"k{n - 1}": -third})]
    right += [0.0, 0.0]
    return np.linalg.solve(np.array(rows), np.array(right)).reshape(n, 4)


def value(x: np.ndarray, arcs: np.ndarray, at: np.ndarray, order: int = 0) -> np.ndarray:
    k = np.clip(np.searchsorted(x, at, side="right") - 1, 0, x.size - 2)
    t, c = at - x[k], arcs[k]
    if order:
        return c[:, 1] + 2 * c[:, 2] * t + 3 * c[:, 3] * t**2
    return c[:, 0] + c[:, 1] * t + c[:, 2] * t**2 + c[:, 3] * t**3


def closed() -> Curve:
    return curves.closed_graph.run(FEET + 1j * Y, OVER, row=N)


def opened() -> tuple[Curve, np.ndarray]:
    y = np.append(Y, 7.0)
    return curves.open_graph.run(FEET + 1j * Y, END + 7j, row=N), y


@pytest.mark.parametrize("kind", ["periodic", "open"])
def test_a_graph_is_the_spline_through_its_points(kind: str) -> None:
    x = np.append(X, LENGTH)
    curve, y = (closed(), np.append(Y, Y[0])) if kind == "periodic" else opened()
    arcs = dense_spline(x, y, kind)
    feet = FINE[None, :] + 0j
    np.testing.assert_allclose(g.erect.run(curve, feet).imag[0], value(x, arcs, FINE), atol=1e-10)
    line = g.touching.run(curve, feet)
    slope = line.along.imag / line.along.real
    np.testing.assert_allclose(slope[0], value(x, arcs, FINE, 1), atol=1e-9)
    np.testing.assert_allclose(np.abs(line.along), 1.0)


def test_knots_are_met_exactly_and_nothing_stands_outside_the_base() -> None:
    curve, y = opened()
    assert (g.erect.run(curve, FEET).imag[0] == Y).all()
    assert g.erect.run(curve, END).imag[0, 0] == pytest.approx(7.0)
    # beyond what a hand pricks and its square leans over ordinates so tall
    out = g.BEYOND + g.LEAN * np.abs(y).max() + 0.01
    outside = np.array([[-out, LENGTH + out]]) + 0j
    assert np.isnan(g.erect.run(curve, outside)).all()
    with np.errstate(all="ignore"):  # as `execute` runs
        assert np.isnan(g.touching.run(curve, outside).along).all()
    assert y.size == N + 1


@given(st.floats(0.0, 1.0), st.floats(-60.0, 60.0))
def test_a_foot_that_a_hand_put_beside_the_end_means_the_end(share: float, height: float) -> None:
    """Five times the student's slips: two points of one ordinate, on lines which lean by the square's swing."""
    student = HANDS["student"]
    reach = 5.0 * 2**0.5 * student.prick + abs(height) * np.tan(np.radians(5.0 * student.swing))
    curve, y = opened()
    beside = np.array([[-share * reach, LENGTH + share * reach]]) + 1j * height
    at = np.array([[0.0, LENGTH]]) + 1j * height
    # within 1e-9 of an interval the curve goes on: that is rounding
    rounding = 1e-9 * 2.0 * float(np.abs(curve.tangents).max())
    ends = g.erect.run(curve, beside).imag
    np.testing.assert_allclose(ends, [[y[0], y[-1]]], rtol=0, atol=rounding)
    np.testing.assert_allclose(
        g.rise_of(curve, beside), g.rise_of(curve, at), rtol=0, atol=6.0 * rounding
    )


def test_a_closed_graph_through_middles_covers_the_whole_base() -> None:
    middles = FEET + STEP / 2
    curve = curves.closed_graph.run(middles + 1j * Y, OVER, row=N)
    both = g.erect.run(curve, np.array([[0.0, LENGTH]]) + 0j).imag[0]
    assert both[0] == pytest.approx(both[1], abs=1e-10)
    np.testing.assert_allclose(g.erect.run(curve, middles).imag[0], Y, atol=1e-12)


@given(st.tuples(*(st.floats(-reach, reach) for reach in (3, 3, 1, 0.1))))
def test_a_cubic_is_prolonged_exactly_by_half_an_interval(c: tuple[float, ...]) -> None:
    """A cubic whose bends, if it has any, lie further apart than three intervals: no tangent is bounded."""
    if abs(c[3]) > 0.0:
        apart = c[2] ** 2 - 3 * c[1] * c[3]
        assume(apart > (1.5 * 3 / N * abs(c[3])) ** 2)

    def cubic(x: np.ndarray) -> np.ndarray:
        t = x / LENGTH
        return c[0] + c[1] * t + c[2] * t**2 + c[3] * t**3

    middles = X + STEP / 2
    curve = curves.open_graph_of_middles.run((middles + 1j * cubic(middles))[None, :], row=N)
    found = g.erect.run(curve, FINE[None, :] + 0j).imag[0]
    np.testing.assert_allclose(found, cubic(FINE), atol=1e-10)


def test_a_missing_point_touches_its_trial_only_and_leaves_runs() -> None:
    rows = np.concatenate([FEET + 1j * Y] * 3)
    rows[1, 5] = np.nan
    for curve in (
        curves.closed_graph.run(rows, OVER, row=N),
        curves.open_graph.run(rows, END + 7j, row=N),
    ):
        found = g.erect.run(curve, FINE[None, :] + 0j).imag
        assert np.isfinite(found[[0, 2]]).all()
        np.testing.assert_array_equal(found[0], found[2])
        gone = (X[4] + 1e-9 < FINE) & (X[6] - 1e-9 > FINE)
        assert np.isnan(found[1, gone]).all()
        assert np.isfinite(found[1, (X[1] < FINE) & (X[4] > FINE)]).all()


def test_trials_of_curve_and_feet_go_together() -> None:
    rows = np.concatenate([FEET + 1j * Y, FEET + 2j * Y])
    curve = curves.closed_graph.run(rows, OVER, row=N)
    one = g.erect.run(curve, FEET)
    np.testing.assert_allclose(one[1].imag, 2 * Y)
    many = g.erect.run(closed(), np.concatenate([FEET, FEET + 1.0]))
    assert many.shape == (2, N)


def test_following_and_halving() -> None:
    extra = np.concatenate([FEET, [[50.0 + 0j]]], axis=1)  # a position outside the row
    after = g.following.run(extra, END, row=N)
    np.testing.assert_array_equal(after[0, : N - 1], FEET[0, 1:])
    assert after[0, N - 1] == LENGTH
    assert np.isnan(after[0, N])
    np.testing.assert_allclose(g.halve.run(extra, after)[0, :N], FEET[0] + STEP / 2)
    assert g.at_zero.run(FEET + 3j)[0, 0] == 3j
    ends = np.array([[1 + 0j], [2 + 0j]])
    assert g.following.run(FEET, ends, row=N).shape == (2, N)


def test_segments_in_succession_add_up_their_rises() -> None:
    slopes = np.random.default_rng(4).normal(size=N)
    along = (1 + 1j * slopes) / np.abs(1 + 1j * slopes)
    rays = Line(np.zeros((1, N), complex), along[None, :])
    start = np.array([[2j]])
    points = g.succession.run(start, rays, FEET, END, row=N)
    heights = 2 + np.concatenate([[0], np.cumsum(slopes * STEP)])
    np.testing.assert_allclose(points.imag[0], heights[:-1], atol=1e-12)
    np.testing.assert_allclose(points.real[0], X)
    last = g.arrival.run(start, rays, FEET, END, row=N)
    assert last[0, 0] == pytest.approx(LENGTH + 1j * heights[-1])
    steep = Line(rays.at, np.where(np.arange(N) == 3, 1j, along)[None, :])
    with np.errstate(all="ignore"):
        broken = g.succession.run(start, steep, FEET, END, row=N)
        end = g.arrival.run(start, steep, FEET, END, row=N)
    assert np.isfinite(broken[0, :4]).all()
    assert np.isnan(broken[0, 4:]).all()
    assert np.isnan(end).all()
