"""Curves of graphs: nowhere outside their neighbours, level where these are, smooth where they turn."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.board.operations import graph_curves as c
from graphic_tmm.board.operations import graphs as g
from graphic_tmm.board.operations.curve import bezier, taut_curve
from graphic_tmm.board.values import Curve, Line

EPS = np.finfo(float).eps
STEP = 8.0
U = np.linspace(0.0, 1.0, 33)
# plateaus, corners, noise, jumps, huge and tiny ordinates
ORDINATE = st.one_of(
    st.sampled_from([0.0, 0.0, 1.0, -1.0, 40.0]),
    st.floats(-50, 50).map(lambda x: round(x, 3)),
    # whose square is no number any more, mm
    st.floats(-50, 50).map(lambda x: 0.0 if abs(x) < 1e-30 else x),
)
ROWS = st.tuples(
    st.lists(ORDINATE, min_size=4, max_size=16), st.sampled_from([1.0, 1e9, 1e-9])
).map(lambda drawn: np.array(drawn[0]) * drawn[1])


def feet(n: int) -> np.ndarray:
    return np.arange(n)[None, :] * STEP + 0j


def closed(op: object, y: np.ndarray) -> Curve:
    n = y.size
    return op.run(feet(n) + 1j * y, np.array([[n * STEP]]), row=n)  # type: ignore[attr-defined]


def opened(y: np.ndarray) -> Curve:
    n = y.size
    end = np.array([[(n - 1) * STEP + 1j * y[-1]]])
    return c.open_graph.run(feet(n)[:, :-1] + 1j * y[:-1], end, row=n - 1)


def arcs(curve: Curve) -> np.ndarray:
    """The ordinates along every drawn arc, (arc, 33), by de Casteljau on the controls that are inked."""
    found = []
    for controls in bezier(curve):
        for k in range(0, len(controls) - 1, 3):
            p = [z.imag for z in controls[k : k + 4]]
            while len(p) > 1:
                p = [a + U * (b - a) for a, b in pairwise(p)]
            found.append(p[0])
    return np.array(found)


def outside(y: np.ndarray) -> np.ndarray:
    """By how much every arc leaves the range of its two ends."""
    ends = y[:, [0, -1]]
    return np.maximum(y.max(axis=1) - ends.max(axis=1), ends.min(axis=1) - y.min(axis=1))


def rounding(y: np.ndarray) -> float:
    """Some forty roundings of the largest ordinate: three levels of de Casteljau and the tangents."""
    return 40 * EPS * float(np.abs(y).max())


@given(ROWS)
def test_a_taut_graph_never_leaves_its_neighbours_and_is_level_between_equal_ones(
    y: np.ndarray,
) -> None:
    drawn = arcs(closed(c.taut_graph, y))
    assert outside(drawn).max() <= rounding(y)
    ends = np.concatenate([y[-1:], y, y[:1]])
    for k in np.flatnonzero(np.diff(ends) == 0.0):
        assert np.ptp(drawn[k]) <= rounding(y)


@given(ROWS, st.data())
def test_so_it_is_beside_gaps(y: np.ndarray, data: st.DataObject) -> None:
    gone = data.draw(st.sets(st.integers(0, y.size - 1), min_size=1))
    holed = y.copy()
    holed[list(gone)] = np.nan
    drawn = arcs(closed(c.taut_graph, holed))
    ends = np.concatenate([holed[-1:], holed, holed[:1]])
    there = np.isfinite(ends[1:]) & np.isfinite(ends[:-1])
    assert len(drawn) == there.sum()
    if len(drawn):
        assert outside(drawn).max() <= rounding(y)


def bends(y: np.ndarray, *, ring: bool) -> np.ndarray:
    """Of every arc the lesser of the second differences at its ends if both bend to one side, else 0."""
    if ring:
        y = np.concatenate([y[-2:], y, y[:2]])
        d = np.diff(y, 2)  # at -1, 0, ..., n
    else:
        d = np.diff(y, 2)
        d = np.concatenate([d[:1], d, d[-1:]])
    a, b = d[:-1], d[1:]
    return np.where(np.sign(a) * np.sign(b) > 0, np.minimum(np.abs(a), np.abs(b)), 0.0)


@given(ROWS)
def test_a_smooth_graph_bulges_by_a_quarter_of_the_bend_at_the_most(y: np.ndarray) -> None:
    drawn = arcs(closed(c.closed_graph, y))[1:]
    assert (outside(drawn) <= bends(y, ring=True)[1:] / 4 + rounding(y)).all()
    drawn = arcs(opened(y))
    assert (outside(drawn) <= bends(y, ring=False) / 4 + rounding(y)).all()


def spline(y: np.ndarray) -> np.ndarray:
    """Tangents of the periodic C² spline, by a dense system."""
    one = np.eye(y.size)
    matrix = 4 * one + np.roll(one, 1, axis=1) + np.roll(one, -1, axis=1)
    return np.linalg.solve(matrix, 3 * (np.roll(y, -1) - np.roll(y, 1)))


@given(ROWS)
def test_tangents_that_are_within_bounds_are_those_of_the_spline(y: np.ndarray) -> None:
    m, ahead = spline(y), np.roll(y, -1) - y
    behind = np.roll(ahead, 1)
    taut = closed(c.taut_graph, y).tangents[0, 1:-1].imag
    slack = 100 * EPS * np.abs(y).max()
    for k in range(y.size):
        least = min(abs(ahead[k]), abs(behind[k]))
        monotone = ahead[k] * behind[k] > 0 and 0 <= m[k] * np.sign(ahead[k]) <= 3 * least
        if monotone:
            assert abs(taut[k] - m[k]) <= slack
        elif ahead[k] * behind[k] <= 0 and abs(ahead[k] * behind[k]) < np.inf:
            assert taut[k] == 0.0


@pytest.mark.parametrize("op", [c.closed_graph, c.taut_graph])
@given(y=ROWS, size=st.floats(0.1, 10.0), up=st.floats(-30, 30))
def test_scaling_shifting_and_turning_a_row_round_does_so_to_its_curve(
    op: object, y: np.ndarray, size: float, up: float
) -> None:
    up *= float(np.abs(y).max())
    one = closed(op, y).tangents[0, 1:-1].imag
    slack = 200 * EPS * (size * float(np.abs(y).max()) + abs(up))
    other = closed(op, size * y + up).tangents[0, 1:-1].imag
    back = closed(op, -y[::-1]).tangents[0, 1:-1].imag
    # a bend or chord that is nothing but rounding changes its sign: it bounds tangents that are as small
    np.testing.assert_allclose(other, size * one, rtol=0, atol=3 * slack)
    np.testing.assert_allclose(back[::-1], one, rtol=0, atol=3 * slack)


@pytest.mark.parametrize("n", [8, 12, 24])
@pytest.mark.parametrize("phase", [0.0, 0.3, 0.5])
def test_a_smooth_graph_of_a_sine_is_its_spline_and_rises_between_two_equal_ordinates(
    n: int, phase: float
) -> None:
    y = 50 * np.cos(2 * np.pi * (np.arange(n) + phase) / n)
    curve = closed(c.closed_graph, y)
    np.testing.assert_allclose(curve.tangents[0, 1:-1].imag, spline(y), atol=1e-12 * 50)
    top = arcs(curve).max()
    # the error of a C² spline: 5/384 of the fourth derivative
    assert (
        abs(top - 50) <= 5 / 384 * (2 * np.pi / n) ** 4 * 50 + 50 * (2 * np.pi / n) ** 2 / 8 / 33**2
    )


@pytest.mark.parametrize("turned", [False, True])
def test_a_smooth_graph_of_three_points_is_their_parabola(turned: bool) -> None:
    u = np.array([1.0, 2.0, 3.0])
    y = u[::-1] ** 2 if turned else u**2
    due = [(1.0 + U) ** 2, (2.0 + U) ** 2]
    drawn = arcs(opened(y))
    np.testing.assert_allclose(drawn[::-1, ::-1] if turned else drawn, due, rtol=1e-14)


def test_a_spike_does_not_ring() -> None:
    y = np.zeros(12)
    y[5] = -100.0
    for op in (c.closed_graph, c.taut_graph):
        drawn = arcs(closed(op, y))
        assert drawn.max() <= 1e-12
        assert np.ptp(drawn[np.r_[0:5, 7:13]]) == 0.0
    assert (spline(y)[4] - spline(y)[3]) / -8 > 12.0  # what the bare spline would rise to


@given(ROWS)
def test_given_tangents_are_honoured(y: np.ndarray) -> None:
    n, pole = y.size, np.array([[-40.0 + 3j]])
    heights = np.roll(y, 3)
    axis = Line(np.zeros((1, 1), complex), np.full((1, 1), 1j))
    end = np.array([[n * STEP + 7j]])
    curve = c.graph_of_rays.run(feet(n) + 1j * y, end, pole, feet(n) + 1j * heights, axis, row=n)
    due = (np.append(heights, heights[0]) - 3.0) / 40.0
    assert (curve.knots == np.append(feet(n)[0] + 1j * y, end[0, 0])).all()
    slopes = curve.tangents[0].imag / curve.tangents[0].real
    np.testing.assert_allclose(slopes, due, rtol=1e-14, atol=1e-14 * float(np.abs(due).max()))
    right = c.graph_of_rays.run(
        feet(n) + 1j * y, end, -pole.conj(), feet(n) + 1j * heights, axis, row=n
    )
    np.testing.assert_allclose(right.tangents.imag, -curve.tangents.imag, rtol=1e-14)


@given(ROWS, st.integers(0, 2**31))
def test_a_graph_of_differences_is_one_everywhere(y: np.ndarray, seed: int) -> None:
    n = y.size
    other = np.random.default_rng(seed).normal(size=n) * float(np.abs(y).max() + 1e-9)
    first, second = closed(c.taut_graph, y), closed(c.closed_graph, other)
    end = np.array([[n * STEP + 1j * (y - other)[0]]])
    made = c.graph_of_differences.run(feet(n) + 1j * (y - other), end, first, second, row=n)
    x = np.linspace(0, n * STEP, 7 * n + 1)[None, :] + 0j
    due = g.erect.run(first, x).imag - g.erect.run(second, x).imag
    found = g.erect.run(made, x).imag
    np.testing.assert_allclose(found, due, rtol=0, atol=200 * n * EPS * np.abs([y, other]).max())


@given(ROWS, st.sampled_from([c.closed_graph, c.taut_graph]))
def test_extremes_are_those_of_the_drawn_curve(y: np.ndarray, op: object) -> None:
    curve, n = closed(op, y), y.size
    over = np.array([[n * STEP + 0j]])
    drawn = arcs(curve)[1:]  # the first arc lies before the base
    size = float(np.abs(y).max())
    with np.errstate(all="ignore"):  # as `execute` runs
        top, bottom = (op.run(curve, feet(n)[:, :1], over)[0, 0] for op in (g.highest, g.lowest))
    for found, best in ((top, drawn.max()), (bottom.conj(), -drawn.min())):
        assert found.imag >= best - rounding(y) - g.EVEN * float(np.ptp(y))
        # between two of 33 samples a cubic rises by no more than an eighth of its bend over their distance
        assert found.imag <= best + 6 * 4 * size / 32**2 / 8 + rounding(y)
        assert 0.0 <= found.real <= n * STEP + 1e-9


def test_an_extreme_before_or_behind_the_limits_does_not_count_and_the_first_of_equals_does() -> (
    None
):
    y = np.array([0, 30, 0, -20, 0, 30, 0, -20.0])
    curve = closed(c.closed_graph, y)
    start, end = np.array([[2 * STEP + 0j]]), np.array([[4 * STEP + 0j]])
    assert g.lowest.run(curve, start, end)[0, 0] == pytest.approx(3 * STEP - 20j)
    assert abs(g.highest.run(curve, start, end)[0, 0].imag) < 1e-9
    whole = g.highest.run(curve, feet(8)[:, :1], np.array([[8 * STEP + 0j]]))[0, 0]
    assert whole == pytest.approx(STEP + 30j)
    y[4] = np.nan
    broken = closed(c.closed_graph, y)
    assert np.isnan(g.highest.run(broken, feet(8)[:, :1], np.array([[8 * STEP + 0j]])))
    both = Curve(
        *(np.concatenate([a, b]) for a, b in zip(curve[:2], broken[:2], strict=True)), False
    )
    found = g.highest.run(both, feet(8)[:, :1], np.array([[8 * STEP + 0j]]))
    assert np.isfinite(found[0, 0])
    assert np.isnan(found[1, 0])


@given(ROWS, st.booleans())
def test_a_rectangle_is_as_large_as_the_figure_below_the_curve(
    y: np.ndarray, between: bool
) -> None:
    """By Gauss's four points on each half: exact for any cubic, and other points than the operation's."""
    n = y.size
    points = feet(n) + (STEP / 2 if between else 0.0) + 1j * y
    curve = c.closed_graph.run(points, np.array([[n * STEP]]), row=n)
    start, end = feet(n), feet(n) + STEP
    found = g.level_off.run(curve, start, end)
    at, weight = np.polynomial.legendre.leggauss(4)
    mean = np.zeros(n)
    for half in (0.25, 0.75):
        for t, w in zip(at, weight, strict=True):
            mean += w / 4 * g.erect.run(curve, start + (half + t / 4) * STEP).imag[0]
    np.testing.assert_allclose(found.imag[0], mean, rtol=0, atol=8 * rounding(y))
    np.testing.assert_allclose(found.real, start.real + STEP / 2)


@pytest.mark.slow
def test_an_indicator_diagram_stays_between_its_points_in_both_directions() -> None:
    rng = np.random.default_rng(11)
    for _ in range(200):
        z = rng.choice([0, 10, 100], 12) + rng.random(12) + 1j * rng.choice([0, 10, 100], 12)
        curve = taut_curve.run(z[None, :], row=12)
        turned = Curve(curve.knots * -1j, curve.tangents * -1j, True)
        for drawn in (arcs(curve), arcs(turned)):
            assert outside(drawn).max() <= 40 * EPS * 150


def test_an_energy_mass_curve_has_the_extremes_of_both_graphs() -> None:
    n = 12
    phi = 2 * np.pi * np.arange(n) / n
    x, y = 60 - 20 * np.cos(2 * phi + 0.4), 30 * np.sin(phi + 0.2)
    rays = Line(np.zeros((1, 1), complex), np.full((1, 1), 1j))
    slope = np.gradient(np.tile(y, 3))[n : 2 * n] / STEP
    end = np.array([[n * STEP + 1j * y[0]]])
    graph = c.graph_of_rays.run(
        feet(n) + 1j * y, end, np.array([[-1.0 + 0j]]), feet(n) + 1j * slope, rays, row=n
    )
    made = c.curve_of_two.run((x + 1j * y)[None, :], graph, row=n)
    assert arcs(made).max() == pytest.approx(arcs(graph).max(), abs=1e-12)
    over = closed(c.closed_graph, x)
    turned = Curve(made.knots * 1j, made.tangents * 1j, True)
    assert arcs(turned).max() == pytest.approx(arcs(over).max(), abs=1e-12)
    gone = np.where(np.arange(n) == 4, np.nan, x + 1j * y)[None, :]
    assert not bezier(c.curve_of_two.run(gone, graph, row=n))
