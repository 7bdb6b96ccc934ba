"""What operations compute, noted on a tape: their own functions, called with numbers that are not known yet.

No operation is described anew: its function runs as it stands, with numpy's functions, and the few helpers of
`geometry` that look at numbers, replaced by such as note what they would do.
"""

from __future__ import annotations

import operator
import types
from collections.abc import Callable
from functools import partial
from typing import Any, NewType

import numpy as np

from graphic_tmm.board import geometry
from graphic_tmm.board.source import globals_of
from graphic_tmm.board.tape import Tape
from graphic_tmm.board.unknown import Mask, NotTraced, Value, valued

REFUSED = (
    *(NotTraced, TypeError, ValueError, AttributeError, NameError, LookupError, ArithmeticError),
)
"""How an operation fails that cannot be noted: what it calls may refuse an unknown number in its own way."""


def _tape_of(*values: Any) -> Tape | None:
    return next((value.tape for value in values if isinstance(value, Value | Mask)), None)


def _noting(name: str) -> Callable[..., Any]:
    """Return the function of numpy of that name, of real numbers; noted where they are not known."""

    def function(*values: Any) -> Any:
        tape = _tape_of(*values)
        if tape is None:
            return float(getattr(np, name)(*values))
        return Value(tape, tape.call(name, *(valued(tape, value).part() for value in values)))

    return function


def _telling(name: str, together: str) -> Callable[[Any], Any]:
    """Return the function of numpy that tells what a number is: of a complex one, by both its parts."""

    def function(value: Any) -> Any:
        if not isinstance(value, Value):
            raise NotTraced(name)
        tape = value.tape
        parts = (part for part in (value.re, value.im) if part is not None)
        nodes = [tape.note(name, tape.plain(part)) for part in parts]
        return Mask(tape, nodes[0] if len(nodes) == 1 else tape.note(together, *nodes))

    return function


def _where(mask: Any, first: Any, second: Any) -> Any:
    if not isinstance(mask, Mask):
        raise NotTraced("where")
    if isinstance(first, Mask):
        return (mask & first) | (~mask & second)
    tape = mask.tape
    a, b = valued(tape, first), valued(tape, second)
    re = tape.choose(mask.node, a.re, b.re)
    if a.im is None and b.im is None:
        return Value(tape, re)
    return Value(tape, re, tape.choose(mask.node, a.im, b.im))


def _itself(value: Any, *_: Any, **__: Any) -> Any:
    return value


def _vector(x: Any, y: Any) -> Any:
    tape = _tape_of(x, y)
    if tape is None:
        return complex(x, y)
    return Value(tape, valued(tape, x).part(), valued(tape, y).part())


def _quadrant(quarters: Any) -> Any:
    rest = quarters - 4.0 * _NUMPY.floor(quarters * 0.25)
    x = _where(rest == 0.0, 1.0, _where(rest == 2.0, -1.0, 0.0))
    return _vector(x, _where(rest == 1.0, 1.0, _where(rest == 3.0, -1.0, 0.0)))


def _true(_: Any) -> bool:
    # nobody knows yet: what is done where a mask is true somewhere is done by that mask
    return True


class _Numpy:
    """What stands for numpy in a function that is noted."""

    pi, nan, inf = float(np.pi), float(np.nan), float(np.inf)
    float64 = staticmethod(_itself)
    asarray = array = staticmethod(_itself)
    where = staticmethod(_where)
    abs = absolute = staticmethod(abs)
    isnan = staticmethod(_telling("isnan", "logical_or"))
    isfinite = staticmethod(_telling("isfinite", "logical_and"))
    conj = conjugate = staticmethod(Value.conj)
    square = staticmethod(lambda z: z * z)
    add, subtract, multiply = operator.add, operator.sub, operator.mul
    divide, negative, power = operator.truediv, operator.neg, operator.pow
    less, less_equal, greater = operator.lt, operator.le, operator.gt
    greater_equal, equal, not_equal = operator.ge, operator.eq, operator.ne
    logical_and, logical_or, logical_not = operator.and_, operator.or_, operator.invert

    def __getattr__(self, name: str) -> Any:
        if name not in _FUNCTIONS:
            raise NotTraced(f"numpy's {name}")
        return _noting(name)


_FUNCTIONS = frozenset(
    {
        *("sqrt", "cbrt", "exp", "log", "sign", "floor", "ceil", "rint", "copysign"),
        *("maximum", "minimum", "fmin", "fmax", "hypot", "radians", "degrees"),
        *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2"),
    }
)
"""Functions of numpy of real numbers that are passes; a remainder is none, for it leaps by rounding alone."""
_NUMPY = _Numpy()


_KNOWN: dict[Callable[..., Any], Callable[..., Any]] = {
    geometry.vector: _vector,
    geometry.reverse: operator.neg,
    # nothing looks at all positions first: that would cost more than it saves
    geometry.sine: geometry.series_of_sine,
    geometry.some: _true,
    geometry.pick: _where,
    geometry.quadrant: _quadrant,
}
"""What functions stand for on a tape; those that were met join them."""


def traced(function: Any) -> Any:
    """Return what a function, or another name of its module, stands for: the same code on a tape."""
    if isinstance(function, NewType):
        return _itself
    if isinstance(function, partial):
        return partial(traced(function.func), **function.keywords)
    if not isinstance(function, types.FunctionType) or function.__closure__:
        return function
    if function not in _KNOWN:
        space: dict[str, Any] = {}
        made = types.FunctionType(
            function.__code__, space, function.__name__, function.__defaults__
        )
        made.__kwdefaults__ = function.__kwdefaults__
        # before its names are looked at: one of them may lead back to it
        _KNOWN[function] = made
        for name in globals_of(function):
            value = function.__globals__[name]
            known = isinstance(value, NewType | types.FunctionType)
            space[name] = _NUMPY if value is np else (traced(value) if known else value)
    return _KNOWN[function]
