"""What others call what there is of a flywheel: views, places, what was made."""

from __future__ import annotations

FLYWHEEL = "flywheel"
VIEWS = {"moment": "moment", "work": "work", "energy": "energy"}
CALCULATED = "flywheel-calculation"
"""The view of what is calculated beside."""
ENERGY_MASS = "energy-mass"
