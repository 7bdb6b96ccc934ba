"""What the page says where a person lays his own drawing on it, by the names that its program has for it."""

from __future__ import annotations

from graphic_tmm.checking.photo.frame_lines import EDGES
from graphic_tmm.language.said import said

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
