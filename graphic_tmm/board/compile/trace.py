"""What operations compute, noted on a tape: their own functions, called with numbers that are not known yet.

No operation is described anew: its function runs as it stands, with numpy's functions, and the few helpers of
`geometry` that look at numbers, replaced by such as note what they would do. A complex number is two real ones.
Nobody may ask what is not known.
"""

from __future__ import annotations

import operator
import types
from collections.abc import Callable
from functools import partial
from typing import Any, NewType

import numpy as np

from graphic_tmm.board import geometry
from graphic_tmm.board.compile.tape import Part, Ref, Tape
from graphic_tmm.board.source import globals_of


class NotTraced(Exception):
    """An operation looks at numbers that are not known yet, or does what the tape has no pass for."""


class _Unknown:
    """What is not known yet: nobody may ask it anything."""

    __slots__ = ()
    __array_ufunc__ = None
    __hash__ = None  # type: ignore[assignment]

    def _undecided(self, *_: object) -> Any:
        raise NotTraced(type(self).__name__)

    __bool__ = __float__ = __int__ = __complex__ = __index__ = _undecided
    __iter__ = __len__ = __getitem__ = __array__ = __getattr__ = _undecided


class Mask(_Unknown):
    """A truth for every position."""

    __slots__ = ("node", "tape")

    def __init__(self, tape: Tape, node: int) -> None:
        self.tape, self.node = tape, node

    def _with(self, does: str, *others: object) -> Mask:
        if not all(isinstance(other, Mask) for other in others):
            raise NotTraced(does)
        nodes = [other.node for other in others]  # type: ignore[attr-defined]
        return Mask(self.tape, self.tape.note(does, self.node, *nodes))

    def __and__(self, other: object) -> Mask:
        return self._with("logical_and", other)

    def __or__(self, other: object) -> Mask:
        return self._with("logical_or", other)

    def __invert__(self) -> Mask:
        return self._with("logical_not")


class Value(_Unknown):
    """A number for every position: real where the imaginary part is nothing, and the real part is not."""

    __slots__ = ("im", "re", "tape")

    def __init__(self, tape: Tape, re: Part, im: Part = None) -> None:
        self.tape, self.re, self.im = tape, re, im

    @property
    def real(self) -> Value:
        """The real part."""
        return Value(self.tape, 0.0 if self.re is None else self.re)

    @property
    def imag(self) -> Value:
        """The imaginary part."""
        return Value(self.tape, 0.0 if self.im is None else self.im)

    def conj(self) -> Value:
        """Return the conjugate."""
        return Value(self.tape, self.re, self.tape.opposite(self.im))

    def part(self) -> Part:
        """Return the only part of a real number."""
        if self.im is not None or self.re is None:
            raise NotTraced("a complex number")
        return self.re

    def _of(self, other: object) -> Value:
        return valued(self.tape, other)

    def __neg__(self) -> Value:
        return Value(self.tape, self.tape.opposite(self.re), self.tape.opposite(self.im))

    def __pos__(self) -> Value:
        return self

    def __add__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        return Value(tape, tape.plus(self.re, b.re), tape.plus(self.im, b.im))

    __radd__ = __add__

    def __sub__(self, other: object) -> Value:
        return self + -self._of(other)

    def __rsub__(self, other: object) -> Value:
        return self._of(other) + -self

    def __mul__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        return Value(
            tape,
            tape.minus(tape.times(self.re, b.re), tape.times(self.im, b.im)),
            tape.plus(tape.times(self.re, b.im), tape.times(self.im, b.re)),
        )

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Value:
        b, tape = self._of(other), self.tape
        if b.im is None:
            return Value(tape, tape.over(self.re, b.re), tape.over(self.im, b.re))
        if length := tape.there("length", *b._bare()):
            # what is known by its length is known by its direction too
            near = 1.0 / Value(tape, length)
            return self * (b * near).conj() * near
        # by the larger part, so that no square leaves the range of numbers
        large = Value(tape, tape.call("maximum", *(tape.call("absolute", p) for p in (b.re, b.im))))
        low = b / large
        size = Value(tape, tape.plus(tape.times(b.re, low.re), tape.times(b.im, low.im)))
        return self * low.conj() * (1.0 / size)

    def __rtruediv__(self, other: object) -> Value:
        return self._of(other) / self

    def __pow__(self, other: object) -> Value:
        if isinstance(other, int | float) and other in (2, 3, 4):
            square = self * self
            return square if other == 2 else square * (self if other == 3 else square)
        return Value(self.tape, self.tape.call("power", self.part(), self._of(other).part()))

    def __rpow__(self, other: object) -> Value:
        return self._of(other) ** self

    def __abs__(self) -> Value:
        if self.im is None:
            return Value(self.tape, self.tape.call("absolute", self._bare()[0]))
        return Value(self.tape, self.tape.call("length", *self._bare()))

    def _bare(self) -> list[Part]:
        """Return both parts without signs before them."""
        return [Ref(p.node) if isinstance(p, Ref) else p for p in (self.re, self.im)]

    def _compared(self, does: str, other: object) -> Mask:
        b = self._of(other)
        return Mask(self.tape, self.tape.compare(does, self.part(), b.part()))

    def __lt__(self, other: object) -> Mask:
        return self._compared("less", other)

    def __le__(self, other: object) -> Mask:
        return self._compared("less_equal", other)

    def __gt__(self, other: object) -> Mask:
        return self._compared("greater", other)

    def __ge__(self, other: object) -> Mask:
        return self._compared("greater_equal", other)

    def __eq__(self, other: object) -> Mask:  # type: ignore[override]
        b, tape = self._of(other), self.tape
        found = Mask(tape, tape.compare("equal", self.re, b.re))
        if self.im is None and b.im is None:
            return found
        return found & Mask(tape, tape.compare("equal", self.im, b.im))

    def __ne__(self, other: object) -> Mask:  # type: ignore[override]
        return ~(self == other)


def valued(tape: Tape, value: object) -> Value:
    """Return a known number as one on a tape; what is on it already, as it is."""
    if isinstance(value, Value):
        return value
    if isinstance(value, int | float):
        return Value(tape, float(value))
    if isinstance(value, complex):
        return Value(tape, value.real or None, value.imag or None)
    raise NotTraced(repr(value))


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
