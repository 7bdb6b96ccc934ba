"""Kinematic diagrams of a slider's point: displacement, velocity, acceleration over time or angle.

What the plans give (the displacement measured on the plan of positions, or the velocity) is laid off over the
base; the others follow by differentiation or integration against a pole.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import Chart, Scaled, ScaleOrder, derived_scale, integrated_scale
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Boundaries, Middles
from graphic_tmm.board.operations.formulas import (
    mm_of_row,
    mm_of_time,
    mm_of_turn,
    rescaled,
    row_per_mm,
    time_of_row,
    time_per_mm,
    turn_per_mm,
)
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.diagrams import words as why
from graphic_tmm.chapters.diagrams.task import ASKED, BASE, DIAGRAMS, VIEWS, KinematicTask, settled
from graphic_tmm.chapters.kinematics.bodies import Positions, sliding_points
from graphic_tmm.chapters.kinematics.closings import GuideLeg
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.positions import VIEW as POSITIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

UNITS = {"S": "m", "V": "m/s", "a": "m/s²"}
"""Of the diagrams over time."""
ROOM = 50.0
"""Room for the highest ordinate of a diagram, mm."""


@dataclass(frozen=True)
class Kinematic:
    """The diagrams as drawn: their base, charts by quantity, and what the plans read of the same quantities.

    ``planned``: for V and a, the reading of the plan along the guide with its sign (Length), by quantity.
    ``laid``: the length laid off in the diagram that is taken from the plans (Length); ``poles``: the distance
    of the pole by which each other one was found (Length). ``whole``: of a row that does not come back, the
    time or the angle that the base stands for (Number). ``middles``: of each diagram found by chords, its
    axes and the points over the middles of the intervals.
    """

    order: KinematicTask
    base: Base
    charts: dict[str, Chart]
    planned: dict[str, Mark]
    laid: Mark
    poles: dict[str, Mark]
    middles: dict[str, tuple[Axes, Middles]]
    whole: Mark | None = None

    @property
    def first(self) -> str:
        """The symbol of the diagram that is laid off from the plans."""
        return "V" if self.order.start == "velocity" else "S"


DIAGRAMS_PLAN: Recorded[Kinematic] = Recorded(DIAGRAMS)


class _Derived(NamedTuple):
    """A diagram found from another: as users see it, the distance of its pole; axes, points, curve.

    ``middles``: the points over the middles of the intervals, of one found by chords.
    """

    chart: Chart
    distance: Mark
    axes: Axes
    at: Boundaries
    curve: Mark
    middles: Middles | None = None


class _Diagrams(NamedTuple):
    """The diagrams by quantity, the length laid off in the first, those found from others."""

    charts: dict[str, Chart]
    laid: Mark
    derived: tuple[_Derived, ...]


def record(bench: Bench) -> Kinematic | None:
    """Draw the diagrams S, V, a of a point.

    Raises
    ------
    StructureError
        If the point does not belong to a link that slides on the frame, or a pole distance is not positive.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    draft, plans = bench.draft, KINEMATICS_PLAN.on(bench)
    positions, velocities, accelerations = plans.positions, plans.velocities, plans.accelerations
    assert velocities is not None
    leg = sliding_leg(positions, order.point, plans.mechanism.frame.number, ASKED.section)
    _refuse_poles(order)
    if order.over == "angle" and not plans.tried.sweep.turns:
        raise StructureError(
            said('the drive slides, there is no angle to draw over; write over = "time"'),
            "diagrams.over",
            head="diagrams",
        )
    order = settled(order, whole(order, plans))
    base, of_row = _base(draft, plans, order)
    planned = {"V": velocities.readings[leg.link]}
    if accelerations is not None and leg.link in accelerations.readings:
        planned["a"] = accelerations.readings[leg.link]
    if order.start == "displacement":
        found = _from_displacement(draft, positions, leg, base, order)
    else:
        found = _from_velocity(draft, velocities, leg, base, order)
    # a derivative by the angle is no velocity: there is nothing to compare it with
    alike = {
        symbol: mark
        for symbol, mark in planned.items()
        if found.charts[symbol].unit == UNITS[symbol]
    }
    poles = {one.chart.symbol: one.distance for one in found.derived}
    middles = {
        one.chart.symbol: (one.axes, one.middles)
        for one in found.derived
        if one.middles is not None
    }
    return Kinematic(order, base, found.charts, alike, found.laid, poles, middles, of_row)


