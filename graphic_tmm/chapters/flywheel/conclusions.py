"""What follows from the flywheel: its moment of inertia by both methods, its power, what its rim keeps."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.table import flywheel_results
from graphic_tmm.chapters.flywheel.task import FlywheelTask
from graphic_tmm.drawn import Drawn, Results, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, result_number
from graphic_tmm.note.document import Run, Runs, lettered
from graphic_tmm.readers.divided import told_off

BOTH = said(
    "The moment of inertia of the flywheel is {J_fly} by the change of kinetic energy and {J_fly_energy_mass}"
    " by the energy–mass diagram, which does not take the speed for even."
)
ONE = said("The moment of inertia of the flywheel is {J_fly}.")
KEPT = said("With its moment of inertia of {J_fly} the flywheel keeps δ = {delta}.")
LESS = said(
    "By the energy–mass diagram it is less by {J_apart}: the first method, which takes the energies of the "
    "links at the mean speed, is on the safe side."
)
MORE = said("By the energy–mass diagram it is greater: the methods differ by {J_apart}.")
EXCESS = said(
    "The largest excess work is {A_excess}; the mean moment of the cycle {M_mean}, the mean power {power}."
)
FAST = said("The rim, {D_e} across, stays below the {D_max} that its speed allows.")
HOLDS = said("Made in whole millimetres it has J = {J_made} and keeps δ = {delta_made}, as wanted.")
MISSES = said(
    "Made in whole millimetres it has J = {J_made} and keeps δ = {delta_made}, which differs from what is "
    "wanted: the width should be rounded up."
)
NEAR = 0.01
"""A δ that differs from the one wanted by no more than this share of it is that one: nobody reads better."""


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what the flywheel has to be, by both methods, and what its rim does."""
    order = FLYWHEEL_PLAN.on(drawn).order
    yield from concluded(drawn, flywheel_results(drawn), order, language)


def concluded(
    drawn: Drawn, results: Results, order: FlywheelTask, language: str, section: str = ""
) -> Iterator[Runs]:
    """Yield it of the results of a flywheel as drawn."""
    _ = speaking(language)

    def told(*sentences: str) -> Runs:
        put: dict[str, Run] = {
            name: result_number(drawn, results, name, language) for name in results
        }
        return filled(" ".join(map(_, sentences)), put)

    if "J_fly" not in results:
        return
    if order.J is not None:
        yield told(*([KEPT] if "delta" in results else []))
    else:
        yield told(BOTH if "J_fly_energy_mass" in results else ONE)
    if "J_apart" in results:
        yield told(LESS if single(results)["J_apart"][0] >= 0.0 else MORE)
    if off := told_off(drawn, language):
        yield lettered("; ".join(off) + ".")
    if {"A_excess", "M_mean", "power"} <= set(results):
        yield told(EXCESS)
    if {"D_e", "D_max", "J_made"} <= set(results):
        kept, wanted = single(results)["delta_made"][0], order.delta
        if wanted is None:
            yield told(FAST)
        else:
            yield told(FAST, HOLDS if kept <= wanted * (1.0 + NEAR) else MISSES)
