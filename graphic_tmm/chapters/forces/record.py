"""What is recorded of forces, and what it needs."""

from __future__ import annotations

from graphic_tmm.chapters.forces.plan import record
from graphic_tmm.chapters.forces.task import ASKED, FORCES
from graphic_tmm.chapters.indicator.task import INDICATOR, Wish
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, BY_DRIVE, TURNS, VELOCITIES
from graphic_tmm.project import Plan
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    needs: dict[str, object] = {VELOCITIES: True, BY_DRIVE: True}
    if order is not None and order.inertia:
        needs[ACCELERATIONS] = True
    if order is not None and order.gas is not None:
        needs[INDICATOR] = Wish(1, FORCES, order.gas)
    if order is not None and order.turns > 1 and not scene.row.open:
        needs[TURNS] = order.turns
    return needs


PLAN = Plan(needs=_needs, record=record)
