"""Operations noted on a tape: all that single numbers can be asked for, and no guess of the rest."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support.unknown_values import unknown

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.instruments import meet, square
from graphic_tmm.board.tape import INPUT, Tape
from graphic_tmm.board.traced import REFUSED, traced
from graphic_tmm.board.values import Curve, Length, Line, Point
from graphic_tmm.chapter import whole_book

LEFT = {
    *("next_standard", "next_standard_length", "nearest_standard", "next_ratio", "whole_mm"),
    *("involute", "working_involute", "angle_of_involute", "tip_thickness", "pointed_involute"),
    *("along_arc", "measure_arc", "common_divisor", "turn_between", "around_outer"),
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
