"""What is recorded of a planetary train."""

from __future__ import annotations

from graphic_tmm.chapters.planetary.beside import record_beside
from graphic_tmm.chapters.planetary.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record, aside=record_beside)
