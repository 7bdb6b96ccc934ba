"""Reads the printed text of a formula as a person with a calculator of fifty digits would.

It knows nothing of the package's reader. The text becomes a line of Python by substitutions, worked out on
numbers that carry how far a float may be from them after every rounding on the way. A degree is the number
π/180, so that an angle is what it is, in whatever unit it is told.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from typing import Any

from mpmath import mp  # type: ignore[import-untyped]

DIGITS = 50
UNIT = mp.mpf(2) ** -53
"""What one rounding changes, as a share."""
CALL = 4 * UNIT
"""What a function of the C library, or of numpy's own, is off, as a share."""
_POWERS = dict(zip("²³⁴⁵⁶⁷⁸⁹", "23456789", strict=True))


class Undecided(Exception):
    """Rounding decides whether there is an answer, or which."""


def expression(text: str) -> str:
    """Return the text of a formula, or of a condition, as Python; a mark {x} is ``V["x"]``."""
    text, *clauses = re.split(r",\s+(?=\w+ = )", text)
    for clause in clauses:
        name, _, meaning = clause.partition(" = ")
        text = re.sub(rf"(?<![\w{{]){name}(?![\w}}])", f"({meaning})", text)
    text = text.partition("±")[0].rstrip()
    text = re.sub(r"\b([a-z]+)([²³])\s*(\{\w+\})", r"(\1(\3))\2", text)
    text = re.sub(r"\b([a-z]+) (\{\w+\})", r"\1(\2)", text)
    text = re.sub(r"⌈([^⌉]+)⌉", r"ceil(\1)", text)
    text = re.sub(r"⌊([^⌋]+)⌋", r"floor(\1)", text)
    text = re.sub(r"√(\{\w+\})", r"sqrt(\1)", text).replace("√(", "sqrt(")
    text = re.sub(r"\|([^|]+)\|", r"abs(\1)", text)
    text = re.sub(r"\{(\w+)\}", r'V["\1"]', text)
    text = re.sub(r"(\d)π", r"\1*pi", text)
    text = re.sub(r"([\d.]+)°", r"(\1*degree)", text)
    for sign, word in {
        "−": "-",
        "·": "*",
        "^": "**",
        "π": "pi",
        "≠": "!=",
        "≥": ">=",
        "≤": "<=",
    }.items():
        text = text.replace(sign, word)
    return re.sub("[²³⁴⁵⁶⁷⁸⁹]", lambda m: f"**{_POWERS[m[0]]}", text)


def worked_out(text: str, values: Mapping[str, Any]) -> Any:
    """Return the value of a formula's text (or whether all of a condition holds), with what it may be off."""
    found = eval(f"({expression(text)},)", {**_FUNCTIONS, "V": values})
    return found[0] if len(found) == 1 else all(found)


class Rounded:
    """A number, and how far a float that came this way may be from it."""

    def __init__(self, value: Any, off: Any = 0) -> None:
        self.value, self.off = mp.mpf(value), mp.mpf(off)

    def __add__(self, other: Any) -> Rounded:
        b = _of(other)
        off = self.off + b.off
        return Rounded(self.value + b.value, off + UNIT * (abs(self.value + b.value) + off))

    def __mul__(self, other: Any) -> Rounded:
        b, value = _of(other), self.value * _of(other).value
        off = abs(self.value) * b.off + abs(b.value) * self.off + self.off * b.off
        return Rounded(value, off + UNIT * (abs(value) + off))

    def __truediv__(self, other: Any) -> Rounded:
        b = _of(other)
        least = abs(b.value) - b.off
        if least <= 0:
            raise Undecided
        value = self.value / b.value
        off = (self.off + abs(value) * b.off) / least
        return Rounded(value, off + UNIT * (abs(value) + off))

    def __pow__(self, other: Any) -> Rounded:
        b = _of(other)
        if self.value - self.off <= 0 and (b.off or b.value != int(b.value)):
            raise Undecided
        ends = [
            (self.value + s * self.off) ** (b.value + t * b.off) for s in (-1, 1) for t in (-1, 1)
        ]
        value = self.value**b.value
        return Rounded(value, max(abs(end - value) for end in ends) + CALL * abs(value))

    def __neg__(self) -> Rounded:
        return Rounded(-self.value, self.off)

    def __sub__(self, other: Any) -> Rounded:
        return self + -_of(other)

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other: Any) -> Rounded:
        return _of(other) - self

    def __rtruediv__(self, other: Any) -> Rounded:
        return _of(other) / self

    def __abs__(self) -> Rounded:
        return Rounded(abs(self.value), self.off)

    def sign(self) -> int:
        """Which side of zero it is on, for sure."""
        if self.off and abs(self.value) <= self.off:
            raise Undecided
        return int(mp.sign(self.value))

    def __lt__(self, other: Any) -> bool:
        return (self - other).sign() < 0

    def __le__(self, other: Any) -> bool:
        return (self - other).sign() <= 0

    def __gt__(self, other: Any) -> bool:
        return (self - other).sign() > 0

    def __ge__(self, other: Any) -> bool:
        return (self - other).sign() >= 0

    def __ne__(self, other: object) -> bool:
        return (self - other).sign() != 0

    __hash__ = None  # type: ignore[assignment]


