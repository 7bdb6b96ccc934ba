"""Letters as strokes: the project's own hand on the grid of ГОСТ 2.304 type B, and its notation.

A glyph is drawn with a round pen; the tables give the path of the *middle* of the pen in units of
the pen's width (h/10), from the left and lower edge of the letter's grid: a capital reaches from 0
to 9, a small letter from 0 to 6, a tail ends at -3; with the pen that makes 10, 7 and 3 units.

A line of a table is ``character width path``, or ``character = other`` where two look alike. The
width is the clear one, pen included (6 for most capitals, so that their paths reach from 0 to 5).
``|`` lifts the pen between strokes; a stroke is written so:

========== =====================================================================================
``x,y``     a straight stroke to the point (the first one: the pen is put down there)
``x,y:r2``  a corner rounded with radius 2; both its neighbours are joined by straight strokes
``x,y:90``  an arc to the point, turning by 90° on the way, counter-clockwise positive
``*x,y``    a full stop: a dot slightly larger than the pen
========== =====================================================================================

The vertices are those of DXF: x, y and the bulge of the way to the next vertex, tan of a quarter
of its turn, counter-clockwise positive, 0 = straight.
"""

from __future__ import annotations

import math
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.paper.lettering.glyph_tables import (
    CAPITALS,
    DIGITS,
    GREEK,
    LATIN,
    MATHEMATICS,
    PUNCTUATION,
    SMALL,
)

Vertex = tuple[float, float, float]
Stroke = tuple[Vertex, ...]

SLANT = math.tan(math.radians(15.0))
"""How far a point moves to the right per unit of its height when a letter is inclined (75°)."""

_DOT = 0.15
"""Half the way that the pen is moved for a dot, in tenths of a capital; chosen by eye."""
_KINK = math.radians(2.0)
_SAME = 1e-9
"""Places closer than this, in the same unit, coincide."""


class _Node(NamedTuple):
    x: float
    y: float
    radius: float
    turn: float


def parse(path: str) -> Stroke:
    """Read one stroke.

    Parameters
    ----------
    path : str
        See the notation at the head of this file.

    Raises
    ------
    ValueError
        A rounded corner has no room between its neighbours, or the notation is wrong.
    """
    words = path.split()
    if len(words) == 1 and words[0].startswith("*"):
        x, y = (float(number) for number in words[0][1:].split(","))
        return ((x - _DOT, y, 1.0), (x + _DOT, y, 1.0), (x - _DOT, y, 0.0))
    nodes = [_node(word) for word in words]
    if len(nodes) < 2 or nodes[0].radius or nodes[0].turn or nodes[-1].radius:
        raise ValueError(f"a stroke begins and ends with plain points: {path!r}")
    _check_room(nodes, path)
    out: list[Vertex] = []
    for i, node in enumerate(nodes):
        if node.radius:
            _round(out, nodes[i - 1], node, nodes[i + 1])
            continue
        if node.turn:
            x, y, _ = out[-1]
            out[-1] = (x, y, math.tan(math.radians(node.turn) / 4.0))
        _add(out, node.x, node.y, 0.0)
    return tuple(out)


def lean(strokes: tuple[Stroke, ...]) -> tuple[Stroke, ...]:
    """Lean strokes to the right by 15°, point (x, y) to (x + y·tan 15°, y).

    A leaning circle is an ellipse; as with compasses, each quarter of it becomes one arc of a
    circle through its ends with its turn (off by less than 0.03 of the radius and by 2° in
    direction; where it would be more, two).
    """
    return tuple(_inclined(stroke) for stroke in strokes)


def extremes(strokes: tuple[Stroke, ...]) -> tuple[float, float, float, float]:
    """Return least x and y, largest x and y of the pen's middle, arcs included; zeros for none."""
    if not strokes:
        return (0.0, 0.0, 0.0, 0.0)
    points = [(x, y) for stroke in strokes for x, y, _ in stroke]
    for stroke in strokes:
        for start, end in pairwise(stroke):
            if start[2]:
                points += _turning_points(start, end)
    xs = [x for x, _ in points]
    ys = [y for _, y in points]
    return (min(xs), min(ys), max(xs), max(ys))


def centre(start: Vertex, end: Vertex) -> tuple[complex, complex]:
    """Return the centre of the arc between two vertices and the radius vector to its start."""
    a, b = complex(*start[:2]), complex(*end[:2])
    bulge = start[2]
    middle = (a + b) / 2.0 + (b - a) * 1j * (1.0 - bulge * bulge) / (4.0 * bulge)
    return middle, a - middle


def _node(word: str) -> _Node:
    place, _, extra = word.partition(":")
    x, y = (float(number) for number in place.split(","))
    if extra.startswith("r"):
        return _Node(x, y, float(extra[1:]), 0.0)
    return _Node(x, y, 0.0, float(extra) if extra else 0.0)


def _tangent(before: _Node, node: _Node, after: _Node) -> tuple[float, complex, complex, float]:
    """Length of the tangents of a rounded corner, the two directions, the turn in radians."""
    a = complex(node.x - before.x, node.y - before.y)
    b = complex(after.x - node.x, after.y - node.y)
    turned = b * a.conjugate()
    turn = math.atan2(turned.imag, turned.real)
    return node.radius * abs(math.tan(turn / 2.0)), a / abs(a), b / abs(b), turn


