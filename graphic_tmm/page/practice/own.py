"""For a drawing of one's own: what the page packs (frames, papers, how lines are sought) and says."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from graphic_tmm.checking.photo import camera, flatten, frame_lines
from graphic_tmm.checking.photo.frame_lines import EDGES
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.paper.sheet_frame import drawing_area


def seeking() -> dict[str, float]:
    """Return how the frame's lines are sought (Seeking of own/strip.js), by the numbers that the check has."""
    return {
        "stations": frame_lines.STATIONS,
        "sights": frame_lines.SIGHTS,
        "reach": frame_lines.REACH,
        "far": frame_lines.FAR,
        "clear": frame_lines.CLEAR,
        "clearDots": frame_lines.CLEAR_DOTS,
        "aside": frame_lines.ASIDE,
        "nearCorner": frame_lines.NEAR_CORNER,
        "faint": frame_lines.FAINT,
        "seen": frame_lines.SEEN,
        "bend": frame_lines.BEND,
        "stray": frame_lines.STRAY,
        "degree": frame_lines.DEGREE,
        "rounds": frame_lines.ROUNDS,
        "cut": frame_lines.CUT,
        "floor": frame_lines.FLOOR,
        "dim": frame_lines.DIM,
        "share": camera.MOST_BOWED,
        "usual": camera.USUAL_CURL,
        "doubt": camera.CURL_DOUBT,
        "shortest": camera.CURL_SIZES[0],
        "longest": camera.CURL_SIZES[1],
        "stiff": camera.STIFF,
        "clearer": camera.CLEARER,
    }


def too_much() -> dict[str, float]:
    """Return from where on a photograph is told of: a bent sheet, a bowing lens, mm."""
    return {"bent": flatten.BENT, "bowed": flatten.BOWED}


OWN: dict[str, str] = {
    "own": said("Own drawing"),
    "own drop": said(
        "Drop a photograph or a scan of your sheet here, or choose a file (JPEG, PNG, WebP)."
    ),
    "own choose": said("Choose a photograph"),
    "own of": said("You click the corners of"),
    "own frame": said("the frame of sheet {sheet}"),
    "own paper": said("the paper {name}"),
    "own rectangle": said("a rectangle"),
    "own width": said("Width, mm"),
    "own height": said("Height, mm"),
    "own corner": said("Corner {n} of 4: tap it roughly; the lines of the frame are found then."),
    "own corner fine": said(
        "Corner {n} of 4: tap it, draw the picture in the loupe until it is under the cross, take it."
    ),
    "own again": said("Corners anew"),
    "own opening": said("The photograph is read …"),
    "own flattening": said("It is laid flat: {percent}"),
    "own exact": said("Exact plan over it"),
    "own origin": said(
        "Tap {letter}, the origin of the plan; draw the picture in the loupe until it is under the cross."
    ),
    "own point": said("Tap {letter}; draw it in the loupe under the cross."),
    "own nameless": said("the origin"),
    "own take": said("Take it"),
    "own all": said("All points of this plan are read. Choose another plan, or save the readings."),
    "own save": said("Save the readings"),
    "own file": said("readings", context="file"),
    "own points": said("Points"),
    "own plan": said("Plan and position"),
    "own desk": said(
        "The photograph: arrows move the cross by a quarter of a dot, held faster; Enter takes the point; "
        "+ and − zoom, 0 whole"
    ),
    "own loupe": said("Loupe, four times"),
    "own nudge": said("Move the cross by a quarter of a dot; held, faster"),
    "own enter": said("Take the point"),
    "own fine": said("fine"),
    "own doubtful": said("doubtful"),
    "own wrong": said("wrong"),
    "own verdict": said("{letter} ({x}; {y}) mm: {verdict}, off by {error} mm."),
    "own follows": said("It follows from an earlier point."),
    "own flat": said("The frame was found; it is straight within {bend} mm."),
    "own lies": said("The photograph lies flat."),
    "own missing": said("No line of the frame at its {edges} edge: these corners stay as clicked."),
    "own edge 0": EDGES[0],
    "own edge 1": EDGES[1],
    "own edge 2": EDGES[2],
    "own edge 3": EDGES[3],
    "own bent": said(
        "The frame is bent by {bend} mm: the sheet is not flat. Take the photograph anew, the sheet pressed "
        "flat."
    ),
    "own bowed": said(
        "The lens bows the frame by {bend} mm: it is taken out, but photograph from farther away, without wide "
        "angle."
    ),
    "own turned": said(
        "The frame looks turned by a quarter: turn the photograph upright, or choose another paper."
    ),
    "own no corners": said("These four make no quadrilateral: give each corner once."),
    "own heic": said(
        "This is a HEIC photograph, which browsers do not read: save it as JPEG (on an iPhone: Settings, "
        "Camera, Formats, Most Compatible)."
    ),
    "own pdf": said("This is a PDF: save its page as a picture, PNG or JPEG."),
    "own tiff": said("This is a TIFF, which browsers do not read: save it as PNG."),
    "own unknown": said("This is no photograph that can be read: save it as JPEG or PNG."),
    "own large": said("The file has more than 200 MB: save it smaller, as JPEG."),
    "own damaged": said(
        "The photograph cannot be read: it is damaged or too large. Save it anew as JPEG."
    ),
}
"""Braces are filled in by the page."""


_WAYS = {"portrait": said("upright"), "landscape": said("lying")}
"""How a format of its own name does not lie."""


def own(sheets: Sequence[Sheet], language: str) -> dict[str, Any]:
    """Return the data of a drawing of one's own (OwnPack of web/own/corners.js)."""
    return {
        "frames": [_frame(sheet, language, number == 0) for number, sheet in enumerate(sheets)],
        "papers": [
            [_called(name, language), paper.width, paper.height] for name, paper in FORMATS.items()
        ],
        "seeking": seeking(),
    } | too_much()


def _frame(sheet: Sheet, language: str, first: bool) -> list[float]:
    """Return the frame of a sheet, mm from its lower left corner: left, bottom, right, top."""
    return [round(float(side), 6) for side in drawing_area(sheet.format, language, first).inner]


def _called(name: str, language: str) -> str:
    """Return what a format is called: A4, A4 lying."""
    size, _, way = name.partition(" ")
    return f"{size} {speaking(language)(_WAYS[way])}" if way else size
