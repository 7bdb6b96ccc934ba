"""Ink rules on traced numbers: the same ink, with expressions that draw it again of other marks."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from graphic_tmm.paper.arithmetic import (
    arcsine,
    bearing,
    below,
    by_case,
    counted,
    either,
    larger,
    outermost,
    polar,
    signed,
    smaller,
    tangent,
)
from graphic_tmm.paper.covering import Covering, covered
from graphic_tmm.paper.drawing import Stroke, arc, circle, line
from graphic_tmm.paper.expressions import Expressions
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import guide, round_arrow, slider
from graphic_tmm.paper.traced import Traced, node_of, untraced

A, B, R = 3.0 + 4.0j, -20.0 + 31.0j, 7.5
"""Two points and a radius that rules are given, and of which they are drawn again."""
ELSEWHERE = (5.5 - 2.0j, -11.0 + 40.0j, 8.0)


def _marks(among: Expressions, *values: complex) -> Iterator[Traced]:
    for slot, value in enumerate(values):
        node = among.node("mark", slot, 0, real=isinstance(value, float))
        yield Traced(value, among, node)


def _again(among: Expressions, nodes: list[int], *values: complex) -> list[complex]:
    """Return the values of nodes with other marks."""
    found = among.values(
        lambda slot, part: np.array([values[slot]]), lambda *_: np.nan, covered, nodes
    )
    return [complex(np.ravel(found[node])[0]) for node in nodes]


RULES: dict[str, Callable[..., Any]] = {
    "arithmetic": lambda a, b, r: [(a - b) / r * 2.0 + 1j * abs(b - a) - (-a).conjugate()],
    "parts": lambda a, b, r: [a.real + 1j * b.imag, b.real - r],
    "directions": lambda a, b, r: [
        polar(r, bearing(b - a)),
        polar(2.0, r),
        tangent(r),
        arcsine(1 / r),
    ],
    "chosen": lambda a, b, r: [smaller(r, a.real, 2.0), larger(r, b.imag), signed(3.0, b.real)],
    "cases": lambda a, b, r: [
        by_case(below(a.real, r), a, b),
        by_case(either(0.0, below(r, 1.0)), a, b),
    ],
    "ends": lambda a, b, r: list(outermost([(a.real, True), (r, False), (b.imag, True)])[1]),
    "rounded": lambda a, b, r: [round(abs(b - a), 6), math.floor(r)],
}


@pytest.mark.parametrize("name", RULES)
def test_an_expression_is_what_python_calculates(name: str) -> None:
    among = Expressions()
    found = RULES[name](*_marks(among, A, B, R))
    assert any(isinstance(one, Traced) for one in found)
    due = [complex(one) for one in RULES[name](A, B, R)]
    assert [untraced(one) for one in found] == pytest.approx(due, abs=1e-12)
    told = _again(among, [node_of(one, among) for one in found], *ELSEWHERE)
    assert told == pytest.approx([complex(one) for one in RULES[name](*ELSEWHERE)], abs=1e-12)


INK: dict[str, Callable[..., Any]] = {
    "line": lambda a, b, r: [line("main", a, b)],
    "circle": lambda a, b, r: [circle("main", a, r)],
    "arc": lambda a, b, r: [arc("thin", a, r, bearing(b - a), 70.0)],
    "arrow": lambda a, b, r: arrow(a, b, "main"),
    "turn": lambda a, b, r: round_arrow(a, r, bearing(b - a), 210.0),
    "slider": lambda a, b, r: slider(a, bearing(b - a)),
}


@pytest.mark.parametrize("name", INK)
def test_ink_is_drawn_again_of_other_marks(name: str) -> None:
    among = Expressions()
    found = _values(INK[name](*_marks(among, A, B, R)))
    assert [untraced(one) for one in found] == pytest.approx(_values(INK[name](A, B, R)), abs=1e-12)
    told = _again(among, [node_of(one, among) for one in found], *ELSEWHERE)
    assert told == pytest.approx([complex(one) for one in _values(INK[name](*ELSEWHERE))], abs=1e-9)


def _values(strokes: list[Stroke]) -> list[Any]:
    return [value for stroke in strokes for vertex in stroke.path for value in vertex]


def test_what_is_compared_is_entered() -> None:
    among = Expressions()
    a, b, r = _marks(among, A, B, R)
    assert abs(a) < r
    assert not abs(b - a) <= r
    assert [(among.nodes[one.node].op, one.found) for one in among.guards] == [("less", True)] * 2
    among.begin()
    assert a == a
    assert untraced(smaller(r, abs(a))) == 5.0
    assert not among.guards


def test_a_float_taken_of_a_traced_number_is_a_constant() -> None:
    among = Expressions()
    a, b, _ = _marks(among, A, B, R)
    made = a + math.hypot(b.real, b.imag)
    assert _again(among, [made.node], *ELSEWHERE) != [ELSEWHERE[0] + abs(ELSEWHERE[1])]


def test_hatching_grows_with_its_guide() -> None:
    """Strokes that are not there yet stand under a condition, and only while they are made."""
    among = Expressions()
    a, b, _ = _marks(among, A, B, R)
    found = guide(a, b)
    assert len(found) > len(guide(A, B)) > len(guide(A, A + (B - A) / 3))
    assert sum(one.taken for one in among.guards) == len(found) - 1
    assert all(one.until for one in among.guards if one.taken)
    assert [*counted(3.0)] == [0, 1, 2]


def test_an_arrow_on_a_link_is_known_on_it_again() -> None:
    among = Expressions()
    a, b, _ = _marks(among, A, B, R)
    for end in (A + (B - A) / 2, A + 1j * (B - A)):
        on = Covering([line("rod", a, b), circle("joint", a, 1.5)]).covers(a, a + (end - A))
        assert untraced(on).real == Covering([line("rod", A, B), circle("joint", A, 1.5)]).covers(
            A, end
        )
        assert isinstance(on, Traced)
        assert _again(among, [on.node], A, B, R) == [untraced(on)]
    inside = Covering(
        [line("body", a, a + 9.0, a + 9.0 + 9.0j, a + 9.0j, closed=True, filled=True)]
    )
    assert untraced(inside.covers(a + 2 + 2j, a + 7 + 7j)) == 1.0
    assert [
        _again(among, [one.node], *ELSEWHERE) for one in [inside.covers(a + 2 + 2j, a + 7 + 7j)]
    ] == [[1.0]]
