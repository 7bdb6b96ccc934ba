"""What is recorded of a law of motion, what that needs, where it has no result."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.flywheel.record import needs_of
from graphic_tmm.chapters.forces.task import ASKED as FORCES_ASKED
from graphic_tmm.chapters.kinematics.task import FULL_TURN, TURNS, VELOCITIES
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN, record
from graphic_tmm.chapters.motion_law.task import ACCELERATION, ASKED, MOTION_LAW, SPEED
from graphic_tmm.chapters.motor.task import MOTOR
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.language.said import said
from graphic_tmm.project import Plan
from graphic_tmm.readers.columns import ordinates
from graphic_tmm.scene.given_speeds import GivenSpeeds, Speeds
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


def _speeds(scene: Scene) -> Speeds:
    """Read ω and ε of the positions off the graphs, in the last turn of the motion.

    ε of a position lies on its graph half-way between the middles of the intervals before and behind it.

    Raises
    ------
    StructureError
        If a turn has no speeds of its own, or they are not known.
    """
    drawn, count = fitted(scene), scene.row.count
    law, rows = LAW_PLAN.on(drawn), drawn.project.count
    forces = FORCES_ASKED.of(scene)
    if rows != count * law.order.turns or (forces is not None and forces.turns > 1):
        raise StructureError(
            said(
                "the forces go over several turns, and each has other speeds: write a list of them"
            )
        )
    if rows == count and not law.order.steady:
        raise StructureError(
            said(
                "plans are drawn for the last turn of the motion, and what is before it must be known: "
                "write turns = 2 or more in [motion_law]"
            )
        )
    read = {
        chart.view: ordinates(drawn.reading, chart.ordinates[0], chart.mu, rows)[1]
        for chart in law.charts
        if chart.view in (SPEED, ACCELERATION)
    }
    omega, gain = (np.ravel(read[view])[:rows] for view in (SPEED, ACCELERATION))
    epsilon = (gain + np.roll(gain, 1)) / 2.0
    last = slice(rows - count, rows)
    if not (np.isfinite(omega[last]) & np.isfinite(epsilon[last])).all():
        raise StructureError(
            said(
                "the machine of [motion_law] does not come through its last turn: nothing moves there"
            )
        )
    return omega[last].tolist(), epsilon[last].tolist()


GIVEN_SPEEDS = GivenSpeeds(
    words=("motion law", "закон движения"), speeds=_speeds, chapters=(MOTOR,)
)

PLAN = Plan(
    needs=_needs,
    record=record,
    charts=lambda made: made.charts,
    result=lambda made: (made.angle,),
    remedy=FULL_TURN,
    causes=lambda made: made.causes,
)
