"""What a sheet shows of a cycle: graphs of moment, works and energy, the sketch of the flywheel, tables."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.cycle.names import CYCLE
from graphic_tmm.chapters.cycle.plan import BESIDE
from graphic_tmm.chapters.cycle.task import ASKED
from graphic_tmm.chapters.flywheel.given import given_of
from graphic_tmm.chapters.flywheel.table import columns_of, results_for, too_wide
from graphic_tmm.chapters.flywheel.views import graphs, results_of, sketch
from graphic_tmm.drawn import Drawn, Results, single
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import heights
from graphic_tmm.paper.views import stacked
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.given import given_speed, given_views
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.readers.task_sheet import Given
from graphic_tmm.scene.records import Scene

PLAN = CYCLE.chapter


def cycle_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the views of a cycle, none if the scene asks for none."""
    made = CYCLE.of(drawn)
    if made is None:
        return []
    language, found = drawn.scene.language, single(cycle_results(drawn))
    views = [stacked("cycle-graphs", graphs(drawn, made.flywheel, lettered, PLAN))]
    rim = made.flywheel.rim
    if rim is not None and math.isfinite(found.get("rim_width", (math.nan, ""))[0]):
        views.append(sketch(drawn, rim, too_wide(found, language), PLAN, "cycle sketch"))
    rows, high = tuple(cycle_columns(drawn)), heights(drawn.scene, PLAN)
    views.append(result_table(PLAN, rows, drawn.names, language, heights=high))
    return [*views, results_of(drawn, found, PLAN)]


def cycle_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of a cycle: moment and energy by positions."""
    yield from columns_of(drawn, CYCLE.on(drawn).flywheel, PLAN)


def cycle_results(drawn: Drawn) -> Results:
    """Return the results of a cycle."""
    return results_for(drawn, CYCLE.on(drawn).flywheel, BESIDE.on(drawn))


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of a cycle: the speed of its shaft, its turns, its flywheel."""
    order = ASKED.of(scene)
    if order is None:
        return
    yield given_speed("1", order.speed)
    yield Given("n_t", float(order.turns))
    yield from given_of(order.flywheel)


SHOWN = Views(draw={CYCLE.chapter: cycle_views, **given_views(CYCLE.chapter)})
