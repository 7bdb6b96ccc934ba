"""How wide formulas are, so that one too wide for a page stands on several lines."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.board.formula_text import Node
from graphic_tmm.note.document import Formula, Leaf, Number, Symbol, Tree
from graphic_tmm.paper.lettering.markup import plain

WIDE = 58.0
"""So many letters stand on a line of a page, brackets and signs among them. Measured on pages of PDF."""
SMALL = 0.65
"""What a letter of an index takes of one on the line."""
SIGN = 2.5
"""What a sign between two sides takes, letters."""


def broken(one: Formula) -> tuple[Formula, ...]:
    """Return a formula as one, or as several where it is too wide: broken before a sign between sides."""
    lines: list[list[Leaf | Tree]] = [[]]
    room = WIDE
    for side in one.sides:
        needed = width(side) + SIGN
        if lines[-1] and needed > room:
            lines.append([])
            room = WIDE
        lines[-1].append(side)
        room -= needed
    first = one._replace(sides=tuple(lines[0]), behind=one.behind if len(lines) == 1 else ())
    rest = [Formula(tuple(line), one.sign, follows=True) for line in lines[1:]]
    if rest and one.behind:
        rest[-1] = rest[-1]._replace(behind=one.behind)
    return (first, *rest)


def width(one: Leaf | Tree) -> float:
    """Return about how wide a side of a formula is, letters."""
    if isinstance(one, Symbol):
        head, _, rest = plain(one.markup).partition("_")
        return len(head) + SMALL * len(rest)
    if isinstance(one, Number):
        return len(one.text) + (len(one.unit) + 1 if one.unit else 0)
    return _tree(one.node, one.put)


def _tree(node: Node, put: Mapping[str, Leaf]) -> float:
    if node.head == "name":
        return width(put[node.word]) if node.word in put else len(node.word)
    if not node.parts:
        return float(len(node.word) or 1)
    parts = [_tree(part, put) for part in node.parts]
    if node.head == "/":
        return max(parts)
    if node.head == "^":
        return parts[0] + SMALL * parts[1] + 2
    if node.head in ("·", "+", "−", "±"):
        return sum(parts) + SIGN
    return sum(parts) + len(node.head) / 2 + 2
