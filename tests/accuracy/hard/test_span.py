"""What a drive is walked through: round ends and steps, whatever its size."""

from __future__ import annotations

import numpy as np
import pytest
from support.digits_left import scene_of
from support.hard_mechanisms import slider_crank, weighed

from graphic_tmm.accuracy.hard.span import Coordinates, Span, span_of
from graphic_tmm.accuracy.hard.walk import walk
from graphic_tmm.mechanism.records import TURN, Sweep

ROD = Sweep("l", "m", 0.0, 2.0, False, "l_GN")


def _between(low: float, high: float, sweep: Sweep = ROD) -> Span:
    """The span of what reaches from one length to another, m."""

    def there(span: Span) -> np.ndarray:
        return np.asarray((1e3 * low <= span.tried) & (span.tried <= 1e3 * high))

    return span_of(sweep, 0.0, np.array([(low + high) / 2.0]), there)


def test_a_turn_is_walked_from_0_to_360_degrees() -> None:
    span = span_of(TURN, 360.0, np.zeros(1), lambda span: np.ones(span.tried.size, bool))
    assert (span.low, span.high, span.cell, span.offs[0], span.offs[-1]) == (0, 360, 5, 10, 1e-9)
    assert span.even.tolist() == [2.5 * k for k in range(144)]
    assert span.apart(359.0, 2.0) == pytest.approx(3.0)
    assert float(span.off(np.asarray(1.0), 359.5)) == pytest.approx(1.5)


def test_two_turns_have_the_hard_places_of_one() -> None:
    span = span_of(TURN, -720.0, np.zeros(1), lambda span: np.ones(span.tried.size, bool))
    assert (span.high, span.once, span.cell) == (720.0, 360.0, 5.0)
    assert span.tried[-1] < 361.0


def test_a_turn_that_does_not_end_where_it_began_goes_from_its_beginning() -> None:
    sweep = Sweep("φ", "°", -421.7, -61.7, False)
    span = span_of(sweep, 360.0, np.array([-421.7]), lambda span: np.ones(span.tried.size, bool))
    assert (span.low, span.high, span.period) == (-425.0, -60.0, 0.0)
    assert span.apart(-424.0, -64.0) == 360.0


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1.0, 1e3])
def test_lengths_are_walked_a_little_beyond_their_reach_in_round_steps(size: float) -> None:
    sweep = Sweep("l", "m", 0.0, 2.0 * size, False)
    span = _between(0.5 * size, 0.84 * size, sweep)
    assert span.low == pytest.approx(495.0 * size)
    assert span.high == pytest.approx(845.0 * size)
    assert span.cell == pytest.approx(5.0 * size)
    assert span.offs[:2] == pytest.approx((10.0 * size, 1.0 * size))
    assert span.even[1] - span.even[0] == pytest.approx(2.5 * size)


def test_what_is_apart_is_never_less_than_nothing() -> None:
    assert _between(0.002, 0.9).low == 0.0
    assert _between(-0.3, 0.9, Sweep("s", "m", -1.0, 1.0, False)).low < -300.0


def test_the_row_of_the_scene_is_walked_wherever_the_rest_ends() -> None:
    def nowhere(span: Span) -> np.ndarray:
        return np.zeros(span.tried.size, bool)

    row: Coordinates = np.array([-0.02, 0.09])
    span = span_of(Sweep("s", "m", 0.0, 0.25, False), 0.0, row, nowhere)
    assert span.low < -20.0
    assert span.high > 90.0


def test_coordinates_are_told_with_letter_and_unit() -> None:
    turn = walk(scene_of(weighed(slider_crank(0.1, 0.3)))).span
    assert turn.at(turn.value(12.5, "ru")) == "φ = 12,5°".replace(" ", "\N{NO-BREAK SPACE}")
    rod = _between(0.5, 0.84)
    assert rod.at(rod.value(612.5, "ru")) == "l_GN = 612,5 мм".replace(" ", "\N{NO-BREAK SPACE}")
