"""What is recorded of an indicator diagram: its plan; aside the scale of its base."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import scale_of
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, record
from graphic_tmm.chapters.indicator.task import CALCULATED, INDICATOR
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside


class Aside(NamedTuple):
    """The piston's stroke (m), and the scale of the base (m/mm)."""

    stroke: Mark
    mu: Mark


BESIDE: Recorded[Aside] = Recorded(aside(INDICATOR))


def record_beside(bench: Bench) -> Aside:
    """Calculate the scale of the base: the stroke, as read on the plan of positions, by its length."""
    made, draft = INDICATOR_PLAN.on(bench).indicator, bench.draft
    draft.open(CALCULATED)
    stroke = draft.draw(in_si, "S", made.stroke, draft.mu_l, unit="m")
    length = draft.uses(made.end)[1]
    return Aside(stroke, draft.draw(scale_of, "μ_S", stroke, length, unit="m/mm"))


PLAN = Plan(record=record, aside=record_beside, charts=lambda made: (made.indicator.chart,))
