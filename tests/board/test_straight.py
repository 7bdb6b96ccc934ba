"""Many positions as one line of passes say what the steps say one by one."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.drawn import board
from support.mechanisms import mechanisms

from graphic_tmm.board import execute, road, straight
from graphic_tmm.board.blocks import Call, Values, varies
from graphic_tmm.board.execute import Reading, prepare
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.hand import EXACT, HANDS, Hand
from graphic_tmm.board.operations.choice import next_standard
from graphic_tmm.board.operations.instruments import join, lay_off, measure, ray
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Angle, Arc, Curve, Length, Line, Number, Point, Side, arrays
from graphic_tmm.chapter import whole_book

WITHIN = 1e-12
"""Of the largest number of a mark: products of complex numbers are rounded otherwise."""


@pytest.fixture
def lined(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Few positions are many; whether they ran as a line."""
    ran: list[bool] = []
    real = straight.in_line

    def told(*arguments: Any) -> bool:
        ran.append(real(*arguments))
        return ran[-1]

    monkeypatch.setattr(road, "MANY", 2)
    monkeypatch.setattr(straight, "in_line", told)
    return ran


def sizes(plans: Reading, marks: list[Any], mark: Any) -> list[float]:
    """The largest finite numbers in the plan of a mark, by its arrays: of places, or of numbers alike."""

    def alike(kind: Any, k: int) -> tuple[Any, int]:
        return (Point, 0) if k == 0 and kind in (Line, Arc) else (kind, k)

    found: dict[tuple[Any, int], float] = {}
    for other in marks:
        if other.view == mark.view:
            for k, array in enumerate(arrays(plans[other])):
                top = float(np.abs(array[np.isfinite(array)]).max(initial=0.0))
                key = alike(other.kind, k)
                found[key] = max(found.get(key, 0.0), top)
    return [found[alike(mark.kind, k)] for k in range(len(arrays(plans[mark])))]


def bits(array: Any) -> bytes:
    """The bytes of numbers; what is undefined has no sign."""
    found = np.array(array).view(np.float64)
    found[np.isnan(found)] = np.nan
    return found.tobytes()


def same(
    one: Any, other: Any, what: object, within: float = WITHIN, least: Sequence[float] = ()
) -> None:
    """Both are undefined in the same places, and elsewhere the same to rounding.

    ``least``: what is large beside their arrays, where they may be nothing but rounding.
    """
    for first, second, beside in zip(
        arrays(one), arrays(other), least or [0.0] * len(arrays(one)), strict=True
    ):
        assert first.shape == second.shape, what
        assert first.dtype == second.dtype, what
        drawn = np.isfinite(first)
        np.testing.assert_array_equal(drawn, np.isfinite(second), err_msg=str(what))
        if drawn.any():
            top = max(np.abs(first[drawn]).max(), beside)
            assert np.abs(first[drawn] - second[drawn]).max() <= within * top, what


def values_of(
    op: Operation, chance: np.random.Generator, widths: list[int], scale: float
) -> Values:
    """Values for an operation, so many positions each; some are undefined, or special."""
    found: Values = {}
    for k, (kind, n) in enumerate(zip(op.takes, widths, strict=True)):

        def number(n: int = n) -> Any:
            return chance.uniform(0.2, 2.0, (1, n)) * chance.choice([-1.0, 1.0], (1, n)) * scale

        def vector(n: int = n) -> Any:
            return number() + 1j * number()

        angle = np.where(chance.random((1, n)) < 0.3, 90.0, 1.0) * chance.integers(-8, 8, (1, n))
        if kind is Line:
            turned = np.exp(1j * np.radians(angle))
            exact = chance.choice([1.0, 1j, -1.0, -1j], (1, n))
            found[k] = Line(vector(), np.where(angle % 90.0 == 0.0, exact, turned))
        elif kind is Arc:
            found[k] = Arc(vector(), np.abs(number()) + scale)
        elif kind is Point:
            found[k] = vector()
        elif kind is Side:
            found[k] = np.sign(number())
        else:
            found[k] = angle.astype(float) if kind is Angle else number()
        if n > 1 and scale == 1.0:
            for array in arrays(found[k]):
                array[0, 3 + k] = np.nan
    return found


def _pointwise() -> list[Operation]:
    whole_book()
    return [
        op for op in OPERATIONS.values() if not op.across and Curve not in (*op.takes, op.leaves)
    ]


@pytest.mark.parametrize("scale", [1.0, 1e-60, 1e60])
def test_every_operation_is_the_same_in_a_line(scale: float) -> None:
    """All that vary, or each alone; undefined values, exact right angles, huge and tiny figures."""
    chance = np.random.default_rng(11)
    ran = 0
    for op in _pointwise():
        count = len(op.takes)
        run = partial(op.run, **dict.fromkeys(op.choices, 1)) if op.choices else op.run
        call = Call(run, tuple(range(count)), count, op.leaves, False)
        for alone in (None, *range(count)):
            widths = [40 if alone in (None, k) else 1 for k in range(count)]
            values = values_of(op, chance, widths, scale)
            with np.errstate(all="ignore"):
                try:
                    due = run(*(values[k] for k in range(count)))
                except (OverflowError, ValueError):
                    break  # a search among standard values has an end
                if not straight.in_line((call,), values, 40, 16, EXACT, frozenset({count})):
                    break
            if not all(np.isinf(array).any() for array in arrays(due)):
                same(due, values[count], (op.name, alone), 1e-11)
                ran += 1
    assert ran > 700


