"""Vectors and dimensions (ГОСТ 2.307) in ink: lines with arrowheads, extension lines, the figure above."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from graphic_tmm.board.record import segment_name
from graphic_tmm.paper.arithmetic import smaller
from graphic_tmm.paper.drawing import Label, Stroke, arc, line
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.symbols.kinematic import ARROW_LENGTH, ARROW_WIDTH, arrowhead

SHAFT = 0.85
"""The shaft of a vector ends in its head, so much of the head's length before the point."""
WIDE = {"main": 2.2, "medium": 1.6, "over": 1.6}
"""Width of the head by the pen of the shaft, mm: wide enough to show on a heavy one."""


def arrow(a: complex, b: complex, pen: str, head: float = ARROW_LENGTH) -> list[Stroke]:
    """Return a vector from ``a`` to ``b`` (not the same point)."""
    size = smaller(head, 0.45 * abs(b - a))
    shaft = b - (b - a) / abs(b - a) * size * SHAFT
    width = WIDE.get(pen, ARROW_WIDTH) * size / head
    return [line(pen, a, shaft), *arrowhead(b, b - a, pen=pen, length=size, width=width)]


def told_arrow(a: complex, b: complex, pen: str, letter: str, mu: float, unit: str) -> list[Stroke]:
    """Return a vector that carries its segment, its length in mm and its value for the page."""
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


ARROW = 3.0
"""Length of an arrowhead, mm (ГОСТ 2.307: at least 2.5)."""
BEYOND = 2.0
"""How far an extension line goes on behind the arrows, mm."""
ABOVE = 0.9
"""Clear height between the dimension line and its figure, mm."""
BESIDE = 1.6
"""Clear width between an extension line and the figure, mm."""
SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""


class Dimension(NamedTuple):
    """The lines of a dimension and its figure."""

    strokes: tuple[Stroke, ...]
    label: Label


def dimension(
    start: complex, end: complex, offset: float, text: str, size: float = SIZE
) -> Dimension:
    """Return the dimension of ``start``–``end`` on a line ``offset`` mm to its left; ``size`` of its figure.

    The figure stands above the line, or left of a vertical one; where the arrows have no room between the
    extension lines they stand outside, and the line goes on behind them. What has no length is measured
    along the x axis.
    """
    way = (end - start) / abs(end - start) if end != start else 1 + 0j
    out = 1j * way * math.copysign(1.0, offset)
    a, b = start + abs(offset) * out, end + abs(offset) * out
    strokes = [line("thin", z, w + BEYOND * out) for z, w in ((start, a), (end, b))]
    made = letter(text, size=size)
    inside = abs(end - start) >= 2 * ARROW + 1.0
    reach = 0.0 if inside else 2 * ARROW
    strokes.append(line("thin", a - reach * way, b + reach * way))
    for tip, sense in ((a, -1), (b, 1)):
        strokes += arrowhead(tip, way * sense * (1 if inside else -1), pen="thin", length=ARROW)
    read = way if (way.real, way.imag) > (1e-9, 0.0) or abs(way.real) < 1e-9 < way.imag else -way
    if abs(read.real) < 1e-9:
        read = 1j
    middle = (a + b) / 2
    if made.width + 2 * BESIDE > abs(end - start):
        middle = b + (reach + 1.0 + made.width / 2) * way
        strokes.append(line("thin", b + reach * way, middle + made.width / 2 * way))
    at = middle + (ABOVE + made.descent) * 1j * read
    label = Label(text, at, size, "middle", round(math.degrees(cmath.phase(read)), 6))
    return Dimension(tuple(strokes), label)


def angular(vertex: complex, start: float, sweep: float, radius: float) -> tuple[Stroke, ...]:
    """Return the arc with arrows that dimensions an angle, and the side on which it begins.

    ``start``, ``sweep`` in degrees, counter-clockwise positive. Where the arrows have no room between the sides
    they stand outside, and the arc goes on behind them.
    """
    inside = abs(math.radians(sweep)) * radius >= 2 * ARROW + 1.0
    beyond = 0.0 if inside else math.copysign(math.degrees(2 * ARROW / radius), sweep)
    strokes = [
        line("thin", vertex, vertex + cmath.rect(radius + BEYOND, math.radians(start))),
        arc("thin", vertex, radius, start - beyond, sweep + 2 * beyond),
    ]
    for turn, sense in ((start, -1), (start + sweep, 1)):
        out = cmath.rect(1.0, math.radians(turn))
        way = 1j * out * math.copysign(1.0, sweep) * sense * (1 if inside else -1)
        strokes += arrowhead(vertex + radius * out, way, pen="thin", length=ARROW)
    return tuple(strokes)


def shelf(point: complex, bend: complex, text: str) -> Dimension:
    """Return a leader from a point to a shelf on which a text stands; to the right of ``bend``."""
    made = letter(text, size=SIZE)
    end = bend + made.width + 1.0
    strokes = (
        line("thin", point, bend, end),
        *arrowhead(point, point - bend, pen="thin", length=ARROW),
    )
    return Dimension(strokes, Label(text, bend + 0.5 + 1j * (ABOVE + made.descent), SIZE))
