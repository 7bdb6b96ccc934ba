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
from graphic_tmm.board.values import Angle, Length, Number, Point, Reals
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.indicator import words as why
from graphic_tmm.chapters.indicator.stretches import SLACK, Row, by_stretches, indexed
from graphic_tmm.chapters.indicator.swinging import (
    Swinging,
    bottom_angle,
    draw_length,
    goes_from_bottom,
    swinging_of,
)
from graphic_tmm.chapters.indicator.task import INDICATOR, TURN, VIEW, Gas, IndicatorTask, Wish
from graphic_tmm.chapters.kinematics.bodies import GuideLeg, PinLeg, Positions
from graphic_tmm.chapters.kinematics.dead_centres import (
    Slider,
    dead_centre,
    draw_dead_centres,
    goes_inward,
    slider_of,
    stands,
    turned_at,
)
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
DIGITS = 6
"""Decimals of a place in the row that are not rounding."""


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


def draw_indicator(
    draft: Draft,
    travel: Mark,
    row: Row,
    order: IndicatorTask,
    tag: str = "",
    length: Mark | None = None,
) -> Indicator:
    """Draw the diagram; ``travel``: the piston's way from where the base begins, as read (Length).

    No pressure is known at positions that stand behind the row. ``tag``: the point of the piston where there
    are several; ``length``: its stroke between dead centres (Length), None where the row has both.

    Raises
    ------
    StructureError
        If the pressures are not as many as the positions of the row.
    """
    draft.open(view_of(tag))
    mu = draft.scale("μ_p", "Pa/mm")
    draft.lay_out()
    origin = draft.take(Point, "O", 0j)
    base = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
    up = draft.draw(square, "(Oy)", origin, base, sense=1)
    drawn = draft.take(Length, "L", order.base, "mm")
    end = draft.draw(lay_off, "E", base, drawn)
    feet, divisions, stroke = _divide(draft, (origin, base, end), travel, row.size, length)
    lines = draft.draw(square, "(i)", feet, base, sense=1)
    ground = _Ground(drawn, lines, feet, up, travel, stroke, tag)
    sides = [_side(draft, "cover", order.cover, row, ground)]
    force = sides[0].force
    if order.shaft is not None:
        sides.append(_side(draft, "shaft", order.shaft, row, ground))
        force = draft.draw(net_force, letter_of("P", tag), force, sides[1].force, unit="N")
    ordinates = tuple(side.ordinate for side in sides)
    chart = Chart(view_of(tag), "p", "Pa", mu, ordinates, True, order.mu, order.height)
    return Indicator(order, chart, origin, end, feet, divisions, stroke, tuple(sides), force)


class _Ground(NamedTuple):
    """What both sides stand on: the base's length, perpendiculars, feet, ordinate axis, travel, stroke.

    ``tag``: what stands behind the letters of their sizes where there are several pistons.
    """

    length: Mark
    lines: Mark
    feet: Mark
    up: Mark
    travel: Mark
    stroke: Mark
    tag: str


def _divide(
    draft: Draft, axis: tuple[Mark, Mark, Mark], travel: Mark, count: int, length: Mark | None
) -> tuple[Mark, Mark, Mark]:
    """Divide the base in proportion to the travel by similar triangles on an auxiliary ray.

    ``axis``: its origin, the base, its end; ``length``: the stroke, None where positions tell it. Returns the
    feet of the positions, their points on the ray, the stroke as it lies there (Length).
    """
    origin, base, end = axis
    way = draft.draw(ray, "(Oq)", origin, draft.take(Angle, "θ", AUXILIARY, "°"), why=why.AUXILIARY)
    marks = draft.draw(lay_off, "q", way, travel, why=why.TRAVEL_ON_RAY)
    if length is None:
        last = draft.draw(farthest, "q_S", origin, marks, row=count)
    else:
        last = draft.draw(lay_off, "q_S", way, length, why=why.STROKE_ON_RAY)
    closing = draft.draw(join, "(q_SE)", last, end, why=why.CLOSING)
    lines = draft.draw(parallel, "(q)", marks, closing, sense=1, why=why.ALIKE)
    stroke = draft.draw(measure, "s_{max}", origin, last)
    return draft.draw(meet, "i", base, lines, why=why.ALIKE), marks, stroke


def _side(draft: Draft, name: str, gas: Gas, row: Row, on: _Ground) -> Side:
    """Lay off the pressures of one side, read them, go round them with the planimeter."""
    sign, count, extras = NAMES[name] + on.tag, row.size, row.extras
    if gas.stretches:
        pressure = by_stretches(
            draft, sign, gas, row, on.travel, on.stroke, at_shaft=name == "shaft"
        )
    elif len(gas.pressures) == count:
        values = np.array([*gas.pressures, *[np.nan] * extras])[None, :]
        pressure = draft.take(Number, indexed("p", sign), values, "Pa")
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
    height = draft.draw(to_board, indexed("h", sign), pressure)
    points = draft.draw(lay_off, sign, on.lines, height, why=why.PRESSURE)
    curve = draft.draw(taut_curve, f"({sign}–{sign})", points, row=count)
    ordinate = draft.draw(
        measure_along, indexed("y", sign), on.feet, points, on.up, why=why.PRESSURE_READ
    )
    read = draft.draw(in_si, indexed("p", sign), ordinate, unit="Pa")
    mean = None if gas.even and name == "shaft" else _mean(draft, sign, curve, on.length)
    outer = draft.take(Number, indexed("D", sign), gas.bore, "m")
    inner = draft.take(Number, indexed("d", sign), gas.rod, "m")
    face = draft.draw(ring_area, indexed("F", sign), outer, inner, unit="m²")
    force = draft.draw(gas_force, indexed("P", sign), read, face, unit="N")
    return Side(name, points, curve, ordinate, read, mean, force)


