"""What is recorded of an indicator diagram."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.beside import record_beside
from graphic_tmm.chapters.indicator.cylinder import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record, aside=record_beside, charts=lambda made: (made.indicator.chart,))
