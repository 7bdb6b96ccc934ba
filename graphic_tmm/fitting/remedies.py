"""What a scene fixes that no sheet holds or nobody can measure: its key, what follows, a value that fits."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SheetError, ViewError
from graphic_tmm.fitting.sizes import Size, Sizing, sizes_of
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import PAPERS
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.scene.registry import size_keys

TINY = 5.0
"""A plan that a fixed μ draws smaller than this, mm, is no plan: nothing can be measured on it. Half a division
of 0.5 mm is 5 % of that."""


def plans() -> dict[str, Size]:
    """Return the sizes that set the μ of a plan, by the name of the plan."""
    found = (size for one in chapters(MECHANISM) for size in Sizing.of(one).sizes)
    return {size.name: size for size in found if size.plan}


def refuse_tiny(scene: Scene, drawn: Drawn) -> None:
    """Refuse a scale factor, fixed by the scene, that leaves nothing of a plan.

    Raises
    ------
    SheetError
        It names the key, the size of the plan in mm, and a value that fits.
    """
    for plan, size in plans().items():
        key = size.fixed(scene)
        if not key or plan not in drawn.scales:
            continue
        large = size.extent(drawn.reach) / drawn.scales[plan].value
        if 0.0 < large < TINY:
            says = said(
                "the plan of {plan} comes out {large:.2g} mm large, too small to measure",
                plan=plan,
                large=large,
            )
            raise SheetError(
                said(
                    "{source}: {key}: {says}: what helps: {remedy}",
                    source=scene.source,
                    key=key,
                    says=says,
                    remedy=_remedy(scene, size),
                )
            )


def refusal(scene: Scene, error: ViewError) -> SheetError:
    """Return the error of a view that no sheet holds, with the key that makes it so large and a remedy."""
    known = plans()
    plan = next((view for view in error.shows if view in known), "")
    if plan in known and not known[plan].fixed(scene):
        freed = scene
        for size in known.values():
            freed = size.freed(freed) if size is not known[plan] else freed
        plan = next(iter(sizes_of(plan, "", freed)), plan)
    key, helps = "", list[str]()
    if plan in known and known[plan].fixed(scene):
        key, helps = f"{known[plan].fixed(scene)}: ", [_remedy(scene, known[plan])]
    elif written := [name for name in size_keys() if name in scene.told]:
        helps = [said("to change, or leave out, {listed}", listed=", ".join(written))]
    elif scene.hand != "exact":
        helps = [
            said("the exact hand, --hand exact: a slip grows where lines meet at a small angle")
        ]
    if larger := _held_by(scene, error):
        helps.append(said('a further sheet with format = "{format}" for it', format=larger))
    says = said("{source}: {key}{error}", source=scene.source, key=key, error=error.args[0])
    if len(helps) == 1:
        says = said("{says}: what helps: {remedy}", says=says, remedy=helps[0])
    elif helps:
        says = said(
            "{says}: what helps: {remedy}, or {other}", says=says, remedy=helps[0], other=helps[1]
        )
    return SheetError(says)


def _held_by(scene: Scene, error: ViewError) -> str:
    """Return the smallest format, not ordered yet, that holds a view; "" if none does."""
    from graphic_tmm.fitting.compose import orders

    for name in PAPERS:
        ((_, rooms),) = orders(replace(scene, sheets=(SheetOrder(name),)))
        if rooms[0].within.share(*error.size) >= 1.0:
            return "" if all(order.format == name for order in scene.sheets) else name
    return ""


def _remedy(scene: Scene, size: Size) -> str:
    """Return what to write for the key that fixes the size of a plan, so that a sheet holds it."""
    from graphic_tmm.fitting.fit import fitted

    key = size.fixed(scene)
    found = fitted(size.freed(scene), exact=True)
    large = size.extent(found.reach) / found.scales[size.name].value
    section, _, name = key.rpartition(".")
    value = size.remedy(found, name)
    return said(
        'write {name} = "{value}" in [{section}] (the plan is {large:.0f} mm large then), or leave '
        "it out",
        name=name,
        value=value,
        section=section,
        large=large,
    )
