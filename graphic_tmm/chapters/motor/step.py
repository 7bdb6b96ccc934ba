"""The crossing of one interval as it is drawn: the parabola of the energy with the motor's curve."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Boundaries
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graphs import erect, standing
from graphic_tmm.board.operations.instruments import lay_off, measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.motor import operations as op
from graphic_tmm.chapters.motor import words as why
from graphic_tmm.chapters.motor.plan import Cross, DrawnMotor, cross
from graphic_tmm.chapters.motor.task import MOTOR, RUN, STEP


class DrawnStep(NamedTuple):
    """One crossing as drawn: its axes, both curves, where they cross, ω there (Number).

    ``moment``: the point of the characteristic at its beginning.
    """

    axes: Cross
    parabola: Mark
    energy: Mark
    moment: Mark
    point: Mark
    omega: Mark


class Run(NamedTuple):
    """The graphs that a step is taken from: of energy, speed and work; the feet of J, and their scale."""

    energy: Boundaries
    speed: Boundaries
    work: Boundaries
    feet: Boundaries
    axes: tuple[Axes, Axes, Axes]
    mu_J: Mark


def draw_step(
    draft: Draft, base: Base, motor: DrawnMotor, run: Run, place: int, *, at_rest: bool
) -> DrawnStep:
    """Draw the crossing of the interval that begins at a position of the row; ``at_rest``: from rest."""
    ends = [(one.points, place) for one in (run.energy, run.speed, run.work)]
    ends += [
        (both.points, place + 1) if place + 1 < base.intervals else (both.end, 0)
        for both in (run.work, run.feet)
    ]
    draft.open(RUN)
    names = ("t_k", "w_k", "a_k", "a_{k+1}", "j_{k+1}")
    spots = [
        draft.draw(standing, name, of, place=at, why=why.STEP_PLACE)
        for name, (of, at) in zip(names, ends, strict=True)
    ]
    origins = (*(one.origin for one in (*run.axes, run.axes[2])), motor.axes.origin)
    # A_k would be an area of the cover side
    names = ("T_k", "ω_k", "A_{k}", "A_{k+1}", "J_{k+1}")
    uprights = (*(one.up for one in (*run.axes, run.axes[2])), motor.axes.along)
    energy, fast, before, after, inertia = (
        draft.draw(measure_along, name, origin, spot, line)
        for name, origin, spot, line in zip(names, origins, spots, uprights, strict=True)
    )
    omega = draft.draw(in_si, "ω_{k1}", fast, run.axes[1].mu, unit="1/s")
    x = draft.draw(to_board, "x_k", omega, motor.mu_omega)
    draft.open(MOTOR)
    foot = draft.draw(lay_off, "f", motor.axes.along, x)
    above = draft.draw(erect, "p", motor.curve, foot)
    moment = draft.draw(measure_along, "M_{mk}", foot, above, motor.axes.up)
    draft.open(RUN)
    share = draft.take(Number, "κ", op.FROM_REST if at_rest else op.HALF)
    intervals = draft.take(Number, "N", float(base.intervals))
    mu_T, mu_A, mu_J = run.axes[0].mu, run.axes[2].mu, run.mu_J
    way = draft.draw(op.way_of_interval, "Δφ", base.length, base.mu, intervals)
    used = (energy, mu_T, after, before, mu_A, share, moment, motor.mu_M, way)
    known = draft.draw(op.known_energy, "T_b", *used, unit="J", why=why.SHARES[at_rest])
    draft.open(STEP)
    draft.lay_out(None, mu_T)
    axes = cross(draft)
    bent = draft.draw(op.parabola, "(T)", inertia, motor.curve, mu_J, mu_T, motor.mu_omega)
    more = (share, way, motor.mu_M, mu_T)
    raised = draft.draw(op.energy_by_motor, "(T_b + A_m)", known, motor.curve, *more)
    point = draft.draw(op.crossing, "c", bent, raised, x)
    found = draft.draw(measure_along, "x_{k+1}", axes.origin, point, axes.along)
    last = draft.draw(in_si, "ω_{k+1}", found, motor.mu_omega, unit="1/s")
    return DrawnStep(axes, bent, raised, above, point, last)
