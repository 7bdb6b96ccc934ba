"""What is recorded of the inertia of cylinders."""

from __future__ import annotations

from graphic_tmm.chapters.cylinders.plan import record
from graphic_tmm.project import Plan

PLAN = Plan(record=record)
