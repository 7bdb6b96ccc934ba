"""Strokes as entities of a space of a DXF document: model space, or a block."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from typing import Any

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Bezier, Ink, Path, Stroke
from graphic_tmm.paper.pens import Pen
from graphic_tmm.paper.shapes import shape
from graphic_tmm.paper.write.dxf_shapes import Arc, Circle, Line, recognised

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
