"""The views that the plans of an engine are drawn in."""

from __future__ import annotations

from graphic_tmm.chapters.engine.names import (
    CALCULATED,
    ENGINE,
    HARMONICS,
    MASSES,
    TRANSFER,
    VIEW,
    WORKS_VIEW,
)
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.indicator.cylinder import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.names import CALCULATED as STROKE
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols


def _views(project: Project) -> dict[str, list[str]]:
    charts = [chart.view for chart in ENGINE_PLAN.on(project).charts]
    cylinder = INDICATOR_PLAN.on(project)
    own = [cylinder.indicator.chart.view, STROKE] if cylinder.shown_by == ENGINE else []
    return {ENGINE: [*own, VIEW, TRANSFER, HARMONICS, *charts, CALCULATED, MASSES, WORKS_VIEW]}


PROTOCOL = Protocols(views=_views)
