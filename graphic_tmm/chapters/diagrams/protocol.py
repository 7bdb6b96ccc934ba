"""What protocols tell of kinematic diagrams."""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.names import CALCULATED, DIAGRAMS
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.words import called
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.titles import Protocols
from graphic_tmm.scene.chapter import Holder


def _views(project: Project) -> dict[str, list[str]]:
    charts = DIAGRAMS_PLAN.on(project).charts.values()
    return {DIAGRAMS: [*(chart.view for chart in charts), CALCULATED]}


def _title(holder: Holder, view: str, language: str) -> str:
    made = DIAGRAMS_PLAN.on(holder)
    own = any(chart.view == view for chart in made.charts.values())
    return called(view, speaking(language), made.order.point) if own else ""


PROTOCOL = Protocols(views=_views, titles=_title)
