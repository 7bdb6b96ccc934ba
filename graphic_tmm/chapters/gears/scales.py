"""The scale factors of a pair of gears."""

from __future__ import annotations

from graphic_tmm.chapters.gears.plan import gear_scales
from graphic_tmm.fitting.scales import ScaleFactors

SCALES = ScaleFactors(
    scales=gear_scales,
    key=lambda view: {"gear": "mu_l_gears", "sliding": "mu_theta"}.get(view, ""),
)
