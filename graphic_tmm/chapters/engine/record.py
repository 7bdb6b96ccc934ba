"""What is recorded of an engine, what it needs, and why there may be no result."""

from __future__ import annotations

from graphic_tmm.chapters.engine.beside import record_beside
from graphic_tmm.chapters.engine.names import ENGINE
from graphic_tmm.chapters.engine.plan import record
from graphic_tmm.chapters.engine.task import ASKED
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.task import Wish
from graphic_tmm.chapters.kinematics.names import ACCELERATIONS, FULL_TURN, VELOCITIES
from graphic_tmm.project import Plan
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    assert order is not None
    wish = Wish(2, ENGINE, order.indicator)
    return {VELOCITIES: True, ACCELERATIONS: True, INDICATOR: wish}


PLAN = Plan(
    needs=_needs,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.values["M"],),
    remedy=FULL_TURN,
)