def whole(order: KinematicTask, plans: KinematicPlans) -> float:
    """Return what the base stands for: a time, or an angle (SI)."""
    return plans.way / (abs(plans.mechanism.drive.speed) if order.over == "time" else 1.0)


def sliding_leg(
    positions: Positions, letter: str, frame: int, section: str, key: str = ""
) -> GuideLeg:
    """Return the leg by which a point's link slides on the frame; StructureError if it does not.

    ``section``: of a scene, whose ``key`` (``point``, if it is not told) names the point.
    """
    points = sliding_points(positions.closings, positions.bodies, frame, section)
    for point, leg in points:
        if point == letter:
            return leg
    there = said("this mechanism has none")
    if points:
        there = said("points that do are {listed}", listed=", ".join(point for point, _ in points))
    raise StructureError(
        said(
            "point {letter} does not slide along a straight guide of the frame; {there}",
            letter=letter,
            there=there,
        ),
        key or f"{section}.point",
        head=section,
    )


def _refuse_poles(order: KinematicTask) -> None:
    for symbol in ("S", "V", "a"):
        drawn: ScaleOrder = getattr(order, symbol)
        if drawn.pole is not None and not drawn.pole > 0.0:
            raise StructureError(
                said(
                    "the pole distance {key} = {pole:g} mm is not greater than 0",
                    key=f"H_{symbol}",
                    pole=drawn.pole,
                ),
                f"diagrams.H_{symbol}",
                head="diagrams",
            )


def _base(draft: Draft, plans: KinematicPlans, order: KinematicTask) -> tuple[Base, Mark | None]:
    """Take the base, its scale over time or angle; and what it stands for, of a row that does not come back."""
    first = "V" if order.start == "velocity" else "S"
    draft.open(VIEWS[first])
    over_time, numbers = order.over == "time", plans.numbers[None, :]
    letter, unit = ("μ_t", "s/mm") if over_time else ("μ_φ", "rad/mm")
    if not plans.closed:
        return _base_of_row(draft, plans, order, letter, unit)
    assert plans.velocities is not None
    omega = plans.velocities.speed
    assert omega is not None
    if order.mu_along is not None:
        mu = draft.take(Number, letter, order.mu_along, unit)
        length = (
            draft.draw(mm_of_time, "L", omega, mu) if over_time else draft.draw(mm_of_turn, "L", mu)
        )
    else:
        length = draft.take(Length, "L", order.base or BASE, "mm", roles.BASE)
        if over_time:
            mu = draft.draw(time_per_mm, letter, omega, length, unit=unit)
        else:
            mu = draft.draw(turn_per_mm, letter, length, unit=unit)
    return graphs.lay_base(draft, length, mu, plans.count, numbers), None


def _base_of_row(
    draft: Draft, plans: KinematicPlans, order: KinematicTask, letter: str, unit: str
) -> tuple[Base, Mark]:
    """Take the base of a row that does not come back, from its first position to its last."""
    there = way_and_speed(draft.constant, plans)
    row = draft.draw(time_of_row, "t", *there, unit="s") if order.over == "time" else there[0]
    if order.mu_along is not None:
        mu = draft.take(Number, letter, order.mu_along, unit)
        length = draft.draw(mm_of_row, "L", row, mu)
    else:
        length = draft.take(Length, "L", order.base or BASE, "mm", roles.BASE)
        mu = draft.draw(row_per_mm, letter, row, length, unit=unit)
    numbers = plans.numbers[None, :]
    return graphs.lay_base(draft, length, mu, plans.count - 1, numbers, closed=False), row


def way_and_speed(
    take: Callable[[str, float, str], Mark], plans: KinematicPlans
) -> tuple[Mark, Mark]:
    """Take how far the drive goes over the row, and how fast."""
    pair = plans.pairs[0]
    letter, unit = pair.sweep.letter, "rad" if pair.sweep.turns else "m"
    return (
        take(f"Δ{letter}", plans.way, unit),
        take(pair.speed_letter, abs(pair.speed), "1/s" if pair.sweep.turns else "m/s"),
    )


def _from_displacement(
    draft: Draft, positions: Positions, leg: GuideLeg, base: Base, order: KinematicTask
) -> _Diagrams:
    point = positions.point(order.point)
    draft.open(POSITIONS)
    start = draft.draw(at_zero, f"{order.point}_0", point, free=True)
    travel = draft.draw(measure_along, f"s_{order.point}", start, point, leg.line, why=why.TRAVEL)
    draft.open(VIEWS["S"])
    mu = draft.scale("μ_S", "m/mm")
    length = draft.draw(rescaled, "y_S", travel, mu)
    axes = graphs.draw_axes(draft, VIEWS["S"], base, mu)
    at = graphs.lay_ordinates(draft, axes, length, "s")
    charts = {"S": _chart(draft, "S", axes, at, True, order)}
    curve = graphs.through(draft, axes, at)
    speeds = _derivative(draft, "V", axes, at, curve, order)
    rates = _derivative(draft, "a", speeds.axes, speeds.at, speeds.curve, order)
    charts |= {"V": speeds.chart, "a": rates.chart}
    return _Diagrams(charts, length, (speeds, rates))


