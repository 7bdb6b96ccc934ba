"""What is recorded of a flywheel for a cycle, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.plan import record, record_beside
from graphic_tmm.language.said import said
from graphic_tmm.project import Plan

PLAN = Plan(
    record=record,
    aside=record_beside,
    charts=lambda made: made.flywheel.charts,
    result=lambda made: (made.flywheel.segment,),
    remedy=said("no work can be told of its moments; write them at more points"),
)
