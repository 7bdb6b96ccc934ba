r"""Reads a formula as it stands in a note, in TeX, and works it out with the figures printed.

It knows nothing of the package: a person with a calculator. Every figure stands for what may have been rounded
to it, so a value comes with how far it may be off.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from typing import NamedTuple

DIGITS = 4
"""Figures are printed to so many significant digits, without noughts at the end."""


class Worked(NamedTuple):
    """What a formula comes to with the figures printed, and how far off their rounding may put it."""

    value: float
    off: float


class Unread(Exception):
    """There are letters in it, or it is no formula."""


_TOKEN = re.compile(
    r"\\text\{(?P<word>[^{}]*)\}|\\mathrm\{(?P<upright>\w+)\}|\\(?P<command>[A-Za-z]+|.)"
    r"|(?P<figure>\d+(?:(?:\{,\}|\.)\d+)?)|(?P<sign>[-−+^{}()|,])|(?P<other>\S)"
)
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "arcsin": lambda x: math.degrees(math.asin(x)),
    "arccos": lambda x: math.degrees(math.acos(x)),
    "arctan": lambda x: math.degrees(math.atan(x)),
    "sgn": lambda x: float((x > 0) - (x < 0)),
    "inv": lambda x: math.tan(x) - x,
}
_TURNED = ("sin", "cos", "tan", "inv")
"""These take an angle: in degrees if it is told so."""
_SPACES = {"", " ", ",", "quad", "qquad", ";"}
_BRACKETS = {"(": ")", "|": "|", "lceil": "rceil", "lfloor": "rfloor"}


_RUSSIAN = re.compile(r"(?<![\\\w{])(arc)?tg(?=[( ])|\\operatorname\{(arc)?tg\}")


def with_tan(formula: str) -> str:
    """Return a formula with tangents as English calls them."""
    return _RUSSIAN.sub(
        lambda found: "\\" * (found[0][0] == "\\") + f"{found[1] or found[2] or ''}tan", formula
    )


def sides_of(formula: str) -> list[str]:
    """Return the sides of an equation, whatever stands in brackets aside."""
    found, depth, start = list[str](), 0, 0
    for at, c in enumerate(formula):
        depth += {"{": 1, "}": -1}.get(c, 0)
        if c == "=" and not depth:
            found.append(formula[start:at])
            start = at + 1
    return [side.strip() for side in (*found, formula[start:])]


def worked_out(side: str) -> Worked:
    """Return the value of a side, its unit left aside.

    Raises
    ------
    Unread
        If a letter stands in it.
    """
    figures = _Reader(side)
    value = figures.whole([])
    off = 0.0
    for k, half in enumerate(figures.halves):
        moved = []
        for way in (-half, half):
            shift = [0.0] * len(figures.halves)
            shift[k] = way
            try:
                moved.append(abs(_Reader(side).whole(shift) - value))
            except (ValueError, ZeroDivisionError, OverflowError):
                moved.append(math.inf)
        off += max(moved)
    return Worked(value, off)


def half_of(told: str) -> float:
    """Return half of the last digit that a figure carries: noughts behind four digits are left out.

    One with one decimal may be a length as a ruler of 0.1 mm reads it.
    """
    plain = told.replace("{,}", ".")
    value = abs(float(plain))
    whole, _, rest = plain.partition(".")
    if len(rest) == 1 or rest.endswith("0") or (not value and rest):
        return 0.5 * 10.0 ** -len(rest)
    if not value:
        return 0.0
    if len(whole) >= DIGITS - 1 and not rest:  # three digits are printed of what a table holds
        return 0.5
    return float(0.5 * 10.0 ** (math.floor(math.log10(value)) + 1 - DIGITS))


class _Reader:
    """Reads one side from left to right, moving each figure by what it is told to."""

    def __init__(self, side: str) -> None:
        self.tokens = [
            (kind, match[kind])
            for match in _TOKEN.finditer(with_tan(side))
            if (kind := str(match.lastgroup)) != "command" or match[kind] not in _SPACES
        ]
        self.at, self.halves = 0, list[float]()
        self.shift: Sequence[float] = ()

    def whole(self, shift: Sequence[float]) -> float:
        self.shift = shift
        value = self.sum()
        rest = self.tokens[self.at :]
        if len(rest) > 1 or any(kind != "word" for kind, _ in rest):
            raise Unread(rest)
        return value

    def peek(self) -> tuple[str, str]:
        return self.tokens[self.at] if self.at < len(self.tokens) else ("", "")

    def take(self, *wanted: str) -> bool:
        if self.peek()[1] in wanted and self.peek()[0] in ("sign", "command"):
            self.at += 1
            return True
        return False

    def need(self, wanted: str) -> None:
        if not self.take(wanted):
            raise Unread(wanted, self.tokens[self.at :])

    def sum(self) -> float:
        value = self.product()
        while True:
            if self.take("+"):
                value += self.product()
            elif self.take("-", "−"):
                value -= self.product()
            elif self.take("pm"):
                self.product()
            else:
                return value

    def product(self) -> float:
        value = self.signed()
        while True:
            if self.take("cdot"):
                value *= self.signed()
            elif self.peek() == ("other", "/"):
                self.at += 1
                value /= self.signed()
            else:
                return value

    def signed(self) -> float:
        return -self.signed() if self.take("-", "−") else self.power()

    def power(self) -> float:
        base = self.atom()
        if not self.take("^"):
            return base
        told = self.tokens[self.at + 1 : self.at + 3]
        if told[0][0] == "figure" and told[1][1] == "}" and told[0][1].isdigit():
            self.at += 3  # a whole power is what it is
            return float(base ** int(told[0][1]))
        return float(base ** self.braced())

    def braced(self) -> float:
        self.need("{")
        value = self.sum()
        self.need("}")
        return value

    def atom(self) -> float:
        kind, text = self.peek()
        self.at += 1
        if kind == "figure":
            return self.figure(text)
        if kind == "word":
            return self.word(text)
        if text in _FUNCTIONS:
            return self.called(text)
        if text == "{":
            self.at -= 1
        ways: dict[str, Callable[[], float]] = {
            "{": self.braced,
            "left": self.bracket,
            "(": self.closed,
            "frac": lambda: self.braced() / self.braced(),
            "sqrt": lambda: math.sqrt(self.braced()),
            "pi": lambda: math.pi,
            "max": lambda: self.chosen(max),
            "min": lambda: self.chosen(min),
        }
        if text not in ways:
            raise Unread(text)
        return ways[text]()

    def closed(self) -> float:
        value = self.sum()
        self.need(")")
        return value

    def figure(self, text: str) -> float:
        self.halves.append(half_of(text))
        value = float(text.replace("{,}", "."))
        return value + (self.shift[len(self.halves) - 1] if self.shift else 0.0)

    def word(self, text: str) -> float:
        """An angle, or a percentage, which is written as one word."""
        found = re.fullmatch(r"([-−]?)(\d+(?:[.,]\d+)?)([°%])", text)
        if not found:
            raise Unread(text)
        value = self.figure(found[2].replace(",", "."))
        return -value if found[1] else value

    def bracket(self) -> float:
        kind = self.peek()[1]
        if kind not in _BRACKETS:
            raise Unread(kind)
        self.at += 1
        value = self.sum()
        self.need("right")
        self.need(_BRACKETS[kind])
        told = {"|": abs, "lceil": math.ceil, "lfloor": math.floor}
        return float(told[kind](value)) if kind in told else value

    def chosen(self, choose: Callable[[float, float], float]) -> float:
        self.take("left")
        self.need("(")
        value = self.sum()
        while self.take(","):
            value = choose(value, self.sum())
        self.take("right")
        self.need(")")
        return value

    def called(self, name: str) -> float:
        raised = self.braced() if self.take("^") else 1.0
        start = self.at
        value = self.power()
        if name in _TURNED and self.degrees(start):
            value = math.radians(value)
        return float(_FUNCTIONS[name](value) ** raised)

    def degrees(self, start: int) -> bool:
        """Whether an argument that began there is told in degrees."""
        return any("°" in text for _, text in self.tokens[start : self.at])
