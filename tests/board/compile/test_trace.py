"""Operations are noted as they are; what is not known yet may be calculated with, and not asked."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from support.each import each
from support.unknown_values import numbers_on, unknown

from graphic_tmm.board.compile.tape import INPUT, Ref, Tape
from graphic_tmm.board.compile.trace import REFUSED, Mask, NotTraced, Value, traced, valued
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.instruments import meet, square
from graphic_tmm.board.values import Curve, Length, Line, Point
from graphic_tmm.scene.chapter import whole_book

LEFT = {
    *("next_standard", "next_standard_length", "nearest_standard", "next_ratio", "whole_mm"),
    *("involute", "working_involute", "angle_of_involute", "tip_thickness", "pointed_involute"),
    *("working_involute_inside", "ring_thickness_at", "pointed_ring_involute", "gap_of_corners"),
    *("along_arc", "measure_arc", "common_divisor", "turn_between", "around_outer"),
    *("crossed_at", "off_arc"),
}
"""Pointwise operations without a curve that look at their numbers, or call what is no pass."""


def test_nearly_all_operations_can_be_noted() -> None:
    whole_book()
    left = set()
    for name, op in OPERATIONS.items():
        if op.across or Curve in (*op.takes, op.leaves):
            continue
        tape = Tape()
        try:
            choice = dict.fromkeys(op.choices, 1)
            traced(op.run)(*(unknown(tape, kind) for kind in op.takes), **choice)
        except REFUSED:
            left.add(name)
    assert left == LEFT


def test_a_line_turned_by_a_right_angle_costs_nothing() -> None:
    tape = Tape()
    through, to = unknown(tape, Point), unknown(tape, Line)
    turned = traced(square.run)(through, to, sense=1)
    assert {node.does for node in tape.nodes} == {INPUT}
    assert (turned.along.im, turned.at.re) == (to.along.re, through.re)


def test_a_second_intersection_of_the_same_lines_is_the_first() -> None:
    tape = Tape()
    base, other = unknown(tape, Line), unknown(tape, Line)
    first = traced(meet.run)(base, other)
    noted = len(tape.nodes)
    second = traced(meet.run)(base, other)
    assert (first.re, first.im, noted) == (second.re, second.im, len(tape.nodes))


def _looks(x: Any) -> Any:
    return x if x > 0 else -x


def _counts(x: Any) -> Any:
    return x * len(x)


def _slices(x: Any) -> Any:
    return x[:, :1]


def _unheard_of(x: Any) -> Any:
    return np.sinc(x)


def _named_within(x: Any) -> Any:
    return (lambda y: np.sqrt(y) if RANGE else y)(x)


def _ordered(x: Any) -> Any:
    return (x + 1j) < 1.0


def _folded(x: Any) -> Any:
    return np.add.reduce(x)


RANGE = 1


@pytest.mark.parametrize(
    "function", [_looks, _counts, _slices, _unheard_of, _named_within, _ordered, _folded, np.where]
)
def test_what_looks_at_numbers_is_refused(function: Any) -> None:
    with pytest.raises(REFUSED):
        traced(function)(unknown(Tape(), Length))


def test_what_encloses_values_runs_as_it_is() -> None:
    scale = 2.0

    def free(length: Length) -> Length:
        return Length(scale * np.abs(length))

    assert traced(free) is free
    with pytest.raises(REFUSED):
        free(unknown(Tape(), Length))


def test_what_folds_the_row_is_not_noted() -> None:
    with pytest.raises(REFUSED):
        traced(french_curve.run)(unknown(Tape(), Point), row=12)


ASKING: list[Callable[[Any], Any]] = [
    bool,
    float,
    complex,
    len,
    list,
    np.asarray,
    np.sqrt,
    lambda x: x[0],
    lambda x: x.shape,
    lambda x: 1 if x > 0.0 else 2,
    lambda x: x @ x,
    lambda x: x + "1",
    lambda x: x + np.ones(3),
]


@each("ask", ASKING)
def test_nobody_may_ask_what_is_not_known(ask: Callable[[Any], Any]) -> None:
    with pytest.raises(REFUSED):
        ask(unknown(Tape(), Length))


def test_powers_that_are_small_and_whole_are_products() -> None:
    tape = Tape()
    x = unknown(tape, Length)
    for power in (2, 3, 4, 2.0):
        assert (x**power).re == (x * x * (1.0, x, x * x)[int(power) - 2]).re
    assert {node.does for node in tape.nodes} == {INPUT, "multiply"}


def test_a_truth_goes_with_truths_only() -> None:
    x = unknown(Tape(), Length)
    assert isinstance((x > 0.0) & ~(x < 1.0), Mask)
    with pytest.raises(NotTraced):
        (x > 0.0) & 1
    with pytest.raises(NotTraced):
        bool(unknown(Tape(), Point) < 1.0)


@pytest.mark.parametrize("value", [1, 2.5, np.float64(3.0), 1j, np.complex128(1.0)])
def test_plain_numbers_are_known(value: Any) -> None:
    tape = Tape()
    found = valued(tape, value)
    assert complex(*(0.0 if part is None else part for part in (found.re, found.im))) == value  # type: ignore[arg-type]
    assert not tape.nodes


@pytest.mark.parametrize("value", ["1", None, [1.0], np.array([1.0]), np.array(1.0)])
def test_nothing_else_is(value: Any) -> None:
    with pytest.raises(NotTraced):
        valued(Tape(), value)


def test_what_is_done_twice_is_noted_once() -> None:
    tape = Tape()
    x, y = unknown(tape, Length), unknown(tape, Length)
    first, second = x * y + 1.0, 1.0 + y * x
    assert isinstance(first, Value)
    assert isinstance(first.re, Ref)
    assert first.re == second.re
    assert [node.does for node in tape.nodes] == [INPUT, INPUT, "multiply", "add"]
    assert (x * 0.0).re != (x * -0.0).re


@pytest.mark.parametrize("known", [True, False])
def test_what_is_divided_by_a_known_length_takes_no_other(known: bool) -> None:
    rows = [np.array([3.0, -2.0, 1e-9, 0.0]), np.array([4.0, 0.5, 2e-9, 0.0])]
    tape = Tape()
    z = Value(tape, *(tape.input(moving=True) for _ in rows))
    if known:
        abs(-z)
    found = (2.0 - 1j) / z
    assert ("maximum" in {node.does for node in tape.nodes}) is not known
    re, im = (numbers_on(tape, part, rows) for part in (found.re, found.im))
    np.testing.assert_allclose(
        (re + 1j * im)[:3], (2.0 - 1j) / (rows[0] + 1j * rows[1])[:3], rtol=1e-15
    )
    assert np.isnan([re[3], im[3]]).all()