def view_of(tag: str) -> str:
    """Return the view of a diagram; ``tag``: the point of its piston where there are several."""
    return f"{VIEW} {tag}" if tag else VIEW


def letter_of(letter: str, tag: str) -> str:
    """Return a letter of what belongs to a cylinder where there are several: P_{B}."""
    return f"{letter}_{{{tag}}}" if tag else letter


def _mean(draft: Draft, sign: str, curve: Mark, length: Mark) -> Mark:
    """Go round the diagram of a side with the planimeter; return the mean pressure."""
    area = draft.draw(planimeter, f"f_{sign}", curve, unit="mm²")
    height = draft.draw(mean_ordinate, f"h_{{{sign}m}}", area, length)
    return draft.draw(in_si, f"p_{{{sign}m}}", height, unit="Pa")


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

    ``shown_by``: the chapter with whose views its diagram stands. ``tag``: the point of its piston where there
    are several; ``further``: the others. ``swings``: the leg by which it swings; None of one that stands.
    """

    indicator: Indicator
    leg: GuideLeg
    outward: float
    shown_by: str = ""
    tag: str = ""
    further: tuple[Cylinder, ...] = ()
    swings: PinLeg | None = None

    @property
    def every(self) -> tuple[Cylinder, ...]:
        """All cylinders in the order of the scene."""
        return (self, *self.further)


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
    machine, orders = machine_of(bench), wish.order.every
    first, *others = (
        draw_cylinder(bench.draft, machine, order, order.point if len(orders) > 1 else "")
        for order in orders
    )
    return replace(first, shown_by=wish.by, further=tuple(others))


def draw_cylinder(draft: Draft, machine: Machine, order: IndicatorTask, tag: str = "") -> Cylinder:
    """Draw the indicator diagram of the piston's point, which slides on the frame.

    Its base begins at the dead centre at which the row does, else at that away from the crank.

    Raises
    ------
    StructureError
        If it does not slide there, or pressures are missing.
    """
    swings = swinging_of(machine.positions, machine.survey, order.point)
    if swings is not None:
        return _swinging(draft, machine, swings, order, tag)
    frame, point = machine.mechanism.frame.number, machine.positions.point(order.point)
    leg = sliding_leg(machine.positions, order.point, frame, INDICATOR)
    slider = slider_of(machine.survey, draft.given, machine.positions, leg, order.point)
    begun = _begun(draft, machine, slider, order)
    length = None
    if begun is None:
        ends = draw_dead_centres(draft, machine.survey, machine.positions, slider)
        draft.open(POSITIONS)
        start = ends.outer
        length = draft.draw(measure, f"s_{{{order.point}max}}", *ends, why=why.STROKE)
    else:
        draft.open(POSITIONS)
        start = draft.draw(at_zero, f"{order.point}_0", point, free=True)
    travel = draft.draw(measure, f"|s_{order.point}|", start, point)
    angles = _angles(draft, machine)
    out = goes_inward(machine.survey, slider, angles)
    row = _row(machine, order, angles, out, turned_at(machine.survey, slider, 1))
    indicator = draw_indicator(draft, travel, row, order, tag, length)
    return Cylinder(indicator, leg, slider.outward, tag=tag)


def _begun(draft: Draft, machine: Machine, slider: Slider, order: IndicatorTask) -> int | None:
    """Return the dead centre at which the row begins, 1 away from the crank or −1; None if at none.

    Parts of a diagram are counted from the cover, so with these it is not begun at the other one.
    """
    angles = _angles(draft, machine)
    if not stands(machine.survey, slider, angles)[0]:
        return None
    if dead_centre(machine.survey, slider, angles[0]) > 0:
        return 1
    sides = (order.cover, order.shaft)
    return None if any(gas is not None and gas.stretches for gas in sides) else -1


def _angles(draft: Draft, machine: Machine) -> Reals:
    """Return the crank's angle at every position, degrees."""
    phi = machine.positions.row[0]
    given = {**draft.given, draft.mu_l: 1.0}
    return np.asarray(execute(draft.board.construction(), given, [phi])[phi][0])


def _swinging(
    draft: Draft, machine: Machine, of: Swinging, order: IndicatorTask, tag: str
) -> Cylinder:
    """Draw the diagram of a cylinder that swings."""
    survey = machine.survey
    draft.open(POSITIONS)
    travel, stroke = draw_length(draft, survey, of, order.point)
    angles = _angles(draft, machine)
    out = goes_from_bottom(survey, of, order.point, angles)
    row = _row(machine, order, angles, out, bottom_angle(survey, of, order.point))
    indicator = draw_indicator(draft, travel, row, order, tag, stroke)
    return Cylinder(indicator, of.leg, -1.0, tag=tag, swings=of.pin)


def _row(
    machine: Machine, order: IndicatorTask, angles: Reals, out: np.ndarray, begins: float
) -> Row:
    """Return the positions, with the turn of the cycle and the stroke on which each of them stands.

    ``begins``: the crank's angle (degrees) at which the stroke from the cover does.
    """
    count, in_turn = machine.count, machine.count // machine.turns
    later = (begins - angles[0]) * machine.mechanism.drive.sense
    first = round(later / TURN * in_turn, DIGITS) % in_turn
    passed = np.floor((machine.numbers - first) / in_turn + SLACK) - order.phase // TURN
    turns = tuple(int(turn) for turn in passed % machine.turns)
    return Row(count, machine.numbers.size - count, turns, tuple(bool(one) for one in out))