def _from_velocity(
    draft: Draft, velocities: Motion, leg: GuideLeg, base: Base, order: KinematicTask
) -> _Diagrams:
    draft.open(VIEWS["V"])
    mu = draft.scale("μ_V", "(m/s)/mm")
    length = draft.draw(rescaled, "y_V", velocities.readings[leg.link], mu)
    axes = graphs.draw_axes(draft, VIEWS["V"], base, mu)
    at = graphs.lay_ordinates(draft, axes, length, "v")
    charts = {"V": _chart(draft, "V", axes, at, True, order)}
    curve = graphs.through(draft, axes, at)
    rates = _derivative(draft, "a", axes, at, curve, order)
    charts["a"] = rates.chart
    if order.integral != "drawn":
        return _Diagrams(charts, length, (rates,))
    ways = _integral(draft, axes, curve, order)
    return _Diagrams({"S": ways.chart, **charts}, length, (ways, rates))


def _derivative(
    draft: Draft, symbol: str, source: Axes, at: Boundaries, curve: Mark, order: KinematicTask
) -> _Derived:
    """Differentiate once."""
    draft.open(VIEWS[symbol])
    drawn: ScaleOrder = getattr(order, symbol)
    scaled = derived_scale(
        draft, symbol, _scale_unit(symbol, order), source.mu, source.base.mu, drawn
    )
    axes = graphs.draw_axes(draft, VIEWS[symbol], source.base, scaled.mu)
    pole = graphs.set_pole(draft, axes, scaled.distance)
    letter, middles = symbol.lower(), None
    if order.method == "tangents":
        points = graphs.by_tangents(draft, source, curve, axes, pole, letter)
        found = graphs.through(draft, axes, points)
    else:
        middles = graphs.by_chords(draft, source, at, axes, pole, f"{letter}′")
        found = graphs.through(draft, axes, middles)
        points = graphs.on_curve(draft, axes, found, letter)
    chart = _chart(draft, symbol, axes, points, scaled.chosen, order)
    return _Derived(chart, scaled.distance, axes, points, found, middles)


def _integral(draft: Draft, source: Axes, curve: Mark, order: KinematicTask) -> _Derived:
    """Integrate the velocities once; the pole stands left of their origin."""
    draft.open(VIEWS["S"])
    scaled: Scaled = integrated_scale(
        draft, "S", _scale_unit("S", order), source.mu, source.base.mu, order.S
    )
    axes = graphs.draw_axes(draft, VIEWS["S"], source.base, scaled.mu)
    pole = graphs.set_pole(draft, source, scaled.distance)
    points = graphs.integrate(draft, source, curve, axes, pole, "s′")
    found = graphs.through(draft, axes, points, closed=False)
    at = graphs.on_curve(draft, axes, found, "s")
    chart = _chart(draft, "S", axes, at, scaled.chosen, order)
    if axes.base.closed:
        end = (axes.end, points.end, axes.up)
        chart = chart._replace(end=draft.draw(measure_along, "S_N", *end, why=why.END_OF_INTEGRAL))
    return _Derived(chart, scaled.distance, axes, at, found)


def _chart(
    draft: Draft, symbol: str, axes: Axes, at: Boundaries, chosen: bool, order: KinematicTask
) -> Chart:
    draft.open(axes.view)
    ordinate = graphs.measure_ordinates(draft, axes, at.points, symbol)
    unit, drawn = unit_of(symbol, order), getattr(order, symbol)
    return Chart(axes.view, symbol, unit, axes.mu, (ordinate,), chosen, drawn.mu, ROOM)


def unit_of(symbol: str, order: KinematicTask) -> str:
    """Return the unit of a diagram's ordinates; over the angle all have that of the first one drawn."""
    if order.over == "angle":
        symbol = "V" if order.start == "velocity" else "S"
    return UNITS[symbol]


def _scale_unit(symbol: str, order: KinematicTask) -> str:
    unit = unit_of(symbol, order)
    return f"({unit})/mm" if "/" in unit else f"{unit}/mm"
