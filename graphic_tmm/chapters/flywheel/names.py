"""What others call what there is of a flywheel: views, places, what was made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.flywheel.plan import Flywheel

FLYWHEEL: Made[Flywheel] = Made("flywheel")
VIEWS = {"moment": "moment", "work": "work", "energy": "energy"}
CALCULATED = "flywheel-calculation"
"""The view of what is calculated beside."""
ENERGY_MASS = "energy-mass"
