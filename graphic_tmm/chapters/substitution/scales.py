"""How large accelerations by substitution are drawn: as those of the plan are."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.chapters.substitution.task import SUBSTITUTION
from graphic_tmm.fitting.sizes import Sizing

SIZES = Sizing(depends={SUBSTITUTION: lambda scene, role: (ACCELERATIONS,)})
