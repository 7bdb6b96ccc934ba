"""Instantaneous centres at any angle of the crank."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import segment_name
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import ASKED, CENTRES, CentresTask
from graphic_tmm.chapters.kinematics.plan import ALL, KINEMATICS_PLAN
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning, TurnQuantity


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the centres that do not always lie at infinity."""
    made, plans = CENTRES_PLAN.on(project), KINEMATICS_PLAN.on(project)
    origin = plans.mechanism.frame.points[plans.structure.origin]
    for one in made.centres:
        if not one.far:
            key = segment_name(one.name)
            yield TurnQuantity(CENTRES, "centres", key, one.mark, made.mu, origin=origin)


TURNING = Turning(
    told=quantities, free=lambda scene: ASKED.put(scene, CentresTask(ALL)), plan=CENTRES
)
