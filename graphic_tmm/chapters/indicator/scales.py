"""The scale factor of an indicator diagram."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.project import Project


def _keys(project: Project) -> dict[str, str]:
    every = (one.indicator for one in INDICATOR_PLAN.on(project).every)
    return {one.chart.view: "_".join(("mu_p", *one.tag.split())) for one in every}


SCALES = ScaleFactors(keys=_keys)
