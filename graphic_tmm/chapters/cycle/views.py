"""What a sheet shows of a cycle: graphs of moment, works and energy, the sketch of the flywheel, tables."""

from __future__ import annotations

import math

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.table import cycle_columns, cycle_results
from graphic_tmm.chapters.cycle.task import CYCLE
from graphic_tmm.chapters.flywheel.views import graphs, results_of, sketch
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.views import stacked
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.readers.task_sheet import given_views


def cycle_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the views of a cycle, none if the scene asks for none."""
    made = CYCLE_PLAN.of(drawn)
    if made is None:
        return []
    language, found = drawn.scene.language, single(cycle_results(drawn))
    views = [stacked("cycle-graphs", graphs(drawn, made.flywheel, lettered, CYCLE))]
    rim = made.flywheel.rim
    if rim is not None and math.isfinite(found.get("rim_width", (math.nan, ""))[0]):
        views.append(sketch(drawn, rim, CYCLE, "cycle sketch"))
    rows, high = tuple(cycle_columns(drawn)), heights(drawn.scene, CYCLE)
    views.append(result_table(CYCLE, rows, drawn.names, language, heights=high))
    return [*views, results_of(drawn, found, CYCLE)]


SHOWN = Views(draw={CYCLE: cycle_views, **given_views(CYCLE)})
