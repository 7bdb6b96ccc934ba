"""The views that the plans of a mechanism are drawn in."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.names import EXTREMES, PLANS
from graphic_tmm.readers.titles import Protocols

PROTOCOL = Protocols(views=lambda project: {plan: (plan,) for plan in (EXTREMES, *PLANS)})
