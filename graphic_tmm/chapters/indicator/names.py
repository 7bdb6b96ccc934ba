"""What others call what there is of an indicator diagram: views, places, what was made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.indicator.cylinder import Cylinder

INDICATOR: Made[Cylinder] = Made("indicator")
VIEW = "indicator"
CALCULATED = "indicator-calculation"
"""The view of what is calculated beside."""
