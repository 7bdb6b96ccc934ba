"""Why the diagrams of a point are begun as they are."""

from __future__ import annotations

from graphic_tmm.language.said import said

TRAVEL = said("The displacement is counted from the zero position, along the guide.")
END_OF_INTEGRAL = said(
    "After a turn the point is back, so the integral of its velocity ends at 0; what is left is the error "
    "of the drawing."
)
MEAN_READ = said(
    "The mean derivative over an interval stands over its middle, from where the smooth curve goes on."
)
