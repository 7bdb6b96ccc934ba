"""Integrals that should close and drift, chords of an almost vertical curve, curves through a few points."""

from __future__ import annotations

from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest

from graphic_tmm.board.execute import execute
from graphic_tmm.board.findings import examine
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.operations.curve import french_curve, taut_curve
from graphic_tmm.board.operations.graph_curves import (
    closed_graph,
    open_graph,
    open_graph_of_middles,
)
from graphic_tmm.board.operations.graphs import arrival, erect, succession
from graphic_tmm.board.operations.instruments import join, lay_off, meet, parallel, ray, square
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Angle, Length, Line, Point, arrays

# integrals


def _added(slopes: np.ndarray, base: float) -> tuple[np.ndarray, complex]:
    """Segments in succession over an even base, each with its slope; where they begin, where the last ends."""
    n = slopes.size
    feet = np.arange(n) * base / n + 0j
    rays = Line(np.zeros((1, 1), complex), ((1 + 1j * slopes) / np.abs(1 + 1j * slopes))[None, :])
    start, end = np.zeros((1, 1), complex), np.full((1, 1), base + 0j)
    with np.errstate(all="raise", under="ignore"):
        points = succession.run(start, rays, feet[None, :], end, row=n)
        last = arrival.run(start, rays, feet[None, :], end, row=n)
    return points[0], complex(last[0, 0])


def _due(slopes: np.ndarray, base: float) -> list[Any]:
    with mp.workdps(50):
        step = mp.mpf(base) / slopes.size
        total, found = mp.mpf(0), []
        for slope in slopes.tolist():
            found.append(total)
            total += step * mp.mpf(slope)
        return [*found, total]


