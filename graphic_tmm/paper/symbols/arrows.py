"""A vector in ink: its line, its arrowhead, what a page reads of it."""

from __future__ import annotations

from graphic_tmm.board.record import segment_name
from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.symbols.kinematic import ARROW_LENGTH, ARROW_WIDTH, arrowhead

SHAFT = 0.85
"""The shaft of a vector ends in its head, so much of the head's length before the point."""
WIDE = {"main": 2.2, "medium": 1.6, "over": 1.6}
"""Width of the head by the pen of the shaft, mm: it shows beside a heavy one."""


def arrow(a: complex, b: complex, pen: str, head: float = ARROW_LENGTH) -> list[Stroke]:
    """Return a vector from ``a`` to ``b`` (not the same point)."""
    size = min(head, 0.45 * abs(b - a))
    shaft = b - (b - a) / abs(b - a) * size * SHAFT
    width = WIDE.get(pen, ARROW_WIDTH) * size / head
    return [line(pen, a, shaft), *arrowhead(b, b - a, pen=pen, length=size, width=width)]


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
