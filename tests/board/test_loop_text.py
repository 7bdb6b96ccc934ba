"""A loop fills rows and single numbers, the same wherever it is cut."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.machine_code import worked

from graphic_tmm.board.geometry import vector
from graphic_tmm.board.loop_passes import WIDTH
from graphic_tmm.board.loop_text import loop_of
from graphic_tmm.board.tape import Tape
from graphic_tmm.board.traced import traced
from graphic_tmm.board.unknown import Value

COUNT = 53
ROWS = [np.linspace(-3.0, 5.0, COUNT)[None, :], np.array([[2.5]]), np.array([[-4.0]])]


def _formulas(x: Any, a: Any, b: Any) -> list[Any]:
    return [
        x * a + b,
        vector(np.sqrt(x + 4.0), np.sin(x)),
        a * b + np.where(b < 0.0, a, 7.0),
        vector(a + x * 0.0, x),
        vector(b, np.arctan2(a, b)),
        np.where(a > b, x, a + x * 0.0),
        np.where((x > 1.0) & (a > b), 1.5, x),
    ]


def _numbers() -> tuple[Tape, list[Any]]:
    tape = Tape()
    inputs = [Value(tape, tape.input(row.size > 1)) for row in ROWS]
    return tape, traced(_formulas)(*inputs)


def test_rows_and_single_numbers() -> None:
    tape, found = _numbers()
    for one, due in zip(worked(tape, found, ROWS), _formulas(*ROWS), strict=True):
        assert one.shape == due.shape
        np.testing.assert_allclose(one, due, rtol=1e-15, atol=1e-15)


@given(st.sets(st.integers(0, COUNT // WIDTH - 1), max_size=5), st.integers(0, COUNT % WIDTH))
def test_cut_anywhere_the_bytes_are_the_same(cuts: set[int], more: int) -> None:
    tape, found = _numbers()
    ends = [WIDTH * k + more for k in sorted(cuts - {0})]
    whole = worked(tape, found, ROWS)
    for one, other in zip(worked(tape, found, ROWS, ends), whole, strict=True):
        assert one.tobytes() == other.tobytes()


def _text(tape: Tape, found: Value) -> str:
    return loop_of(tape, [(tape.plain(found.part()),)]).text


def test_what_nobody_wants_is_not_worked() -> None:
    tape = Tape()
    x, other = (Value(tape, tape.input(moving=True)) for _ in range(2))
    traced(_formulas)(x, other, other)
    loop = loop_of(tape, [(tape.plain((x + 1.0).part()),)])
    assert "sin" not in loop.text
    assert loop.rows == (0,)


def test_what_stands_still_is_worked_before_the_loop() -> None:
    tape = Tape()
    x, a = (Value(tape, tape.input(moving)) for moving in (True, False))
    text = _text(tape, x * Value(tape, tape.call("sqrt", a.re)))
    before, within = text.split("\nloop:")
    assert "@llvm.sqrt.f64(double" in before
    assert "sqrt" not in within


def test_a_number_is_spread_once() -> None:
    tape = Tape()
    x, a = (Value(tape, tape.input(moving)) for moving in (True, False))
    assert _text(tape, (x + a) * (x - a)).count("_wide = ") == 1


def test_unknown_work_is_told() -> None:
    tape = Tape()
    with pytest.raises(KeyError, match="gamma"):
        loop_of(tape, [(tape.note("gamma", tape.plain(tape.input(moving=True))),)])
