"""Figures by their own bounds: noughts, digits, what is not there; on boards of a few steps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import product, rate
from graphic_tmm.board.operations.graphs import erect
from graphic_tmm.board.operations.instruments import (
    cut,
    join,
    lay_off,
    measure,
    meet,
    parallel,
    ray,
    strike,
)
from graphic_tmm.board.operations.statics import difference_of
from graphic_tmm.board.record import Board, Mark
from graphic_tmm.board.shaking import SHAKE
from graphic_tmm.board.values import Angle, Curve, Length, Number, Point, Side


class Bench:
    """A board with marks given, and what is found of it."""

    def __init__(self) -> None:
        self.board = Board()
        self.given: dict[Mark, Any] = {}
        self.board.open("plan")

    def take(self, kind: Any, letter: str, value: Any) -> Mark:
        mark = self.board.take(kind, letter)
        self.given[mark] = np.atleast_2d(value)
        return mark

    def figure(self, mark: Mark) -> Any:
        log = self.board.construction()
        reading = execute(log, self.given).doubted(Doubts(log.steps, self.given))
        return reading.figure(mark)[0]


def _crossing(bench: Bench, angles: list[float]) -> Mark:
    """Where a line through the origin meets one that begins 1 mm above it, at small angles (degrees)."""
    base = bench.board.draw(ray, "m", bench.take(Point, "O", 0j), bench.take(Angle, "α", 30.0))
    start = bench.take(Point, "Q", 1j * np.exp(1j * np.pi / 6))
    other = bench.board.draw(ray, "n", start, bench.take(Angle, "β", 30.0 - np.array(angles)))
    return bench.board.draw(meet, "b", base, other)


def test_a_figure_keeps_the_digits_that_are_sure_and_no_others() -> None:
    """At an angle β the lines meet cot β away; both directions are known to a shake, so is that but by 1/β."""
    bench, offs = Bench(), [10.0, 1e-3, 1e-6, 1e-9, 1e-10, 1e-13]
    point = _crossing(bench, offs)
    origin = next(mark for mark in bench.given if mark.letter == "O")
    found = bench.figure(bench.board.draw(measure, "Ob", origin, point))
    for value, off in zip(found, offs, strict=True):
        beta = np.radians(30.0 - (30.0 - off))
        share = SHAKE / beta
        if share > 0.2:
            assert np.isnan(value)
            continue
        due = 1.0 / np.tan(beta)
        assert abs(value - due) <= 4.0 * share * due
        if share > 1e-9:
            # the last digit that is written is unsure, the one before it is not
            assert len(f"{value:.12e}".split("e")[0].rstrip("0")) - 1 <= 2 - np.log10(share)


@pytest.mark.parametrize("share", [1e-3, 1e-7, 1e-10, 1e-12])
def test_what_nobody_could_read_beside_its_plan_is_nothing(share: float) -> None:
    """Every digit told of a difference is sure; one too small beside what it is made of is 0.

    A small figure that is given, and what is computed from it alone, is as large as it should be.
    """
    bench = Bench()
    unit = bench.take(Number, "i", 1.0)
    one = bench.board.draw(product, "a", bench.take(Number, "j", 1.0), unit)
    more = bench.board.draw(product, "b", bench.take(Number, "k", 1.0 + share), unit)
    small = bench.take(Number, "c", share)
    rest = bench.board.draw(difference_of, "d", more, one)
    times = bench.board.draw(product, "e", rest, one)
    own = bench.board.draw(product, "f", small, one)
    told = share if share > 1e-9 else 0.0
    for mark in (rest, times):
        assert bench.figure(mark)[0] == pytest.approx(told, rel=2e-3, abs=0.0)
    assert bench.figure(own)[0] == pytest.approx(share, rel=1e-9)


@pytest.mark.parametrize("share", [1e-8, 1e-10])
def test_a_length_is_nothing_beside_what_is_drawn_of_its_plan(share: float) -> None:
    bench = Bench()
    origin = bench.take(Point, "O", 0j)
    short = bench.take(Point, "A", [100.0, share * 100.0])
    bench.board.draw(measure, "OB", origin, bench.take(Point, "B", 100j))
    whole, found = bench.figure(bench.board.draw(measure, "OA", origin, short))
    assert whole == 100.0
    assert found == pytest.approx(share * 100.0 if share > 1e-9 else 0.0, abs=0.0)


def test_a_length_that_does_not_vary_stays_one_figure_on_a_plan_that_does() -> None:
    bench = Bench()
    origin = bench.take(Point, "O", 0j)
    fixed = bench.board.draw(measure, "OA", origin, bench.take(Point, "A", 3.0 + 4.0j))
    line = bench.board.draw(ray, "m", origin, bench.take(Angle, "α", [10.0, 20.0, 30.0]))
    bench.board.draw(lay_off, "B", line, fixed)
    assert bench.figure(fixed).tolist() == [5.0]


def test_the_difference_of_equals_is_nothing() -> None:
    bench = Bench()
    third = bench.take(Number, "a", [0.1, 1.0, 1e300])
    three = bench.take(Number, "b", 3.0)
    whole = bench.board.draw(product, "c", third, three)
    other = bench.board.draw(added, "d", bench.board.draw(added, "e", third, third), third)
    assert (bench.figure(bench.board.draw(difference_of, "f", whole, other)) == 0.0).all()


@pytest.mark.parametrize("rest", [1e-2, 1e-6, 1e-8])
def test_a_small_difference_that_stands_out_of_rounding_is_itself(rest: float) -> None:
    bench = Bench()
    one = bench.board.draw(
        product, "c", bench.take(Number, "a", 1.0 + rest), bench.take(Number, "i", 1.0)
    )
    two = bench.board.draw(product, "d", bench.take(Number, "b", 1.0), bench.take(Number, "j", 1.0))
    (found,) = bench.figure(bench.board.draw(difference_of, "f", one, two))
    assert found == pytest.approx(rest, rel=4 * SHAKE / rest + 1e-12)


def test_each_position_is_judged_by_itself() -> None:
    """A position at which all is 10¹⁵ times as large takes nothing from its neighbour."""
    bench = Bench()
    line = bench.board.draw(
        join, "m", bench.take(Point, "A", 0j), bench.take(Point, "B", [1 + 1j, 1e15 * (1 + 1j)])
    )
    end = bench.board.draw(lay_off, "c", line, bench.take(Length, "l", [0.25, 7e14]))
    start = next(mark for mark in bench.given if mark.letter == "A")
    found = bench.figure(bench.board.draw(measure, "Ac", start, end))
    assert found == pytest.approx([0.25, 7e14], rel=1e-12)


def test_a_rate_of_nothing_is_nothing_and_one_of_noise_is_not_known() -> None:
    """0 over a length is 0; what rounding made of two points, over no length, is neither."""
    bench = Bench()
    a = bench.take(Point, "A", 100.0 + 0j)
    b = bench.board.draw(
        lay_off,
        "B",
        bench.board.draw(join, "m", a, bench.take(Point, "Q", 0j)),
        bench.take(Length, "l", [100.0 / 3.0 * 3.0, 50.0]),
    )
    origin = next(mark for mark in bench.given if mark.letter == "Q")
    left = bench.board.draw(measure, "QB", origin, b)
    one = bench.take(Number, "μ", 1.0)
    slow = bench.board.draw(rate, "ω", left, one, bench.take(Length, "r", 10.0), one)
    wild = bench.board.draw(rate, "ν", left, one, left, one)
    assert bench.figure(slow).tolist() == [0.0, 5.0]
    found = bench.figure(wild)
    assert np.isnan(found[0])
    assert found[1] == 1.0


def test_a_figure_read_off_a_curve_that_is_given_is_doubted_as_others_are() -> None:
    """An open parabola x, x²/10 with its tangents: a cubic piece is the parabola itself."""
    bench, x = Bench(), np.arange(5.0)
    curve = bench.board.take(Curve, "y")
    bench.given[curve] = Curve((x + 0.1j * x**2)[None, :], (1 + 0.2j * x)[None, :], False)
    foot = bench.take(Point, "x", [0.5, 1.5, 2.5])
    end = bench.board.draw(erect, "e", curve, foot)
    found = bench.figure(bench.board.draw(measure, "xe", foot, end))
    np.testing.assert_allclose(found, 0.1 * np.array([0.5, 1.5, 2.5]) ** 2, rtol=1e-9)


@pytest.mark.parametrize("touching", [slice(0, 5), slice(1500, 1505)])
def test_bounds_of_many_positions_are_those_of_each(touching: slice) -> None:
    """A line of one direction, through points of which some touch: also where few of its row do."""
    radii = np.full(3000, 2.0)
    radii[touching] = 1.0

    def bounds(radii: np.ndarray) -> np.ndarray:
        bench = Bench()
        line = bench.board.draw(
            ray, "m", bench.take(Point, "Q", -3 + 1j), bench.take(Angle, "α", 0.0)
        )
        arc = bench.board.draw(
            strike, "c", bench.take(Point, "O", 0j), bench.take(Length, "r", radii)
        )
        point = bench.board.draw(cut, "B", line, arc, bench.take(Side, "s", 1))
        bench.board.open("velocities")
        at = bench.board.draw(parallel, "n", point, line)
        log = bench.board.construction()
        found = Doubts(log.steps, bench.given).bound(at)
        return np.broadcast_to(found, (1, radii.size))[0]

    found = bounds(radii)
    assert found[touching].tolist() == bounds(radii[touching]).tolist()
