"""How large a plan to a free scale is drawn: as its first vector is long."""

from __future__ import annotations

from graphic_tmm.chapters.free_scale.task import FREE_SCALE
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.fitting.sizes import Sizing

SIZES = Sizing(depends={FREE_SCALE: lambda scene, role: (VELOCITIES,)})
