"""What people call the indicator diagram."""

from __future__ import annotations

from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "indicator": said("Indicator diagram"),
    "strokes of the cycle": said("Strokes of the cycle"),
    "indicator-calculation": said("Scale of the stroke"),
}


WORDS = Named(
    captions=CAPTIONS,
    sources=("artobolevsky",),
)
