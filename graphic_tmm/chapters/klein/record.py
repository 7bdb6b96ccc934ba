"""What is recorded of Klein's construction."""

from __future__ import annotations

from graphic_tmm.chapters.klein.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record)
