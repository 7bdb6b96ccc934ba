"""A cylinder on a mechanism: the piston's travel, its indicator diagram, gas forces."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.curve import taut_curve
from graphic_tmm.board.operations.energetics import gas_force, mean_ordinate, net_force, ring_area
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.operations.supports import farthest, planimeter
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length, Number, Point
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.indicator import words as why
from graphic_tmm.chapters.indicator.stretches import Row, by_stretches
from graphic_tmm.chapters.indicator.task import INDICATOR, VIEW, Gas, IndicatorTask, Wish
from graphic_tmm.chapters.kinematics.bodies import GuideLeg, Positions
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, crank_length
from graphic_tmm.chapters.kinematics.positions import VIEW as POSITIONS
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

AUXILIARY = -30.0
"""The angle of the auxiliary ray below the base, degrees."""
NAMES = {"cover": "k", "shaft": "v"}
"""Letters of the sides: of the cover, of the shaft."""


@dataclass(frozen=True)
class Side:
    """One side of the piston on the diagram.

    Its points, curve, ordinates read (Length), the pressures they stand for, mean pressure, gas force.
    ``mean``: None on a shaft side whose pressure is the same all the time: it does no work in a cycle.
    """

    name: str
    points: Mark
    curve: Mark
    ordinate: Mark
    pressure: Mark
    mean: Mark | None
    force: Mark


@dataclass(frozen=True)
class Indicator:
    """The diagram as drawn: its chart (μ_p), the ends of its base, the feet, the sides, the piston's force.

    ``divisions``: the points on the auxiliary ray by which the base is divided; ``stroke``: the piston's, as
    read there (Length).
    """

    order: IndicatorTask
    chart: Chart
    origin: Mark
    end: Mark
    feet: Mark
    divisions: Mark
    stroke: Mark
    sides: tuple[Side, ...]
    force: Mark


def draw_indicator(draft: Draft, travel: Mark, row: Row, order: IndicatorTask) -> Indicator:
    """Draw the diagram; ``travel``: the piston's way from the zero position, as read (Length).

    No pressure is known at positions that stand behind the row.

    Raises
    ------
    StructureError
        If the pressures are not as many as the positions of the row.
    """
    draft.open(VIEW)
    mu = draft.scale("μ_p", "Pa/mm")
    draft.lay_out()
    origin = draft.take(Point, "O", 0j)
    base = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
    up = draft.draw(square, "(Oy)", origin, base, sense=1)
    length = draft.take(Length, "L", order.base, "mm")
    end = draft.draw(lay_off, "E", base, length)
    feet, divisions, stroke = _divide(draft, origin, base, end, travel, row.size)
    lines = draft.draw(square, "(i)", feet, base, sense=1)
    ground = _Ground(length, lines, feet, up, travel, stroke)
    sides = [_side(draft, "cover", order.cover, row, ground)]
    force = sides[0].force
    if order.shaft is not None:
        sides.append(_side(draft, "shaft", order.shaft, row, ground))
        force = draft.draw(net_force, "P", force, sides[1].force, unit="N")
    ordinates = tuple(side.ordinate for side in sides)
    chart = Chart(VIEW, "p", "Pa", mu, ordinates, True, order.mu, order.height)
    return Indicator(order, chart, origin, end, feet, divisions, stroke, tuple(sides), force)


class _Ground(NamedTuple):
    """What both sides stand on: the base's length, perpendiculars, feet, ordinate axis, travel, stroke."""

    length: Mark
    lines: Mark
    feet: Mark
    up: Mark
    travel: Mark
    stroke: Mark


