"""Strokes as entities of a DXF document: lines, circles, arcs, polylines; conventional signs as blocks.

A block is what the strokes of a sign are about its own origin. Signs of one kind that look otherwise (a support
whose hatching a letter interrupts) are blocks of their own, numbered.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import Any, NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Bezier, Ink, Path, Stroke, Symbol, Vertex
from graphic_tmm.paper.pens import Pen
from graphic_tmm.paper.shapes import shape

SAME = 1e-6
"""Places closer than this, mm, coincide: a thousandth of the precision of an SVG."""


class Line(NamedTuple):
    """A straight line."""

    start: complex
    end: complex


class Circle(NamedTuple):
    """A full circle."""

    centre: complex
    radius: float


class Arc(NamedTuple):
    """An arc, counter-clockwise from ``start`` to ``end``, degrees."""

    centre: complex
    radius: float
    start: float
    end: float


def recognised(stroke: Stroke) -> Line | Circle | Arc | None:
    """Return what a stroke is as a whole; None for a polyline."""
    path = stroke.path
    if len(path) == 2 and not stroke.closed and path[0][2] == 0.0:
        return Line(complex(*path[0][:2]), complex(*path[1][:2]))
    segments = [*pairwise(path), *([(path[-1], path[0])] if stroke.closed else [])]
    bulges = [a[2] for a, _ in segments]
    if not bulges or not (all(b > 0 for b in bulges) or all(b < 0 for b in bulges)):
        return None
    centres = [_centre(a, b) for a, b in segments]
    centre = centres[0]
    start, end = complex(*path[0][:2]), complex(*segments[-1][1][:2])
    radius = abs(start - centre)
    reaches = [abs(complex(*vertex[:2]) - centre) for vertex in path]
    if max(abs(z - centre) for z in centres) > SAME or max(reaches) - min(reaches) > SAME:
        return None
    turn = sum(4 * math.atan(b) for b in bulges)
    if abs(end - start) <= SAME and abs(abs(turn) - 2 * math.pi) < 1e-6:
        return Circle(centre, radius)
    if abs(turn) >= 2 * math.pi:
        return None
    ends = [math.degrees(cmath.phase(z - centre)) % 360.0 for z in (start, end)]
    return Arc(centre, radius, *(ends if turn > 0 else reversed(ends)))


def _centre(a: Vertex, b: Vertex) -> complex:
    """Return the centre of the arc between two vertices; its bulge is not 0."""
    start, chord, bulge = complex(*a[:2]), complex(b[0] - a[0], b[1] - a[1]), a[2]
    return start + chord / 2 + 1j * chord * (1 - bulge * bulge) / (4 * bulge)


DIGITS = 6
"""Decimals of a coordinate, mm: the same bytes whatever the last bits."""
WEIGHTS = (
    *(13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70),
    *(80, 90, 100, 106, 120, 140, 158, 200, 211),
)
"""Line weights that DXF knows, 1/100 mm."""
RUNNING = 128
"""Flag of a polyline whose dashes run on over its corners."""


def weight(width: float) -> int:
    """Return the line weight of DXF nearest to a width in mm."""
    return min(WEIGHTS, key=lambda known: abs(known - 100 * width))


def spot(z: complex) -> tuple[float, float]:
    """Return a place as DXF has it; SheetError if it is none."""
    if not cmath.isfinite(z):
        raise SheetError(f"a coordinate of the sheet is not a finite number: {z}")
    return round(z.real, DIGITS), round(z.imag, DIGITS)


def vertices(path: Path) -> list[tuple[float, float, float]]:
    """Return a path as DXF has it: x, y, bulge."""
    return [(*spot(complex(x, y)), round(bulge, 9)) for x, y, bulge in path]


class Inker:
    """Writes strokes into a space, each as what it is."""

    def __init__(self, space: Any, pens: Mapping[str, Pen]) -> None:
        self.space, self.pens = space, pens

    def stroke(self, stroke: Ink, style: Mapping[str, Any]) -> None:
        """Write one stroke: a curve, a filled shape, or a line with the wipeout below its outline."""
        pen = self.pens[stroke.pen]
        if isinstance(stroke, Bezier):
            self.spline(stroke, style)
        elif stroke.filled:
            self.filled(stroke, style)
        else:
            if pen.fill == "white":
                vertices(stroke.path)  # refused if it has no place
                corners = [spot(complex(x, y)) for x, y in shape(stroke).coords[:-1]]
                self.space.add_wipeout(corners, dxfattribs=style)
            if pen.width:
                self.line(stroke, style)

    def spline(self, curve: Bezier, style: Mapping[str, Any]) -> None:
        """Write cubic arcs as one spline: the same points, each joint a knot of three."""
        arcs = (len(curve.controls) - 1) // 3
        inner = [float(k) for k in range(1, arcs) for _ in range(3)]
        knots = [0.0] * 4 + inner + [float(arcs)] * 4
        points = [spot(z) for z in curve.controls]
        self.space.add_open_spline(points, degree=3, knots=knots, dxfattribs=style)

    def filled(self, stroke: Stroke, style: Mapping[str, Any]) -> None:
        """Write a filled shape: a triangle as a solid, as arrowheads are; any other as a hatch."""
        points = vertices(stroke.path)
        if len(points) == 3 and not any(bulge for _, _, bulge in points):
            self.space.add_solid([point[:2] for point in points], dxfattribs=style)
            return
        hatch = self.space.add_hatch(color=256, dxfattribs=style)
        found = recognised(stroke)
        if isinstance(found, Circle):
            hatch.paths.add_edge_path().add_arc(spot(found.centre), round(found.radius, DIGITS))
        else:
            hatch.paths.add_polyline_path(points, is_closed=True)

    def line(self, stroke: Stroke, style: Mapping[str, Any]) -> None:
        """Write a line as what it is."""
        match recognised(stroke):
            case Line(start, end):
                self.space.add_line(spot(start), spot(end), dxfattribs=style)
            case Circle(centre, radius):
                self.space.add_circle(spot(centre), round(radius, DIGITS), dxfattribs=style)
            case Arc(centre, radius, start, end):
                angles = (round(start, 9), round(end, 9))
                self.space.add_arc(spot(centre), round(radius, DIGITS), *angles, dxfattribs=style)
            case None:
                made = self.space.add_lwpolyline(
                    vertices(stroke.path), format="xyb", close=stroke.closed, dxfattribs=style
                )
                made.dxf.flags |= RUNNING


class Sign(NamedTuple):
    """A sign on a drawing, its strokes, the uppermost of their pens, and the position that it belongs to."""

    symbol: Symbol
    strokes: tuple[Stroke, ...]
    pen: str
    position: int | None


def symbol_of(stroke: Ink) -> Symbol | None:
    """Return the sign of which a stroke is one; None for one that stands by itself."""
    return stroke.symbol if isinstance(stroke, Stroke) else None


def gathered(strokes: Iterable[Ink], pens: Mapping[str, Pen]) -> list[Sign]:
    """Return the signs among strokes, in the order in which they are met; what stands twice, once."""
    found: dict[tuple[Symbol, int | None], list[Stroke]] = {}
    for stroke in strokes:
        if isinstance(stroke, Stroke) and stroke.symbol is not None:
            found.setdefault((stroke.symbol, stroke.position), []).append(stroke)
    order = list(pens)
    return [
        Sign(symbol, tuple(some), max((s.pen for s in some), key=order.index), position)
        for (symbol, position), some in found.items()
    ]


class Blocks:
    """The blocks of a document, created when first needed."""

    def __init__(self, document: Any, pens: Mapping[str, Pen]) -> None:
        self.document, self.pens = document, pens
        self.names: dict[tuple[object, ...], str] = {}

    def insert(self, space: Any, sign: Sign, layer: str) -> None:
        """Put a sign into a space as a block."""
        turned = {"layer": layer, "rotation": round(sign.symbol.turn, DIGITS)}
        space.add_blockref(self.name(sign), spot(sign.symbol.at), dxfattribs=turned)

    def name(self, sign: Sign) -> str:
        """Return the name of the block that looks like a sign."""
        kind = sign.symbol.kind.upper()
        own = tuple(dict.fromkeys(_about_origin(stroke, sign.symbol) for stroke in sign.strokes))
        look = (kind, *((s.pen, s.path, s.closed, s.filled) for s in own))
        if look not in self.names:
            count = sum(known[0] == kind for known in self.names)
            self.names[look] = name = f"{kind}_{count + 1}" if count else kind
            ink = Inker(self.document.blocks.new(name), self.pens)
            order = list(self.pens)
            for stroke in sorted(own, key=lambda stroke: order.index(stroke.pen)):
                width = self.pens[stroke.pen].width
                ink.stroke(stroke, {"layer": "0", "lineweight": weight(width)})
        return self.names[look]


def _about_origin(stroke: Stroke, symbol: Symbol) -> Stroke:
    """Return a bare stroke as it would be drawn at the origin, not turned."""
    back = cmath.rect(1.0, -math.radians(symbol.turn))
    spots = [((complex(x, y) - symbol.at) * back, bulge) for x, y, bulge in stroke.path]
    path = tuple((z.real, z.imag, bulge) for z, bulge in spots)
    clean = tuple((x + 0.0, y + 0.0, bulge + 0.0) for x, y, bulge in vertices(path))
    return Stroke(stroke.pen, clean, stroke.closed, stroke.filled)
