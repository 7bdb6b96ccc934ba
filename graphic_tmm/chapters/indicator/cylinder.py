"""A cylinder on a mechanism: the piston's travel, its indicator diagram, the force of the gas on it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import measure
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.indicator.names import INDICATOR
from graphic_tmm.chapters.indicator.plan import Indicator, draw_indicator
from graphic_tmm.chapters.indicator.stretches import Row
from graphic_tmm.chapters.indicator.task import IndicatorTask, Wish
from graphic_tmm.chapters.kinematics.bodies import GuideLeg
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, crank_length
from graphic_tmm.chapters.kinematics.positions import VIEW as POSITIONS
from graphic_tmm.chapters.kinematics.positions import Positions
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Made

STANDS = 1e-6
"""A piston slower than this share of its fastest stands."""


@dataclass(frozen=True)
class Machine:
    """What a flywheel is drawn for: the mechanism and its plans, where positions stand in the row.

    ``count`` of them make the row, over so many ``turns`` of the crank.
    """

    mechanism: Mechanism
    positions: Positions
    velocities: Motion
    pivot: str
    pin: str
    arm: Mark
    numbers: np.ndarray
    count: int
    turns: int = 1


@dataclass(frozen=True)
class Cylinder:
    """A cylinder: its indicator diagram, the leg of its piston, the sense of the guide to its cover.

    ``shown_by``: the chapter with whose views its diagram stands.
    """

    indicator: Indicator
    leg: GuideLeg
    outward: float
    shown_by: str = ""


INDICATOR_PLAN: Made[Cylinder] = Made(INDICATOR)


def machine_of(bench: Bench) -> Machine:
    """Return the machine on a board, once its plans are drawn."""
    plans = KINEMATICS_PLAN.on(bench)
    assert plans.velocities is not None
    pivot, pin = plans.structure.pivot, plans.structure.pin
    arm = crank_length(bench, plans)
    drawn = (plans.positions, plans.velocities)
    return Machine(
        plans.mechanism, *drawn, pivot, pin, arm, plans.numbers, plans.count, plans.turns
    )


def record(bench: Bench) -> Cylinder | None:
    """Draw the indicator diagram that another chapter needs."""
    wish: Wish | None = bench.needed.get(INDICATOR)
    if wish is None:
        return None
    drawn = draw_cylinder(bench.draft, machine_of(bench), wish.order, INDICATOR)
    return replace(drawn, shown_by=wish.by)


def draw_cylinder(draft: Draft, machine: Machine, order: IndicatorTask, section: str) -> Cylinder:
    """Draw the indicator diagram of the piston's point, which slides on the frame.

    Raises
    ------
    StructureError
        If it does not, the row does not begin at a dead centre of it, or pressures are missing.
    """
    frame = machine.mechanism.frame.number
    leg = sliding_leg(machine.positions, order.point, frame, section)
    outward = _outward(draft, machine, leg)
    _refuse_zero(draft, machine, leg, outward, order)
    point = machine.positions.point(order.point)
    draft.open(POSITIONS)
    start = draft.draw(at_zero, f"{order.point}_0", point, free=True)
    travel = draft.draw(measure, f"|s_{order.point}|", start, point)
    extras = machine.numbers.size - machine.count
    row = Row(machine.count, extras, machine.turns)
    indicator = draw_indicator(draft, travel, row, order)
    return Cylinder(indicator, leg, outward)


def _outward(draft: Draft, machine: Machine, leg: GuideLeg) -> float:
    """Return the sense of the guide, +1 or −1, in which the cover lies: away from the crank."""
    closing = next(c for c in machine.positions.closings if leg in c.legs)
    side = machine.positions.sides.get(closing.group.name)
    return 1.0 if side is None else float(np.ravel(np.asarray(draft.given[side]))[0])


def _refuse_zero(
    draft: Draft, machine: Machine, leg: GuideLeg, outward: float, order: IndicatorTask
) -> None:
    """Refuse a row that does not begin at a dead centre, or parts of a diagram that begin at the inner one."""
    speed = machine.velocities.readings[leg.link]
    given = {**draft.given, draft.mu_l: 1.0, machine.velocities.mu: 1.0}
    found = execute(draft.board.construction(), given, [speed])[speed][0, : machine.count]
    point = order.point
    remedy = said("begin where {point} is farthest from the crank, by zero in [drive]", point=point)
    fastest = np.max(np.abs(found), initial=0.0, where=np.isfinite(found))
    if abs(found[0]) > STANDS * fastest:
        raise StructureError(
            said(
                "the row does not begin at a dead centre of {point}: {remedy}",
                point=point,
                remedy=remedy,
            ),
            "drive.zero",
            "indicator.point",
            head="indicator",
        )
    sides = (order.cover, order.shaft)
    if outward * found[1] > 0.0 and any(gas is not None and gas.stretches for gas in sides):
        raise StructureError(
            said(
                "its parts are counted from the cover, the row begins at the other end: {remedy}",
                remedy=remedy,
            ),
            "drive.zero",
            head="indicator",
        )
