"""How large the plans of positions, velocities and accelerations may be."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from graphic_tmm.chapters.kinematics.names import (
    ACCELERATIONS,
    KINEMATICS,
    PLANS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import KEYS, SMALL, UNITS, UNSEEN, VECTORS, crank_sizes
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.units import unit_name
from graphic_tmm.paper.formats import narrowest
from graphic_tmm.scene.records import Scales, Scene


def _narrow(scene: Scene) -> float:
    """Return the room for the plan of positions on the formats of its sheets, mm."""
    orders = [order for order in scene.sheets if POSITIONS in order.place] or scene.sheets
    return narrowest(order.format for order in orders).room


def _size(plan: str, usual: Callable[[Scene], float], cap: float, small: float = 0.0) -> Size:
    keys = KEYS[plan]

    def fixed(scene: Scene) -> str:
        return next((f"scales.{key}" for key in keys if getattr(scene.scales, key)), "")

    def freed(scene: Scene) -> Scene:
        left: dict[str, Any] = dict.fromkeys(keys)
        free: Scales = replace(scene.scales, **left)
        return replace(scene, scales=free)

    def remedy(drawn: Drawn, key: str) -> str:
        mu = drawn.scales[plan].value
        crank = crank_sizes(KINEMATICS_PLAN.on(drawn))[PLANS.index(plan)] / mu
        return (
            f"{mu:g} {unit_name(UNITS[key], drawn.scene.language)}"
            if key in UNITS
            else f"{math.floor(crank) or crank:g} mm"
        )

    def own(reach: Mapping[str, Any]) -> float:
        return float(getattr(reach[KINEMATICS], plan))

    return Size(
        plan,
        usual,
        in_mm=True,
        small=small,
        unseen=UNSEEN if small else 0.0,
        cap=cap,
        extent=own,
        fixed=fixed,
        freed=freed,
        remedy=remedy,
        keys=keys,
    )


_SIZES = (
    _size(POSITIONS, _narrow, 0.6),
    _size(VELOCITIES, lambda scene: VECTORS, 0.4, SMALL),
    _size(ACCELERATIONS, lambda scene: VECTORS, 0.4, SMALL),
)
"""Room for the plan of positions, and for the longest vectors of the others."""


def _velocities(scene: Scene, view: str) -> tuple[str, ...]:
    return (POSITIONS,) if scene.scales.mu_v_is_mu_l_omega else (VELOCITIES,)


SIZES = Sizing(
    sizes=_SIZES,
    depends={
        POSITIONS: lambda scene, view: (POSITIONS,),
        VELOCITIES: _velocities,
        ACCELERATIONS: lambda scene, view: (ACCELERATIONS,),
    },
)
