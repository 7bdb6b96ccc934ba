"""The text of a loop: each pass of a tape does what numpy does, in one lane as in eight."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from support.each import each
from support.machine_code import worked

from graphic_tmm.board import geometry
from graphic_tmm.board.compile.llvm import LIBRARY, PASSES, WIDTH, loop_of
from graphic_tmm.board.compile.loop import assembled, taken_apart
from graphic_tmm.board.compile.tape import MASKS, Tape
from graphic_tmm.board.compile.trace import _FUNCTIONS, REFUSED, NotTraced, Value, traced
from graphic_tmm.board.geometry import cis, vector
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.values import (
    Angle,
    Arc,
    Curve,
    Length,
    Line,
    Number,
    Point,
    Side,
    arrays,
    complexes,
)
from graphic_tmm.scene.chapter import whole_book

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


SPECIAL = [0.0, -0.0, 1.0, -1.0, 0.5, -2.5, 3.0, 1e-300, -7e200, np.inf, -np.inf, np.nan]
PAIRS = np.array(list(itertools.product(SPECIAL, SPECIAL))).T
ORDINARY = np.random.default_rng(1).uniform(-9.0, 9.0, (4, 80))

EXACT: list[Callable[..., Any]] = [
    lambda a, b: np.add(a, b),
    lambda a, b: np.subtract(a, b),
    lambda a, b: np.multiply(a, b),
    lambda a, b: np.divide(a, b),
    lambda a, b: np.maximum(a, b),
    lambda a, b: np.minimum(a, b),
    lambda a, b: np.fmax(a, b),
    lambda a, b: np.fmin(a, b),
    lambda a, b: np.copysign(a, b),
    lambda a, b: np.where(a < b, a, b),
    lambda a, b: np.where((a <= b) & ~(a == 0.0), a, 1.0),
    lambda a, b: np.where((a >= b) | (b != 0.0), a, 2.0),
    lambda a, b: np.where(np.isnan(a) | np.isfinite(b), a, b),
    lambda a, b: np.where(np.where(a > b, a > 0.0, b > 0.0), a, b),
    lambda a, b: np.sqrt(a) + np.floor(b) - np.ceil(a) + np.rint(b),
    lambda a, b: np.sign(a) * np.abs(b) - (-a),
    lambda a, b: 2.0 - (1.0 / a) + 3.0 * b + (1.0 + a) ** 2,
    lambda a, b: np.where(np.logical_not(np.logical_or(a > 0, b > 0)), a, b),
    lambda a, b: np.where(np.logical_and(np.less(a, b), np.not_equal(a, -1.0)), a, np.square(b)),
    lambda a, b: np.radians(a) * np.degrees(b),
]
NEAR: list[Callable[..., Any]] = [
    lambda a, b: np.sin(a) + np.cos(b) + np.tan(a / 9.0),
    lambda a, b: np.arctan2(a, b) + np.arctan(a),
    lambda a, b: np.arcsin(a / 9.0) + np.arccos(b / 9.0),
    lambda a, b: np.exp(a / 9.0) + np.log(np.abs(b)),
    lambda a, b: np.hypot(a, b) + np.cbrt(a),
    lambda a, b: np.abs(a) ** b + a**3 - b**4 + 2.0 ** (b / 9.0),
]
OF_VECTORS: list[Callable[..., Any]] = [
    *(lambda z, w: z + w, lambda z, w: z - w, lambda z, w: z * w, lambda z, w: z / w),
    lambda z, w: np.abs(z) * w + z / np.abs(w),
    lambda z, w: 1j * z - w * 2.0 + z * (0.5 - 2j) + (1.0 + w) - (2.0 - z) - 3.0,
    lambda z, w: np.conj(z) * w**2,
    lambda z, w: np.where(z.real > 0.0, z, -w),
    lambda z, w: np.where(z == w, z, z - w.imag),
    lambda z, w: np.where(np.isnan(z) | ~np.isfinite(w), z, np.square(w)),
]


def _inputs(tape: Tape, rows: Any) -> list[Value]:
    return [Value(tape, tape.input(moving=True)) for _ in rows]


def _made(function: Callable[..., Any], *rows: Any) -> Any:
    tape = Tape()
    found = traced(function)(*_inputs(tape, rows))
    (numbers,) = worked(tape, [found], [np.ascontiguousarray(row[None]) for row in rows])
    return numbers[0]


@each("function", EXACT)
def test_numbers_to_the_last_bit(function: Callable[..., Any]) -> None:
    with np.errstate(all="ignore"):
        due = function(*PAIRS)
    np.testing.assert_array_equal(_made(function, *PAIRS), due)


@pytest.mark.parametrize("function", NEAR)
def test_functions_of_the_library(function: Callable[..., Any]) -> None:
    found = _made(function, *ORDINARY[:2])
    np.testing.assert_allclose(found, function(*ORDINARY[:2]), rtol=1e-14, atol=1e-14)


@pytest.mark.parametrize("function", OF_VECTORS)
def test_vectors(function: Callable[..., Any]) -> None:
    tape = Tape()
    p, q, r, s = _inputs(tape, ORDINARY)
    found = traced(function)(Value(tape, p.re, q.re), Value(tape, r.re, s.re))
    (numbers,) = worked(tape, [found], [np.ascontiguousarray(row[None]) for row in ORDINARY])
    a, b, c, d = ORDINARY
    due = function(a + 1j * b, c + 1j * d)
    np.testing.assert_allclose(numbers[0], due, rtol=1e-14, atol=1e-13)


@pytest.mark.parametrize(
    "function",
    [
        lambda z: np.sin(z),
        lambda z: z < 1.0,
        lambda z: np.where(z, z, z),
        lambda z: (z == 0.0) & z,
        lambda z: np.maximum(z, 1.0),
    ],
)
def test_vectors_have_no_order(function: Callable[..., Any]) -> None:
    tape = Tape()
    p, q = _inputs(tape, "ab")
    with pytest.raises(NotTraced):
        traced(function)(Value(tape, p.re, q.re))


def test_a_direction_of_nothing_is_undefined() -> None:
    tape = Tape()
    p, q = _inputs(tape, "ab")
    found = traced(geometry.unit)(Value(tape, p.re, q.re))
    (numbers,) = worked(tape, [found], [np.zeros((1, 9)), np.zeros((1, 9))])
    assert not np.isfinite(numbers).any()


def test_each_pass_that_a_tracer_knows_is_one_of_machine_code() -> None:
    known = {*PASSES, *LIBRARY}
    assert known >= MASKS
    assert known >= _FUNCTIONS
    assert not PASSES.keys() & LIBRARY.keys()


MANY = 60
ONLY_EXECUTED = {
    *("turn_between", "measure_arc", "along_arc", "around_outer", "crossed_at", "off_arc"),
    *("whole_mm", "next_ratio", "next_standard", "next_standard_length", "nearest_standard"),
    *("common_divisor", "involute", "angle_of_involute", "pointed_involute", "working_involute"),
    *("tip_thickness", "working_involute_inside", "ring_thickness_at", "gap_of_corners"),
    "pointed_ring_involute",
}
"""Operations that look into tables, search, or count turns: no curve, nor across, and yet not noted."""


def values(kind: Any, chance: np.random.Generator) -> Any:
    """Values of a kind, (1, position): ordinary ones, and the awkward ones of its kind among them."""
    if kind is Line:
        with np.errstate(invalid="ignore"):
            return Line(values(Point, chance), cis(values(Angle, chance)))
    if kind is Arc:
        return Arc(values(Point, chance), np.abs(values(Length, chance)) + 30.0)
    if kind is Side:
        return chance.choice([-1.0, 1.0], (1, MANY))
    if kind is Point:
        found: Any = chance.uniform(-90, 90, (1, MANY)) + 1j * chance.uniform(-90, 90, (1, MANY))
        found[0, :2] = 0.0
        return found
    top = {Length: 90.0, Angle: 360.0, Number: 9.0}[kind]
    found = chance.uniform(-top, top, (1, MANY))
    found[0, 1:8] = 0.0, 45.0, 90.0, -180.0, 1.0, 2.0, np.nan
    return found


def noted(tape: Tape, value: Any, kind: Any, rows: list[NDArray[Any]]) -> Any:
    """A value as inputs of a tape; its rows are entered."""
    parts: list[list[Any]] = []
    for array, two in zip(arrays(value), complexes(kind), strict=True):
        numbers = (array.real, array.imag) if two else (array,)
        parts.append([tape.input(moving=True) for _ in numbers])
        rows += [np.ascontiguousarray(number) for number in numbers]
    return assembled(type(value), tape, parts)


def choices(op: Operation) -> list[dict[str, int]]:
    """Choices of an operation: none, and each of them by both signs."""
    return [{}] if not op.choices else [{name: sign} for name in op.choices for sign in (1, -1)]


WANDERING = (
    "trace",
    "trace_on_guide",
    "trace_on_guides",
    "trace_past",
    "trace_on_guide_past",
    "trace_past_both",
    "lay_on_guides",
    "lay_on_guides_past",
    "lay_on_guide_past",
    "lay_past_all",
    "trace_joined",
)
"""From far off corrections wander by rounding: from near they are compared by whole mechanisms."""


@pytest.mark.slow
def test_operations_in_machine_code_make_what_they_make_by_numpy() -> None:
    whole_book()
    chance = np.random.default_rng(3)
    tape = Tape()
    rows: list[NDArray[Any]] = []
    due: list[NDArray[Any]] = []
    found: list[Value] = []
    names: list[str] = []
    without = set()
    for op in OPERATIONS.values():
        if op.across or Curve in (*op.takes, op.leaves) or op.name in WANDERING:
            continue
        for choice in choices(op):
            given = [values(kind, chance) for kind in op.takes]
            try:
                made = traced(op.run)(
                    *[
                        noted(tape, one, kind, rows)
                        for one, kind in zip(given, op.takes, strict=True)
                    ],
                    **choice,
                )
            except REFUSED:
                without.add(op.name)
                continue
            with np.errstate(all="ignore"):
                numbers = arrays(op.run(*given, **choice))
            # what is on the tape is complex where numpy's numbers are
            assert complexes(op.leaves) == tuple(map(np.iscomplexobj, numbers)), op.name
            for parts in taken_apart(made, complexes(op.leaves)):
                found.append(Value(tape, *(0.0 if part is None else part for part in parts)))
            due += numbers
            names += [op.name] * len(numbers)
    assert without == ONLY_EXECUTED
    got = worked(tape, found, rows)
    assert len(set(names)) > 250
    for name, one, other in zip(names, due, got, strict=True):
        assert one.dtype == other.dtype, name
        one = np.broadcast_to(one, other.shape)
        known = np.isfinite(one)
        np.testing.assert_array_equal(known, np.isfinite(other), err_msg=name)
        top = np.abs(one[known]).max(initial=0.0)
        assert np.abs(one[known] - other[known]).max(initial=0.0) <= 1e-12 * top, name
