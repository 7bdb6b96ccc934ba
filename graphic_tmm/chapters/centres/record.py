"""What is recorded of instantaneous centres, and what it needs."""

from __future__ import annotations

from graphic_tmm.chapters.centres.plan import record
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.project import Plan

PLAN = Plan(needs=lambda scene: {VELOCITIES: True}, record=record)