@settings(max_examples=15, deadline=None)
@given(drawn=mechanisms(), read=st.booleans(), data=st.data())
def test_three_plans_of_any_mechanism(drawn: Any, read: bool, data: st.DataObject) -> None:
    """All marks of the plans, or some; in blocks of any size to the last bit."""
    one = board(drawn.mechanism, mu=(0.01, 0.1, 1.0))
    marks = [step.it for step in one.log.steps]
    wanted = data.draw(st.sampled_from([marks, marks[-3:], marks[::4]]))
    angles = drawn.phi + np.linspace(-4.0, 4.0, 23)[None, :]
    program = prepare(one.log, wanted)
    hand = Hand(ruler=0.1) if read else EXACT
    given_ = one.given | {one.positions.phi: angles}
    plain = program.run(given_, hand=hand)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(road, "MANY", 2)
        whole = program.run(given_, hand=hand)
        parts = [program.run(given_, hand=hand, block=block) for block in (1, 5, 22)]
    everything = prepare(one.log, marks).run(given_, hand=hand)
    for mark in wanted:
        same(plain[mark], whole[mark], mark, 1e-9, sizes(everything, marks, mark))
        for other in parts:
            for first, second in zip(arrays(whole[mark]), arrays(other[mark]), strict=True):
                assert bits(first) == bits(second)


def _ladder(*, chosen: bool = False) -> tuple[Any, dict[str, Any]]:
    draft = Board()
    draft.open("positions")
    marks: dict[str, Any] = {
        "O": draft.take(Point, "O"),
        "φ": draft.take(Angle, "φ"),
        "l": draft.take(Length, "l"),
        "μ": draft.take(Number, "μ", "m/mm"),
    }
    marks["(OA)"] = draft.draw(ray, "(OA)", marks["O"], marks["φ"])
    marks["A"] = draft.draw(lay_off, "A", marks["(OA)"], marks["l"])
    marks["(AO)"] = draft.draw(join, "(AO)", marks["A"], marks["O"])
    marks["OA"] = draft.draw(measure, "OA", marks["O"], marks["A"])
    if chosen:
        marks["ν"] = draft.draw(next_standard, "ν", marks["μ"], unit="m/mm")
    return draft.construction(), marks


def _run(log: Any, marks: dict[str, Any], *, hand: Hand = EXACT, **told: Any) -> Reading:
    given_ = {"O": 0j, "φ": np.linspace(-100.0, 400.0, 50)[None, :], "l": 30.0, "μ": 0.002} | told
    return execute.execute(log, {marks[k]: v for k, v in given_.items()}, hand=hand)


def test_what_is_the_same_all_over_stays_so(lined: list[bool]) -> None:
    log, marks = _ladder()
    reading = _run(log, marks)
    assert lined == [True]
    assert reading[marks["(OA)"]].at.shape == (1, 1)
    assert reading[marks["A"]].shape == (1, 50)
    assert not varies(reading[marks["O"]])


def test_one_program_serves_other_lengths_and_what_is_undefined(lined: list[bool]) -> None:
    log, marks = _ladder()
    for length in (30.0, 1.0, 0.0, -1.0, np.nan, 7.0):
        found = _run(log, marks, l=length)[marks["A"]]
        np.testing.assert_allclose(np.abs(found), np.full((1, 50), abs(length)), rtol=1e-15)
    assert all(lined)


def test_exact_angles_are_exact_at_any_number_of_positions(lined: list[bool]) -> None:
    log, marks = _ladder()
    for count in (4, 400):
        angles = np.full((1, count), 270.0)
        found = _run(log, marks, φ=angles)[marks["A"]]
        np.testing.assert_array_equal(found, np.full((1, count), -30j))
    assert lined == [True, True]


def test_trials_and_hands_that_slip_run_step_by_step(lined: list[bool]) -> None:
    log, marks = _ladder()
    lengths = np.array([[28.0], [30.0]])
    found = _run(log, marks, l=lengths)
    assert lined == [False]
    np.testing.assert_allclose(found[marks["OA"]], np.broadcast_to(lengths, (2, 50)))
    _run(log, marks, hand=HANDS["student"]._replace(trials=2))
    _run(log, marks, hand=Hand(digits=3))
    assert lined == [False]


def test_a_search_runs_before_the_line_or_instead_of_it(lined: list[bool]) -> None:
    log, marks = _ladder(chosen=True)
    assert _run(log, marks)[marks["ν"]].shape == (1, 1)
    many = _run(log, marks, μ=np.full((1, 50), 0.0021))
    assert lined == [True, False]
    assert many[marks["ν"]].shape == (1, 50)
    same(_run(log, marks)[marks["A"]], many[marks["A"]], "A")


def test_few_positions_run_step_by_step(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(straight, "in_line", None)
    log, marks = _ladder()
    assert _run(log, marks)[marks["A"]].shape == (1, 50)
