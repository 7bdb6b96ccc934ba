"""The scale factor of an indicator diagram."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.project import Project


def _keys(project: Project) -> dict[str, str]:
    every = INDICATOR_PLAN.on(project).every
    return {one.indicator.chart.view: "_".join(filter(None, ("mu_p", one.tag))) for one in every}


SCALES = ScaleFactors(keys=_keys)
