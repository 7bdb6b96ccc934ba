"""DXF R2010 of a sheet, by ezdxf (extra ``dxf``), so that the drawing goes on in a CAD program.

Millimetres; layers by plan and by line type; line weights and standard linetype names; strokes, lettering
too, as polylines with bulges; what hides lines on paper is a wipeout.
"""

from __future__ import annotations

import cmath
import io
import math
from typing import Any

from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Sheet, Stroke
from graphic_tmm.paper.labels import flat, shape
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.pens import Pen, pens
from graphic_tmm.paper.write.svg import shift

WEIGHTS = (
    13,
    15,
    18,
    20,
    25,
    30,
    35,
    40,
    50,
    53,
    60,
    70,
    80,
    90,
    100,
    106,
    120,
    140,
    158,
    200,
    211,
)
"""Line weights that DXF knows, 1/100 mm."""
LINETYPES = {"dashed": "DASHED", "centre": "CENTER", "phantom": "DASHDOT"}


def dxf(sheet: Sheet) -> str:
    """Return a sheet as DXF text; x right, y up, the origin in the sheet's lower left corner.

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
        document = new("R2010", setup=["linetypes"])
        document.units = units.MM
        document.set_wipeout_variables(frame=0)
        writer = _Writer(document, pens(sheet.format))
        for drawing in sheet.drawings:
            writer.draw(drawing)
        out = io.StringIO()
        document.write(out)
    finally:
        options.write_fixed_meta_data_for_testing = kept
    return out.getvalue()


class _Writer:
    """What turns records of ink into entities of one model space."""

    def __init__(self, document: Any, box: Any) -> None:
        self.document, self.space, self.box = document, document.modelspace(), box

    def layer(self, drawing: Drawing, pen: str, width: float) -> str:
        """Return the layer of a pen in a plan, made when it is first needed."""
        name = f"{drawing.name.split('-')[0]}_{pen}"
        if name not in self.document.layers:
            self.document.layers.add(
                name, linetype=LINETYPES.get(pen, "CONTINUOUS"), lineweight=_weight(width)
            )
        return name

    def draw(self, drawing: Drawing) -> None:
        """Write the strokes in the order of the pens, then the lettering."""
        for key, pen in self.box.items():
            for stroke in drawing.strokes:
                if stroke.pen == key:
                    self.stroke(drawing, stroke, pen)
        for label in drawing.labels:
            self.label(drawing, label)

    def stroke(self, drawing: Drawing, stroke: Stroke | Bezier, pen: Pen) -> None:
        """Write one stroke: a polyline, a filled hatch, or a wipeout below its outline."""
        layer = {"layer": self.layer(drawing, stroke.pen, pen.width)}
        if isinstance(stroke, Bezier):
            points = [(z.real, z.imag) for z in flat(stroke.controls)]
            self.space.add_lwpolyline(points, dxfattribs=layer)
            return
        if stroke.filled:
            hatch = self.space.add_hatch(color=256, dxfattribs=layer)
            hatch.paths.add_polyline_path(stroke.path, is_closed=True)
            return
        if pen.fill == "white":
            self.space.add_wipeout(_outline(stroke), dxfattribs=layer)
        if pen.width:
            self.space.add_lwpolyline(
                stroke.path, format="xyb", close=stroke.closed, dxfattribs=layer
            )

    def label(self, drawing: Drawing, label: Label) -> None:
        """Write a label as the strokes of its letters."""
        written = letters.letter(label.text, size=label.size, inclined=label.inclined)
        start, turn = (
            label.at - shift(label, written.width),
            cmath.rect(1.0, math.radians(label.turn)),
        )
        layer = {"layer": self.layer(drawing, f"lettering_{label.size:g}", label.size / 10)}
        for path in written.strokes:
            spots = [(start + complex(x, y) * turn, bulge) for x, y, bulge in path]
            points = [(z.real, z.imag, bulge) for z, bulge in spots]
            self.space.add_lwpolyline(points, format="xyb", dxfattribs=layer)


def _outline(stroke: Stroke) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in shape(stroke).coords[:-1]]


def _weight(width: float) -> int:
    """Return the line weight of DXF nearest to a width in mm."""
    return min(WEIGHTS, key=lambda known: abs(known - 100 * width))
