"""The scale factor of an indicator diagram."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.fitting.scales import ScaleFactors

SCALES = ScaleFactors(keys=lambda project: {VIEW: "mu_p"})
