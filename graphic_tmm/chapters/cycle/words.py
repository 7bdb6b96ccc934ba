"""What the chapter of the flywheel for a cycle calls things."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.task import CYCLE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

WORDS = Named(
    captions={
        "cycle": said("Flywheel for a cycle of moments"),
        "given cycle": said("Given for the cycle"),
        "table cycle": said("Flywheel, by positions"),
    },
    plans=(CYCLE,),
    sources=("artobolevsky",),
)
