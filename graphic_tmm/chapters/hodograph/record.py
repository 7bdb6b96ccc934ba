"""What is recorded of hodographs: their curves, on the plans of velocities."""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.plan import record
from graphic_tmm.chapters.hodograph.task import ASKED
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.project import Plan

PLAN = Plan(needs=lambda scene: {VELOCITIES: True} if ASKED.of(scene) else {}, record=record)
