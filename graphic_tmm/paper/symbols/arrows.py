"""A vector in ink: its line, its arrowhead, what a page reads of it."""

from __future__ import annotations

from graphic_tmm.board.naming import (
    segment_name,
)
from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.symbols.kinematic import ARROW_LENGTH, arrowhead


def arrow(a: complex, b: complex, pen: str, head: float = ARROW_LENGTH) -> list[Stroke]:
    """Return a vector from ``a`` to ``b`` (not the same point)."""
    size = min(head, 0.45 * abs(b - a))
    shaft = b - (b - a) / abs(b - a) * size * 0.5
    return [line(pen, a, shaft), *arrowhead(b, b - a, pen=pen, length=size)]


def told_arrow(a: complex, b: complex, pen: str, letter: str, mu: float, unit: str) -> list[Stroke]:
    """Return a vector that tells a page its segment, its length in mm and what it stands for."""
    mm, name = abs(b - a), segment_name(letter)
    data = (
        ("segment", name),
        ("mm", f"{mm:.2f}"),
        ("value", f"{mm * mu:.6g}"),
        ("unit", unit),
    )
    shaft, *head = arrow(a, b, pen)
    title = f"{name} = {mm:.1f} mm = {mm * mu:.4g} {unit}"
    return [shaft._replace(title=title, data=data), *head]
