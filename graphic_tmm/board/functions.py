"""Functions that a formula's text may call, and where it speaks of angles in degrees."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from graphic_tmm.board.formula_text import Node


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
