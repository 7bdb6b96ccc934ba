"""The arithmetic of ink: on plain numbers Python's own, on `traced` ones it keeps their expressions.

A rule that chooses by `chosen` has one expression for all cases; one that asks by ``if`` has one for each.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from graphic_tmm.paper.expressions import OVER_TURN, Expressions
from graphic_tmm.paper.traced import Traced, TracedRow, alone_of, node_of, untraced, value_at

MORE = 2.0
"""A row of strokes is traced so many times as long as it is: its length may grow."""


def bearing(way: complex) -> float:
    """Return the direction of a vector, degrees, counter-clockwise from the x axis."""
    return _of_one(way, "bearing") if _any(way) else math.degrees(cmath.phase(way))


def polar(length: float, degrees: float) -> complex:
    """Return the vector of a length in the direction of so many degrees."""
    if not _any(length, degrees):
        return cmath.rect(length, math.radians(degrees))
    way: complex = (
        _of_one(degrees, "heading") if _any(degrees) else cmath.rect(1.0, math.radians(degrees))
    )
    return length * way


def tangent(degrees: float) -> float:
    """Return the tangent of an angle."""
    return _of_one(degrees, "tangent") if _any(degrees) else math.tan(math.radians(degrees))


def arcsine(sine: float) -> float:
    """Return the angle of a sine, degrees."""
    return _of_one(sine, "arcsine") if _any(sine) else math.degrees(math.asin(sine))


def signed(size: float, like: float) -> float:
    """Return a number with the sign of another."""
    return abs(size) * _of_one(like, "sign") if _any(like) else math.copysign(size, like)


def smaller(*values: float) -> float:
    """Return the least of some numbers."""
    return _one_of("smaller", min, values)


def larger(*values: float) -> float:
    """Return the greatest of some numbers."""
    return _one_of("larger", max, values)


def below(first: float, second: float) -> float:
    """Return 1 where a number is less than another, else 0."""
    found = float(untraced(first).real < untraced(second).real)
    return _traced("less", found, first, second) if _any(first, second) else found


def either(first: float, second: float) -> float:
    """Return 1 where one of two is, else 0."""
    return larger(first, second)


def by_case(which: float, first: Any, second: Any) -> Any:
    """Return the first of two numbers or vectors where ``which`` is 1, the second where it is 0."""
    own = first if untraced(which).real else second
    if not _any(which) or first is second:
        return own
    return _traced("chosen", own, which, first, second)


def outermost(
    places: Sequence[tuple[float, bool]],
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the least and the greatest of some numbers, each with what is said of it."""
    if not _any(*(value for value, _ in places)):
        return min(places), max(places)
    low: tuple[float, float] = places[0]
    high = low
    for value, said in places[1:]:
        low = smaller(low[0], value), by_case(below(value, low[0]), said, low[1])
        high = larger(high[0], value), by_case(below(high[0], value), said, high[1])
    return low, high


def extremes(values: np.ndarray[Any, Any], there: Sequence[int]) -> tuple[float, float]:
    """Return the least and the greatest real part of a row, (trial, position), at some positions.

    Of a traced row those over all positions that can be drawn, or the number at the only one.
    """
    own = alone_of(values)[0].real
    own = own if own.size == 1 else own[list(there)]
    low, high = float(own.min()), float(own.max())
    if not (isinstance(values, TracedRow) and values.node is not None):
        return low, high
    if len(there) == 1:
        only = value_at(values, there[0]).real
        return only, only
    lowest, highest = (values.among.node(op, values.node) for op in OVER_TURN)
    ends: Any = Traced(low, values.among, lowest), Traced(high, values.among, highest)
    return ends  # type: ignore[no-any-return]


def counted(count: float) -> Iterator[int]:
    """Yield the whole numbers below a count; of a traced one more, each taken to be below it."""
    if not isinstance(count, Traced):
        yield from range(int(count))
        return
    among = count.among
    for k in range(int(MORE * count.value.real) + 1):
        begun = len(among.guards)
        among.guard(among.node("less", among.number(k), count.node), found=True, taken=True)
        yield k
        among.end(begun)


def decided(*comparisons: bool) -> None:
    """Take what comparisons of traced numbers tell of a decision that was made without them."""


def coordinates(places: Sequence[complex]) -> list[tuple[float, float]]:
    """Return places as plain pairs of coordinates."""
    return [(untraced(z).real, untraced(z).imag) for z in places]


def _any(*values: complex) -> bool:
    return any(isinstance(one, Traced) for one in values)


def _among(*values: complex) -> Expressions:
    return next(one.among for one in values if isinstance(one, Traced))


def _of_one(value: Any, op: str) -> Any:
    return value.of_one(op)


def _traced(op: str, value: complex, *of: complex) -> Any:
    """Return a number with the expression that it was made by."""
    among = _among(*of)
    return Traced(untraced(value), among, among.node(op, *(node_of(one, among) for one in of)))


def _one_of(op: str, choose: Callable[..., float], values: Sequence[float]) -> float:
    if not _any(*values):
        return choose(values)
    found = values[0]
    for one in values[1:]:
        value = choose(untraced(found).real, untraced(one).real)
        found = _traced(op, value, found, one) if _any(found, one) else value
    return found
