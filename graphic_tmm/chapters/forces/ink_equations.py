"""Equations as lines of lettering under a title, each broken at its terms where it is too wide."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.paper.drawing import EQUATIONS, Drawing, Label
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.letters import letter

WIDE = 34.0
"""How wide a block of equations may be, in heights of its letters; a longer line is broken at its terms."""
LEAD = 0.7
"""Clear height between two lines, in heights of their letters."""
INDENT = 2.0
"""How far the rest of a broken line stands in, in heights of its letters."""


class Row(NamedTuple):
    """A line of lettering: the parts between which it may break, the mark that it finds."""

    parts: Sequence[str]
    of: Mark


def draw_balances(name: str, title: str, rows: Iterable[Row], index: int, high: Heights) -> Drawing:
    """Return equations under their title, each broken where it is too wide."""
    labels, base = list[Label](), 0.0
    size, wide = high.point, WIDE * high.point
    lines: list[tuple[str, float, float, tuple[int, ...]]] = [(title, high.title, 0.0, ())]
    for row in rows:
        for k, text in enumerate(_broken(row.parts, size, wide)):
            lines.append((text, size, INDENT * size if k else 0.0, (row.of.slot,)))
    for text, height, x, of in lines:
        made = letter(text, size=height)
        base -= made.ascent + (LEAD * height if labels else 0.0)
        position = index if of else None
        labels.append(Label(text, complex(x, base), height, of=of, position=position))
        base -= made.descent
    return Drawing(name, title, labels=tuple(labels), role=EQUATIONS, position=index)


def _broken(parts: Sequence[str], size: float, wide: float) -> list[str]:
    lines: list[str] = []
    for part in parts:
        longer = f"{lines[-1]} {part.strip()}" if lines else part.strip()
        if lines and letter(longer, size=size).width > wide - (len(lines) > 1) * INDENT * size:
            lines.append(part.strip())
        elif lines:
            lines[-1] = longer
        else:
            lines = [longer]
    return lines
