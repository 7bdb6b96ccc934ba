"""What is recorded of a flywheel for a cycle, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.plan import CYCLE_PLAN, record
from graphic_tmm.chapters.flywheel.record import Aside, calculate
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

BESIDE: Recorded[Aside] = Recorded(aside("cycle"))


def record_beside(bench: Bench) -> Aside:
    """Calculate the mean moment and its power."""
    made = CYCLE_PLAN.on(bench)
    return calculate(bench.draft, made.flywheel, made.speed)


PLAN = Plan(
    record=record,
    aside=record_beside,
    charts=lambda made: made.flywheel.charts,
    result=lambda made: (made.flywheel.segment,),
    remedy=said("no work can be told of its moments; write them at more points"),
)
