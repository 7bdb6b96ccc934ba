"""What a scene fixes that no sheet holds or nobody can measure: its key, what follows, a value that fits."""

from __future__ import annotations

import math
from dataclasses import replace

from graphic_tmm.errors import SheetError, ViewError
from graphic_tmm.fitting import PLANS, depends, fitted, fixed
from graphic_tmm.scaling import crank_sizes
from graphic_tmm.scene.records import Scales, Scene, SheetOrder
from graphic_tmm.work import Work

TINY = 5.0
"""A plan that a fixed μ draws smaller than this, mm, is no plan: nothing can be measured on it."""
UNITS = {"mu_l": "m/mm", "mu_v": "(m/s)/mm", "mu_a": "(m/s²)/mm"}
SIZE_KEYS = (
    *(
        f"diagrams.{key}"
        for key in ("base", "mu_t", "mu_phi", "mu_S", "mu_V", "mu_a", "H_S", "H_V", "H_a")
    ),
    *(f"flywheel.{key}" for key in ("base", "H", "mu_M")),
    *(f"indicator.{key}" for key in ("base", "height", "mu_p")),
    *(f"cam.{key}" for key in ("base", "height", "mu_l", "mu_S", "mu_V", "mu_A")),
    *("engine.base", "forces.mu_F", "gears.mu_l", "planetary.mu_l"),
)
"""Keys besides those of [scales] that fix how large something is drawn."""


def refuse_tiny(scene: Scene, drawn: Work) -> None:
    """Refuse a scale factor, fixed by the scene, that leaves nothing of a plan.

    Raises
    ------
    SheetError
        It names the key, the size of the plan in mm, and a value that fits.
    """
    for plan, keys in PLANS.items():
        key = next((key for key in keys if getattr(scene.scales, key)), None)
        if key is None or plan not in drawn.scales:
            continue
        large = getattr(drawn.extents, plan) / drawn.scales[plan].value
        if 0.0 < large < TINY:
            says = f"the plan of {plan} comes out {large:.2g} mm large, too small to measure"
            helps = _remedy(scene, plan)
            raise SheetError(f"{scene.source}: scales.{key}: {says}: what helps: {helps}")


def refusal(scene: Scene, error: ViewError) -> SheetError:
    """Return the error of a view that no sheet holds, with the key that makes it so large and a remedy."""
    plan = error.view.partition("-")[0]
    if plan == "velocities" and not fixed(plan, scene):
        plan = next(iter(depends(plan, plan, replace(scene, scales=_free(scene, "positions")))))
    key, helps = "", []
    if plan in PLANS and fixed(plan, scene):
        key, helps = f"scales.{_written(scene, plan)}: ", [_remedy(scene, plan)]
    elif written := [name for name in SIZE_KEYS if name in scene.told]:
        helps = [f"to change, or leave out, {', '.join(written)}"]
    if any(order.format != "A1" for order in scene.sheets) and _held_by_a1(scene, error):
        helps.append('a further sheet with format = "A1" for it')
    remedies = f": what helps: {', or '.join(helps)}" if helps else ""
    return SheetError(f"{scene.source}: {key}{error}{remedies}")


def _held_by_a1(scene: Scene, error: ViewError) -> bool:
    from graphic_tmm.paper.compose import orders

    ((_, rooms),) = orders(replace(scene, sheets=(SheetOrder("A1"),)))
    return rooms[0].within.share(*error.size) >= 1.0


def _written(scene: Scene, plan: str) -> str:
    """Return the key of [scales] by which the scene fixes the size of a plan."""
    return next(key for key in PLANS[plan] if getattr(scene.scales, key))


def _free(scene: Scene, plan: str) -> Scales:
    """Return what a scene fixes of its scale factors, but for those of a plan."""
    if plan == "positions":
        return replace(scene.scales, mu_l=None, OA=None)
    if plan == "velocities":
        return replace(scene.scales, mu_v=None, pa=None)
    return replace(scene.scales, mu_a=None, pi_a=None)


def _remedy(scene: Scene, plan: str) -> str:
    """Return what to write for the key that fixes the size of a plan, so that a sheet holds it."""
    found, key = (
        fitted(replace(scene, scales=_free(scene, plan)), exact=True),
        _written(scene, plan),
    )
    mu = found.scales[plan].value
    large = getattr(found.extents, plan) / mu
    crank = crank_sizes(found.project)[list(PLANS).index(plan)] / mu
    value = f"{mu:g} {UNITS[key]}" if key in UNITS else f"{math.floor(crank) or crank:g} mm"
    return f'write {key} = "{value}" in [scales] (the plan is {large:.0f} mm large then), or leave it out'
