"""What is recorded of a Geneva wheel."""

from __future__ import annotations

from graphic_tmm.chapters.geneva.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record)
