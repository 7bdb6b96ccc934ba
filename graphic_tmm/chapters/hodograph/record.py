"""What is recorded of hodographs: their curves, on the plans of velocities."""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.plan import record
from graphic_tmm.chapters.hodograph.task import ASKED
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.project import Plan
from graphic_tmm.scene.records import Scene


def _needs(scene: Scene) -> dict[str, bool]:
    """Return the plans whose vectors are carried, or are held against: also where no sheet shows them."""
    if ASKED.of(scene) is None:
        return {}
    return {VELOCITIES: True, **({ACCELERATIONS: True} if scene.row.accelerations else {})}


PLAN = Plan(needs=_needs, record=record)
