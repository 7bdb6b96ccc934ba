"""How μ_F of the polygons, μ_l of what is detached and the size of the lever were chosen, step by step."""

from __future__ import annotations

import math

from graphic_tmm.board.operations.choice import next_ratio, times_larger
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.forces.names import FORCES
from graphic_tmm.chapters.forces.pictured import ACROSS, UP, pictured
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.scales import Reaches, polygon_scales
from graphic_tmm.chapters.kinematics.names import POSITIONS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger
from graphic_tmm.language.said import said

GRAIN = 10.0
"""What is meant for the lever is told in multiples of this, mm."""
_POINT = said(
    "All points of what is detached lie in one: no length tells how large to draw it, so it keeps the scale of "
    "the plan of positions."
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of the forces were chosen."""
    made, reach = FORCES_PLAN.on(drawn), drawn.reach[FORCES]
    known: Reaches = reach
    for figure in made.figures:
        ledger.of(figure.view)
        if known.detached[figure.view] > 0.0:
            far = ledger.quantity("l_{max}", known.detached[figure.view], "m")
            ledger.fitting(figure.mu, far, ledger.value_of(drawn, figure.mu), lengths=True)
        else:
            ledger.same(figure.mu, drawn.project.scale(POSITIONS), figure.mu.name, why=_POINT)
    for mu in polygon_scales(drawn.project):
        if mu not in drawn.given or not (made.order.mu or known.polygons[mu.view] > 0.0):
            continue
        ledger.of(mu.view)
        if made.order.mu:
            ledger.told(mu, made.order.mu)
            continue
        most = ledger.quantity("F_{max}", known.polygons[mu.view], "N")
        ledger.fitting(mu, most, ledger.value_of(drawn, mu))
    _lever(drawn, ledger, known.lever)
    for one in pictured(drawn):
        ledger.of(one.view)
        along, up = one.scales
        if along:
            base = ledger.quantity(f"{along[2:]}_{{max}}", one.reach, one.base.removesuffix("/mm"))
            ledger.pictured(along, one.base, base, ACROSS)
        of = one.unit.removesuffix("/mm")
        largest = ledger.quantity(f"{one.letter[:-1]}max}}", one.largest, of)
        ledger.pictured(up, one.unit, largest, UP)


def _lever(drawn: Drawn, ledger: Ledger, longest: float) -> None:
    """Record how many times larger than the plan of velocities the lever is drawn."""
    lever = FORCES_PLAN.on(drawn).lever
    plan = ledger.chosen[drawn.project.scale(VELOCITIES).slot]
    ledger.of(lever.mu.view)
    times = ledger.value_of(drawn, lever.times)
    if not longest > 0.0:
        ledger.quantity(lever.times.name, times, "")
        return
    mu_v = ledger.value_of(drawn, drawn.project.scale(VELOCITIES))
    most = ledger.quantity("v_{max}", longest, "m/s")
    room = GRAIN * math.ceil(times * longest / mu_v / GRAIN)
    wanted = ledger.draft.take(Length, f"[{most.name}]", room)
    exact = ledger.draft.draw(times_larger, f"{lever.times.name}′", wanted, plan, most)
    ledger.enter(lever.times, ledger.draft.draw(next_ratio, lever.times.name, exact))


CHOICE = Choice(choose)
