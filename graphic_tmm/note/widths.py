"""How wide formulas are, so that one too wide for a page stands on several lines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.formula_text import Node
from graphic_tmm.note.document import Formula, Leaf, Number, Symbol, Tree
from graphic_tmm.paper.lettering.markup import plain

WIDE = 76.0
"""So many figures stand on a line of a page, signs among them: 165 mm of 12 pt, a figure half as wide."""
CAPITAL = 1.35
"""What a capital takes."""
TIMES, APART = 1.6, 5.0
"""What a sign between factors takes, and what stands between formulas beside one another."""
SMALL = 0.65
"""What a letter of an index takes of one on the line."""
SIGN = 2.5
"""What a sign between two sides takes, letters."""


def broken(one: Formula) -> tuple[Formula, ...]:
    """Return a formula as one, or as several where it is too wide.

    It is broken before a sign between sides; a side too wide alone, a sum or a sum over
    something, at its terms.
    """
    lines: list[Formula] = []
    room = 0.0
    for k, side in enumerate(one.sides):
        first, *rest = _lines(side, room if k == 1 else WIDE)
        if k + 2 == len(one.sides) and width(one.sides[-1]) <= ALONE:
            used = width(first) + SIGN + (WIDE - room if k == 1 and width(first) <= room else 0.0)
            first, *rest = _for_last(first, rest, used, width(one.sides[-1]) + SIGN)
        needed = width(first) + SIGN
        if lines and needed <= room:
            lines[-1] = lines[-1]._replace(sides=(*lines[-1].sides, first))
            room -= needed
        else:
            lines.append(Formula((first,), one.sign, follows=k > 0))
            room = WIDE - needed
        for sign, more in rest:
            lines.append(Formula((more,), one.sign, follows=True, lead=sign))
            room = WIDE - width(more) - SIGN
    lines[-1] = lines[-1]._replace(behind=one.behind)
    return tuple(lines)


ALONE = 4.0
"""A side no wider than this, letters, does not stand on a line alone: = 0."""


def _for_last(
    first: Leaf | Tree, rest: list[SumLine], used: float, room: float
) -> tuple[Leaf | Tree, *tuple[SumLine, ...]]:
    """Return the lines of a side so that behind the last there is room: else its last term goes with it.

    ``used``: what the line takes on which the first stands; ``room``: what has to go behind the last, letters.
    """
    last = rest[-1].told if rest else first
    taken = width(last) + SIGN if rest else used
    if taken + room <= WIDE or not isinstance(last, Tree) or last.node.head not in SUMS:
        return (first, *rest)
    before, after = (Tree(part, last.put) for part in last.node.parts)
    line = SumLine(last.node.head, after)
    if not rest:
        return (before, line)
    lines = [*rest[:-1], SumLine(rest[-1].sign, before), line]
    return (first, *lines)


class SumLine(NamedTuple):
    """A line of a sum that follows another: the sign before it, what stands in it."""

    sign: str
    told: Tree


def _lines(side: Leaf | Tree, room: float) -> tuple[Leaf | Tree, *tuple[SumLine, ...]]:
    """Return a side, or its first line and those that follow; ``room``: that of the line it may go on."""
    begun = room if room > LEAST else WIDE
    if not isinstance(side, Tree) or width(side) + SIGN <= begun:
        return (side,)
    below, total = _over(side.node)
    runs = _runs(list(_terms(total)), side.put, begun)
    if len(runs) == 1:
        return (side,)
    first, *rest = [_joined(run) for run in runs]
    if runs[0][0][0] == "−":
        first = _joined([("", Node("neg", (runs[0][0][1],))), *runs[0][1:]])
    if not below:
        follow = [
            SumLine(run[0][0], Tree(node, side.put))
            for run, node in zip(runs[1:], rest, strict=True)
        ]
        return (Tree(first, side.put), *follow)
    heads = ["inner"] * (len(rest) - 1) + ["close"]
    made = [
        Node(head, (node, *(below if head == "close" else ())))
        for head, node in zip(heads, rest, strict=True)
    ]
    follow = [
        SumLine(run[0][0], Tree(node, side.put)) for run, node in zip(runs[1:], made, strict=True)
    ]
    return (Tree(Node("open", (first,)), side.put), *follow)


def _joined(run: list[tuple[str, Node]]) -> Node:
    """Return terms as a sum; the sign of the first stands before it."""
    found = run[0][1]
    for sign, term in run[1:]:
        found = Node(sign, (found, term))
    return found


LEAST = 24.0
"""Less room than this, letters, is left empty: a long sum begins on a line of its own."""


def _over(node: Node) -> tuple[tuple[Node, ...], Node]:
    """Return what a sum is divided by, () if by nothing, and the sum."""
    if node.head == "/" and node.parts[0].head in SUMS:
        return (node.parts[1],), node.parts[0]
    return (), node


def _terms(node: Node) -> Iterator[tuple[str, Node]]:
    """Yield the terms of a sum, each with its sign."""
    if node.head not in SUMS:
        yield ("−", node.parts[0]) if node.head == "neg" else ("+", node)
        return
    yield from _terms(node.parts[0])
    yield node.head, node.parts[1]


def _runs(
    terms: list[tuple[str, Node]], put: Mapping[str, Leaf], room: float
) -> list[list[tuple[str, Node]]]:
    """Return terms in lines, each as full as it can be; ``room``: of the first."""
    runs: list[list[tuple[str, Node]]] = [[]]
    room -= SIGN
    for one in terms:
        needed = _tree(one[1], put) + SIGN
        if runs[-1] and needed > room:
            runs.append([])
            room = WIDE - SIGN
        runs[-1].append(one)
        room -= needed
    return runs


SUMS = ("+", "−")
"""Heads of sums."""


def packed(formulas: Sequence[Formula]) -> tuple[tuple[Formula, ...], ...]:
    """Return formulas line by line: short ones that are whole stand beside one another."""
    rows: list[tuple[Formula, ...]] = []
    for k, one in enumerate(formulas):
        if rows and _whole(formulas, k) and _whole(formulas, k - 1) and _fit((*rows[-1], one)):
            rows[-1] = (*rows[-1], one)
        else:
            rows.append((one,))
    return tuple(rows)


def pieces(one: Formula) -> tuple[Formula, ...]:
    """Return a formula among words in pieces that no line parts: it goes on before a sign between sides."""
    first, rest = one.sides[:2], one.sides[2:]
    begun = one._replace(sides=first, behind=() if rest else one.behind)
    more = [one._replace(sides=(side,), follows=True, lead="", behind=()) for side in rest]
    if more:
        more[-1] = more[-1]._replace(behind=one.behind)
    return (begun, *more)


def wholes(
    rows: Sequence[tuple[Formula, ...]],
) -> Iterator[Sequence[tuple[Formula, ...]]]:
    """Yield lines of formulas, those together that are one formula."""
    held: list[tuple[Formula, ...]] = []
    for row in rows:
        if held and not row[0].follows:
            yield held
            held = []
        held.append(row)
    if held:
        yield held


def _whole(formulas: Sequence[Formula], k: int) -> bool:
    """Whether a formula stands alone: it follows none, none follows it."""
    one = formulas[k]
    after = k + 1 < len(formulas) and formulas[k + 1].follows
    return not (one.follows or one.behind or after)


def _fit(beside: Sequence[Formula]) -> bool:
    """Whether formulas stand on one line."""
    sides = [width(side) + SIGN for one in beside for side in one.sides]
    apart = APART * (len(beside) - 1) - SIGN * len(beside)
    return len(beside) <= ABREAST and sum(sides) + apart <= WIDE


ABREAST = 3
"""So many formulas stand on a line at most."""


def width(one: Leaf | Tree) -> float:
    """Return about how wide a side of a formula is, letters."""
    if isinstance(one, Symbol):
        scripts = "".join(braced or sign for braced, sign in _SCRIPT.findall(one.markup))
        return _line(plain(_SCRIPT.sub("", one.markup))) + SMALL * _line(plain(scripts))
    if isinstance(one, Number):
        return len(one.text) + (len(one.unit) + 1 if one.unit else 0)
    return _tree(one.node, one.put)


_SCRIPT = re.compile(r"[_^](?:\{((?:[^{}]|\{[^{}]*\})*)\}|(.))")
"""An index or a power."""


def _line(letters: str) -> float:
    """Return how much room letters take on a line."""
    return sum(CAPITAL if c.isupper() else 1.0 for c in letters)


def _tree(node: Node, put: Mapping[str, Leaf]) -> float:
    if node.head == "name":
        return width(put[node.word]) if node.word in put else len(node.word)
    if not node.parts:
        return float(len(node.word) or 1)
    parts = [_tree(part, put) for part in node.parts]
    if node.head == "/":
        return max(parts)
    if node.head == "neg":
        return parts[0] + 1
    if node.head == "^":
        return parts[0] + SMALL * parts[1] + 2
    if node.head in ("·", "+", "−", "±"):
        return sum(parts) + (TIMES if node.head == "·" else SIGN)
    return sum(parts) + len(node.head) / 2 + 2
