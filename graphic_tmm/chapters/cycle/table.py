"""What tables tell of a flywheel for a cycle."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cycle.names import CYCLE
from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN
from graphic_tmm.chapters.cycle.record import BESIDE
from graphic_tmm.chapters.flywheel.table import columns_of, results_for
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.measured import Tabled


def cycle_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of a cycle: moment and energy by positions."""
    yield from columns_of(drawn, CYCLE_PLAN.on(drawn).flywheel, CYCLE)


def cycle_results(drawn: Drawn) -> Results:
    """Return the results of a cycle."""
    return results_for(drawn, CYCLE_PLAN.on(drawn).flywheel, BESIDE.on(drawn))


TABLE = Tabled(columns=cycle_columns, results=cycle_results)
