"""What a sheet shows of curvature: both constructions at each of their positions, their table."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.curvature.ink import draw_figure
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.table import curvature_columns, drawn_places, radius_marks
from graphic_tmm.chapters.curvature.task import CURVATURE
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import mu_text, paired
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.scene.captions import captions


def curvature_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the constructions at each of their positions, then the table."""
    language, made = drawn.scene.language, CURVATURE_PLAN.of(drawn)
    found = list[Drawing]()
    for k in made.places if made is not None else ():
        if views := views_at(drawn, k, lettered):
            found += paired(views)
    columns = curvature_columns(drawn) if found else ()
    rows = [one for one in columns if np.isfinite(one.value).any()]
    if rows:
        high = heights(drawn.scene, CURVATURE)
        found.append(result_table(CURVATURE, rows, drawn.names, language, heights=high))
    return found


def views_at(drawn: Drawn, k: int, lettered: bool) -> list[Drawing]:
    """Return the constructions in a position (index)."""
    made, language, name = CURVATURE_PLAN.on(drawn), drawn.scene.language, drawn.names[k]
    words, found = captions(language), list[Drawing]()
    for figure in made.figures:
        if k not in drawn_places(drawn, figure.mu):
            continue
        title = f"{words[figure.view]}, {words['position']} {escape(name)}"
        on = subject(drawn, title, CURVATURE, name=f"{figure.view}-{name}")
        mu = mu_text(drawn.scales[figure.view].at(k), language)
        view = with_caption(draw_figure(on, made, figure, k), on, lettered, mu)
        found.append(view._replace(position=k))
    return found


SHOWN = Views(draw={CURVATURE: curvature_views})
READINGS = Readings(named_marks=radius_marks)
