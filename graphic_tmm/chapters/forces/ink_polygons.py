"""A polygon of forces in ink: sides with arrows, vertices numbered as drawn, reactions across it."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.polygons import Polygon, Reaction
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.symbols.arrows import told_arrow

SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SMALL = 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
LEAST = 0.5
"""A side shorter than this, mm, is a point."""
BEYOND = 4.0
"""How far the line of an unknown force goes on behind the vertex, mm."""
MARGIN = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


def bar(letter: str) -> str:
    r"""Return a force's letter as a vector: R_{12}^{n} -> \bar{R}_{12}^{n}."""
    sign = "−" if letter.startswith("−") else ""
    rest = letter.removeprefix("−")
    return f"{sign}\\bar{{{rest[0]}}}{rest[1:]}"


def spot(reading: Reading, mark: Mark, index: int) -> complex:
    """Return where a mark is in one position."""
    row = reading[mark][0]
    return complex(row[index if row.size > 1 else 0])


def whole(reading: Reading, polygon: Polygon, reactions: Sequence[Reaction], index: int) -> bool:
    """Whether all vertices of a polygon are there in one position."""
    ends = [mark for _, tail, head in polygon.sides for mark in (tail, head)]
    ends += [mark for one in reactions for mark in (one.tail, one.head)]
    return all(cmath.isfinite(spot(reading, mark, index)) for mark in ends)


def draw_polygon(
    reading: Reading,
    polygon: Polygon,
    reactions: Sequence[Reaction],
    index: int,
    name: str,
    title: str,
    mu: float,
    language: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return a polygon of forces in one position; the last two sides were unknown.

    ``reactions``: of the group; those that are no side of the polygon are drawn across it. ``language``:
    of the sheet.
    """
    strokes: list[Stroke | Bezier] = []
    corners = [spot(reading, tail, index) for _, tail, _ in polygon.sides]
    middle = complex(np.mean(corners))
    wanted = list[Wanted]()
    sides = {(tail, head) for _, tail, head in polygon.sides}
    across = [(r.letter, r.tail, r.head) for r in reactions if (r.tail, r.head) not in sides]
    for drawn, pen in ((polygon.sides, "main"), (across, "medium")):
        for letter, tail, head in drawn:
            a, b = spot(reading, tail, index), spot(reading, head, index)
            if abs(b - a) < LEAST:
                continue
            strokes += told_arrow(a, b, pen, letter, mu, "N")
            wanted.append(_label(symbol(letter, language), a, b, middle))
    strokes += [line("thin", *ends) for ends in _beyond(reading, polygon, index)]
    wanted += _numbers(reading, polygon, index, middle)
    if not lettered:
        x, y = [z.real for z in corners], [z.imag for z in corners]
        cell = (min(x) - MARGIN, min(y) - MARGIN, max(x) + MARGIN, max(y) + MARGIN)
        return Drawing(name, title, cell=cell)
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def _label(letter: str, a: complex, b: complex, middle: complex) -> Wanted:
    at = (a + b) / 2
    out = 1j * (b - a) / abs(b - a)
    if ((at - middle) * out.conjugate()).real < 0:
        out = -out
    return Wanted(bar(letter), at, SIZE, 1.0, out)


def _beyond(reading: Reading, polygon: Polygon, index: int) -> list[tuple[complex, complex]]:
    """Return the ends of unknown sides, drawn a little on behind the vertex in which they met."""
    found = []
    for _, tail, head in polygon.sides[-2:]:
        a, b = spot(reading, tail, index), spot(reading, head, index)
        if abs(b - a) >= LEAST and len(polygon.sides) > 2:
            way = (b - a) / abs(b - a) * BEYOND
            found.append((b, b + way) if head != polygon.sides[0][1] else (a, a - way))
    return found


def _numbers(reading: Reading, polygon: Polygon, index: int, middle: complex) -> list[Wanted]:
    """The numbers of the vertices in the order drawn; vertices in one place share a label."""
    places: list[tuple[complex, list[str]]] = []
    for mark in dict.fromkeys(mark for _, tail, head in polygon.sides for mark in (tail, head)):
        at = spot(reading, mark, index)
        near = next((names for z, names in places if abs(z - at) < LEAST), None)
        if near is None:
            places.append((at, [mark.name]))
        else:
            near.append(mark.name)
    return [Wanted(", ".join(names), at, SMALL, 1.0, _out(at - middle)) for at, names in places]


def _out(way: complex) -> complex:
    return cmath.rect(1.0, cmath.phase(way)) if way else 1j
