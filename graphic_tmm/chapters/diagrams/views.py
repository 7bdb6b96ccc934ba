"""What a sheet shows of kinematic diagrams: graphs one below the other, and their table."""

from __future__ import annotations

from graphic_tmm.captions import captions
from graphic_tmm.chapters.diagrams.plan import BASE_VIEW, DIAGRAMS
from graphic_tmm.chapters.diagrams.table import PLAN, diagram_columns
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.views import captioned, mu_text, pole_texts, stacked
from graphic_tmm.readers.result_table import result_table


def diagram_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the kinematic diagrams one below the other, and their table."""
    kinematic, language = DIAGRAMS.of(drawn), drawn.scene.language
    if kinematic is None:
        return []
    words, row, log = captions(language), drawn.project.count, drawn.construction
    along = "t" if kinematic.order.over == "time" else "φ"
    views = []
    for chart in kinematic.charts.values():
        title = words[chart.view].format(point=escape(kinematic.order.point))
        letters = Names([escape(name) for name in drawn.names], chart.symbol, along)
        view = draw_graph(log, drawn.reading, chart.view, row, letters, title, lettered=lettered)
        scales = [mu_text(drawn.scales[key], language) for key in (chart.view, BASE_VIEW)]
        poles = pole_texts(log, drawn.reading, chart.view, language)
        views.append(captioned(view, title, ", ".join([*scales, *poles])))
    rows = tuple(diagram_columns(drawn))
    return [stacked("diagrams", views), result_table(PLAN, rows, drawn.names, language)]
