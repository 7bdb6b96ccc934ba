"""Why the indicator diagram is divided and read as it is."""

from __future__ import annotations

from graphic_tmm.language.said import said

AUXILIARY = said(
    "On a ray at any angle the travel may be laid off as it is, whatever the length of the base."
)
TRAVEL_ON_RAY = said(
    "The travel of the piston in this position, as it was read off the plan of positions."
)
CLOSING = said("The end of the stroke on the ray belongs to the end of the base.")
ALIKE = said("Parallels cut both lines in the same ratio: the base is divided as the stroke is.")
PRESSURE = said("Over the place of the piston stands the pressure of this position, to scale.")
PRESSURE_READ = said("The ordinate over the place of the piston is the pressure there.")
