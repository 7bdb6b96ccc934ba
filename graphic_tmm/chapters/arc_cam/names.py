"""Where what was made of an arc cam is held."""

from __future__ import annotations

ARC_CAM = "arc_cam"
