"""The analogues of velocity and acceleration at any angle of the crank."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.chapters.hodograph.record import HODOGRAPH_PLAN
from graphic_tmm.chapters.hodograph.task import ASKED, HODOGRAPH
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Turning, TurnQuantity
from graphic_tmm.scene.records import Scene


def free(scene: Scene) -> Scene:
    """Return the scene with the analogues of its points, and no hodograph of accelerations."""
    order = ASKED.of(scene)
    if order is None:
        return scene
    own = replace(order, analogues=True, accelerations=False)
    return scene.asking(**{HODOGRAPH: own})


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield dS/dφ and d²S/dφ² (m): vectors of the plans to the scales of the analogues."""
    for one in HODOGRAPH_PLAN.on(project).analogues:
        name = f"{'dS' if one.plan == VELOCITIES else 'ddS'}_{one.point}"
        yield TurnQuantity(HODOGRAPH, "analogues", name, one.image, one.mu)


TURNING = Turning(told=quantities, free=free, plan=HODOGRAPH)
