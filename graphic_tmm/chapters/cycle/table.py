"""The columns and results of a flywheel for a cycle; what protocols call its graphs."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.record import BESIDE
from graphic_tmm.chapters.cycle.task import CYCLE
from graphic_tmm.chapters.flywheel.table import columns_of, results_for
from graphic_tmm.chapters.flywheel.task import VIEWS
from graphic_tmm.chapters.flywheel.words import graph_title
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.readers.columns import Column, Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder


def cycle_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of a cycle: moment and energy by positions."""
    yield from columns_of(drawn, CYCLE_PLAN.on(drawn).flywheel, CYCLE)


def cycle_results(drawn: Drawn) -> Results:
    """Return the results of a cycle."""
    return results_for(drawn, CYCLE_PLAN.on(drawn).flywheel, BESIDE.on(drawn))


TABLE = Tabled(columns=cycle_columns, results=cycle_results)


def _title(holder: Holder, view: str, language: str) -> str:
    order = CYCLE_PLAN.on(holder).order.flywheel
    title = graph_title(view, order.constant, speaking(language), given=True)
    return title if view == VIEWS["moment"] else ""


PROTOCOL = Protocols(titles=_title)
