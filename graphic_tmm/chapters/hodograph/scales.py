"""How large hodographs may be drawn: as the plans whose vectors they bear."""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.task import ASKED, HODOGRAPH
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.fitting.sizes import Sizing
from graphic_tmm.scene.records import Scene


def _sizes(scene: Scene, role: str) -> tuple[str, ...]:
    order = ASKED.of(scene)
    more = (ACCELERATIONS,) if order is not None and order.accelerations else ()
    return (VELOCITIES, *more)


SIZES = Sizing(depends={HODOGRAPH: _sizes})
