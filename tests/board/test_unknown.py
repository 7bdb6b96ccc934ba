"""What is not known yet may be calculated with, and not asked."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from support.unknown_values import numbers_on, unknown

from graphic_tmm.board.tape import INPUT, Ref, Tape
from graphic_tmm.board.traced import REFUSED
from graphic_tmm.board.unknown import Mask, NotTraced, Value, valued
from graphic_tmm.board.values import Length, Point

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


@pytest.mark.parametrize("ask", ASKING)
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
