"""DXF R2010 of a sheet, by ezdxf (extra ``dxf``), so that the drawing goes on in a CAD program.

Millimetres, the sheet at 1:1 in model space, and a paper layout that shows it so. What is round is a CIRCLE or
an ARC, a smooth curve a SPLINE, lettering TEXT; symbols of pairs and supports are blocks. A layer for each
view, position and line kind; what hides lines on paper is a wipeout.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from typing import Any

from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke
from graphic_tmm.paper.labels import box, shape
from graphic_tmm.paper.pens import CENTRE, DASHED, PHANTOM, Pen, pens
from graphic_tmm.paper.write.dxf_shapes import Arc, Circle, Line, recognised
from graphic_tmm.paper.write.dxf_text import Letterer, add_styles, spot, weight

LINETYPES = {"dashed": "DASHED", "centre": "CENTER", "phantom": "PHANTOM"}
"""Names of the line types, as CAD programs have them, of the pens that draw them."""
DASHES = {"DASHED": DASHED, "CENTER": CENTRE, "PHANTOM": PHANTOM}
"""Their strokes and gaps, mm."""
WINDOW = "viewport"
"""The layer of the frame of the viewport: it is not printed."""


def dxf(sheet: Sheet, *, stroked: bool = False) -> str:
    """Return a sheet as DXF text; x right, y up, the origin in the sheet's lower left corner.

    ``stroked``: the letters as strokes, not as TEXT.

    Raises
    ------
    SheetError
        If ezdxf is not installed.
    """
    try:
        from ezdxf import units
        from ezdxf._options import options
        from ezdxf.filemanagement import new
    except ImportError as error:
        raise SheetError(
            said("dxf needs the package ezdxf: pip install 'graphic-tmm[dxf]'")
        ) from error
    kept = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True  # nothing from the clock
    try:
        document = new("R2010")
        document.units = units.MM
        _set_up(document, sheet)
        writer = _Writer(document, pens(sheet.format), stroked=stroked)
        for drawing in sheet.drawings:
            writer.draw(drawing)
        for kind in sorted(document.entitydb.dxf_types_in_use()):
            document.classes.add_class(kind)  # which ezdxf would do in the order of a set
        out = io.StringIO()
        document.write(out)
    finally:
        options.write_fixed_meta_data_for_testing = kept
    return out.getvalue()


def _set_up(document: Any, sheet: Sheet) -> None:
    """Define line types and text styles, and a paper layout of the sheet at 1:1."""
    document.header["$LWDISPLAY"] = 1
    document.set_wipeout_variables(frame=0)
    for name, dashes in DASHES.items():
        signed = [dash * (1, -1)[k % 2] for k, dash in enumerate(dashes)]
        document.linetypes.add(name, [sum(dashes), *signed], description=name.lower())
    add_styles(document)
    size, middle = (sheet.width, sheet.height), (sheet.width / 2, sheet.height / 2)
    left, low, right, top = _extents(sheet)
    model = document.modelspace()
    model.reset_limits((0, 0), size)
    model.reset_extents((left, low, 0), (right, top, 0))
    document.set_modelspace_vport(sheet.height, middle)
    document.layouts.rename("Layout1", sheet.format)
    paper = document.layout(sheet.format)
    paper.page_setup(size, scale=(1, 1), name=f"ISO_full_bleed_{sheet.format.split()[0]}")
    paper.reset_extents((0, 0, 0), (*size, 0))
    document.layers.add(WINDOW, plot=False)
    paper.add_viewport(middle, size, middle, sheet.height, dxfattribs={"layer": WINDOW})


def _extents(sheet: Sheet) -> tuple[float, float, float, float]:
    """Return left, lower, right and upper edge of all strokes and letters, mm; of a bare sheet its own."""
    import shapely

    found = [shape(stroke) for drawing in sheet.drawings for stroke in drawing.strokes]
    found += [box(label) for drawing in sheet.drawings for label in drawing.labels]
    if not found:
        return (0.0, 0.0, sheet.width, sheet.height)
    left, low, right, top = (round(float(edge), 6) for edge in shapely.total_bounds(found))
    return left, low, right, top


class _Writer:
    """What turns records of ink into entities of one model space."""

    def __init__(self, document: Any, pens: Mapping[str, Pen], *, stroked: bool) -> None:
        self.document, self.space, self.pens = document, document.modelspace(), pens
        self.letterer = Letterer(document, self.space, stroked=stroked)

    def layer(self, drawing: Drawing, kind: str, width: float) -> str:
        """Return the layer of a line kind in a view, made when it is first needed."""
        name = re.sub(r"[^\w.-]+", "-", drawing.name) + f"_{kind}"
        if name not in self.document.layers:
            made = self.document.layers.add(
                name, linetype=LINETYPES.get(kind, "CONTINUOUS"), lineweight=weight(width)
            )
            made.description = f"{drawing.title or drawing.name}: {kind}"
        return name

    def draw(self, drawing: Drawing) -> None:
        """Write the strokes in the order of the pens, then the lettering."""
        for key, pen in self.pens.items():
            for stroke in drawing.strokes:
                if stroke.pen == key:
                    self.stroke(stroke, pen, {"layer": self.layer(drawing, key, pen.width)})
        for label in drawing.labels:
            self.letterer.label(label, self.layer(drawing, "lettering", label.size / 10))

    def stroke(self, stroke: Stroke | Bezier, pen: Pen, style: Mapping[str, Any]) -> None:
        """Write one stroke: a curve, a filled shape, or a line with the wipeout below its outline."""
        if isinstance(stroke, Bezier):
            self.spline(stroke, style)
        elif stroke.filled:
            self.filled(stroke, style)
        else:
            if pen.fill == "white":
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
        points = _vertices(stroke)
        if len(points) == 3 and not any(bulge for _, _, bulge in points):
            self.space.add_solid([point[:2] for point in points], dxfattribs=style)
            return
        hatch = self.space.add_hatch(color=256, dxfattribs=style)
        hatch.paths.add_polyline_path(points, is_closed=True)

    def line(self, stroke: Stroke, style: Mapping[str, Any]) -> None:
        """Write a line as what it is."""
        match recognised(stroke):
            case Line(start, end):
                self.space.add_line(spot(start), spot(end), dxfattribs=style)
            case Circle(centre, radius):
                self.space.add_circle(spot(centre), round(radius, 6), dxfattribs=style)
            case Arc(centre, radius, start, end):
                angles = (round(start, 9), round(end, 9))
                self.space.add_arc(spot(centre), round(radius, 6), *angles, dxfattribs=style)
            case None:
                made = self.space.add_lwpolyline(
                    _vertices(stroke), format="xyb", close=stroke.closed, dxfattribs=style
                )
                made.dxf.flags |= 128  # dashes run on over the corners


def _vertices(stroke: Stroke) -> list[tuple[float, float, float]]:
    return [(*spot(complex(x, y)), round(bulge, 9)) for x, y, bulge in stroke.path]
