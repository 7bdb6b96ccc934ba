"""What the parts of drawings are called: the layers that the page shows and hides."""

from __future__ import annotations

from graphic_tmm.language.said import said

PARTS: dict[str, str] = {
    "angle": said("angles"),
    "arm": said("arms of forces"),
    "axis": said("axes"),
    "carrier": said("carriers"),
    "centre": said("mass centres"),
    "circle": said("circles"),
    "contour": said("contours"),
    "couple": said("couples"),
    "cylinder": said("cylinders"),
    "dimension": said("dimensions"),
    "face": said("flat faces"),
    "follower": said("followers"),
    "given": said("given loads"),
    "guide": said("guides"),
    "hatching": said("hatching"),
    "leader": said("leaders of letters"),
    "limit": said("limits"),
    "link": said("links"),
    "mean": said("mean values"),
    "normal": said("normals"),
    "number": said("rings of link numbers"),
    "outline": said("outlines"),
    "pair": said("turning pairs"),
    "path": said("paths"),
    "piston": said("pistons"),
    "pivot": said("fixed pivots"),
    "point": said("points"),
    "pole": said("poles"),
    "rim": said("rims"),
    "ring": said("ring gears"),
    "roller": said("rollers"),
    "sense": said("senses of rotation"),
    "slider": said("sliders"),
    "stone": said("stones"),
    "tooth": said("teeth"),
    "turning": said("sense of the crank"),
    "wheel": said("wheels"),
}
"""By what a stroke is a part of (`Stroke.part`)."""
