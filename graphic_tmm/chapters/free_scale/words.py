"""What people call a plan of velocities to a free scale; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.free_scale.task import FREE_SCALE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

PLATE = "free scale plate"
"""The view in which the line of two pins of the plate is drawn."""
TITLE = said("Velocities by link {link} as the driving one, position {position}")
LINE = said("The line of two pins of the plate")
CAPTIONS: dict[str, str] = {
    "chapter free_scale": said("Velocities by another driving link"),
    FREE_SCALE: said("Velocities by another driving link, to a free scale"),
    f"table {FREE_SCALE}": said("Velocities by another driving link"),
}

FREE = said("How long this vector is may be chosen: only ratios of velocities count so far.")

WORDS = Named(captions=CAPTIONS, plans=(FREE_SCALE,), sources=("artobolevsky",))
