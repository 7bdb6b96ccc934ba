"""Arithmetic written down instead of done: a tape of passes over real arrays, each of them noted once.

A number that is not known yet is a `Ref`: a node of the tape and a sign. Signs, factors of one and parts of
complex numbers that are nothing (None) are settled here, so that they cost no pass. A pass is named as the
function of numpy that does it; `length` is √(x² + y²), `choose` what `where` does. Of each number is kept what
is known of its sign, whatever it comes to: a sum with nothing changes the sign of a zero at most, and so does a
sum with −0 not even that.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from enum import IntEnum
from functools import reduce
from operator import or_
from typing import NamedTuple

import numpy as np


class Sign(IntEnum):
    """What is known: nothing; that no zero of it is −0; that, and that nothing of it is below 0."""

    FREE = 0
    UNSIGNED = 1
    POSITIVE = 2


_KEEPS_SIGN = frozenset({"floor", "ceil", "rint", "choose"})
"""Passes that leave nothing below 0, and no −0, where what they take is so."""


def of_known(number: float) -> Sign:
    """Return the sign of a number that is known."""
    if number == 0.0:
        return Sign.FREE if math.copysign(1.0, number) < 0.0 else Sign.POSITIVE
    return Sign.POSITIVE if number > 0.0 else Sign.UNSIGNED


def of_pass(does: str, takes: Sequence[Sign], *, alike: bool) -> Sign:
    """Return the sign of what a pass leaves; ``alike``: it takes one number twice."""
    if does in ("absolute", "length") or (does == "multiply" and alike):
        return Sign.POSITIVE
    if does == "add":
        # two zeros make −0 only where both are
        return Sign.POSITIVE if min(takes) == Sign.POSITIVE else min(max(takes), Sign.UNSIGNED)
    if does == "subtract":
        return min(takes[0], Sign.UNSIGNED)
    if does in ("multiply", "divide"):
        return Sign.POSITIVE if min(takes) == Sign.POSITIVE else Sign.FREE
    if does == "sqrt":
        # of what is below 0 it is NaN, of −0 it is −0
        return Sign.POSITIVE if takes[0] else Sign.FREE
    if does == "copysign":
        return Sign.POSITIVE if takes[1] == Sign.POSITIVE else Sign.FREE
    if does in _KEEPS_SIGN:
        least = min(takes)
        return least if does == "choose" or least == Sign.POSITIVE else Sign.FREE
    return Sign.FREE


class Ref(NamedTuple):
    """The number that a node of the tape leaves, or its opposite."""

    node: int
    minus: bool = False


Part = Ref | float | None
"""A part of a number: noted on the tape, known, or nothing at all."""


class Node(NamedTuple):
    """A pass: what it does, of which nodes and numbers, whether its result varies with the position.

    ``may``, ``must``: a bit for each node; where its number is undefined, so may, or must, this one be, and
    where none of ``may`` is, this one is defined. ``sign``: what is known of it.
    """

    does: str
    takes: tuple[int | float, ...]
    moving: bool
    may: int
    must: int
    sign: Sign


INPUT = "input"
_CARRYING = {
    **dict.fromkeys(("add", "subtract", "multiply"), (0, 1)),
    **dict.fromkeys(("negative", "absolute", "rint"), (0,)),
}
"""Passes that are undefined just where these numbers are that they take."""
_KEEPING = {"sqrt": (0,), "length": (0, 1), "divide": (0,)}
"""Passes that are undefined where these numbers are that they take, but elsewhere too."""
MASKS = frozenset(
    {
        *("less", "less_equal", "greater", "greater_equal", "equal", "not_equal"),
        *("logical_and", "logical_or", "logical_not", "isnan", "isfinite"),
    }
)
"""Passes that leave a truth for every position."""
_TURNED = {
    "less": "greater",
    "less_equal": "greater_equal",
    "greater": "less",
    "greater_equal": "less_equal",
    "equal": "equal",
    "not_equal": "not_equal",
}


class Tape:
    """Passes in the order in which they may be made."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self._known: dict[tuple[str | int, ...], int] = {}

    def input(self, moving: bool, sign: Sign = Sign.FREE) -> Ref:
        """Return a number that comes from outside: the nodes of such numbers are in the order of asking."""
        own = 1 << len(self.nodes)
        self.nodes.append(Node(INPUT, (), moving, own, own, sign))
        return Ref(len(self.nodes) - 1)

    def note(self, does: str, *takes: int | float) -> int:
        """Return the node of a pass, the one that is there if it was noted before."""
        # what is written tells 0 from −0, and a known number from a node
        key = (does, *[k if isinstance(k, int) else repr(k) for k in takes])
        if key not in self._known:
            moving = any(isinstance(k, int) and self.nodes[k].moving for k in takes)
            self._known[key] = len(self.nodes)
            self.nodes.append(
                Node(does, takes, moving, *self._undefined(does, takes), self._sign(does, takes))
            )
        return self._known[key]

    def _sign(self, does: str, takes: tuple[int | float, ...]) -> Sign:
        if does == "choose":
            takes = takes[1:]
        signs = [self.nodes[t].sign if isinstance(t, int) else of_known(t) for t in takes]
        return of_pass(does, signs, alike=len(takes) == 2 and takes[0] == takes[1])

    def _undefined(self, does: str, takes: tuple[int | float, ...]) -> tuple[int, int]:
        """Return where a new node may be undefined, and where it must."""
        own = 1 << len(self.nodes)
        if does in MASKS:
            return 0, 0
        nodes = [self.nodes[t] if isinstance(t, int) else None for t in takes]
        if does == "choose":
            both = nodes[1:]
            may = own if any(isinstance(t, float) and t != t for t in takes) else 0
            must = both[0].must & both[1].must if both[0] and both[1] else 0
            return may | _together(node.may for node in both if node), must
        kept = [nodes[k] for k in (*_CARRYING.get(does, ()), *_KEEPING.get(does, ()))]
        must = _together(node.must for node in kept if node)
        if does in _CARRYING and not any(isinstance(t, float) and t != t for t in takes):
            return _together(node.may for node in kept if node), must
        return own, own | must

    def call(self, does: str, *parts: Part) -> Ref:
        """Return what a function of real numbers leaves."""
        if does == "copysign" and self._positive(parts[1]):
            does, parts = "absolute", parts[:1]
        if does == "absolute" and self._positive(parts[0]):
            return parts[0]  # type: ignore[return-value]
        return Ref(self.note(does, *map(self.plain, parts)))

    def there(self, does: str, *parts: Part) -> Ref | None:
        """Return what a function leaves if it was noted before, else None."""
        key = (does, *[part.node if isinstance(part, Ref) else repr(part) for part in parts])
        return Ref(self._known[key]) if key in self._known else None

    def _positive(self, part: Part) -> bool:
        return (
            isinstance(part, Ref) and not part.minus and self.nodes[part.node].sign == Sign.POSITIVE
        )

    def plain(self, part: Part) -> int | float:
        """Return a part as a pass takes it, without a sign before it."""
        if part is None:
            return 0.0
        if isinstance(part, Ref):
            return self.note("negative", part.node) if part.minus else part.node
        return float(part)

    def plus(self, a: Part, b: Part) -> Part:
        """Return a + b."""
        if a is None or b is None:
            return b if a is None else a
        if not isinstance(a, Ref):
            if not isinstance(b, Ref):
                return a + b
            a, b = b, a
        for one, nothing in ((a, b), (b, a)):
            if isinstance(one, Ref) and isinstance(nothing, Ref) and self._spared(one, nothing):
                return one
        if not isinstance(b, Ref):
            if b == 0.0 and (of_known(b) is Sign.FREE or self._unsigned(a)):
                return a
            return Ref(self.note("subtract", b, a.node) if a.minus else self.note("add", a.node, b))
        if a.minus == b.minus:
            return Ref(self.note("add", *sorted((a.node, b.node))), a.minus)
        first, second = (b, a) if a.minus else (a, b)
        return Ref(self.note("subtract", first.node, second.node))

    def _unsigned(self, a: Ref) -> bool:
        return not a.minus and self.nodes[a.node].sign != Sign.FREE

    def _spared(self, one: Ref, nothing: Ref) -> bool:
        """Whether a part is a product by 0 that is undefined only where the other part is."""
        node = self.nodes[nothing.node]
        if node.does != "multiply" or 0.0 not in [t for t in node.takes if isinstance(t, float)]:
            return False
        return not node.may & ~self.nodes[one.node].must

    def minus(self, a: Part, b: Part) -> Part:
        """Return a − b."""
        return self.plus(a, self.opposite(b))

    def opposite(self, a: Part) -> Part:
        """Return −a."""
        if isinstance(a, Ref):
            return a._replace(minus=not a.minus)
        return None if a is None else -a

    def times(self, a: Part, b: Part) -> Part:
        """Return a·b."""
        if a is None or b is None:
            return None
        if not isinstance(a, Ref):
            if not isinstance(b, Ref):
                return a * b
            a, b = b, a
        if isinstance(b, Ref):
            return Ref(self._product(a.node, b.node), a.minus != b.minus)
        if abs(b) == 1.0:
            return a if b > 0.0 else self.opposite(a)
        return Ref(self.note("multiply", a.node, b), a.minus)

    def _product(self, a: int, b: int) -> int:
        """Return the node of a product; factors that do not vary are multiplied with one another first."""
        if a == b and (parts := self._factored(a)):
            return self._product(
                self.note("multiply", parts[0], parts[0]), self.note("multiply", parts[1], parts[1])
            )
        for one, still in ((a, b), (b, a)):
            if not self.nodes[still].moving and (parts := self._factored(one)):
                return self.note(
                    "multiply", parts[0], self.note("multiply", *sorted((parts[1], still)))
                )
        return self.note("multiply", *sorted((a, b)))

    def _factored(self, k: int) -> tuple[int, int] | None:
        """Return a node that varies without its factor that does not, and that factor; None if it has none."""
        node = self.nodes[k]
        if node.moving and node.does == "multiply":
            for one, other in (node.takes, node.takes[::-1]):
                if isinstance(one, int) and isinstance(other, int) and not self.nodes[other].moving:
                    return one, other
        return None

    def over(self, a: Part, b: Part) -> Part:
        """Return a/b."""
        if a is None:
            return None
        if not isinstance(a, Ref) and not isinstance(b, Ref):
            return float(np.divide(a, 0.0 if b is None else b))
        if not isinstance(b, Ref) and b == 1.0:
            return a
        both = isinstance(a, Ref) and isinstance(b, Ref)
        if both and self.nodes[a.node].moving and not self.nodes[b.node].moving:  # type: ignore[union-attr]
            # once a run instead of once a position
            return self.times(a, self.over(1.0, b))
        minus = [isinstance(part, Ref) and part.minus for part in (a, b)]
        nodes = [part.node if isinstance(part, Ref) else part or 0.0 for part in (a, b)]
        return Ref(self.note("divide", *nodes), minus[0] != minus[1])

    def compare(self, does: str, a: Part, b: Part) -> int:
        """Return the node of a comparison of two real numbers."""
        a, b = (0.0 if part is None else part for part in (a, b))
        if all(part.minus if isinstance(part, Ref) else True for part in (a, b)):
            a, b, does = self.opposite(a), self.opposite(b), _TURNED[does]
        return self.note(does, self.plain(a), self.plain(b))

    def choose(self, mask: int, a: Part, b: Part) -> Part:
        """Return ``a`` where a mask is true, ``b`` elsewhere."""
        if a == b and isinstance(a, Ref):
            return a
        both = isinstance(a, Ref) and isinstance(b, Ref) and a.minus and b.minus
        if both:
            a, b = self.opposite(a), self.opposite(b)
        return Ref(self.note("choose", mask, self.plain(a), self.plain(b)), both)


def _together(bits: Iterable[int]) -> int:
    return reduce(or_, bits, 0)