def _divide(
    draft: Draft, origin: Mark, base: Mark, end: Mark, travel: Mark, count: int
) -> tuple[Mark, Mark, Mark]:
    """Divide the base in proportion to the travel by similar triangles on an auxiliary ray.

    Returns the feet of the positions, their points on the ray, the stroke as it lies there (Length).
    """
    way = draft.draw(ray, "(Oq)", origin, draft.take(Angle, "θ", AUXILIARY, "°"), why=why.AUXILIARY)
    marks = draft.draw(lay_off, "q", way, travel, why=why.TRAVEL_ON_RAY)
    last = draft.draw(farthest, "q_S", origin, marks, row=count)
    closing = draft.draw(join, "(q_SE)", last, end, why=why.CLOSING)
    lines = draft.draw(parallel, "(q)", marks, closing, sense=1, why=why.ALIKE)
    stroke = draft.draw(measure, "s_{max}", origin, last)
    return draft.draw(meet, "i", base, lines, why=why.ALIKE), marks, stroke


def _side(draft: Draft, name: str, gas: Gas, row: Row, on: _Ground) -> Side:
    """Lay off the pressures of one side, read them, go round them with the planimeter."""
    sign, (count, extras, _) = NAMES[name], row
    if gas.stretches:
        pressure = by_stretches(
            draft, sign, gas, row, on.travel, on.stroke, at_shaft=name == "shaft"
        )
    elif len(gas.pressures) == count:
        values = np.array([*gas.pressures, *[np.nan] * extras])[None, :]
        pressure = draft.take(Number, f"p_{sign}", values, "Pa")
    else:
        raise StructureError(
            said(
                "{n} pressures for {count} positions: give one for each",
                n=len(gas.pressures),
                count=count,
            ),
            f"indicator.{name}",
            head=f"indicator, {name}",
        )
    height = draft.draw(to_board, f"h_{sign}", pressure)
    points = draft.draw(lay_off, sign, on.lines, height, why=why.PRESSURE)
    curve = draft.draw(taut_curve, f"({sign}–{sign})", points, row=count)
    ordinate = draft.draw(measure_along, f"y_{sign}", on.feet, points, on.up, why=why.PRESSURE_READ)
    read = draft.draw(in_si, f"p_{sign}", ordinate, unit="Pa")
    mean = None if gas.even and name == "shaft" else _mean(draft, sign, curve, on.length)
    outer = draft.take(Number, f"D_{sign}", gas.bore, "m")
    inner = draft.take(Number, f"d_{sign}", gas.rod, "m")
    face = draft.draw(ring_area, f"F_{sign}", outer, inner, unit="m²")
    force = draft.draw(gas_force, f"P_{sign}", read, face, unit="N")
    return Side(name, points, curve, ordinate, read, mean, force)


def _mean(draft: Draft, sign: str, curve: Mark, length: Mark) -> Mark:
    """Go round the diagram of a side with the planimeter; return the mean pressure."""
    area = draft.draw(planimeter, f"f_{sign}", curve, unit="mm²")
    height = draft.draw(mean_ordinate, f"h_{{{sign}m}}", area, length)
    return draft.draw(in_si, f"p_{{{sign}m}}", height, unit="Pa")


STANDS = 1e-6
"""A piston slower than this share of its fastest stands."""


@dataclass(frozen=True)
class Machine:
    """What a flywheel is drawn for: the mechanism and its plans, where positions stand in the row.

    ``count`` of them make the row, over so many ``turns`` of the crank; ``survey``: it at any angles.
    """

    mechanism: Mechanism
    positions: Positions
    velocities: Motion
    pivot: str
    pin: str
    arm: Mark
    numbers: np.ndarray
    count: int
    survey: Survey
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


INDICATOR_PLAN: Recorded[Cylinder] = Recorded(INDICATOR)


def machine_of(bench: Bench) -> Machine:
    """Return the machine on a board, once its plans are drawn."""
    plans = KINEMATICS_PLAN.on(bench)
    assert plans.velocities is not None
    pivot, pin = plans.structure.origin, plans.structure.first.pin
    arm = crank_length(bench, plans)
    drawn = (plans.positions, plans.velocities)
    numbers, count = plans.numbers, plans.count
    return Machine(
        plans.mechanism, *drawn, pivot, pin, arm, numbers, count, plans.tried, plans.turns
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
