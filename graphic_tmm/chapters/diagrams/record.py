"""What is recorded of kinematic diagrams, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.beside import record_beside
from graphic_tmm.chapters.diagrams.plan import record
from graphic_tmm.chapters.kinematics.names import FULL_TURN, VELOCITIES
from graphic_tmm.project import Plan

PLAN = Plan(
    needs=lambda scene: {VELOCITIES: True},
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts.values(),
    result=lambda made: [chart.ordinates[0] for chart in made.charts.values()],
    remedy=FULL_TURN,
)
