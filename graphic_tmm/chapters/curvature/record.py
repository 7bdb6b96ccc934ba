"""What is recorded of the curvature of paths, and what it needs."""

from __future__ import annotations

from graphic_tmm.chapters.curvature.plan import record
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.project import Plan

PLAN = Plan(needs=lambda scene: {VELOCITIES: True, ACCELERATIONS: True}, record=record)
