"""The text of a formula as a tree: what is printed is what is computed; the functions that it may call."""

from __future__ import annotations

import re
from collections.abc import Callable, Container
from typing import Any, NamedTuple


class Node(NamedTuple):
    """A part of a formula: what is done (``head``), to which parts; of a leaf, its figure or its name.

    Heads: "figure", "°" (a figure in degrees), "π", "name"; "+", "−", "±", "·", "/", "^", "neg"; a sign of
    comparison, "and"; or the name of a function, also where it has a sign of its own (`BRACKETS`, √).
    """

    head: str
    parts: tuple[Node, ...] = ()
    word: str = ""


_TOKEN = re.compile(
    r"\s*(?:(?P<figure>\d+(?:\.\d+)?)|\{(?P<mark>\w+)\}|(?P<word>[^\W\d_²³⁴⁵⁶⁷⁸⁹π]+)"
    r"|(?P<power>[²³⁴⁵⁶⁷⁸⁹])|(?P<sign>[-+−±·/^()|⌈⌉⌊⌋√π°%,=≠<>≤≥]))"
)
_POWERS = dict(zip("²³⁴⁵⁶⁷⁸⁹", "23456789", strict=True))
_CLAUSE = re.compile(r",\s+(?=\w+ = )")
BRACKETS = {"(": (")", ""), "|": ("|", "abs"), "⌈": ("⌉", "ceil"), "⌊": ("⌋", "floor")}
"""What opens a bracket: what closes it, and the function it is ("" for none)."""
ORDERS = "=≠<>≤≥"
"""Signs of comparison."""


def tree_of(text: str, functions: Container[str]) -> Node:
    """Return what the text of a formula says.

    Raises
    ------
    ValueError
        If it is not such a text; says where.
    """
    main, *rest = _CLAUSE.split(text)
    reader = _Reader(main, functions)
    found = reader.whole(reader.sum)
    for clause in rest:
        name, _, meaning = clause.partition("=")
        other = _Reader(meaning, functions)
        found = _put(found, name.strip(), other.whole(other.sum))
    return found


def condition_of(text: str, functions: Container[str]) -> Node:
    """Return what a condition says: comparisons, with commas between those that must all hold.

    Raises
    ------
    ValueError
        If it is not such a text; says where.
    """
    reader = _Reader(text, functions)
    return reader.whole(reader.comparisons)


def names_of(node: Node) -> frozenset[str]:
    """Return the names that stand in a tree."""
    if node.head == "name":
        return frozenset({node.word})
    return frozenset().union(*(names_of(part) for part in node.parts))


def tree_text(node: Node) -> str:
    """Return a tree as a text again, its names in braces; brackets stand where it needs them."""
    return _text(node)


_BINDS = {"+": 1, "−": 1, "±": 1, "·": 2, "/": 2, "neg": 2, "^": 4}
_SUPERSCRIPT = {figure: sign for sign, figure in _POWERS.items()}


def _text(node: Node, within: int = 0) -> str:
    binds = _BINDS.get(node.head, 5)
    if node.head in _SIGNS_BETWEEN:
        one, other = _text(node.parts[0], binds), _text(node.parts[1], binds + 1)
        between = f" {node.head} " if binds == 1 else node.head
        found = f"{one}{between}{other}"
    elif node.head == "neg":
        found = f"−{_text(node.parts[0], binds + 1)}"
    elif node.head == "^":
        power = node.parts[1]
        raised = _SUPERSCRIPT.get(power.word) if power.head == "figure" else None
        found = _text(node.parts[0], binds + 1) + (raised or f"^{_text(power, binds + 1)}")
    elif node.head in ("radians", "degrees"):
        return _text(node.parts[0], within)
    elif node.parts:
        sign = next((s for s, (_, head) in BRACKETS.items() if head == node.head), "")
        inner = ", ".join(map(_text, node.parts))
        named = "√" if node.head == "sqrt" else node.head
        return f"{sign}{inner}{BRACKETS[sign][0]}" if sign else f"{named}({inner})"
    elif node.head == "name":
        return f"{{{node.word}}}"
    else:
        return {"π": "π", "°": f"{node.word}°"}.get(node.head, node.word)
    return f"({found})" if binds < within else found


