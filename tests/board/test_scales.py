"""The ruler, the scales, and the narrowing down of an angle."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.examples import most

from graphic_tmm.board.execute import execute
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.operations.locus import narrow, refinement
from graphic_tmm.board.record import Board
from graphic_tmm.board.scales import (
    ENLARGEMENTS,
    LENGTHS,
    REDUCTIONS,
    Scale,
    standard,
    standard_length,
)
from graphic_tmm.board.values import Angle

# ---------------------------------------------------------------- the ruler


def test_a_tie_goes_to_the_longer_length_on_both_sides() -> None:
    """0.05, 0.15 ... : the nearest floats lie on either side of the tie, the reading does not care."""
    tenth = np.arange(3000)
    for sign in (1, -1):
        tie = sign * (tenth / 10 + 0.05)
        around = [np.nextafter(tie, 0), tie, np.nextafter(tie, 9e9 * sign), tie * (1 + 1e-13)]
        due = np.broadcast_to(sign * (tenth + 1) / 10, (4, tenth.size))
        np.testing.assert_allclose(Hand(0.1).read(np.array(around)), due, rtol=1e-15)


def test_below_half_a_division_nothing_is_read() -> None:
    read = Hand(0.5).read(np.array([[0.2, -0.2, 0.0, -0.0, 0.26, -0.26, np.nan]]))
    np.testing.assert_array_equal(read, [[0.0, 0.0, 0.0, 0.0, 0.5, -0.5, np.nan]])
    assert not np.signbit(read[0, :4]).any()


@pytest.mark.slow
@settings(max_examples=most(200), deadline=None)
@given(st.floats(-1e4, 1e4), st.sampled_from([0.1, 0.25, 0.5, 1.0, 0.01]))
def test_a_reading_is_the_nearest_division(length: float, ruler: float) -> None:
    hand = Hand(ruler)
    read = float(hand.read(np.array([[length]]))[0, 0])
    assert abs(read - length) <= ruler * (0.5 + 1e-8)
    assert math.isclose(read / ruler, round(read / ruler), abs_tol=1e-9)
    assert float(hand.read(np.array([[read]]))[0, 0]) == read
    assert float(hand.read(np.array([[-length]]))[0, 0]) == -read


def test_the_exact_hand_rounds_nothing() -> None:
    lengths = np.array([[0.12345, np.pi]])
    assert EXACT.read(lengths) is lengths


# ---------------------------------------------------------------- scales


def test_the_scales_are_those_of_the_standard() -> None:
    ratios = {"1:2", "1:2.5", "1:4", "1:5", "1:10", "1:15", "1:20", "1:25", "1:40", "1:50", "1:75"}
    ratios |= {"1:100", "1:200", "1:400", "1:500", "1:800", "1:1000", "1:1"}
    ratios |= {"2:1", "2.5:1", "4:1", "5:1", "10:1", "20:1", "40:1", "50:1", "100:1"}
    made = {f"1:{n:g}" for n in REDUCTIONS} | {f"{n:g}:1" for n in ENLARGEMENTS} | {"1:1"}
    assert made == ratios
    assert list(LENGTHS) == sorted(set(LENGTHS))
    assert len(LENGTHS) == len(ratios)


@pytest.mark.parametrize(
    ("largest", "room", "due"),
    [
        (0.9, 250, 0.004),
        (1.0, 250, 0.004),
        (1.0000001, 250, 0.005),
        (0.25, 250, 0.001),
        (0.1, 250, 0.0004),
        (3.0, 250, 0.015),
        (1.0, 1e6, 1e-6),
        (0.0026, 260, 1e-5),
        (300.0, 250, 1.5),
        (380.0, 250, 2.0),
    ],
)
def test_a_standard_scale_of_lengths(largest: float, room: float, due: float) -> None:
    assert math.isclose(standard_length(largest, room), due, rel_tol=1e-12)


@pytest.mark.slow
@settings(max_examples=most(200), deadline=None)
@given(st.floats(1e-9, 1e9), st.floats(10.0, 500.0))
def test_a_standard_scale_fits_and_the_next_finer_does_not(largest: float, room: float) -> None:
    mu = standard(largest, room)
    digits, power = f"{mu:e}".split("e")
    assert float(digits) in (1.0, 1.5, 2.0, 2.5, 4.0, 5.0, 7.5)
    assert largest / mu <= room * (1 + 1e-11)
    finer = max(
        float(f"{m}e{d}")
        for m in (1, 1.5, 2, 2.5, 4, 5, 7.5)
        for d in (int(power), int(power) - 1)
        if float(f"{m}e{d}") < mu * (1 - 1e-9)
    )
    assert largest / finer > room
    longest = standard_length(largest, room)
    assert largest / longest <= room * (1 + 1e-11)


@pytest.mark.parametrize("largest", [0.0, -1.0, math.nan, math.inf])
def test_nothing_to_scale_takes_one(largest: float) -> None:
    assert standard(largest, 100.0) == 1.0
    assert standard_length(largest, 100.0) == 1.0


@settings(max_examples=most(100), deadline=None)
@given(st.floats(-1e6, 1e6), st.sampled_from(LENGTHS))
def test_there_and_back_through_the_door(quantity: float, mu: float) -> None:
    scale = Scale("μ_l", mu, "m/mm")
    assert math.isclose(scale.to_board(quantity) * scale.value, quantity, rel_tol=1e-15, abs_tol=0)


# ---------------------------------------------------------------- narrowing


def _span(low: Any, high: Any) -> tuple[Any, Any]:
    return np.atleast_2d(np.asarray(low, float)).T, np.atleast_2d(np.asarray(high, float)).T


@pytest.mark.slow
@settings(max_examples=most(200), deadline=None)
@given(st.floats(-360, 360), st.floats(1e-3, 90), st.floats(1e-3, 90), st.sampled_from([1, -1]))
def test_a_root_is_found_to_its_last_bit(root: float, left: float, right: float, sign: int) -> None:
    low, high = _span(root - left, root + right)
    found = narrow(lambda x: sign * (x - root), low, high)
    assert found.shape == (1, 1)
    size = max(abs(low[0, 0]), abs(high[0, 0]))
    assert abs(found[0, 0] - root) <= 2 * np.spacing(size)


def test_the_zero_of_a_cosine() -> None:
    found = narrow(lambda x: np.cos(np.radians(x)), *_span(30.0, 100.0))
    assert abs(found[0, 0] - 90.0) <= np.spacing(90.0)


def test_trials_are_narrowed_side_by_side() -> None:
    """One root on a try of its own, one at an end, one in between, one that is none."""
    roots = np.array([[5.0], [10.0], [3.3], [77.0]])
    found = narrow(lambda x: x - roots, *_span([0.0] * 4, [10.0] * 4))
    np.testing.assert_allclose(found[:3], roots[:3], rtol=0, atol=1e-14)
    assert np.isnan(found[3, 0])
    alone = [narrow(lambda x, r=r: x - r, *_span(0.0, 10.0))[0, 0] for r in roots[:3, 0]]
    np.testing.assert_allclose(found[:3, 0], alone, rtol=0, atol=1e-14)


def test_a_value_that_cannot_be_drawn_counts_as_not_positive() -> None:
    found = narrow(lambda x: np.where(x > 2.0, 1.0, np.nan), *_span(0.0, 3.0))
    assert abs(found[0, 0] - 2.0) <= 1e-14


def test_refining_is_a_step_of_the_log() -> None:
    board = Board()
    board.open("extremes")
    low, high = board.take(Angle, "low"), board.take(Angle, "high")
    op = refinement(lambda x: x * x - 2.0, "between {low} and {high}")
    mark = board.draw(op, "φ", low, high)
    given_ = {low: np.array([[0.0], [3.0]]), high: np.array([[2.0], [4.0]])}
    found = execute(board.construction(), given_, [mark])[mark]
    assert abs(found[0, 0] - math.sqrt(2)) <= np.spacing(2.0)
    assert np.isnan(found[1, 0])