def _check_room(nodes: list[_Node], path: str) -> None:
    room = [0.0] * len(nodes)
    for i, node in enumerate(nodes):
        if node.radius:
            if node.turn or nodes[i + 1].turn:
                raise ValueError(f"an arc runs into a rounded corner: {path!r}")
            room[i] = _tangent(nodes[i - 1], node, nodes[i + 1])[0]
    for i in range(1, len(nodes)):
        length = math.hypot(nodes[i].x - nodes[i - 1].x, nodes[i].y - nodes[i - 1].y)
        if room[i - 1] + room[i] > length + 1e-6:
            raise ValueError(f"no room for the rounding before point {i + 1} of {path!r}")


def _round(out: list[Vertex], before: _Node, node: _Node, after: _Node) -> None:
    length, a, b, turn = _tangent(before, node, after)
    start = complex(node.x, node.y) - a * length
    end = complex(node.x, node.y) + b * length
    _add(out, start.real, start.imag, math.tan(turn / 4.0))
    _add(out, end.real, end.imag, 0.0)


def _add(out: list[Vertex], x: float, y: float, bulge: float) -> None:
    """Put a vertex; one that falls on the last gives it its bulge instead."""
    if out and not out[-1][2] and math.hypot(x - out[-1][0], y - out[-1][1]) < _SAME:
        out[-1] = (out[-1][0], out[-1][1], bulge)
    else:
        out.append((x, y, bulge))


def _turning_points(start: Vertex, end: Vertex) -> list[tuple[float, float]]:
    """Points of an arc whose tangent is level or upright."""
    middle, radius = centre(start, end)
    begin, turn = math.atan2(radius.imag, radius.real), 4.0 * math.atan(start[2])
    low, high = sorted((begin, begin + turn))
    quarter = math.pi / 2.0
    found = []
    for k in range(math.ceil(low / quarter - _SAME), math.floor(high / quarter + _SAME) + 1):
        point = middle + abs(radius) * complex(*((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4])
        found.append((point.real, point.imag))
    return found


def _lean(point: complex) -> complex:
    return complex(point.real + SLANT * point.imag, point.imag)


def _inclined(stroke: Stroke) -> Stroke:
    out: list[Vertex] = []
    for i, start in enumerate(stroke):
        if not start[2] or i + 1 == len(stroke):
            out.append((start[0] + SLANT * start[1], start[1], 0.0))
            continue
        middle, radius = centre(start, stroke[i + 1])
        begin, turn = math.atan2(radius.imag, radius.real), 4.0 * math.atan(start[2])
        ends = [begin, *_quarters(begin, begin + turn), begin + turn]
        for first, last in pairwise(ends):
            _lean_arc(out, middle, abs(radius), first, last)
    return tuple(out)


def _quarters(begin: float, end: float) -> list[float]:
    """Angles between begin and end, in order, where a circle's tangent is level or upright."""
    quarter = math.pi / 2.0
    low, high = sorted((begin, end))
    inner = [
        k * quarter
        for k in range(math.ceil(low / quarter), math.floor(high / quarter) + 1)
        if low + 1e-6 < k * quarter < high - 1e-6
    ]
    return inner if begin < end else inner[::-1]


def _lean_arc(out: list[Vertex], middle: complex, radius: float, first: float, last: float) -> None:
    """Add the start of one arc of a circle for a leaning piece of a circle, or of two."""
    start, end = (middle + radius * complex(math.cos(a), math.sin(a)) for a in (first, last))
    sense = math.copysign(1.0, last - first)
    chord = _lean(end) - _lean(start)
    leaving, arriving = (
        _lean(sense * 1j * complex(math.cos(a), math.sin(a))) for a in (first, last)
    )
    before, after = leaving.conjugate() * chord, chord.conjugate() * arriving
    turns = (math.atan2(before.imag, before.real), math.atan2(after.imag, after.real))
    if abs(turns[0] - turns[1]) > 2.0 * _KINK:
        half = (first + last) / 2.0
        _lean_arc(out, middle, radius, first, half)
        _lean_arc(out, middle, radius, half, last)
        return
    place = _lean(start)
    out.append((place.real, place.imag, math.tan(sum(turns) / 4.0)))


BLANKS = {" ": 2.0, "\u00a0": 2.0, "\u202f": 0.0, "\u2009": 0.0}
"""Widths of blanks: with a gap of 2 on both sides they part words by 6 and thousands by 4 units."""


class Glyph(NamedTuple):
    """A letter: its clear width (units, pen included) and the strokes of the pen's middle."""

    width: float
    strokes: tuple[Stroke, ...]


@cache
def _table() -> dict[str, str]:
    """Every drawn character with the rest of its line; a line is parsed when it is needed."""
    lines = "\n".join((CAPITALS, SMALL, LATIN, DIGITS, GREEK, PUNCTUATION, MATHEMATICS))
    table: dict[str, str] = {}
    for line in lines.splitlines():
        if line:
            character, rest = line.split(None, 1)
            if character in table:
                raise ValueError(f"{character!r} stands twice in the tables of glyphs")
            table[character] = rest
    return table


@cache
def characters() -> frozenset[str]:
    """Return all characters that have a glyph, blanks included."""
    return frozenset(_table()) | frozenset(BLANKS)


@lru_cache(maxsize=1024)
def glyph(character: str) -> Glyph:
    """Return the upright glyph of a character; KeyError where there is none.

    Returns
    -------
    Glyph
        Its left edge of ink is x = 0 and its base line, the lower edge of the ink, y = 0 (units).
    """
    if character in BLANKS:
        return Glyph(BLANKS[character], ())
    width, path = _table()[character].split(None, 1)
    if width == "=":
        return glyph(path)
    return Glyph(float(width), tuple(_on_base_line(parse(part)) for part in path.split("|")))


def _on_base_line(stroke: Stroke) -> Stroke:
    return tuple((x + 0.5, y + 0.5, bulge) for x, y, bulge in stroke)
