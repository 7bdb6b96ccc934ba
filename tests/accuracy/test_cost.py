"""Work counted off the log: by hand, against a walk over positions, additive, sliced, with its errors."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from support.gallery import ALL, NAMES
from support.logs import FourBar, logs, sizes

from graphic_tmm.accuracy.cost import (
    MINUTES,
    NOTHING,
    BoardWork,
    count,
    done,
    repeated,
    varying,
)
from graphic_tmm.accuracy.geometrography import ELEMENTARY, elements, symbol
from graphic_tmm.board.execute import execute, needed
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.graph_curves import open_graph
from graphic_tmm.board.operations.graphs import following, succession
from graphic_tmm.board.operations.instruments import join, lay_off, measure, parallel, ray, strike
from graphic_tmm.board.operations.supports import planimeter
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Angle, Curve, Length, Line, Point, arrays
from graphic_tmm.chapters.cam.operations import smooth_stretch
from graphic_tmm.errors import ConstructionError


@pytest.mark.parametrize("name", ALL)
def test_a_step_is_repeated_where_its_value_has_all_positions(name: str) -> None:
    for log, given in logs(name):
        again = repeated(log, varying(given))
        count = execute(log, given).positions
        for mark, size in sizes(log, given):
            assert size in (1, count)
            assert (size > 1) == (mark.slot in again), (mark.view, mark.letter)


@pytest.mark.slow
def test_steps_across_positions_leave_one_mark_or_one_for_each_position() -> None:
    seen = set()
    for name in ALL:
        for log, given in logs(name):
            reading = execute(log, given)
            for step in log.steps:
                if step.op.across and step.op.leaves is not Curve:
                    size = max(part.shape[1] for part in arrays(reading[step.it]))
                    assert size == (reading.positions if step.op.everywhere else 1), step.op
                    seen.add(step.op.name)
    assert seen >= {"following", "succession", "next_satellite"}


def test_some_scene_has_many_steps_of_either_sort() -> None:
    ((log, given),) = logs("windrower")
    again = repeated(log, varying(given))
    pointwise = [step for step in log.steps if not step.op.across]
    assert 30 < len(again) < len(pointwise) - 30


@pytest.mark.parametrize("name", ALL)
def test_what_does_not_vary_has_the_same_value_at_all_positions(name: str) -> None:
    """Run at each position alone: a step that is drawn once leaves the same there, to the bit."""
    for log, given in logs(name):
        if any(step.op.across for step in log.steps):
            continue
        again = repeated(log, varying(given))
        marks = [step.it for step in log.steps if step.it.slot not in again]
        alone = [execute(log, given, marks, positions=[k]) for k in range(3)]
        for mark in marks:
            for part, other in zip(arrays(alone[0][mark]), arrays(alone[-1][mark]), strict=True):
                np.testing.assert_array_equal(part, other)


class Small:
    """A crank, the line through its pin parallel to a fixed one, and one parallel to that through the pivot."""

    def __init__(self) -> None:
        board = Board()
        board.open("positions")
        self.o, self.c = board.take(Point, "O"), board.take(Point, "C")
        self.phi, self.r = board.take(Angle, "φ"), board.take(Length, "r")
        self.frame = board.draw(join, "(OC)", self.o, self.c)
        self.crank = board.draw(ray, "(OA)", self.o, self.phi)
        self.a = board.draw(lay_off, "A", self.crank, self.r)
        self.arc = board.draw(strike, "(O)", self.o, self.r)
        self.moving = board.draw(parallel, "(A)", self.a, self.frame)
        self.fixed = board.draw(parallel, "(O′)", self.o, self.moving)
        self.next = board.draw(following, "A′", self.a, self.o, row=2)
        self.length = board.draw(measure, "AA′", self.a, self.next)
        self.log = board.construction()


def test_a_parallel_of_a_line_that_moves_without_turning_is_drawn_once() -> None:
    small = Small()
    again = repeated(small.log, [small.phi])
    for mark in (small.crank, small.a, small.moving, small.length):
        assert mark.slot in again
    for mark in (small.frame, small.arc, small.fixed):
        assert mark.slot not in again


def test_steps_across_positions_are_repeated_by_nobody() -> None:
    small = Small()
    assert small.next.slot not in repeated(small.log, [small.phi])
    # but what they leave has a place at each position
    assert small.length.slot in repeated(small.log, [])


def test_if_nothing_varies_all_else_is_drawn_once_and_more_repeats_more() -> None:
    small = Small()
    assert repeated(small.log, []) == {small.length.slot}
    some, more = (repeated(small.log, v) for v in ([small.phi], [small.phi, small.r]))
    assert some < more
    assert small.arc.slot in more


def test_what_varies_is_what_has_a_row_of_positions() -> None:
    marks = Small()
    given = {
        marks.o: 0j,
        marks.c: np.ones((5, 1)),
        marks.phi: np.ones((1, 12)),
        marks.r: [[1.0, 2.0]],
    }
    assert varying(given) == {marks.phi, marks.r}
    assert varying({marks.phi: np.arange(3.0)}) == {marks.phi}
    assert varying({}) == frozenset()


def test_a_mark_of_another_board_is_refused() -> None:
    small = Small()
    with pytest.raises(ConstructionError, match="'A' is not given on this board"):
        repeated(small.log, [small.phi, small.a])


def test_a_four_bar_is_what_one_counts_on_the_fingers() -> None:
    bar = FourBar()
    work = count(bar.log, [bar.phi], positions=12)
    # ray 12(P1 + P2 + 2R1 + R2), pin 12(M1 + R1 + M2), arcs 13(3C1 + C3), reading 12(M1 + R1 + M3)
    assert work.elements == {
        **dict.fromkeys(("P1", "P2", "R2", "M2", "M3"), 12),
        **{"R1": 48, "M1": 24, "C1": 39, "C3": 13},
    }
    assert work.operations == {"ray": 12, "lay_off": 12, "strike": 13, "cross": 12, "measure": 12}
    assert work.simplicity == 12 * (5 + 3 + 4 + 3) + 4
    assert work.exactitude == 12 * (3 + 2 + 3 + 2) + 3
    assert work.symbol == ("48R1 + 12R2 + 39C1 + 13C3 + 24M1 + 12M2 + 12M3 + 12P1 + 12P2")
    assert work.minutes == pytest.approx(sum(n * MINUTES[e] for e, n in work.elements.items()))
    assert work.untold == ()


def test_only_what_the_wanted_marks_need_is_counted() -> None:
    bar = FourBar()
    pin = count(bar.log, [bar.phi], [bar.a], positions=12)
    assert pin.operations == {"ray": 12, "lay_off": 12}
    assert count(bar.log, [bar.phi], [bar.around_c], positions=12).operations == {"strike": 1}
    assert count(bar.log, [bar.phi], [], positions=12) == NOTHING
    assert count(bar.log, [bar.phi], [bar.phi], positions=12) == NOTHING


def test_if_nothing_varies_all_is_drawn_once() -> None:
    bar = FourBar()
    assert count(bar.log, [], positions=500) == count(bar.log, [bar.phi], positions=1)


def walked(log: Construction, given: Mapping[Mark, object]) -> Counter[str]:
    """Count operations as execution shows them: once for each position that a value has."""
    found = Counter(step.op.name for step in log.steps if step.op.across)
    many = dict(sizes(log, given))
    for step in log.steps:
        if step.it in many:
            found[step.op.name] += many[step.it]
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", [*NAMES, "cam", "gear-pair", "planetary"])
def test_operations_are_as_many_as_execution_leaves_numbers(name: str) -> None:
    for log, given in logs(name):
        positions = execute(log, given).positions
        work = count(log, varying(given), positions=positions)
        assert work.operations == walked(log, given)
        assert 0 < work.exactitude < work.simplicity
        assert work.minutes == pytest.approx(sum(n * MINUTES[e] for e, n in work.elements.items()))


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_work_grows_by_the_same_with_every_position(name: str) -> None:
    log, given = logs(name)[0]
    one, two, many = (count(log, varying(given), positions=n).simplicity for n in (1, 2, 100))
    assert two > one
    assert many - one == 99 * (two - one)


@pytest.mark.parametrize("name", NAMES)
def test_the_work_of_all_is_that_of_the_steps_together(name: str) -> None:
    log, given = logs(name)[0]
    every = done(log, varying(given), positions=7)
    assert [one.step for one in every] == list(log.steps)
    found: Counter[str] = Counter()
    for step, times, row in every:
        for element, n in elements(symbol(step.op), row).items():
            found[element] += n * times
    assert found == count(log, varying(given), positions=7).elements


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_costs_what_its_own_steps_add(name: str) -> None:
    log, given = logs(name)[0]
    varies = varying(given)
    before: list[Mark] = []
    last = NOTHING
    for view in dict.fromkeys(step.it.view for step in log.steps):
        before += [step.it for step in log.steps if step.it.view == view]
        work = count(log, varies, before, positions=12)
        slots = {step.it.slot for step in needed(log, before)}
        added = sum(
            one.times for one in done(log, varies, positions=12) if one.step.it.slot in slots
        )
        assert sum(work.operations.values()) == added
        assert work.simplicity >= last.simplicity
        last = work
    assert last == count(log, varies, positions=12)


@pytest.mark.slow
def test_a_view_drawn_at_three_positions_costs_three_of_it() -> None:
    ((log, given),) = logs("windrower")
    varies = varying(given)
    full = count(log, varies, positions=13)
    few = count(log, varies, positions=13, only={"accelerations": 3})
    own = [s.it for s in log.steps if s.it.view == "accelerations"]
    kept = {s.it.slot for s in log.steps} - {mark.slot for mark in own}
    others = sum(one.times for one in done(log, varies, positions=13) if one.step.it.slot in kept)
    again = [one for one in done(log, varies, positions=3) if one.step.it.slot not in kept]
    assert sum(few.operations.values()) == others + sum(one.times for one in again)
    assert few.minutes < full.minutes


def rows(*, row: int, first: int, last: int) -> tuple[Construction, dict[str, Mark], Mark]:
    board = Board()
    board.open("diagram")
    foot, end, start = (board.take(Point, name) for name in ("x", "x_{n}", "s"))
    height = board.take(Length, "y")
    base = board.take(Line, "(x)")
    rays = board.draw(parallel, "(y)", foot, base)
    point = board.draw(lay_off, "S", rays, height)
    marks = {
        "french_curve": board.draw(french_curve, "(1)", point, row=row),
        "open_graph": board.draw(open_graph, "(2)", point, end, row=row),
        "smooth_stretch": board.draw(smooth_stretch, "(3)", point, first=first, last=last),
        "succession": board.draw(succession, "σ", start, rays, foot, end, row=row),
    }
    marks["planimeter"] = board.draw(planimeter, "Ω", marks["french_curve"])
    return board.construction(), marks, foot


@pytest.mark.parametrize(
    ("name", "due"),
    [
        ("french_curve", {"K1": 9, "K2": 9}),
        ("open_graph", {"K1": 10, "K2": 10}),
        ("smooth_stretch", {"K1": 4, "K2": 4}),
        ("succession", {"E1": 9, "E2": 9, "R2": 9}),
        ("planimeter", {"A1": 1, "A2": 1}),
    ],
)
def test_a_step_across_positions_is_done_once_and_goes_through_its_row(
    name: str, due: dict[str, int]
) -> None:
    log, marks, foot = rows(row=9, first=2, last=5)
    (one,) = [o for o in done(log, [foot], positions=11) if o.step.it == marks[name]]
    assert one.times == 1
    assert elements(symbol(one.step.op), one.row) == due


def test_minutes_are_the_users_own_where_given() -> None:
    bar = FourBar()
    plain = count(bar.log, [bar.phi], positions=12)
    slow = count(bar.log, [bar.phi], positions=12, minutes={"C1": 10.0})
    assert slow.minutes - plain.minutes == pytest.approx(39 * (10.0 - MINUTES["C1"]))
    assert (slow.elements, slow.operations) == (plain.elements, plain.operations)
    assert count(bar.log, [], minutes=dict.fromkeys(ELEMENTARY, 0.0)).minutes == 0.0


def test_works_are_added_and_multiplied() -> None:
    bar = FourBar()
    work = count(bar.log, [bar.phi], positions=3)
    assert (work + NOTHING, NOTHING + work) == (work, work)
    thrice, added = work * 3, work + work + work
    assert (thrice.elements, thrice.operations) == (added.elements, added.operations)
    assert thrice.minutes == pytest.approx(added.minutes)
    assert (work + work).simplicity == 2 * work.simplicity
    mark = bar.phi
    left, right = BoardWork({}, {}, 0.0, (mark,)), BoardWork({}, {}, 0.0, (mark, bar.a))
    assert (left + right).untold == (mark, bar.a)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"positions": 0}, "positions: at least one position, not 0"),
        ({"only": {"positions": -1}}, "positions: at least one position, not -1"),
        ({"only": {"velocities": 3}}, "no view velocities; there are positions"),
        ({"minutes": {"Q7": 1.0}}, "no elementary operation Q7"),
        ({"minutes": {"R1": -1.0}}, "R1 cannot take -1.0 minutes"),
        ({"minutes": {"R1": math.nan}}, "R1 cannot take nan minutes"),
    ],
)
def test_what_makes_no_sense_is_refused(wrong: dict[str, Any], said: str) -> None:
    bar = FourBar()
    with pytest.raises(ConstructionError, match=said):
        count(bar.log, [bar.phi], **wrong)
