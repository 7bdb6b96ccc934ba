"""A cylinder on a mechanism: the piston's travel, its indicator diagram, gas forces."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import measure
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.diagrams.plan import sliding_leg
from graphic_tmm.chapters.indicator import words as why
from graphic_tmm.chapters.indicator.diagram import Indicator, Piston, draw_diagram
from graphic_tmm.chapters.indicator.sharing import by_diagram
from graphic_tmm.chapters.indicator.stretches import SLACK, Row
from graphic_tmm.chapters.indicator.swinging import (
    Swinging,
    bottom_angle,
    draw_length,
    goes_from_bottom,
    swinging_of,
)
from graphic_tmm.chapters.indicator.task import INDICATOR, TURN, IndicatorTask, Wish
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg
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
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

DIGITS = 6
"""Decimals of a place in the row that are not rounding."""


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

    @property
    def diagrams(self) -> tuple[tuple[Cylinder, ...], ...]:
        """The cylinders diagram by diagram: those that share one stand together."""
        views = dict.fromkeys(one.indicator.chart.view for one in self.every)
        return tuple(
            tuple(one for one in self.every if one.indicator.chart.view == view) for view in views
        )

    @property
    def charts(self) -> tuple[Chart, ...]:
        """The charts of the diagrams."""
        return tuple(first.indicator.chart for first, *_ in self.diagrams)


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
    machine, orders, draft = machine_of(bench), wish.order.every, bench.draft
    drawn = dict[str, Cylinder]()
    for source in dict.fromkeys(one.same_as or one.point for one in orders):
        alike = [one for one in orders if source in (one.same_as, one.point)]
        tags = [one.point if len(orders) > 1 else "" for one in alike]
        pistons = [_piston(draft, machine, *one) for one in zip(alike, tags, strict=True)]
        for group in by_diagram(draft, pistons):
            tag = " ".join(one.tag for one, _ in group) if len(group) < len(orders) else ""
            for (one, _), made in zip(group, draw_diagram(draft, group, tag), strict=True):
                cylinder = Cylinder(made, one.leg, one.outward, tag=one.tag, swings=one.swings)
                drawn[made.order.point] = cylinder
    first, *others = (drawn[one.point] for one in orders)
    return replace(first, shown_by=wish.by, further=tuple(others))


def _piston(draft: Draft, machine: Machine, order: IndicatorTask, tag: str) -> Piston:
    """Read off the travel of the piston's point, which slides on the frame.

    Its base begins at the dead centre at which the row does, else at that away from the crank.

    Raises
    ------
    StructureError
        If it does not slide there.
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
    return Piston(order, travel, row, leg, slider.outward, length, tag)


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
) -> Piston:
    """Calculate the travel of the piston of a cylinder that swings."""
    survey = machine.survey
    draft.open(POSITIONS)
    travel, stroke = draw_length(draft, survey, of, order.point)
    angles = _angles(draft, machine)
    out = goes_from_bottom(survey, of, order.point, angles)
    row = _row(machine, order, angles, out, bottom_angle(survey, of, order.point))
    return Piston(order, travel, row, of.leg, -1.0, stroke, tag, of.pin)


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
