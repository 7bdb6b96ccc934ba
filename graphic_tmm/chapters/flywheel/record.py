"""What is recorded of a flywheel: its plan; aside reduced force, mean moment, power, both methods compared."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.operations.energetics import irregularity
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel, record
from graphic_tmm.chapters.flywheel.task import ASKED, CALCULATED, FLYWHEEL
from graphic_tmm.chapters.forces.task import ASKED as FORCES_ASKED
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.chapters.indicator.plan import machine_of
from graphic_tmm.chapters.indicator.task import INDICATOR, IndicatorTask, Wish
from graphic_tmm.chapters.kinematics.task import FULL_TURN, TURNS, VELOCITIES
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside
from graphic_tmm.scene.records import Scene


@formula(
    holds="{of_pin} ≠ 0",
    fails="the crank pin does not move",
    why=said(
        "The force reduced to the crank pin has the power of the force on the piston: P·v of the one is P·v "
        "of the other, and the plan of velocities tells the ratio of both."
    ),
)
def reduced_force(outward: Number, force: Number, of_point: Length, of_pin: Length) -> Number:
    """−{outward}·{force}·{of_point}/{of_pin}"""


@formula(
    why=said(
        "Moment times rate of turning is power. Over a cycle the constant moment does the work of the one "
        "that varies, so this is the mean power of the machine."
    )
)
def mean_power(moment: Number, omega: Number) -> Number:
    """{moment}·{omega}"""


@formula(
    holds="{first} ≠ 0",
    fails="there is nothing to compare with",
    why=said(
        "Both methods look for the moment of inertia that keeps the same δ; the first takes the links' "
        "energy at the mean speed, the other does not. So much of the first do they differ."
    ),
)
def apart(first: Number, second: Number) -> Number:
    """100·({first} − {second})/{first}"""


@formula(
    why=said(
        "The largest excess work is what the energy of the flywheel changes by, {segment} to the scale {mu}."
    )
)
def excess_work(segment: Length, mu: Number) -> Number:
    """{segment}·{mu}"""


@operation(symbol=FREE, why=said("What is made is measured in whole millimetres."))
def whole_mm(size: Number) -> Number:
    """Make {size} in whole millimetres: {it}."""
    return Number(np.maximum(np.round(size, 3), 0.001))


@formula(
    why=said(
        "The rim as it is made, a ring of this width, has its mass at about half its mean diameter: J = "
        "m·D²/4."
    )
)
def rim_inertia(
    density: Number, outer: Number, inner: Number, middle: Number, width: Number
) -> Number:
    """π·{density}·({outer}² − {inner}²)·{middle}²·{width}/16"""


class Aside(NamedTuple):
    """Marks (Number).

    ``force``: the gas force reduced to the crank pin (N), None where loads or several cylinders are reduced.
    ``moment``: the constant moment (N·m), which is the mean one of the cycle; ``power``: its mean power (W).
    ``apart``: by how much the moments of inertia of both methods differ, in % of the first; None with one
    method. ``excess``: the
    largest excess work (J). ``rim``: its width in whole millimetres (m), the J of a rim made so, the δ that it
    keeps; None without a rim.
    """

    force: Mark | None
    moment: Mark
    power: Mark
    apart: Mark | None
    excess: Mark
    rim: tuple[Mark, Mark, Mark] | None


BESIDE: Recorded[Aside] = Recorded(aside(FLYWHEEL))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the drawing of a flywheel does not need."""
    speed = machine_of(bench).velocities.speed
    assert speed is not None
    return calculate(bench.draft, FLYWHEEL_PLAN.on(bench), speed)


def calculate(draft: Draft, made: Flywheel, speed: Mark) -> Aside:
    """Calculate it of a flywheel as drawn; ``speed``: of its shaft (1/s)."""
    axes = made.axes
    draft.open(CALCULATED)
    force = _force(draft, made)
    name = made.constant.letter
    read = draft.draw(
        measure_along, f"y_{{{name.replace('_', '')}}}", axes.origin, made.constant, axes.up
    )
    moment = draft.draw(in_si, "M_{mean}", read, axes.mu, unit="N·m")
    power = draft.draw(mean_power, "N", moment, speed, unit="W")
    differ = None
    if made.energy_mass is not None:
        differ = draft.draw(apart, "Δ_J", made.inertia, made.energy_mass.inertia, unit="%")
    excess = draft.draw(excess_work, "A_{ex}", made.segment, unit="J")
    return Aside(force, moment, power, differ, excess, _rim(draft, made, speed))


def _rim(draft: Draft, made: Flywheel, speed: Mark) -> tuple[Mark, Mark, Mark] | None:
    """Calculate what the rim does as it is made: the moment of inertia that it has, the δ that it keeps."""
    if made.rim is None:
        return None
    rim = made.rim
    width = draft.draw(whole_mm, "b′", rim.width, unit="m")
    density = draft.uses(rim.width)[1]
    sizes = (density, rim.outer, rim.inner, rim.mean, width)
    inertia = draft.draw(rim_inertia, "J′", *sizes, unit="kg·m²")
    return width, inertia, draft.draw(irregularity, "δ′", made.segment, inertia, speed)


def _force(draft: Draft, made: Flywheel) -> Mark | None:
    """Calculate the force on the piston as reduced to the crank pin, from what the reduced moment is."""
    if made.cylinder is None or made.parts:
        return None
    return draft.draw(reduced_force, "P_{red}", *draft.uses(made.moment)[:4], unit="N")


def needs_of(gas: IndicatorTask | None, scene: Scene, by: str) -> dict[str, object]:
    """Return what has to be recorded for a machine that gas or loads drive; ``by``: the chapter that asks."""
    if gas is None:
        forces = FORCES_ASKED.of(scene)
        turns = {TURNS: forces.turns} if forces is not None and forces.turns > 1 else {}
        return {VELOCITIES: True, FORCES: True, **turns}
    return {VELOCITIES: True, INDICATOR: Wish(3, by, gas), TURNS: gas.turns}


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    return needs_of(order.indicator if order is not None else None, scene, FLYWHEEL)


PLAN = Plan(
    needs=_needs,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.segment,),
    remedy=FULL_TURN,
)
