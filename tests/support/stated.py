"""Puts the values that were stated before into an equation by letters, as a person with a calculator would.

It reads what is printed, in TeX, as lettering or as plain text, and knows nothing of the package. A letter has
the value that was stated last; one that was never stated (an arm read off a figure) that of the line of figures
that belongs to the equation. What figures were rounded by tells how far off a sum may be.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from support.tex_sums import DIGITS, Unread, Worked, _Reader, half_of, sides_of, with_tan

SPARE = 1.02
_STRUCTURE = frozenset(
    re.findall(
        r"\S+",
        "frac left right cdot sqrt text mathrm quad qquad pm lceil rceil lfloor rfloor max min "
        "sin cos tan sgn inv arcsin arccos arctan , ;",
    )
)
"""Commands of TeX that are no letters."""
_NOT_READ = (Unread, IndexError, ValueError, TypeError, ZeroDivisionError, OverflowError)
_WHOLE = 7
"""A whole figure of more digits is told with a power of ten."""
_CALLED = re.compile(r"(?<![\\\w{])(sgn|sin|cos|tan)(?=\()")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_TEN = re.compile(r"(\d+(?:\.(\d+))?)\s*\\cdot\s*10\^\{\s*([-−]?\d+)\s*\}")
_BOXED = re.compile(r"\[([^\[\]·+−=/-]+)\]")
"""The length of a quantity on paper, in brackets: a letter of its own."""
_PLAIN = str.maketrans({"·": r" \cdot ", "[": "(", "]": ")"})
_UNIT = re.compile(r"\s*(?:\\text\{[^{}\d]*\}|(?<=\d)\s+[^\d\s\\(·+−=%-][^+−=()]*)\s*$")


class Stated(NamedTuple):
    """A value as it was stated, how far off its last digit may put it, whether it is one in degrees."""

    value: float
    half: float
    turned: bool = False

    def is_of(self, size: Stated) -> bool:
        """Whether it may be so large."""
        return abs(abs(self.value) - size.value) <= SPARE * (self.half + size.half)


Known = Mapping[str, Stated]
Leaf = tuple[str, str, bool]
"""A letter or a figure, as it stands there, and whether a minus of its own stands before it."""


class _Letters(_Reader):
    """Reads a side with letters; ``seen`` are those that it met, in their order."""

    def __init__(self, side: str, known: Known) -> None:
        super().__init__(side)
        self.known, self.seen = known, list[str]()
        self.leaves: list[tuple[str, str, bool]] = []
        self.moved: Mapping[str, float] = {}

    def atom(self) -> float:
        if self.take("|"):
            return self._size("|")
        if self.peek() == ("command", "left") and self.tokens[self.at + 1][1] == "|":
            self.at += 2
            value = self._size("right")
            self.need("|")
            return value
        start = self.at
        name = self._name()
        return self._value(name, self.at - start) if name else super().atom()

    def _size(self, end: str) -> float:
        """The size of what stands in bars; of a letter of which only that was stated, too."""
        start = self.at
        name = self._name()
        if name and self.take(end):
            size = f"|{name}|"
            short = name in self.known or size not in self.known
            return abs(self._value(name if short else size, self.at - start))
        self.at = start
        value = self.sum()
        self.need(end)
        return abs(value)

    def figure(self, text: str) -> float:
        self._leaf("figure", text, 1)
        return super().figure(text)

    def degrees(self, start: int) -> bool:
        inside = _Letters("", self.known)
        inside.tokens, inside.at = self.tokens[start : self.at], 0
        inside.sum()
        if inside.seen and not all(self.known[name].turned for name in inside.seen):
            raise Unread(inside.seen[0])  # in degrees or not: a letter does not say it
        return bool(inside.seen) or super().degrees(start)

    def word(self, text: str) -> float:
        value = super().word(text)
        kind, figure, _ = self.leaves.pop()
        unit = "°" if text.endswith("°") and not figure.endswith("°") else ""
        self.leaves.append((kind, figure + unit, value < 0))
        return value

    def _leaf(self, kind: str, text: str, tokens: int) -> None:
        """Enter a leaf; a minus in a bracket, or where a side begins, is its own."""
        before = [one for _, one in self.tokens[: self.at - tokens]]
        own = False
        while before and before[-1] in (*"-−({|", "left"):
            sign = before.pop()
            if sign in "-−" and (not before or before[-1] in (*"-−({|", "left")):
                own = not own
        self.leaves.append((kind, text, own))

    def _value(self, name: str, tokens: int) -> float:
        self.seen.append(name)
        self._leaf("letter", name, tokens)
        if name not in self.known:
            raise Unread(name)
        return self.known[name].value + self.moved.get(name, 0.0)

    def _name(self) -> str:
        """Return the letter that begins here with all its indices, "" if none does."""
        start = self.at
        kind, text = self.peek()
        if not self._letter(kind, text) or (text == "pi" and not self._followed()):
            return ""
        while self.at < len(self.tokens):
            kind, text = self.peek()
            if self._letter(kind, text) or kind in ("figure", "upright") or text in ("_", "'", "′"):
                self.at += 1
            elif text == "{" and self.tokens[self.at - 1][1] in ("_", "^"):
                self._past("{", "}")
            elif text == "(":
                self._past("(", ")")
            elif text == "^" and not self._power():
                self.at += 1
            else:
                break
        return "".join(text for _, text in self.tokens[start : self.at] if text not in "{}")

    @staticmethod
    def _letter(kind: str, text: str) -> bool:
        word = kind == "command" and text not in _STRUCTURE
        return word or (kind == "other" and text.isalpha() and text not in "√")

    def _followed(self) -> bool:
        """Whether π is the pole of a segment, not the number."""
        return self.at + 1 < len(self.tokens) and self._letter(*self.tokens[self.at + 1])

    def _power(self) -> bool:
        after = [text for _, text in self.tokens[self.at + 1 : self.at + 4]]
        return after[0].isdigit() or (after[:1] == ["{"] and after[1].isdigit() and after[2] == "}")

    def _past(self, begin: str, end: str) -> None:
        depth = 0
        while True:
            depth += {begin: 1, end: -1}.get(self.peek()[1], 0)
            self.at += 1
            if not depth:
                return


def letters_of(side: str) -> list[str]:
    """Return the letters of a side in their order, each time one stands there."""
    return [text for kind, text, _ in leaves_of(side) if kind == "letter"]


def leaves_of(side: str) -> list[tuple[str, str, bool]]:
    """Return the letters and the figures of a side in their order, and whether a minus stands before each."""
    reader = _Letters(side, _Any())
    reader.whole([])
    return reader.leaves


class _Any(dict[str, Stated]):
    """Every letter is stated, somehow: structure alone is of interest."""

    def __contains__(self, name: object) -> bool:
        return True

    def __missing__(self, name: str) -> Stated:
        return Stated(1.0 + sum(map(ord, name)) % 97 / 50, 0.0, True)


def put_in(side: str, known: Known) -> Worked:
    """Return what a side comes to with the values stated, and how far off their rounding may put it."""
    reader = _Letters(side, known)
    value, off = reader.whole([]), 0.0
    for name in dict.fromkeys(reader.seen):
        ways = []
        for way in (-1.0, 1.0):
            again = _Letters(side, known)
            again.moved = {name: way * known[name].half}
            ways.append(abs(again.whole([]) - value))
        off += max(ways)
    return Worked(value, off)


class Equations:
    """Equations in the order in which they are read: how many were evaluated, and which are wrong."""

    def __init__(self, known: Known | None = None) -> None:
        self.known = {"π": Stated(math.pi, 0.0)} | dict(known or {})
        self.evaluated = self.signed = 0
        self.wrong: list[str] = []
        self.left_out: list[str] = []
        self._open: tuple[str, str] | None = None

    def read(self, formulas: Iterable[str]) -> None:
        for formula in formulas:
            self.one(formula)

    def one(self, formula: str) -> None:
        """Evaluate an equation, or keep it until what it gives is told; enter what it states."""
        *sides, last = sides_of(_plain(formula))
        if not sides or r"\bar" in formula:
            return  # a sum of vectors has no value
        first, *rest = sides
        last = _UNIT.sub("", last).strip().rstrip("\\ ")
        if last == "0" and len(rest) == 1 and letters_of(rest[0]):
            self._open = (first, rest[0])
            return
        result = _number(last)
        if result is None:
            return
        if self._open is not None and rest:
            self._balance(first, rest[-1], result)
        elif len(rest) > 1:
            self._judge(formula, rest[0], rest[-1], result, {})
        self._state(first, result)

    def state(self, name: str, text: str) -> None:
        """Enter a value of a table."""
        found = _number(text)
        if found is not None:
            self.known[name] = found

    def _judge(self, formula: str, letters: str, figures: str, due: Stated, extra: Known) -> None:
        """Put what was stated into the side of letters; what was not is taken from the side of figures."""
        try:
            told, put = leaves_of(letters), leaves_of(figures)
            if "letter" not in {kind for kind, _, _ in told}:
                return
            if (
                due.value == 0.0
            ):  # the minus with which a sum begins is its first term's, not a figure's
                told, put = ([(*some[0][:2], False), *some[1:]] for some in (told, put))
            sizes = due.value == 0.0 and "|" not in letters
            known = {**self.known, **self._paired(told, put, extra, sizes), **extra}
            found = put_in(letters, known)
        except _NOT_READ:
            self.left_out.append(formula)
            return
        self.evaluated += 1
        self.signed += re.search("−|-(?![a-z])", formula) is not None
        room = SPARE * (found.off + due.half) + 1e-12 * abs(due.value)
        if not abs(found.value - due.value) <= room:
            self.wrong.append(f"{found.value:.6g} ± {room:.2g}, not {due.value:.6g}: {formula}")

    def _paired(self, told: list[Leaf], put: list[Leaf], extra: Known, sizes: bool) -> Known:
        """Return what the figures tell of letters that were not stated, or stand for another size by now.

        The same size is stated already: then its sign is, too. ``sizes``: no figure has a sign of its own.
        """
        told = [one for one in told if one[1].strip("|") not in {name.strip("|") for name in extra}]
        if len(told) < len(put) and put[0][1] == "0":
            put = put[1:]  # what is sought stands alone in a sum that is nothing
        if len(told) != len(put):
            return {}
        found: dict[str, Stated] = {}
        for (kind, name, minus), (_, text, below) in zip(told, put, strict=True):
            figure = _number(text)
            if kind != "letter" or figure is None:
                continue
            known = self.known.get(name)
            if known is None or not known.is_of(figure):
                turned = minus != below and not sizes
                found[name] = figure._replace(value=-figure.value if turned else figure.value)
        return found

    def _balance(self, first: str, figures: str, result: Stated) -> None:
        """Evaluate a sum that is nothing, once the line below tells what it gives, with which figures."""
        assert self._open is not None
        (heading, left), self._open = self._open, None
        (sought,) = letters_of(first)
        self.known.pop(sought, None)
        extra = {f"|{sought}|" if "|" in first else sought: result}
        self._judge(
            f"{heading} = {left} = 0; {first} = {figures} = {result.value}",
            left,
            figures,
            Stated(0.0, 0.0),
            extra,
        )

    def _state(self, first: str, value: Stated) -> None:
        try:
            names = letters_of(first)
        except _NOT_READ:
            return
        if len(names) == 1:
            self.known[f"|{names[0]}|" if "|" in first else names[0]] = value


_SLOWNESS = re.compile(r"1/\\omega *_\{m\}")
"""What a graph of 1/ω_m shows: one figure by that name."""


def _plain(formula: str) -> str:
    """Return a formula in TeX's signs, with points in figures, and figures with a power of ten as one."""
    formula = re.sub(r"(?<=\d)(?:\{,\}|,)(?=\d)", ".", with_tan(formula))
    formula = _SLOWNESS.sub(r"\\sigma _{m}", formula)
    formula = re.sub(r"[⁻⁰¹²³⁴-⁹]+", lambda found: f"^{{{found[0].translate(_RAISED)}}}", formula)
    formula = _BOXED.sub(r"\\boxed_{\1}", formula).translate(_PLAIN)
    return _TEN.sub(_in_full, _CALLED.sub(r"\\mathrm{\1} ", formula))


def _in_full(found: re.Match[str]) -> str:
    power = int(found[3].replace("−", "-"))
    return f"{float(found[1]) * 10.0**power:.{max(0, len(found[2] or '') - power)}f}"


def _number(side: str) -> Stated | None:
    """Return a side that is one figure, else None; a percentage is rounded at the last digit that it has."""
    plain = re.sub(
        r"[\s(){}]|\\left|\\right|\\text", "", side.replace("{,}", ".").replace(",", ".")
    )
    found = re.fullmatch(r"([-−]?)(\d+(?:\.(\d+))?)(\\?[%°])?", plain)
    if found is None:
        return None
    minus, figure, decimals, unit = found.groups()
    half = half_of(figure) if unit in (None, "°") else 0.5 * 10.0 ** -len(decimals or "")
    if len(figure) > _WHOLE and decimals is None:
        half = 0.5 * 10.0 ** (len(figure) - DIGITS)  # it was told with a power of ten
    return Stated(-float(figure) if minus else float(figure), half, unit == "°")
