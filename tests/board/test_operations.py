"""Every instrument against fifty digits, in frames of all sizes, turned and moved.

A bound is c·ε·(what the operation magnifies): the condition where it has one, the lengths it handles, and
the size of the answer's own coordinates. References are the textbook formulas, not those of the board.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.each import each
from support.examples import most

from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.grammar import OPERATIONS, Operation
from graphic_tmm.board.operations import instruments, outside
from graphic_tmm.board.operations.supports import swung
from graphic_tmm.board.values import Angle, Arc, Length, Line, Number, Point, Side

DIGITS = 50
BASIC_OPERATIONS = [
    op
    for op in OPERATIONS.values()
    if op.run.__module__ in (instruments.__name__, outside.__name__)
]
BASIC_OPERATIONS.append(swung)
Bounded = tuple[Any, Any] | None
"""The true value and how far a float may be from it, part by part; None where there is none."""


# ---------------------------------------------------------------- what is drawn


def _grid(low: int, high: int, parts: int) -> st.SearchStrategy[float]:
    return st.integers(low * parts, high * parts).map(lambda n: n / parts)


@st.composite
def values(draw: st.DrawFn, op: Operation) -> list[Any]:
    """Values for an operation: one frame of some size, place and turn; coordinates on a grid."""
    scale = 10.0 ** draw(st.integers(-6, 6))
    turn = cmath.rect(1.0, draw(_grid(0, 7, 10)))
    shift = complex(draw(_grid(-9, 9, 1)), draw(_grid(-9, 9, 1))) if draw(st.booleans()) else 0j
    near = _grid(-1, 1, 10**6) | _grid(-3, 3, 1)

    def point() -> complex:
        return scale * (shift + turn * complex(draw(near), draw(near)))

    def one(kind: Any, name: str) -> Any:
        if kind is Point:
            return point()
        if kind is Length:
            return scale * draw(near)
        if kind is Line:
            return Line(*map(_wrap, (point(), turn * cmath.rect(1.0, draw(_grid(-4, 4, 1000))))))
        if kind is Arc:
            return Arc(_wrap(point()), _wrap(scale * abs(draw(near))))
        if kind is Angle:
            return draw(_grid(-400, 400, 10) | _grid(-360, 360, 10**6))
        if kind is Side:
            return float(draw(st.sampled_from((1, -1))))
        assert kind is Number, name
        return draw(near) * 10.0 ** draw(st.integers(-6, 6))

    drawn = [one(kind, name) for kind, name in zip(op.takes, op.arguments, strict=True)]
    return [value if isinstance(value, tuple) else _wrap(value) for value in drawn]


def _wrap(value: complex | float) -> Any:
    return np.array([[value]])


def _lift(value: Any) -> Any:
    """The same value in digits; directions made units."""
    if isinstance(value, Line):
        along = _lift(value.along)
        return _lift(value.at), along / abs(along)
    if isinstance(value, tuple):
        return tuple(map(_lift, value))
    item = value[0, 0]
    return mp.mpc(item.real, item.imag) if np.iscomplexobj(value) else mp.mpf(float(item))


# ---------------------------------------------------------------- references


def _wedge(a: Any, b: Any) -> Any:
    return mp.im(mp.conj(a) * b)


def _dot(a: Any, b: Any) -> Any:
    return mp.re(mp.conj(a) * b)


def _rooted(condition: Any, linear: Any) -> Any:
    """How far a root may be off: by its condition, but never by more than the root of ε."""
    return min(16 * EPS * condition, 8 * mp.sqrt(EPS)) * linear


def _gone(gap: Any, size: Any) -> bool:
    return bool(gap < 0 and gap >= -64 * EPS * size)


class _Rounding(Exception):
    """Rounding may decide whether there is an answer: either is right."""


def _through(a: Any, b: Any) -> Bounded:
    return None if a == b else ((a, (b - a) / abs(b - a)), (0, 8 * EPS))


def _ray(start: Any, angle: Any) -> Bounded:
    return (start, mp.expjpi(angle / 180)), (0, 4 * EPS)


def _shift(to: Any, by: Any) -> Bounded:
    at = to[0] + 1j * by * to[1]
    return (at, to[1]), (EPS * (8 * abs(by) + abs(at)), 4 * EPS)


def _off(on: Any, x: Any, y: Any = 0) -> Bounded:
    arm = mp.mpc(x, y)
    at = on[0] + arm * on[1]
    return at, EPS * (8 * abs(arm) + abs(at))


def _meet(base: Any, other: Any) -> Bounded:
    sine, d = _wedge(base[1], other[1]), other[0] - base[0]
    if abs(sine) <= EPS:
        return None
    if abs(sine) <= 32 * EPS:
        raise _Rounding
    t, s = _wedge(d, other[1]) / sine, _wedge(d, base[1]) / sine
    at = base[0] + t * base[1]
    return at, EPS * (8 * (abs(d) + min(abs(t), abs(s))) / abs(sine) + 2 * abs(at))


def _cut(line: Any, arc: Any, side: Any) -> Bounded:
    (at, u), (centre, r) = line, arc
    c = centre - at
    height, size = abs(_wedge(u, c)), abs(c) + r
    if _gone(r - height, size):
        raise _Rounding
    if height > r or not size:
        return None if size else (at, 0)
    half = mp.sqrt(r**2 - height**2)
    point = at + (_dot(c, u) + side * half) * u
    root = min(16 * EPS * size * r / half if half else mp.inf, 8 * mp.sqrt(EPS * size * r))
    return point, root + EPS * (8 * size + 2 * abs(point))


def _cross(first: Any, second: Any, side: Any) -> Bounded:
    (c, r), (e, s) = first, second
    d = abs(e - c)
    size = d + r + s
    gap = min(r + s - d, d - abs(r - s))
    if d == 0:
        return None
    if _gone(gap, size) and gap != 0:
        raise _Rounding
    if gap < 0:
        return None
    x = (d**2 + r**2 - s**2) / (2 * d)
    y = mp.sqrt(max(r**2 - x**2, mp.mpf(0)))
    point = c + (x + 1j * side * y) * (e - c) / d
    return point, _rooted(r * s / (d * y) if y else mp.inf, size) + EPS * (
        8 * size + 2 * abs(point)
    )


def _tangent(through: Any, centre: Any, radius: Any, side: Any) -> Bounded:
    base = through - centre
    d = abs(base)
    if d and _gone(d - abs(radius), d):
        raise _Rounding
    if d < abs(radius) or not d:
        return None
    half = mp.sqrt(d**2 - radius**2)
    along = base / d * mp.mpc(side * half, -radius) / d
    return (through, along), (0, _rooted(d / half if half else mp.inf, 1) + 8 * EPS)


def _touch(start: Any, arc: Any, side: Any) -> Bounded:
    centre, r = arc
    base = start - centre
    d = abs(base)
    if d and _gone(d - r, d):
        raise _Rounding
    if d < r or not d:
        return None
    angle = mp.acos(r / d)
    point = centre + r * base / d * mp.expj(-side * angle)
    half = mp.sqrt(d**2 - r**2)
    return point, _rooted(d / half if half else mp.inf, r) + EPS * (8 * r + 2 * abs(point))


def _image(start: Any, chord: Any, base: Any, arm: Any) -> Bounded:
    if base == 0:
        return None
    point = start + chord * arm / base
    return point, EPS * (16 * abs(chord * arm / base) + 2 * abs(point))


def _bearing(start: Any, end: Any) -> Bounded:
    if start == end:
        return None
    angle = mp.degrees(mp.arg(end - start))
    return angle, 8 * EPS * abs(angle)


def _swung(first: Any, last: Any, start: Any, end: Any, sense: int = 1) -> Bounded:
    if start == end or first == last:
        return None
    angle = sense * mp.degrees(mp.arg((end - start) * mp.conj(last - first)))
    if abs(abs(angle) - 180) < 1e-9 or abs(angle + 45) < 1e-9:
        raise _Rounding  # which side of the cut it is on, rounding decides
    return angle + 360 * (angle < -45), 8 * EPS * (360 + abs(angle))


REFERENCES: dict[str, Callable[..., Bounded]] = {
    "join": _through,
    "ray": _ray,
    "parallel": lambda p, to, sense=1: ((p, sense * to[1]), (0, 4 * EPS)),
    "square": lambda p, to, sense=1: ((p, 1j * sense * to[1]), (0, 4 * EPS)),
    "incline": lambda p, to, by: ((p, to[1] * mp.expjpi(by / 180)), (0, 8 * EPS)),
    "shift": _shift,
    "lay_off": _off,
    "place": _off,
    "strike": lambda centre, radius: ((centre, radius), (0, 0)),
    "meet": _meet,
    "cut": _cut,
    "cross": _cross,
    "tangent": _tangent,
    "rocker_line": _through,
    "cylinder_axis": _through,
    "directed": lambda p, to, side: ((p, side * to[1]), (0, 4 * EPS)),
    "touch": _touch,
    "similar": lambda a, b, A, B, S: _image(a, b - a, B - A, S - A),
    "homologous": lambda s, a, b, A, B, Q, E: _image(s, b - a, B - A, E - Q),
    "coincide": lambda image: (image, 0),
    "measure": lambda a, b: (abs(b - a), 4 * EPS * abs(b - a)),
    "measure_along": lambda a, b, on: (_dot(b - a, on[1]), 8 * EPS * abs(b - a)),
    "bearing": _bearing,
    "swung": _swung,
    "stand": lambda regular, extreme, at: (extreme if at > 0 else regular, 0),
    "stand_out": lambda regular, extreme, at: (extreme if at > 0 else regular, 0),
}


# ---------------------------------------------------------------- the comparison


def _check(op: Operation, args: list[Any], choice: dict[str, int]) -> None:
    with np.errstate(all="ignore"):
        found = op.run(*args, **choice)
    with mp.workdps(DIGITS):
        try:
            expected = REFERENCES[op.name](*map(_lift, args), **choice)
        except _Rounding:
            return
        parts = found if isinstance(found, tuple) else (found,)
        if expected is None:
            assert not all(np.isfinite(part).all() for part in parts), (op.name, args, found)
            return
        pairs = [(x, 0) if not isinstance(x, tuple) else (x, 1) for x in expected]
        due, bounds = ((pair[0],) if pair[1] == 0 else pair[0] for pair in pairs)
        for part, true, bound in zip(parts, due, bounds, strict=True):
            assert part.shape == (1, 1)
            item = complex(part[0, 0])
            off = abs(mp.mpc(item.real, item.imag) - true)
            assert off <= bound, (op.name, args, item, true, float(off), float(bound))


@pytest.mark.turns(6)
@pytest.mark.slow
@pytest.mark.parametrize("op", BASIC_OPERATIONS, ids=repr)
@settings(max_examples=most(100), deadline=None)
@given(data=st.data())
def test_as_exact_as_its_condition_allows(op: Operation, data: st.DataObject) -> None:
    args = data.draw(values(op))
    choice = {name: data.draw(st.sampled_from((1, -1))) for name in op.choices}
    _check(op, args, choice)


def test_every_operation_has_a_reference() -> None:
    assert sorted(op.name for op in BASIC_OPERATIONS) == sorted(REFERENCES)


@each("op", BASIC_OPERATIONS)
def test_a_mark_that_is_not_there_leaves_none(op: Operation) -> None:
    """NaN in any argument gives NaN, without a warning; other positions do not notice."""
    samples: dict[Any, Any] = {
        Point: lambda k: np.array([[1 + 2j, 0.5 + k, 3 + 1j * k]]),
        Line: lambda k: Line(
            np.array([[0j, 1j, 2.0 + k]]), np.exp(1j * np.array([[0.3, 1, 2]]) * k)
        ),
        Arc: lambda k: Arc(np.array([[0j, 1j, 2.0 + k]]), np.array([[3.0, 3.0, 3.0]])),
        Side: lambda k: np.array([[1.0, 1.0, -1.0]]),
        Length: lambda k: np.array([[0.5, 0.6, 0.7]]) * k,
        Angle: lambda k: np.array([[10.0, 20.0, 30.0]]) * k,
        Number: lambda k: np.array([[1.5, 2.5, 3.5]]) * k,
    }
    args = [samples[kind](k + 1) for k, kind in enumerate(op.takes)]
    choice = dict.fromkeys(op.choices, 1)
    with np.errstate(all="ignore"):
        before = op.run(*args, **choice)
        for k, kind in enumerate(op.takes):
            if op.name in ("stand", "stand_out"):
                continue  # takes one of two: the other need not be there
            hurt = list(args)
            whole = args[k] if isinstance(args[k], tuple) else (args[k],)
            bad = [np.where([[False, True, False]], np.nan * part, part) for part in whole]
            hurt[k] = kind(*bad) if isinstance(args[k], tuple) else bad[0]
            after = op.run(*hurt, **choice)
            olds, news = (x if isinstance(x, tuple) else (x,) for x in (before, after))
            for old, new in zip(olds, news, strict=True):
                np.testing.assert_array_equal(
                    np.broadcast_to(new, (1, 3))[:, [0, 2]], np.broadcast_to(old, (1, 3))[:, [0, 2]]
                )
            assert any(np.isnan(np.broadcast_to(new, (1, 3))[0, 1]) for new in news), (op, k)
