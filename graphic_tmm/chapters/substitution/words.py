"""What people call accelerations by substitution; why the steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.substitution.task import SUBSTITUTION
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

HELD = "substitution velocities"
"""The view of velocities with the pivots held."""
PLATES = "substitution plates"
"""The view in which lengths of plates are read."""
HELD_TITLE = said("Velocities with the pivots held, position {position}")
HELD_VIEW = said("Velocities with the pivots held")
TITLE = said("Accelerations by substitution, position {position}")
CAPTIONS: dict[str, str] = {
    "chapter substitution": said("Accelerations by substitution"),
    SUBSTITUTION: said("Accelerations by substitution"),
    f"table {SUBSTITUTION}": said("Accelerations by substitution"),
}

FREE = said("How long this vector is may be chosen: only the ratio to the others counts.")
WITHOUT_EPSILON = said(
    "ε of the plate is taken as 0 first: its points have normal accelerations alone."
)
GAP = said(
    "The other joining link is rigid: along it its ends differ by its normal acceleration. They are this far "
    "from it as long as ε = 0."
)
PARTING = said("So fast the ends of that link part along it while the pivots stand.")
ADDED = said("The plan with the pivots held is added as many times as closes the gap.")

WORDS = Named(captions=CAPTIONS, plans=(SUBSTITUTION,), sources=("artobolevsky",))
