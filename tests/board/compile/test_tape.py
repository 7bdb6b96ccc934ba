"""A tape notes a pass once, and none for what costs nothing; what is undefined stays so, signs are known."""

from __future__ import annotations

import operator
from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.each import each
from support.examples import most
from support.unknown_values import numbers_on

from graphic_tmm.board.compile.tape import INPUT, Ref, Sign, Tape, of_known, of_pass

NUMBERS = st.sampled_from([0.0, 1.0, -1.0, 2.5, np.nan])
NUMPY: dict[str, Callable[[Any, Any], Any]] = {
    "plus": operator.add,
    "minus": operator.sub,
    "times": operator.mul,
    "over": operator.truediv,
    "opposite": lambda a, _: -a,
}
DOES = st.sampled_from(sorted(NUMPY))


def passes_of(tape: Tape) -> list[str]:
    """The passes on a tape, without what enters."""
    return [node.does for node in tape.nodes if node.does != INPUT]


def test_signs_and_ones_cost_no_pass() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    found = tape.times(tape.opposite(x), tape.times(y, 1.0))
    assert passes_of(tape) == ["multiply"]
    assert isinstance(found, Ref)
    assert found.minus
    assert tape.over(x, 1.0) == x
    assert tape.times(None, x) is None
    assert tape.plus(None, x) == x
    assert passes_of(tape) == ["multiply"]


def test_the_same_is_noted_once_whatever_its_order_and_sign() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    assert tape.plus(x, y) == tape.plus(y, x)
    assert tape.plus(x, tape.opposite(y)) == tape.minus(x, y)
    assert tape.plus(tape.opposite(x), tape.opposite(y)) == tape.opposite(tape.plus(x, y))


def test_factors_that_do_not_vary_are_one_pass() -> None:
    tape = Tape()
    x, a, b = (tape.input(moving) for moving in (True, False, False))
    found = tape.over(tape.times(tape.times(x, a), b), a)
    assert isinstance(found, Ref)
    last = tape.nodes[found.node]
    assert last.does == "multiply"
    assert [tape.nodes[k].does for k in last.takes if tape.nodes[k].moving] == [INPUT]


def test_a_product_by_nothing_is_spared_only_where_nothing_undefined_is_lost() -> None:
    rows = [np.array([1.0, np.nan, 3.0]), np.array([1.0, 2.0, np.nan])]
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    assert tape.plus(x, tape.times(x, 0.0)) == x
    kept = tape.plus(x, tape.times(y, 0.0))
    assert kept != x
    np.testing.assert_array_equal(numbers_on(tape, kept, rows), [1.0, np.nan, np.nan])
    # what is undefined itself is not lost either
    unknown = tape.times(tape.plus(x, np.nan), 0.0)
    assert np.isnan(numbers_on(tape, tape.minus(x, unknown), rows)).all()
    # a comparison with what is undefined is false: it is no longer undefined behind it
    chosen = tape.choose(tape.compare("less", y, 5.0), x, 2.0)
    carried = tape.plus(chosen, tape.times(y, 0.0))
    np.testing.assert_array_equal(numbers_on(tape, carried, rows), [1.0, np.nan, np.nan])


@pytest.mark.parametrize("moving", [True, False])
@settings(max_examples=most(100), deadline=None)
@given(data=st.data())
def test_any_arithmetic_is_that_of_numpy(data: st.DataObject, moving: bool) -> None:
    """Random sequences of it, of numbers and of what is undefined."""
    tape = Tape()
    width = 9 if moving else 1
    cells = st.lists(st.sampled_from([0.5, 1.0, -2.0, 3.0, np.nan]), min_size=width, max_size=width)
    rows = [np.array(data.draw(cells)) for _ in range(2)] + [np.array([1.5])]
    parts: list[Any] = [tape.input(row.size > 1) for row in rows]
    values: list[Any] = list(rows)
    for _ in range(data.draw(st.integers(1, 8))):
        does, k, n = data.draw(DOES), *(data.draw(st.integers(0, len(parts) - 1)) for _ in "ab")
        number = data.draw(st.none() | NUMBERS)
        other, value = (parts[n], values[n]) if number is None else (number, number)
        with np.errstate(all="ignore"):
            values.append(
                NUMPY[does](values[k], np.float64(value) if np.ndim(value) == 0 else value)
            )
            parts.append(
                tape.opposite(parts[k])
                if does == "opposite"
                else getattr(tape, does)(parts[k], other)
            )
    entering = [row if row.size > 1 else row[0] for row in rows]
    count = max(row.size for row in rows)
    whole = np.broadcast_to(numbers_on(tape, parts[-1], entering), count)
    bounded = np.logical_and.reduce([~np.isinf(np.broadcast_to(v, count)) for v in values])
    due = np.broadcast_to(values[-1], count)
    np.testing.assert_array_equal(np.isnan(due)[bounded], np.isnan(whole)[bounded])
    np.testing.assert_allclose(whole[bounded], due[bounded], rtol=1e-13, atol=1e-13)