def _of(value: Any) -> Rounded:
    return value if isinstance(value, Rounded) else Rounded(value)


def degrees(value: float) -> Rounded:
    """An angle of so many degrees."""
    return Rounded(value) * DEGREE


def _growing(function: Callable[[Any], Any]) -> Callable[[Any], Rounded]:
    """A function that grows, or falls, between where its argument may be."""

    def called(x: Any) -> Rounded:
        x = _of(x)
        ends = [function(x.value + s * x.off) for s in (-1, 0, 1)]
        if any(mp.im(end) for end in ends):
            raise Undecided
        off = max(abs(ends[0] - ends[1]), abs(ends[2] - ends[1]))
        return Rounded(ends[1], off + CALL * abs(ends[1]))

    return called


def _wave(function: Callable[[Any], Any]) -> Callable[[Any], Rounded]:
    def called(x: Any) -> Rounded:
        x = _of(x)
        return Rounded(function(x.value), x.off + CALL * abs(function(x.value)))

    return called


def _whole(function: Callable[[Any], Any]) -> Callable[[Any], Rounded]:
    def called(x: Any) -> Rounded:
        if function(x.value - x.off) != function(x.value + x.off):
            raise Undecided
        return Rounded(function(x.value))

    return called


def _one_of(choose: Callable[..., Any]) -> Callable[[Any, Any], Rounded]:
    def called(a: Any, b: Any) -> Rounded:
        a, b = _of(a), _of(b)
        return Rounded(choose(a.value, b.value), max(a.off, b.off))

    return called


def _inv(x: Rounded) -> Rounded:
    """tan x − x: by its series at small angles, else with the rounding of tan x."""
    found = _growing(lambda a: mp.tan(a) - a)(x)
    return Rounded(
        found.value,
        found.off
        + 32 * UNIT * abs(found.value)
        + CALL * abs(mp.tan(x.value)) * (abs(x.value) > 0.09),
    )


def _arcinv(x: Rounded) -> Rounded:
    if x.value <= 0:
        raise Undecided
    start = mp.atan(x.value + mp.pi / 2) if x.value > 0.1 else mp.cbrt(3 * x.value)
    angle = mp.findroot(lambda a: mp.tan(a) - a - x.value, start)
    # an error of inv α comes back divided by its slope, tan² α
    passed = max(32 * UNIT * x.value, CALL * mp.tan(angle)) / mp.tan(angle) ** 2
    return Rounded(angle, passed + CALL * angle)


_FUNCTIONS: dict[str, Any] = {
    "__builtins__": {},
    "abs": abs,
    "sqrt": _growing(mp.sqrt),
    "sin": _wave(mp.sin),
    "cos": _wave(mp.cos),
    "tan": _growing(mp.tan),
    "arcsin": _growing(mp.asin),
    "arccos": _growing(mp.acos),
    "arctan": _growing(mp.atan),
    "ln": _growing(mp.log),
    "inv": _inv,
    "arcinv": _arcinv,
    "ceil": _whole(mp.ceil),
    "floor": _whole(mp.floor),
    "min": _one_of(min),
    "max": _one_of(max),
    "sgn": lambda x: Rounded(x.sign()),
    "gcd": lambda a, b: Rounded(math.gcd(int(a.value), int(b.value))),
}
with mp.workdps(DIGITS):
    _FUNCTIONS["pi"] = Rounded(mp.pi, UNIT * mp.pi)
    DEGREE = Rounded(mp.pi / 180, 3 * UNIT * mp.pi / 180)
    _FUNCTIONS["degree"] = DEGREE
