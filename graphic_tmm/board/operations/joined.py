"""Two plates on tracing paper, about pivots, each on a sheet of its own: so laid that two links join them.

How they lie is kept as a `Line` of two directions, those of both plates' lines from their pivots.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.geometry import along, cis, vector, wedge
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.operations.tracing import (
    Laid,
    arc_normal,
    arc_off,
    both_turned,
    pricked,
)
from graphic_tmm.board.values import Angle, Arc, Complexes, Length, Line, Point, Reals
from graphic_tmm.language.said import said


class Square(NamedTuple):
    """Two plates about pivots with two links that join them: what is known of them before they are laid.

    ``to``, ``at``: the pivots; from these, in the plates' own axes, the pins of the links (``b`` from ``to``,
    ``c`` from ``at``); ``l``: how long the links are. Of a `Line` ``at`` is the direction of the plate about
    ``to``, ``along`` that of the one about ``at``.
    """

    to: Point
    at: Point
    b1: Complexes
    b2: Complexes
    c1: Complexes
    c2: Complexes
    l1: Reals
    l2: Reals


def first_joined(square: Square, lies: Line) -> Arc:
    """Return the arc of the first link about its pin on the plate about ``to``."""
    return Arc(square.to + square.b1 * lies.at, square.l1)


def second_joined(square: Square, lies: Line) -> Arc:
    """Return the arc of the second link about its pin on the plate about ``to``."""
    return Arc(square.to + square.b2 * lies.at, square.l2)


def square_off(square: Square, lies: Line) -> Complexes:
    """Return how far the pins of the plate about ``at`` are outside the arcs of both links."""
    at_c1, at_c2 = square.at + square.c1 * lies.along, square.at + square.c2 * lies.along
    return vector(
        arc_off(at_c1, first_joined(square, lies)), arc_off(at_c2, second_joined(square, lies))
    )


def grows(pins: Complexes, others: Complexes, along_it: Complexes) -> Complexes:
    """Return how a link would grow as the plate about ``to`` turns; imaginary, as that about ``at`` does."""
    return vector(-along(pins * 1j, along_it), along(others * 1j, along_it))


def first_grows(square: Square, lies: Line) -> Complexes:
    """Return how the first link would grow as the plates turn, see `grows`."""
    c1 = square.c1 * lies.along
    way = arc_normal(square.at + c1, first_joined(square, lies))
    return grows(square.b1 * lies.at, c1, way)


def second_grows(square: Square, lies: Line) -> Complexes:
    """Return how the second link would grow as the plates turn, see `grows`."""
    c2 = square.c2 * lies.along
    way = arc_normal(square.at + c2, second_joined(square, lies))
    return grows(square.b2 * lies.at, c2, way)


def on_links(lies: Line, square: Square) -> Line:
    """Return how two plates lie after one correction, joined by two links."""
    one, two = first_grows(square, lies), second_grows(square, lies)
    off = square_off(square, lies)
    return both_turned(lies, off, one.real, one.imag, two.real, two.imag)


def square_laid(square: Square, lies: Line) -> Laid:
    """Return how two plates came to lie."""
    first, second = first_joined(square, lies), second_joined(square, lies)
    return Laid(
        square_off(square, lies),
        np.abs(square.c1) + np.abs(square.c2) + np.abs(square.b1) + np.abs(square.b2),
        np.abs(first.centre) + first.radius + second.radius,
        1.0 / first.radius + 1.0 / second.radius,
        wedge(first_grows(square, lies), second_grows(square, lies)),
    )


@operation(
    symbol="2P1 + 4P2 + 4R1 + 2R2",
    fails="the two plates cannot be laid so that both links join them",
    why=said(
        "Each plate turns about its own pivot and both links are rigid, so the plates are where both fit at "
        "once; of the places where they do it is the one next to that of the neighbouring position."
    ),
)
def trace_joined(
    to: Point,
    at: Point,
    b: Length,
    bx: Length,
    by: Length,
    c: Length,
    cx: Length,
    cy: Length,
    first: Length,
    second: Length,
    other: Angle,
    plate: Angle,
) -> Line:
    """Fit tracings ({b}; {bx}, {by}) at {to} and ({c}; {cx}, {cy}) at {at} to {first} and {second}; prick {it}.

    ``b``, ``c``: where the first link joins the plates, along their lines from the pivots; ``bx`` and so on:
    where the second does, along and to the left. The line pricked through is that of the first link.
    """
    square = Square(
        to,
        at,
        vector(b, 0.0 * b),
        vector(bx, by),
        vector(c, 0.0 * c),
        vector(cx, cy),
        first,
        second,
    )
    near = Line(cis(other), cis(plate))
    lies = on_links(near, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    lies = on_links(lies, square)
    arc = first_joined(square, lies)
    line = Line(arc.centre, arc_normal(at + square.c1 * lies.along, arc))
    before = wedge(first_grows(square, near), second_grows(square, near))
    return pricked(line, lies, near, square_laid(square, lies), before)