_SIGNS_BETWEEN = ("+", "−", "±", "·", "/")


def _put(node: Node, name: str, meaning: Node) -> Node:
    if node == Node("name", (), name):
        return meaning
    return node._replace(parts=tuple(_put(part, name, meaning) for part in node.parts))


class _Reader:
    """Reads a text once, from left to right."""

    def __init__(self, text: str, functions: Container[str]) -> None:
        self.text, self.functions = text, functions
        self.tokens = self._tokens(text.rstrip())
        self.place = 0

    def _tokens(self, text: str) -> list[tuple[str, str]]:
        found, at = [], 0
        while at < len(text):
            token = _TOKEN.match(text, at)
            if token is None:
                raise ValueError(f"cannot read '{text[at:]}' in '{self.text}'")
            assert token.lastgroup is not None
            found.append((token.lastgroup, token[token.lastgroup]))
            at = token.end()
        return [*found, ("end", "")]

    def whole(self, read: Callable[[], Node]) -> Node:
        """Read all of the text."""
        found = read()
        if self.tokens[self.place][0] != "end":
            raise self._wrong()
        return found

    def comparisons(self) -> Node:
        """Read comparisons, as far as they go."""
        found = [self._comparison()]
        while self._take(","):
            found.append(self._comparison())
        return found[0] if len(found) == 1 else Node("and", tuple(found))

    def _comparison(self) -> Node:
        left = self.sum()
        order = self.tokens[self.place][1]
        if not order or order not in ORDERS:
            raise self._wrong()
        self.place += 1
        return Node(order, (left, self.sum()))

    def sum(self) -> Node:
        """Read terms, as far as they go."""
        found = self._product()
        while sign := self._take("+", "−", "±"):
            found = Node(sign, (found, self._product()))
        return found

    def _product(self) -> Node:
        # a sign turns the first factor alone: what follows is the same, to the last bit
        found = Node("neg", (self._factor(),)) if self._take("−") else self._factor()
        while True:
            if sign := self._take("·", "/"):
                found = Node(sign, (found, self._factor()))
            elif found.head == "figure" and self.tokens[self.place][1] == "π":
                found = Node("·", (found, self._factor()))
            else:
                return found

    def _factor(self) -> Node:
        found = self._raised(self._atom())
        if self._take("^"):
            found = Node("^", (found, self._atom()))
        return found

    def _raised(self, node: Node) -> Node:
        if self.tokens[self.place][0] == "power":
            node = Node("^", (node, self._power()))
        return node

    def _power(self) -> Node:
        self.place += 1
        return Node("figure", (), _POWERS[self.tokens[self.place - 1][1]])

    def _atom(self) -> Node:
        kind, word = self.tokens[self.place]
        self.place += 1
        if kind == "figure":
            return Node("°" if self._take("°") else "figure", (), word)
        if kind == "mark":
            return Node("name", (), word)
        if kind == "word":
            return self._call(word) if word in self.functions else Node("name", (), word)
        if word in BRACKETS:
            return self._bracket(*BRACKETS[word])
        if word == "√":
            return Node("sqrt", (self._atom(),))
        if word == "π":
            return Node("π")
        if kind == "sign" and word in "°%":
            return Node("name", (), word)
        self.place -= 1
        raise self._wrong()

    def _bracket(self, end: str, head: str) -> Node:
        found = self.sum()
        if not self._take(end):
            raise self._wrong(f"'{end}' is missing")
        return Node(head, (found,)) if head else found

    def _call(self, head: str) -> Node:
        power = self._power() if self.tokens[self.place][0] == "power" else None
        if self._take("("):
            parts = [self.sum()]
            while self._take(","):
                parts.append(self.sum())
            if not self._take(")"):
                raise self._wrong("')' is missing")
        else:
            parts = [self._atom()]
            if self.tokens[self.place][0] == "power":
                raise self._wrong("a bracket is missing before the power")
        found = Node(head, tuple(parts))
        return found if power is None else Node("^", (found, power))

    def _take(self, *signs: str) -> str:
        """Return the next sign if it is one of these, and go past it; else ""."""
        kind, word = self.tokens[self.place]
        if kind != "sign" or word not in signs:
            return ""
        self.place += 1
        return word

    def _wrong(self, says: str = "") -> ValueError:
        kind, word = self.tokens[self.place]
        says = says or (f"'{word}' is out of place" if kind != "end" else "something is missing")
        return ValueError(f"{says} in '{self.text}'")


