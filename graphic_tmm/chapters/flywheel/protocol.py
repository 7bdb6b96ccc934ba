"""What protocols tell of a flywheel."""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.names import CALCULATED, FLYWHEEL, VIEWS
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.words import graph_title
from graphic_tmm.chapters.indicator.names import CALCULATED as STROKE
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols
from graphic_tmm.scene.chapter import Holder


def _views(project: Project) -> dict[str, list[str]]:
    charts = FLYWHEEL_PLAN.on(project).charts
    return {FLYWHEEL: [*(chart.view for chart in charts), STROKE, CALCULATED]}


def _title(holder: Holder, view: str, language: str) -> str:
    made = FLYWHEEL_PLAN.on(holder)
    varying = view == VIEWS["moment"]
    return graph_title(view, made.order.constant, speaking(language)) if varying else ""


PROTOCOL = Protocols(views=_views, titles=_title)
