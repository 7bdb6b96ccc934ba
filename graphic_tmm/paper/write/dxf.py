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

from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.catalogue import SOURCE, Speech, speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.pens import (
    CENTRE,
    DASHED,
    KINDS,
    LETTERING,
    PHANTOM,
    Pen,
    pens,
    refuse_unknown,
)
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.write.dxf_ink import Blocks, Inker, gathered, symbol_of, weight
from graphic_tmm.paper.write.dxf_text import Letterer, add_styles
from graphic_tmm.paper.write.svg import clean

LINETYPES = {"dashed": "DASHED", "centre": "CENTER", "phantom": "PHANTOM"}
"""Names of the line types, as CAD programs have them, of the pens that draw them."""
DASHES = {"DASHED": DASHED, "CENTER": CENTRE, "PHANTOM": PHANTOM}
"""Their strokes and gaps, mm."""
UNFIT = re.compile(r"[^\w.~-]+")
"""What the name of a layer does not hold, or better not."""
LONGEST = 255
"""Greatest number of characters of a text outside the drawing."""
WINDOW = "viewport"
"""The layer of the frame of the viewport: it is not printed."""


def dxf(sheet: Sheet, *, stroked: bool = False) -> str:
    """Return a sheet as DXF text; x right, y up, the origin in the sheet's lower left corner.

    ``stroked``: the letters as strokes, not as TEXT.

    Raises
    ------
    SheetError
        If ezdxf is not installed, a coordinate is not finite, or a pen is unknown.
    """
    try:
        from ezdxf import units
        from ezdxf._options import options
        from ezdxf.filemanagement import new
    except ImportError as error:
        raise SheetError(
            said("dxf needs the package ezdxf: {remedy}", remedy=installing("[dxf]"))
        ) from error
    kept = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True  # nothing from the clock
    try:
        document = new("R2010")
        document.units = units.MM
        _set_up(document, sheet)
        speech = speaking(sheet.language or SOURCE)
        writer = _Writer(document, pens(sheet.format), speech, stroked=stroked)
        for drawing in sheet.drawings:
            writer.draw(drawing)
        left, low, right, top = _extents(sheet)
        document.modelspace().reset_extents((left, low, 0), (right, top, 0))
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
    document.modelspace().reset_limits((0, 0), size)
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
    """What turns drawings into entities of one model space, on layers."""

    def __init__(
        self, document: Any, box: Mapping[str, Pen], speech: Speech, *, stroked: bool
    ) -> None:
        self.document, self.box, self.speech = document, box, speech
        self.ink = Inker(document.modelspace(), box)
        self.blocks = Blocks(document, box)
        self.letterer = Letterer(document, document.modelspace(), stroked=stroked)

    def layer(self, drawing: Drawing, position: int | None, kind: str, width: float) -> str:
        """Return the layer of a line kind in a view and position; it is created when first needed.

        A drawing of one position has its number in its name, one of several lists their numbers.
        """
        number = dict(drawing.numbers).get(-1 if position is None else position, "")
        view = f"{drawing.name}-{number}" if number else drawing.name
        name = UNFIT.sub("-", view.replace("*", "~")) + f"_{kind}"
        if name not in self.document.layers:
            made = self.document.layers.add(
                name, linetype=LINETYPES.get(kind, "CONTINUOUS"), lineweight=weight(width)
            )
            called = self.speech(KINDS.get(kind, LETTERING))
            told = ", ".join(filter(None, (clean(drawing.title), number, called)))
            made.description = told[:LONGEST]
        return name

    def draw(self, drawing: Drawing) -> None:
        """Write the strokes in the order of the pens, then the lettering."""
        refuse_unknown((stroke.pen for stroke in drawing.strokes), self.box, drawing.name)
        signs = gathered(drawing.strokes, self.box)
        for key, pen in self.box.items():
            for sign in (sign for sign in signs if sign.pen == key):
                layer = self.layer(drawing, sign.position, key, pen.width)
                self.blocks.insert(self.document.modelspace(), sign, layer)
            for stroke in drawing.strokes:
                if stroke.pen == key and not symbol_of(stroke):
                    layer = self.layer(drawing, stroke.position, key, pen.width)
                    self.ink.stroke(stroke, {"layer": layer})
        for label in drawing.labels:
            layer = self.layer(drawing, label.position, "lettering", label.size / 10)
            self.letterer.label(label, layer)