@pytest.mark.parametrize("count", [4, 12, 1000, 20000])
@pytest.mark.parametrize("offset", [0.0, 1e6])
def test_an_integral_drifts_no_further_than_its_roundings(count: int, offset: float) -> None:
    """n roundings of the largest sum so far, and of each rise the eight of its slope; a foot is off by ε·L."""
    base = 240.0
    source = np.random.default_rng(count)
    slopes = offset + source.standard_normal(count)
    slopes -= slopes.mean() if offset == 0 else 0.0
    points, last = _added(slopes, base)
    due = _due(slopes, base)
    rises = np.abs(slopes) * base / count
    bound = EPS * ((count + 8) * rises.sum() + 2 * base * np.abs(slopes).max())
    for k in {0, 1, count // 2, count - 1}:
        assert abs(points[k].imag - due[k]) <= bound
    assert abs(last.imag - due[-1]) <= bound


@pytest.mark.parametrize("count", [12, 360, 20000])
def test_an_integral_that_should_close_closes(count: int) -> None:
    """Rises that cancel: what is left at the end is rounding, not a slope of the whole graph."""
    slopes = 3.0 * np.sin(2 * np.pi * np.arange(count) / count + 0.3)
    points, last = _added(slopes, 240.0)
    bound = EPS * (count + 8) * np.abs(slopes).sum() * 240.0 / count
    assert abs(last.imag) <= bound
    assert abs(points[-1].imag + slopes[-1] * 240.0 / count - last.imag) <= bound


# chords of an almost vertical curve


def _carried(rise: list[float], pole: float = 20.0) -> tuple[np.ndarray, tuple[Any, ...]]:
    """From a pole a ray parallel to the chord over 10 mm, carried to the axis of ordinates."""
    board = Board()
    board.open("a")
    origin, start, end = (board.take(Point, letter) for letter in "OAB")
    zero, distance = board.take(Angle, "0°"), board.take(Length, "H")
    along = board.draw(ray, "(Ox)", origin, zero)
    up = board.draw(square, "(Oy)", origin, along)
    at_pole = board.draw(lay_off, "P", board.draw(square, "(OP)", origin, up), distance)
    chord = board.draw(join, "(AB)", start, end)
    made = board.draw(meet, "a", up, board.draw(parallel, "(P)", at_pole, chord))
    given: dict[Any, Any] = {origin: 0j, zero: 0.0, distance: pole, start: 3 + 1j}
    given[end] = np.array([[13 + 1j + 1j * r for r in rise]])
    log = board.construction()
    return execute(log, given, [made])[made][0], examine(log, given, [made])


def test_chords_of_an_almost_vertical_curve() -> None:
    """The ordinate is right within the condition of the crossing; where that is too much, it is told."""
    rises = [sign * 10.0**k for k in range(0, 18, 2) for sign in (1, -1)]
    found, told = _carried(rises)
    doubtful = {k for f in told if f.kind == "doubtful" for k in f.positions}
    undrawn = {k for f in told if f.kind == "undrawn" for k in f.positions}
    for k, rise in enumerate(rises):
        end = complex(13, 1 + rise)
        slope = (end.imag - 1) / (end.real - 3)
        kappa = np.hypot(1.0, slope)
        if not np.isfinite(found[k]):
            assert k in undrawn
            assert kappa * 4 * EPS >= 0.5
            continue
        assert abs(found[k].imag - 20.0 * slope) <= 16 * EPS * kappa * abs(20.0 * slope)
        assert (k in doubtful) == (kappa > 1e8)


def test_a_vertical_chord_has_no_slope_and_is_named() -> None:
    board = Board()
    board.open("S")
    start, end = board.take(Point, "A"), board.take(Point, "B")
    chord = board.draw(join, "(AB)", start, end)
    given = {start: 1 + 1j, end: np.array([[1 + 9j, 1 + 1j, 4 + 5j]])}
    (finding,) = examine(board.construction(), given, [chord])
    assert finding.positions == (1,)
    way = execute(board.construction(), given, [chord])[chord].along
    assert way[0, 0] == 1j
    assert abs(way[0, 2] - 0.6 - 0.8j) <= EPS


def test_a_succession_of_a_vertical_ray_is_missing_and_leaves_its_trial_only() -> None:
    rays = Line(np.zeros((2, 1), complex), np.array([[1 + 0j, 1j, 1], [1, 0.6 + 0.8j, 1]]))
    feet, end = np.array([[0j, 1, 2]]), np.array([[3 + 0j]])
    with np.errstate(all="ignore"):
        last = arrival.run(np.zeros((2, 1), complex), rays, feet, end, row=3)
    assert np.isnan(last[0, 0])
    assert abs(last[1, 0] - (3 + 4j / 3)) <= 4 * EPS


# few points


@pytest.mark.parametrize("row", [1, 2, 3, 4])
def test_curves_through_a_few_points_do_not_break(row: int) -> None:
    points = np.array([[0j, 1 + 2j, 2 - 1j, 3 + 1j]])[:, :row]
    over, end = np.array([[float(row)]]), np.array([[row + 0.5j]])
    with np.errstate(all="ignore"):
        made = [
            french_curve.run(points, row=row),
            taut_curve.run(points, row=row),
            closed_graph.run(points, over, row=row),
            open_graph.run(points, end, row=row),
        ]
        if row > 1:
            made.append(open_graph_of_middles.run(points, row=row))
        for curve in made[2:4]:
            at = erect.run(curve, points)
            assert at.shape == points.shape
            there = np.isfinite(at)
            np.testing.assert_allclose(at[there], points[there], atol=1e-12)
    for curve in made:
        assert all(part.shape[0] == 1 for part in arrays(curve) if isinstance(part, np.ndarray))


def test_a_closed_curve_of_a_steep_graph_keeps_its_points() -> None:
    n = 24
    y = 1e8 * np.sign(np.sin(2 * np.pi * (np.arange(n) + 0.5) / n))
    points = (np.arange(n) * 10.0 + 1j * y)[None, :]
    curve = closed_graph.run(points, np.array([[240.0]]), row=n)
    np.testing.assert_allclose(erect.run(curve, points), points, rtol=4 * EPS)
