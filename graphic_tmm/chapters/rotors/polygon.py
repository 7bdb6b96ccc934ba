"""A polygon of vectors that are laid off at their angles, one behind the other; the side that closes it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import accumulate
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import bearing, lay_off, measure, ray
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.rotors import words as why

CLOSED = 1e-9
"""What is left of a polygon by less than this share of its longest side is rounding: it closes by itself."""
VERTICES = "abcdefghijklmnopqrstuvwxyz"


class Vector(NamedTuple):
    """What is laid off: its letter, its size (Number, perhaps negative) and its angle; exactly, SI."""

    letter: str
    size: Mark
    angle: Mark
    exact: complex


class Side(NamedTuple):
    """A side as drawn: the letter of its vector, its tail, its head."""

    letter: str
    tail: Mark
    head: Mark


class Polygon(NamedTuple):
    """A polygon as drawn.

    ``closing``: from the last vertex to the first, of a total the other way, by its ``letter``; its ``length``
    as measured, its ``size``, its ``angle``: None where it is nothing. ``exact``: that side, SI; ``reach``: the
    longer side of the box about the polygon, SI.
    """

    view: str
    mu: Mark
    sides: tuple[Side, ...]
    closing: Side
    length: Mark
    size: Mark
    angle: Mark | None
    exact: complex
    reach: float


def draw_polygon(
    draft: Draft,
    view: str,
    mu: tuple[str, str],
    vectors: Sequence[Vector],
    letter: str,
    *,
    total: bool = False,
) -> Polygon | None:
    """Draw the polygon of some vectors in a view of its own; None where all of them are nothing.

    ``mu``: the letter of its scale factor, and its unit; ``letter``: of the vector that closes it, or of their
    ``total``, from the first vertex to the last.
    """
    there = [one for one in vectors if one.exact]
    if not there:
        return None
    draft.open(view)
    factor = draft.scale(*mu)
    unit = mu[1].removesuffix("/mm").strip("()")
    first = at = draft.take(Point, VERTICES[0], 0j)
    draft.lay_out(first)
    sides = []
    for name, one in zip(VERTICES[1:], there, strict=False):
        side = f"{at.letter}{name}"
        line = draft.draw(ray, f"({side})", at, one.angle, why=why.DIRECTION)
        so_long = draft.draw(to_board, side, one.size, factor)
        end = draft.draw(lay_off, name, line, so_long, why=why.LAID_OFF)
        sides.append(Side(one.letter, at, end))
        at = end
    tail, head = (first, at) if total else (at, first)
    reason, points = (why.TOTAL, why.POINTS) if total else (why.CLOSES, why.ANGLE)
    length = draft.draw(measure, f"{tail.letter}{head.letter}", tail, head, why=reason)
    size = draft.draw(in_si, letter, length, unit=unit)
    corners = [0j, *accumulate(one.exact for one in there)]
    rest = corners[-1] if total else -corners[-1]
    angle = None
    if abs(rest) > CLOSED * max(abs(one.exact) for one in there):
        angle = draft.draw(
            bearing, f"α_{{{index(letter)}}}", tail, head, role=roles.READ_OFF, why=points
        )
    else:
        rest = 0j
    wide, high = ([f(z) for z in corners] for f in (_x, _y))
    reach = max(max(wide) - min(wide), max(high) - min(high))
    return Polygon(
        view, factor, tuple(sides), Side(letter, tail, head), length, size, angle, rest, reach
    )


def turned(size: float, degrees: float) -> complex:
    """Return a vector by its size and its angle."""
    return cmath.rect(size, math.radians(degrees))


def index(letter: str) -> str:
    """Return the index of a letter: II of D_{II}."""
    return letter.partition("_")[2].strip("{}")


def _x(z: complex) -> float:
    return z.real


def _y(z: complex) -> float:
    return z.imag
