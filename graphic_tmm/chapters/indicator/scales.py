"""The scale factor of an indicator diagram."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.fitting.scales import ScaleFactors

SCALES = ScaleFactors(key=lambda view: "mu_p" if view == VIEW else "")
