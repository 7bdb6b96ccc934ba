"""What could not be drawn is named: the step, the gap, the positions, by how much."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from graphic_tmm.board.findings import examine, step_number
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    lay_off,
    meet,
    ray,
    rocker_line,
    strike,
    tangent,
)
from graphic_tmm.board.record import Board, Mark
from graphic_tmm.board.shaking import SHAKE
from graphic_tmm.board.values import Angle, Length, Number, Point, Side

Row = list[float] | float


class Bench:
    """A board for one step: earlier marks are taken, or made by a step of another view."""

    def __init__(self) -> None:
        self.board = Board()
        self.given: dict[Mark, Any] = {}
        self.board.open("positions")

    def take(self, kind: Any, letter: str, value: Any, unit: str = "") -> Mark:
        mark = self.board.take(kind, letter, unit)
        self.given[mark] = np.atleast_2d(value)
        return mark

    def line(self, letter: str, at: complex, degrees: Row) -> Mark:
        start = self.take(Point, f"{letter}0", at)
        return self.board.draw(ray, letter, start, self.take(Angle, f"∠{letter}", degrees))

    def arc(self, letter: str, at: complex, radius: Row) -> Mark:
        centre = self.take(Point, f"{letter}0", at)
        return self.board.draw(strike, letter, centre, self.take(Length, f"r{letter}", radius))

    def side(self, value: float = 1.0) -> Mark:
        return self.take(Side, "±", value)

    def draw(self, op: Operation, letter: str, *uses: Mark) -> Mark:
        self.board.open("velocities")
        return self.board.draw(op, letter, *uses)

    def examine(self, *wanted: Mark) -> Any:
        return examine(self.board.construction(), self.given, wanted)


@pytest.fixture
def bench() -> Bench:
    return Bench()


def test_parallel_lines_are_named_where_they_are(bench: Bench) -> None:
    m = bench.line("m", 0j, 30.0)
    n = bench.line("n", 1j, [10.0, 30.0, 210.0, 30.0 + 1e-5, -150.0])
    first = bench.draw(lay_off, "a", m, bench.take(Length, "l", 1.0))
    point = bench.draw(meet, "b", m, n)
    after = bench.draw(ray, "(b)", point, bench.take(Angle, "φ", 0.0))
    (finding,) = bench.examine(first, after)
    assert finding.kind == "undrawn"
    assert finding.step.it == point
    assert finding.number == 2
    assert finding.positions == (1, 2, 4)
    assert finding.step.op.fails == "the lines are parallel"
    assert finding.gap is None


def test_lines_that_hardly_meet_are_doubtful(bench: Bench) -> None:
    m, n = bench.line("m", 0j, 0.0), bench.line("n", 1j, [10.0, 1e-7, 1e-9])
    (finding,) = bench.examine(bench.draw(meet, "b", m, n))
    assert (finding.kind, finding.positions) == ("doubtful", (1, 2))
    # two lines turned by a shake each, and their beginnings moved
    assert SHAKE / 2 < finding.amount * np.radians(1e-9) < 8 * SHAKE


@pytest.mark.parametrize(
    ("radii", "gap", "short"),
    [([8.0, 3.0, 2.0, 10.0], 0, 3.0), ([8.0, 15.0, 17.0, 10.0], 1, 2.0)],
)
def test_arcs_that_do_not_meet_tell_which_way(
    bench: Bench, radii: list[float], gap: int, short: float
) -> None:
    """Ten apart; the other opening is 5: openings from 5 to 15 meet."""
    one, other = bench.arc("a", 0j, 5.0), bench.arc("c", 6 + 8j, radii)
    point = bench.draw(cross, "b", one, other, bench.side())
    found = {f.kind: f for f in bench.examine(point)}
    bad = tuple(i for i, r in enumerate(radii) if not 5 <= r <= 15)
    assert found["undrawn"].positions == bad
    assert found["undrawn"].gap is cross.gaps[gap]
    assert np.isclose(found["undrawn"].amount, short)
    assert found["undrawn"].gap.says.count("{first}") == 1
    if 15.0 in radii:
        assert found["touching"].positions == (1,)


def test_an_arc_that_only_touches_is_drawn_and_told(bench: Bench) -> None:
    line, arc = bench.line("m", -7 + 0j, 0.0), bench.arc("c", 2j, [3.0, 2.0, 1.5])
    found = bench.examine(bench.draw(cut, "b", line, arc, bench.side()))
    assert [(f.kind, f.positions) for f in found] == [("undrawn", (2,)), ("touching", (1,))]
    assert np.isclose(found[0].amount, 0.5)


def test_the_inside_of_a_circle_has_no_tangent(bench: Bench) -> None:
    at = bench.take(Point, "A", [3 + 0j, 0.5j])
    centre, radius = bench.take(Point, "C", 0j), bench.take(Length, "h", -1.0)
    (finding,) = bench.examine(bench.draw(tangent, "(A)", at, centre, radius, bench.side()))
    assert (finding.kind, finding.positions, finding.amount) == ("undrawn", (1,), 0.5)


def test_a_stone_over_its_pivot(bench: Bench) -> None:
    pivot, stone = bench.take(Point, "C", 1j), bench.take(Point, "A", [1.0, 1j])
    found = {f.kind: f for f in bench.examine(bench.draw(rocker_line, "(CA)", pivot, stone))}
    assert found["undrawn"].positions == (1,)


def test_only_the_step_that_failed_is_named(bench: Bench) -> None:
    """A step that was handed what is not there has done nothing wrong."""
    one, other = bench.arc("a", 0j, 1.0), bench.arc("c", 6 + 8j, [9.5, 1.0])
    b = bench.draw(cross, "b", one, other, bench.side())
    m = bench.draw(ray, "m", b, bench.take(Angle, "φ", 0.0))
    d = bench.draw(
        cut, "d", m, bench.draw(strike, "k", b, bench.take(Length, "l", 1.0)), bench.side()
    )
    curve = bench.board.draw(french_curve, "(d–d)", d, row=2)
    (finding,) = bench.examine(curve)
    assert (finding.step.it, finding.positions) == (b, (1,))


def test_dividing_by_nothing(bench: Bench) -> None:
    mu = bench.take(Number, "μ", [2.0, 0.0], "(m/s)/mm")
    (finding,) = bench.examine(bench.draw(to_board, "pa", bench.take(Number, "v", 1.0, "m/s"), mu))
    assert (finding.kind, finding.positions) == ("undrawn", (1,))


def test_all_is_well_says_nothing(bench: Bench) -> None:
    one, other = bench.arc("a", 0j, 5.0), bench.arc("c", 6 + 8j, [8.0, 9.0])
    b = bench.draw(cross, "b", one, other, bench.side())
    assert bench.examine(b) == ()
    assert bench.examine() == ()


def test_steps_are_numbered_within_their_view(bench: Bench) -> None:
    m, n = bench.line("m", 0j, 0.0), bench.line("n", 0j, 90.0)
    bench.draw(meet, "b", m, n)
    log = bench.board.construction()
    assert [step_number(log, step) for step in log.steps] == [1, 2, 1]
