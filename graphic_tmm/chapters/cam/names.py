"""What others call what there is of a cam: views, places, what was made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.cam.plan import Cam

CAM: Made[Cam] = Made("cam")
GRAPHS = "cam graphs"
"""The size of a cam's diagrams; that of its other views is called as the chapter is."""
