"""What is recorded of a pair of gears."""

from __future__ import annotations

from graphic_tmm.chapters.gears.beside import record_beside
from graphic_tmm.chapters.gears.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record, aside=record_beside)
