"""Where what was made of an arc cam is held."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.scene.chapter import Made

if TYPE_CHECKING:
    from graphic_tmm.chapters.arc_cam.plan import ArcCam

ARC_CAM: Made[ArcCam] = Made("arc_cam")
