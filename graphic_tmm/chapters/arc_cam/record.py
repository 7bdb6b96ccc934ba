"""What is recorded of a cam of arcs."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.beside import record_beside
from graphic_tmm.chapters.arc_cam.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record, aside=record_beside, charts=lambda made: made.charts.values())
