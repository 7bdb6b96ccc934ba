"""What is recorded of a flywheel, what it needs, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.beside import record_beside
from graphic_tmm.chapters.flywheel.names import FLYWHEEL
from graphic_tmm.chapters.flywheel.plan import record
from graphic_tmm.chapters.flywheel.task import ASKED
from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.names import FULL_TURN, TURNS, VELOCITIES
from graphic_tmm.project import Plan
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    gas = order.indicator if order is not None else None
    if gas is None:
        return {VELOCITIES: True, FORCES: True}
    wish = Wish(3, FLYWHEEL, gas)
    return {VELOCITIES: True, INDICATOR: wish, TURNS: gas.turns}


PLAN = Plan(
    needs=_needs,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.segment,),
    remedy=FULL_TURN,
)
