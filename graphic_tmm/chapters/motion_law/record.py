"""What is recorded of a law of motion, what that needs, where it has no result."""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.record import needs_of
from graphic_tmm.chapters.forces.task import ASKED as FORCES_ASKED
from graphic_tmm.chapters.kinematics.task import FULL_TURN, TURNS, VELOCITIES
from graphic_tmm.chapters.motion_law.plan import record
from graphic_tmm.chapters.motion_law.task import ASKED, MOTION_LAW
from graphic_tmm.chapters.motor.task import MOTOR
from graphic_tmm.project import Plan
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    if order is None:
        return {}
    needs: dict[str, object] = {VELOCITIES: True}
    if order.indicator is not None or FORCES_ASKED.of(scene) is not None:
        needs = needs_of(order.indicator, scene, MOTION_LAW)
    if order.motor is not None:
        needs[MOTOR] = order.motor
    return {**needs, TURNS: max(order.turns, int(str(needs.get(TURNS, 1))))}


PLAN = Plan(
    needs=_needs,
    record=record,
    charts=lambda made: made.charts,
    result=lambda made: (made.angle,),
    remedy=FULL_TURN,
    causes=lambda made: made.causes,
)
