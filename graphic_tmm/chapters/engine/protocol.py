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
from graphic_tmm.chapters.indicator.names import CALCULATED as STROKE
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols


def _views(project: Project) -> dict[str, list[str]]:
    charts = [chart.view for chart in ENGINE.on(project).charts]
    cylinder = INDICATOR.on(project)
    own = [cylinder.indicator.chart.view, STROKE] if cylinder.shown_by == ENGINE.chapter else []
    return {
        ENGINE.chapter: [*own, VIEW, TRANSFER, HARMONICS, *charts, CALCULATED, MASSES, WORKS_VIEW]
    }


PROTOCOL = Protocols(views=_views)
