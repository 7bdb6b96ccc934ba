"""The characteristic of a motor as its crank has it: by a catalogue, or a straight line."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import ray, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.motor import operations as op
from graphic_tmm.chapters.motor.task import MOTOR, MotorTask

SPEEDS = "motor-speeds"
"""What its base goes by: of ω, with the scale μ_ω."""
ROOM = 120.0
"""Room for the speed without load, mm."""


class Cross(NamedTuple):
    """Two axes of a view without positions: the origin, the level and the upright one."""

    origin: Mark
    along: Mark
    up: Mark


class DrawnMotor(NamedTuple):
    """The characteristic on the crank as drawn: ω level, M upright; the ratio to the crank (Number)."""

    axes: Cross
    curve: Mark
    mu_M: Mark
    mu_omega: Mark
    ratio: Mark
    charts: tuple[Chart, ...]


def cross(draft: Draft) -> Cross:
    """Draw two axes in the open view."""
    origin = draft.take(Point, "O", 0j)
    along = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
    return Cross(origin, along, draft.draw(square, "(Oy)", origin, along, sense=1))


def draw_motor(draft: Draft, order: MotorTask) -> DrawnMotor:
    """Draw the characteristic of a motor as the crank has it."""
    draft.open(MOTOR)
    ratio = draft.take(Number, "i", order.ratio)
    nominal = None
    if order.power is not None and order.nominal is not None:
        power = draft.take(Number, "P_n", order.power, "W")
        speed = draft.take(Number, "ω_n", order.nominal, "1/s")
        nominal = (draft.draw(op.nominal_moment, "M_n", power, speed, unit="N·m"), speed)
    one = draft.take(Number, "1", 1.0)
    mu_M = draft.scale("μ_M", "(N·m)/mm")
    mu_omega = draft.ask(Number, "μ_ω", "(1/s)/mm")
    draft.lay_out()
    axes = cross(draft)
    if order.points is not None:
        return _by_table(draft, order.points, axes, (ratio, one, mu_M, mu_omega))
    if order.synchronous is not None:
        assert nominal is not None
        field = draft.take(Number, "ω_s", order.synchronous, "1/s")
        times = draft.take(Number, "λ", order.overload)
        slip = draft.draw(op.slip, "s_n", field, nominal[1])
        critical = draft.draw(op.critical_slip, "s_k", slip, times)
        greatest = draft.draw(op.moment_on_crank, "M_k", nominal[0], times, ratio, unit="N·m")
        idle = draft.draw(op.speed_of_crank, "ω_{s1}", field, ratio, unit="1/s")
        curve = draft.draw(op.kloss_curve, "(M)", greatest, critical, idle, mu_M, mu_omega)
        high = greatest
    else:
        free = draft.take(Number, "ω_x", order.no_load, "1/s")
        if order.starting is not None:
            starts = draft.take(Number, "M_p", order.starting, "N·m")
        else:
            assert nominal is not None
            starts = draft.draw(op.starting_moment, "M_p", nominal[0], free, nominal[1], unit="N·m")
        high = draft.draw(op.moment_on_crank, "M_{p1}", starts, one, ratio, unit="N·m")
        idle = draft.draw(op.speed_of_crank, "ω_{x1}", free, ratio, unit="1/s")
        curve = draft.draw(op.straight_curve, "(M)", high, idle, mu_M, mu_omega)
    charts = _charts(draft, high, idle, mu_M, mu_omega)
    return DrawnMotor(axes, curve, mu_M, mu_omega, ratio, charts)


def _charts(draft: Draft, high: Mark, idle: Mark, mu_M: Mark, mu_omega: Mark) -> tuple[Chart, ...]:
    """Return what chooses both scales: the greatest moment, the speed without load."""
    heights = draft.draw(to_board, "y_k", high, mu_M), draft.draw(to_board, "x_s", idle, mu_omega)
    return (
        Chart(MOTOR, "M", "N·m", mu_M, (heights[0],), True, None, None),
        Chart(SPEEDS, "ω", "1/s", mu_omega, (heights[1],), True, None, ROOM),
    )


def _by_table(
    draft: Draft,
    points: Sequence[tuple[float, float]],
    axes: Cross,
    scales: tuple[Mark, Mark, Mark, Mark],
) -> DrawnMotor:
    """Draw a characteristic straight between the points of a table."""
    ratio, one, mu_M, mu_omega = scales
    marks = [
        (draft.take(Number, f"ω_{k}", omega, "1/s"), draft.take(Number, f"M_{k}", moment, "N·m"))
        for k, (omega, moment) in enumerate(points, 1)
    ]
    last = marks[-1][0]
    curve = draft.draw(op.level_curve, "(M_1)", marks[0][1], last, ratio, mu_M, mu_omega)
    for k, (first, then) in enumerate(pairwise(marks), 2):
        curve = draft.draw(
            op.on_to, f"(M_{k})", curve, *first, *then, ratio, mu_M, mu_omega, role=roles.SUM
        )
    largest = max(range(len(points)), key=lambda k: abs(points[k][1]))
    high = draft.draw(op.moment_on_crank, "M_{k1}", marks[largest][1], one, ratio, unit="N·m")
    idle = draft.draw(op.speed_of_crank, "ω_{x1}", last, ratio, unit="1/s")
    charts = _charts(draft, high, idle, mu_M, mu_omega)
    return DrawnMotor(axes, curve, mu_M, mu_omega, ratio, charts)
