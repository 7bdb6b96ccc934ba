"""What is recorded of forces by centres, where a scene has both."""

from __future__ import annotations

from graphic_tmm.chapters.advantage.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record)
