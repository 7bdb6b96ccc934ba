"""What others call what there is of forces: views, places, what was made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.forces.plan import Forces

FORCES: Made[Forces] = Made("forces")
LOADS = "load diagram"
"""The place of the diagrams of loads."""
