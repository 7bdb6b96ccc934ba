"""An engine's force triangles on the crank mechanism, and the rotating vectors of its inertia force."""

from __future__ import annotations

import cmath
import math

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.engine.plan import Engine
from graphic_tmm.chapters.forces.ink_polygons import LEAST, spot
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.symbols.arrows import told_arrow
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, pole, slider, turning_pair

SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SMALL = 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
MARGIN = 7.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


def draw_triangles(
    reading: Reading,
    made: Engine,
    pivot: Mark,
    index: int,
    name: str,
    title: str,
    mu: float,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the mechanism of one position with the triangles P′ = Q + N at B and Q = K + T at A."""
    t, unit = made.triangles, made.order.unit
    marks = (pivot, t.at_a, t.at_b, t.end_p, t.end_q, t.end_qa, t.end_t)
    o, a, b, p, q, qa, end_t = (spot(reading, mark, index) for mark in marks)
    strokes: list[Stroke | Bezier] = [line("thin", o, a, b), *fixed_pivot(o)]
    guide = complex(reading[made.guide].along[0, 0])
    angle = math.degrees(cmath.phase(guide))
    strokes += [*slider(b, angle, pin=False), *turning_pair(a), *turning_pair(b)]
    wanted = [
        Wanted(markup(pivot.letter), o, SIZE, 2.2),
        Wanted(markup(t.at_a.letter), a, SIZE, 2.2, a - o),
        Wanted(markup(t.at_b.letter), b, SIZE, 2.2, 1j * guide),
    ]
    for start, end, letter, pen in (
        (b, p, "P′", "over"),
        (q, p, "N", "over"),
        (b, q, "Q", "over"),
        (a, qa, "Q", "over"),
        (a, end_t, "T", "over"),
        (end_t, qa, "K", "over"),
    ):
        if abs(end - start) < LEAST:
            continue
        strokes += told_arrow(start, end, pen, letter, mu, unit)
        out = 1j * (end - start)
        wanted.append(
            Wanted(f"\\bar{{{letter[0]}}}{letter[1:]}", (start + end) / 2, SMALL, 0.8, out)
        )
    if not lettered:
        x, y = (
            [z.real for z in (o, a, b, p, q, qa, end_t)],
            [z.imag for z in (o, a, b, p, q, qa, end_t)],
        )
        m = MARGIN
        return Drawing(name, title, cell=(min(x) - m, min(y) - m, max(x) + m, max(y) + m))
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def draw_rotating(
    reading: Reading,
    made: Engine,
    index: int,
    name: str,
    title: str,
    mu: float,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the rotating vectors of first and second order in one position with their projections."""
    found = made.harmonics
    centre = spot(reading, found.origin, index)
    along = complex(reading[found.axis].along[0, 0])
    ends = [spot(reading, mark, index) for mark in found.ends]
    reach = max((abs(z - centre) for z in ends), default=0.0)
    strokes: list[Stroke | Bezier] = [
        line("centre", centre - along * (reach + 8.0), centre + along * (reach + 8.0)),
        *(circle("thin", centre, abs(z - centre)) for z in ends if abs(z - centre) >= LEAST),
    ]
    wanted = [Wanted("O", centre, SIZE, 1.2, -1j)]
    letters = ("m·ω^{2}·R", "m·ω^{2}·R·λ")
    for end, letter, order in zip(ends, letters, ("I", "II"), strict=True):
        if abs(end - centre) < LEAST:
            continue
        strokes += told_arrow(centre, end, "main", order, mu, "N")
        foot = centre + along * ((end - centre) * along.conjugate()).real
        strokes.append(line("thin", end, foot))
        wanted.append(Wanted(letter, end, SMALL, 1.0, end - centre))
        if abs(foot - centre) >= LEAST:
            wanted.append(Wanted(order, foot, SMALL, 1.0, -1j))
    strokes += pole(centre)
    if not lettered:
        r = reach + 20.0
        return Drawing(name, title, cell=(-r, -r, r, r))
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)