class Function(NamedTuple):
    """A function of formulas: how Python calls it, and what is called where that is no name of numpy's.

    ``of_angle``: its argument is an angle, which it takes in radians; ``angle``: its result is one, in radians.
    An angle of a formula itself is in degrees.
    """

    written: str
    run: Callable[..., Any] | None = None
    of_angle: bool = False
    angle: bool = False


FUNCTIONS: dict[str, Function] = {
    "abs": Function("np.abs"),
    "sqrt": Function("np.sqrt"),
    "ceil": Function("np.ceil"),
    "floor": Function("np.floor"),
    "sgn": Function("np.sign"),
    "min": Function("np.minimum"),
    "max": Function("np.maximum"),
    "sin": Function("np.sin", of_angle=True),
    "cos": Function("np.cos", of_angle=True),
    "tan": Function("np.tan", of_angle=True),
    "arcsin": Function("np.arcsin", angle=True),
    "arccos": Function("np.arccos", angle=True),
    "arctan": Function("np.arctan", angle=True),
    "radians": Function("np.radians"),
    "degrees": Function("np.degrees"),
}
"""By the name in the text; a chapter adds its own with `define`."""
KEEPING = ("abs", "ceil", "floor", "min", "max")
"""Functions whose result has the unit of what they take."""


def define(
    name: str, run: Callable[..., Any], *, of_angle: bool = False, angle: bool = False
) -> None:
    """Let formulas use a function of a chapter's own: of arrays, angles in radians."""
    FUNCTIONS[name] = Function(name, run, of_angle, angle)


def in_radians(node: Node, angles: frozenset[str]) -> Node:
    """Return a tree whose functions of angles take radians and give degrees: what is left unsaid in a text.

    ``angles``: the names that stand for degrees. A plain number is an angle in radians.
    """
    parts = tuple(in_radians(part, angles) for part in node.parts)
    known = FUNCTIONS.get(node.head)
    if known is None or not (known.of_angle or known.angle):
        return node._replace(parts=parts)
    if known.of_angle:
        parts = tuple(Node("radians", (p,)) if _degrees(p, angles) else p for p in parts)
    found = node._replace(parts=parts)
    return Node("degrees", (found,)) if known.angle else found


def whole_power(node: Node) -> bool:
    """Whether a power is a whole figure, as in a square."""
    return node.parts[1].head == "figure" and node.parts[1].word.isdigit()


def _degrees(node: Node, angles: frozenset[str]) -> int:
    """Return the power of degrees in a tree: 1 of an angle, 0 of a plain number."""
    if not node.parts:
        return int(node.head == "°" or node.word in angles)
    powers = [_degrees(part, angles) for part in node.parts]
    if node.head in ("·", "/"):
        return powers[0] + (powers[1] if node.head == "·" else -powers[1])
    if node.head == "^":
        return powers[0] * int(node.parts[1].word) if whole_power(node) else 0
    if node.head in FUNCTIONS and node.head not in KEEPING:
        return int(node.head == "degrees")
    return powers[0]
