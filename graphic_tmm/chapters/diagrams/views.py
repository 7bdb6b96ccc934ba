"""What a sheet shows of kinematic diagrams: graphs one below the other, and their table."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.table import PLAN, diagram_columns
from graphic_tmm.chapters.diagrams.task import BASE_VIEW, DIAGRAMS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import mu_text, pole_figures, stacked, wrapped
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.scene.captions import captions


def diagram_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the kinematic diagrams one below the other, and their table."""
    kinematic, language = DIAGRAMS_PLAN.of(drawn), drawn.scene.language
    if kinematic is None:
        return []
    words, row, log = captions(language), drawn.project.count, drawn.construction
    of_base = unit(kinematic.base.mu.unit.removesuffix("/mm"), language)
    along = on_axis("t" if kinematic.order.over == "time" else "φ", of_base)
    names, high = [escape(name) for name in drawn.names], heights(drawn.scene, PLAN)
    views, scales = [], []
    for chart in kinematic.charts.values():
        title = words[chart.view].format(point=escape(kinematic.order.point))
        up = on_axis(chart.symbol, unit(chart.unit, language))
        poles = pole_figures(log, drawn.reading, chart.view, language)
        letters = Names(names, up, along, lengths=poles)
        view = draw_graph(subject(drawn, title, PLAN), chart.view, row, letters)
        scales.append(mu_text(drawn.scales[chart.view], language))
        views.append(finished(view, lettered))
    width, title = _width(views), words["diagrams of"].format(point=escape(kinematic.order.point))
    common = mu_text(drawn.scales[BASE_VIEW], language)

    def heading_lines(chosen: Sequence[int]) -> list[str]:
        """The title and the scales of some of the diagrams; the one they have in common once, at the end."""
        line = ", ".join([*(scales[k] for k in chosen), common])
        return [title, *wrapped(line, high.point, width)]

    rows = tuple(diagram_columns(drawn))
    return [
        stacked(PLAN, views, heading_lines, high),
        result_table(PLAN, rows, drawn.names, language, heights=high),
    ]


def _width(views: Sequence[Drawing]) -> float:
    """Return how wide diagrams are whose origins stand above each other, mm."""
    boxes = [bounds(view) for view in views]
    return max(box[2] for box in boxes) - min(box[0] for box in boxes)


SHOWN = Views(draw={DIAGRAMS: diagram_views})
