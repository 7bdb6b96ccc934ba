"""Slices, blocks, subsets and strata: how a log is run never shows in its numbers."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest

from graphic_tmm.board.execute import execute, needed, prepare
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.hand import Hand
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.formulas import rate, to_board
from graphic_tmm.board.operations.instruments import (
    cross,
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    ray,
    square,
    strike,
)
from graphic_tmm.board.record import Board, Construction, Mark
from graphic_tmm.board.values import Angle, Arc, Length, Line, Number, Point, Side, arrays
from graphic_tmm.errors import ConstructionError


class Fourbar:
    """A four-bar: its log, its marks by letter, what is given on it, how often each step has run."""

    def __init__(self) -> None:
        self.board = Board()
        self.ran: Counter[str] = Counter()
        self.board.open("positions")
        self.marks: dict[str, Mark] = {}
        self.given: dict[Mark, Any] = {}
        for letter, kind, value in (
            ("O", Point, 0j),
            ("C", Point, 90 + 10j),
            ("φ", Angle, 0.0),
            ("OA", Length, 30.0),
            ("AB", Length, 80.0),
            ("CB", Length, 70.0),
            ("±", Side, 1.0),
            ("μ", Number, 0.002),
            ("never", Number, 1.0),
        ):
            unit = {"μ": "m/mm", "never": "m"}.get(letter, "")
            self.marks[letter] = self.board.take(kind, letter, unit)
            self.given[self.marks[letter]] = value
        for letter, op, *uses in (
            ("(OA)", ray, "O", "φ"),
            ("A", lay_off, "(OA)", "OA"),
            ("(A)", strike, "A", "AB"),
            ("(C)", strike, "C", "CB"),
            ("B", cross, "(A)", "(C)", "±"),
            ("(OC)", join, "O", "C"),
            ("(AB)", join, "A", "B"),
            ("P", meet, "(AB)", "(OC)"),
            ("(P)", square, "P", "(OC)"),
            ("oc", measure, "O", "C"),
            ("OB", measure_along, "O", "B", "(OC)"),
            ("ω", rate, "OB", "μ", "OA", "μ"),
            ("L", to_board, "never", "μ"),
        ):
            self.draw(letter, op, *uses)

    def draw(self, letter: str, op: Operation, *uses: str, **choice: int) -> Mark:
        def counted(*args: Any, **choice: int) -> Any:
            self.ran[letter] += 1
            return op.run(*args, **choice)

        counting = op._replace(run=counted)
        marks = [self.marks[name] for name in uses]
        self.marks[letter] = self.board.draw(counting, letter, *marks, **choice)
        return self.marks[letter]

    @property
    def log(self) -> Construction:
        return self.board.construction()

    def at(self, angles: Any) -> dict[Mark, Any]:
        return self.given | {self.marks["φ"]: np.atleast_2d(np.asarray(angles, float))}

    def wanted(self, *letters: str) -> list[Mark]:
        return [self.marks[letter] for letter in letters]


@pytest.fixture
def bar() -> Fourbar:
    return Fourbar()


ANGLES = np.linspace(-720.0, 720.0, 29)[None, :]


def test_only_what_is_needed_runs_and_once(bar: Fourbar) -> None:
    steps = needed(bar.log, bar.wanted("P"))
    due = ["(OA)", "A", "(A)", "(C)", "B", "(OC)", "(AB)", "P"]
    assert [step.it.letter for step in steps] == due
    reading = execute(bar.log, bar.at(ANGLES), bar.wanted("P"))
    assert bar.ran == Counter(due)
    assert bar.marks["P"] in reading
    assert bar.marks["B"] not in reading
    with pytest.raises(KeyError):
        reading[bar.marks["B"]]


def test_a_given_mark_alone_runs_nothing(bar: Fourbar) -> None:
    reading = execute(bar.log, bar.given, bar.wanted("O"))
    assert reading[bar.marks["O"]].tolist() == [[0j]]
    assert not bar.ran
    assert needed(bar.log, []) == ()


def test_everything_runs_when_nothing_is_named(bar: Fourbar) -> None:
    reading = execute(bar.log, bar.at(ANGLES))
    assert bar.ran == Counter(step.it.letter for step in bar.log.steps)
    assert all(mark in reading for mark in (*bar.log.given, *(s.it for s in bar.log.steps)))
    assert "A" not in reading


def test_a_missing_value_is_named_if_it_is_needed(bar: Fourbar) -> None:
    bar.given.pop(bar.marks["never"])
    execute(bar.log, bar.at(ANGLES), bar.wanted("B"))
    with pytest.raises(ConstructionError, match="positions: 'never' was not given"):
        execute(bar.log, bar.at(ANGLES), bar.wanted("L"))


def test_a_slice_changes_no_number(bar: Fourbar) -> None:
    whole = execute(bar.log, bar.at(ANGLES))
    for step in bar.log.steps:
        alone = execute(bar.log, bar.at(ANGLES), [step.it])
        for one, other in zip(arrays(alone[step.it]), arrays(whole[step.it]), strict=True):
            np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("block", [1, 2, 7, 28, 29, 30, 4096])
def test_blocks_change_no_number(bar: Fourbar, block: int) -> None:
    whole = execute(bar.log, bar.at(ANGLES), block=10**9)
    parts = execute(bar.log, bar.at(ANGLES), block=block)
    for step in bar.log.steps:
        for one, other in zip(arrays(parts[step.it]), arrays(whole[step.it]), strict=True):
            assert one.shape == other.shape, step.it.letter
            np.testing.assert_allclose(one, other, rtol=1e-14, atol=1e-12)


@pytest.mark.parametrize("block", [2, 4096])
def test_what_does_not_vary_is_found_once(bar: Fourbar, block: int) -> None:
    reading = execute(bar.log, bar.at(ANGLES), block=block)
    shapes = {s.it.letter: [a.shape for a in arrays(reading[s.it])] for s in bar.log.steps}
    one, all_ = (1, 1), ANGLES.shape
    assert shapes["(C)"] == shapes["(OC)"] == [one, one]
    assert shapes["oc"] == [one]
    assert shapes["(A)"] == [all_, one]
    assert shapes["(P)"] == [all_, one]
    assert shapes["ω"] == shapes["B"] == [all_]
    assert isinstance(reading[bar.marks["(A)"]], Arc)
    assert isinstance(reading[bar.marks["(OC)"]], Line)


def test_trials_and_positions_are_two_axes(bar: Fourbar) -> None:
    lengths = np.array([[28.0], [30.0], [32.0]])
    given = bar.at(ANGLES) | {bar.marks["OA"]: lengths}
    reading = execute(bar.log, given, block=7)
    assert reading[bar.marks["B"]].shape == (3, ANGLES.size)
    for trial, length in enumerate(lengths[:, 0]):
        one = execute(bar.log, bar.at(ANGLES) | {bar.marks["OA"]: length}, bar.wanted("B", "ω"))
        for letter in ("B", "ω"):
            np.testing.assert_allclose(
                reading[bar.marks[letter]][[trial]], one[bar.marks[letter]], rtol=1e-13
            )


def test_a_subset_of_positions_is_what_it_was(bar: Fourbar) -> None:
    whole = execute(bar.log, bar.at(ANGLES), bar.wanted("B", "oc"))
    some = execute(bar.log, bar.at(ANGLES), bar.wanted("B", "oc"), positions=[3, 28, 0])
    assert some.positions == 3
    np.testing.assert_allclose(
        some[bar.marks["B"]], whole[bar.marks["B"]][:, [3, 28, 0]], rtol=1e-14
    )
    assert some[bar.marks["oc"]].shape == (1, 1)


def test_a_position_that_fails_does_not_touch_the_others(bar: Fourbar) -> None:
    radii = np.full(ANGLES.shape, 80.0)
    radii[0, [4, 11]] = 5.0
    fine = execute(bar.log, bar.at(ANGLES), bar.wanted("B", "ω"))
    hurt = execute(bar.log, bar.at(ANGLES) | {bar.marks["AB"]: radii}, bar.wanted("B", "ω"))
    for letter in ("B", "ω"):
        found = hurt[bar.marks[letter]]
        assert np.flatnonzero(np.isnan(found[0])).tolist() == [4, 11]
        keep = ~np.isnan(found)
        np.testing.assert_array_equal(found[keep], fine[bar.marks[letter]][keep])


def test_a_curve_runs_on_whole_rows_and_work_goes_on_behind_it(bar: Fourbar) -> None:
    curve = bar.draw("(B–B)", french_curve, "B", row=24)
    still = bar.draw("(C–C)", french_curve, "C", row=24)
    log, given = bar.log, bar.at(ANGLES)
    whole = execute(log, given)
    for block in (1, 2, 7):
        bar.ran.clear()
        parts = execute(log, given, block=block)
        assert bar.ran["(B–B)"] == 1
        np.testing.assert_allclose(parts[curve].knots, whole[curve].knots, rtol=1e-14)
        np.testing.assert_allclose(parts[curve].tangents, whole[curve].tangents, rtol=1e-9)
    np.testing.assert_array_equal(whole[curve].knots, whole[bar.marks["B"]][:, :24])
    assert whole[still].knots.shape == (1, 24)
    assert np.abs(whole[still].tangents).max() < 1e-12
    program = prepare(log, [curve])
    assert len(program.strata) == 2
    with pytest.raises(ConstructionError, match="needs all positions"):
        execute(log, given, [curve], positions=[0, 1])
    execute(log, given, bar.wanted("B"), positions=[0, 1])


def test_steps_behind_a_curve_find_what_lies_before_it(bar: Fourbar) -> None:
    """A reading of a curve's own: pointwise steps before, across, and pointwise behind."""

    def highest(through: Point) -> Length:
        return Length(np.max(through.imag, axis=1, keepdims=True))

    top = measure._replace(
        name="highest", run=highest, takes=(Point,), arguments=("through",), across=True
    )
    high = bar.draw("top", top, "B")
    last = bar.draw("T", lay_off, "(OA)", "top")
    for block in (2, 4096):
        reading = execute(bar.log, bar.at(ANGLES), [high, last], block=block)
        b = execute(bar.log, bar.at(ANGLES), bar.wanted("B"))[bar.marks["B"]]
        assert reading[high].tolist() == [[b.imag.max()]]
        assert reading[last].shape == ANGLES.shape
        np.testing.assert_allclose(np.abs(reading[last]), b.imag.max(), rtol=1e-14)


def test_readings_are_rounded_and_enter_as_measured(bar: Fourbar) -> None:
    wanted = bar.wanted("OB", "ω", "oc", "B")
    exact = execute(bar.log, bar.at(ANGLES), wanted)
    for block in (2, 4096):
        read = execute(bar.log, bar.at(ANGLES), wanted, hand=Hand(0.5), block=block)
        for letter in ("OB", "oc"):
            tenths = read[bar.marks[letter]] / 0.5
            np.testing.assert_array_equal(tenths, np.rint(tenths))
            assert np.abs(read[bar.marks[letter]] - exact[bar.marks[letter]]).max() <= 0.25 + 1e-9
        np.testing.assert_allclose(read[bar.marks["ω"]], read[bar.marks["OB"]] / 30.0, rtol=1e-15)
        np.testing.assert_array_equal(read[bar.marks["B"]], exact[bar.marks["B"]])


def test_what_was_given_is_not_changed(bar: Fourbar) -> None:
    given = bar.at(ANGLES)
    before = given[bar.marks["φ"]].copy()
    execute(bar.log, given, hand=Hand(0.1), block=7)
    np.testing.assert_array_equal(given[bar.marks["φ"]], before)