SIGNED = (0.0, -0.0, 1.0, -1.0, 0.4, -0.4, 2.5, -2.5, 1e-300, -1e-300, np.inf, -np.inf, np.nan)
HAVE = {
    Sign.FREE: SIGNED,
    Sign.UNSIGNED: tuple(x for x in SIGNED if x != 0.0 or not np.signbit(x)),
    Sign.POSITIVE: tuple(x for x in SIGNED if not (x < 0.0) and not (x == 0.0 and np.signbit(x))),
}
"""Numbers of which so much is known."""
TWO = {
    "add": np.add,
    "subtract": np.subtract,
    "multiply": np.multiply,
    "divide": np.divide,
    "copysign": np.copysign,
    "length": np.hypot,
    "choose": lambda x, y: np.array([x, y]),
}
ONE = {
    "sqrt": np.sqrt,
    "absolute": np.abs,
    "floor": np.floor,
    "ceil": np.ceil,
    "rint": np.rint,
    "negative": np.negative,
    "arctan": np.arctan,
}


def holds(sign: Sign, found: np.ndarray) -> bool:
    zeros = found[found == 0.0]
    if sign >= Sign.UNSIGNED and np.signbit(zeros).any():
        return False
    return sign < Sign.POSITIVE or not (found < 0.0).any()


@each("does", [*TWO, *ONE])
def test_what_a_pass_leaves_is_as_it_is_said(does: str) -> None:
    """For all that may be known of what it takes."""
    with np.errstate(all="ignore"):
        for signs in product(Sign, repeat=2 if does in TWO else 1):
            rows = [HAVE[sign] for sign in signs]
            found = np.array([(TWO | ONE)[does](*each) for each in product(*rows)], dtype=float)
            said = of_pass(does, signs, alike=False)
            assert holds(said, np.ravel(found)), signs


def test_a_square_is_nothing_below_nothing() -> None:
    found = np.array([x * x for x in SIGNED])
    assert holds(of_pass("multiply", (Sign.FREE, Sign.FREE), alike=True), found)
    assert of_pass("multiply", (Sign.FREE, Sign.FREE), alike=True) == Sign.POSITIVE
    assert not holds(Sign.POSITIVE, np.array(SIGNED))
    assert not holds(Sign.UNSIGNED, np.array([-0.0]))


def test_known_numbers() -> None:
    for number in SIGNED:
        assert holds(of_known(number), np.array([number]))
    assert [of_known(x) for x in (0.0, -0.0, 2.0, -2.0)] == [
        Sign.POSITIVE,
        Sign.FREE,
        Sign.POSITIVE,
        Sign.UNSIGNED,
    ]


def test_sums_with_nothing_cost_no_pass_where_they_change_no_byte() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    assert tape.plus(x, -0.0) == x
    assert tape.minus(x, 0.0) == x
    kept = tape.plus(x, 0.0)
    assert kept != x
    assert tape.plus(kept, 0.0) == kept
    assert tape.plus(tape.plus(kept, y), 0.0) == tape.plus(kept, y)
    assert tape.plus(tape.opposite(kept), 0.0) != tape.opposite(kept)


def test_what_is_nothing_below_nothing_has_no_sign_to_take_off() -> None:
    tape = Tape()
    x, y = tape.input(moving=True), tape.input(moving=True)
    size = tape.call("length", x, y)
    assert tape.call("absolute", size) == size
    assert tape.call("copysign", size, tape.call("absolute", x)) == size
    assert tape.call("copysign", x, size) == tape.call("absolute", x)
    assert tape.call("absolute", x) != x
    assert tape.call("copysign", size, x) != size
