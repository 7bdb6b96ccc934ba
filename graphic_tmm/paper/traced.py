"""Numbers that know by which expression of marks they were calculated: ink is traced from its own rules.

A rule of ink takes places and lengths of one position and gives strokes. Handed `Traced` numbers it runs as it
is and its strokes have vertices that carry their expressions: so what a rule draws can be drawn again of other
values of the same marks, in the page, without a second description. What a rule compares is entered as a
`Guard`: the expression holds where all comparisons come out as they did.

What leaves these numbers (a float taken of them, a function of numpy) is a constant from there on; who ties ink
to marks tries it with other lengths and finds that out. Functions that keep expressions are in `arithmetic`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve
from graphic_tmm.paper.expressions import Expressions

NEARLY = 1e-9
"""What differs by no more is alike: rounding decides how it compares, and either way the same is drawn."""

_PLAIN: Mapping[str, Callable[[complex, complex], complex]] = {
    "plus": complex.__add__,
    "minus": complex.__sub__,
    "times": complex.__mul__,
    "over": complex.__truediv__,
}
_OF_ONE: Mapping[str, Callable[[complex], complex]] = {
    "conjugate": complex.conjugate,
    "real": lambda z: z.real,
    "imag": lambda z: z.imag,
    "abs": abs,
    "bearing": lambda z: math.degrees(cmath.phase(z)),
    "heading": lambda z: cmath.rect(1.0, math.radians(z.real)),
    "tangent": lambda z: math.tan(math.radians(z.real)),
    "arcsine": lambda z: math.degrees(math.asin(z.real)),
    "sign": lambda z: math.copysign(1.0, z.real),
    "floor": lambda z: math.floor(z.real),
    "round": lambda z: round(z.real, 6),
}
_NUMBERS = (int, float, complex)
_UFUNCS: Mapping[Any, str] = {
    np.add: "plus",
    np.subtract: "minus",
    np.multiply: "times",
    np.divide: "over",
    np.conjugate: "conjugate",
}


class Traced(complex):
    """A number and its expression, a node ``among`` others; ``seen``: how many guards there were by then."""

    __slots__ = ("among", "node", "seen")
    among: Expressions
    node: int
    seen: int

    def __new__(cls, value: complex, among: Expressions, node: int) -> Traced:
        """Return a value with its expression."""
        made = super().__new__(cls, value)
        made.among, made.node, made.seen = among, node, len(among.guards)
        return made

    @property
    def value(self) -> complex:
        """The number alone."""
        return complex.__pos__(self)

    @property
    def plain(self) -> complex:
        """The number alone, a real one as such."""
        return self.value.real if self._real else self.value

    @property
    def _real(self) -> bool:
        return self.among.real[self.node]

    def of_one(self, op: str) -> Any:
        """Return what an operation on one number makes of it."""
        return Traced(_OF_ONE[op](self.value), self.among, self.among.node(op, self.node))

    def _of_two(self, op: str, first: complex, second: complex) -> Any:
        if not (isinstance(first, _NUMBERS) and isinstance(second, _NUMBERS)):
            return NotImplemented
        among = self.among
        # most of what tracing costs is here: each number is looked at once
        if isinstance(first, Traced):
            a, m = complex.__pos__(first), first.node
        else:
            a = complex(first)
            m = among.number(a)
        if isinstance(second, Traced):
            b, n = complex.__pos__(second), second.node
        else:
            b = complex(second)
            n = among.number(b)
        return Traced(_PLAIN[op](a, b), among, among.node(op, m, n))

    def _nodes(self, *values: complex) -> list[int]:
        return [node_of(one, self.among) for one in values]

    def __add__(self, other: complex) -> Any:
        return self._of_two("plus", self, other)

    def __radd__(self, other: complex) -> Any:
        return self._of_two("plus", other, self)

    def __sub__(self, other: complex) -> Any:
        return self._of_two("minus", self, other)

    def __rsub__(self, other: complex) -> Any:
        return self._of_two("minus", other, self)

    def __mul__(self, other: complex) -> Any:
        return self._of_two("times", self, other)

    def __rmul__(self, other: complex) -> Any:
        return self._of_two("times", other, self)

    def __truediv__(self, other: complex) -> Any:
        return self._of_two("over", self, other)

    def __rtruediv__(self, other: complex) -> Any:
        return self._of_two("over", other, self)

    def __neg__(self) -> Any:
        return self._of_two("times", -1.0, self)

    def __pos__(self) -> Traced:
        return self

    def conjugate(self) -> Any:
        """Return the conjugate."""
        return self if self._real else self.of_one("conjugate")

    @property
    def real(self) -> Any:
        """The real part."""
        return self if self._real else self.of_one("real")

    @property
    def imag(self) -> Any:
        """The imaginary part."""
        return 0.0 if self._real else self.of_one("imag")

    def __abs__(self) -> Any:
        return self.of_one("abs")

    def __floor__(self) -> Any:
        return self.of_one("floor")

    def __ceil__(self) -> int:
        found = math.ceil(self.value.real)
        self._compared(found - 1, self, found=True)
        self._compared(found, self, found=False)
        return found

    def __round__(self, digits: int = 6) -> Any:
        return self.of_one("round")

    def __float__(self) -> float:
        return self.value.real

    def __int__(self) -> int:
        return int(self.value.real)

    def __bool__(self) -> bool:
        return self != 0.0

    def __format__(self, how: str) -> str:
        return format(self.plain, how)

    def __hash__(self) -> int:
        return hash(self.value)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _NUMBERS):
            return False
        if isinstance(other, Traced) and other.node == self.node:
            return True
        found = self.value == untraced(other)
        self._compared(0.0, abs(self - other), found=not found)
        return found

    def __ne__(self, other: object) -> bool:
        return not self == other

    def _compared(self, first: complex, second: complex, *, found: bool) -> bool:
        self.among.guard(self.among.node("less", *self._nodes(first, second)), found=found)
        return found

    def _less(self, first: complex, second: complex) -> bool:
        a, b = untraced(first).real, untraced(second).real
        return self._compared(first, second, found=a < b) if abs(b - a) > NEARLY else a < b

    def __lt__(self, other: Any) -> bool:
        return self._less(self, other)

    def __gt__(self, other: Any) -> bool:
        return self._less(other, self)

    def __le__(self, other: Any) -> bool:
        return not self._less(other, self) and not cmath.isnan(self)

    def __ge__(self, other: Any) -> bool:
        return not self._less(self, other) and not cmath.isnan(self)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **how: Any) -> Any:
        alone = not how and len(inputs) == 2 and all(np.ndim(one) == 0 for one in inputs)
        if method == "__call__" and alone and ufunc in _UFUNCS:
            return self._of_two(_UFUNCS[ufunc], *map(_scalar, inputs))
        return getattr(ufunc, method)(*map(alone_of, inputs), **how)


def untraced(number: complex) -> complex:
    """Return a number without its expression."""
    return number.value if isinstance(number, Traced) else complex(number)


def node_of(number: complex, among: Expressions) -> int:
    """Return the node of a number; of a plain one that of a constant."""
    return number.node if isinstance(number, Traced) else among.number(complex(number))


def _scalar(number: Any) -> complex:
    return number if isinstance(number, Traced) else complex(number)


class TracedRow(np.ndarray[Any, Any]):
    """The values of an expression, (trial, position); ``node`` is None of what was made of them otherwise."""

    among: Expressions
    node: int | None = None

    def __array_finalize__(self, of: Any) -> None:
        """Let what numpy makes of a row have no expression."""
        self.node = None

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **how: Any) -> Any:
        found = getattr(ufunc, method)(*map(alone_of, inputs), **how)
        among = next(
            (z.among for z in inputs if isinstance(z, TracedRow) and z.node is not None), None
        )
        if among is None or method != "__call__" or how or ufunc not in _UFUNCS:
            return found
        nodes = [
            (one.node if isinstance(one, TracedRow) else None)
            if np.ndim(one)
            else node_of(_scalar(one), among)
            for one in inputs
        ]
        told = [node for node in nodes if node is not None]
        return (
            row(found, among, among.node(_UFUNCS[ufunc], *told))
            if len(told) == len(nodes)
            else found
        )


def row(values: Any, among: Expressions, node: int) -> TracedRow:
    """Return values as those of an expression."""
    made: TracedRow = np.asarray(values).view(TracedRow)
    made.among, made.node = among, node
    return made


def alone_of(value: Any) -> Any:
    """Return numbers without their expression."""
    if isinstance(value, TracedRow):
        return value.view(np.ndarray)
    return value.plain if isinstance(value, Traced) else value


def value_at(values: np.ndarray[Any, Any], k: int) -> complex:
    """Return the value of a row, (trial, position), in one position: traced if the row is."""
    value = complex(values[0, k if values.shape[1] > 1 else 0])
    if isinstance(values, TracedRow) and values.node is not None:
        return Traced(value, values.among, values.node)
    return value


class TracedReading(Reading):
    """The numbers of marks, each with its expression."""

    among: Expressions

    def __getitem__(self, mark: Mark) -> Any:
        """Return the value of a mark, whose parts know that they are its."""
        value = self.values[mark.slot]
        if isinstance(value, Curve):
            return value
        if isinstance(value, tuple):
            return type(value)(*(self._row(part, mark, k) for k, part in enumerate(value)))
        return self._row(value, mark, 0)

    def _row(self, values: Any, mark: Mark, part: int) -> TracedRow:
        node = self.among.node("mark", mark.slot, part, real=not np.iscomplexobj(values))
        return row(values, self.among, node)


def traced(reading: Reading, among: Expressions) -> Reading:
    """Return the numbers of a reading, each with its expression."""
    made = TracedReading(reading.values, reading.positions, reading.doubts, reading.places)
    object.__setattr__(made, "among", among)
    return made
