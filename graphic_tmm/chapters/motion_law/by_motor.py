"""What a motor adds to the law of motion: runs by its characteristic, one crossing, δ and the J for it."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.graphs import Axes, Boundaries
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.kinematics.task import FULL_TURN
from graphic_tmm.chapters.motion_law import words as why
from graphic_tmm.chapters.motion_law.over_angle import Both, OverAngle
from graphic_tmm.chapters.motion_law.task import SPEED
from graphic_tmm.chapters.motor import operations_run as op
from graphic_tmm.chapters.motor.operations_error import (
    error_of_steps,
    error_of_works,
    rough_graph,
)
from graphic_tmm.chapters.motor.plan import DrawnMotor
from graphic_tmm.chapters.motor.step import DrawnStep, Run, draw_step
from graphic_tmm.chapters.motor.task import RUN

ENOUGH = 24
"""By so many positions a turn, or a few more, the turns of a run-up are counted."""


class Inertia(NamedTuple):
    """The energy–mass diagram as begun: its axes, the feet of J (Point), J of the first position and T_0 there.

    The machine has that J (``x``, a Length) at the end again. ``read``: J_r (Length). ``start``, ``first``:
    ω_0, T_0.
    """

    mu: Mark
    origin: Mark
    along: Mark
    up: Mark
    feet: Both
    x: Mark
    read: Mark
    start: Mark
    first: Mark


class ByMotor(OverAngle):
    """The graphs of a machine that a motor may drive."""

    inertia: Inertia
    motor: DrawnMotor | None
    moment_axes: Axes
    moment_points: Boundaries
    moment_curve: Mark
    flywheel: Mark | None = None
    work: Both
    work_mu: Mark
    work_at: Boundaries
    work_axes: Axes
    energy_at: Boundaries
    energy_axes: Axes

    def by_motor(
        self, motor: DrawnMotor, inertia: Mark, mu_J: Mark, *start: Mark
    ) -> tuple[Mark, ...]:
        """Return what a run by the motor takes, in order."""
        works = (*self.work, inertia, self.base.length)
        return (
            motor.curve,
            *start,
            *works,
            motor.mu_M,
            motor.mu_omega,
            self.work_mu,
            mu_J,
            self.base.mu,
        )

    def sought(self, motor: DrawnMotor, parts: list[Mark], delta: float) -> Mark:
        """Seek the moment of inertia that keeps δ, beside what is there."""
        draft, whole = self.draft, parts[0]
        for more in parts[1:]:
            whole = draft.draw(
                added, "J_0", whole, more, unit="kg·m²", role=roles.SUM, why=why.INERTIAS
            )
        due = draft.take(Number, "[δ]", delta)
        used = (motor.curve, due, *self.work, whole, self.base.length, motor.mu_M, motor.mu_omega)
        scales = self.work_mu, self.base.mu
        without = (motor.curve, *self.work, whole, *used[5:], *scales)
        alone = draft.draw(op.unevenness_without, "δ_1", *without, row=self.row)
        more = draft.draw(op.more_even, "δ_1/[δ]", due, alone)
        self.flywheel = draft.draw(
            op.inertia_for, "J_F", *used, *scales, unit="kg·m²", row=self.row
        )
        self.causes += [
            (whole, FULL_TURN),
            (alone, why.NOT_STEADY),
            (more, why.NOT_NEEDED),
            (self.flywheel, why.NONE_DOES),
        ]
        parts[:] = [whole]
        return self.flywheel

    def step(self) -> DrawnStep | None:
        """Draw the crossing of one interval, where a motor drives."""
        order = self.order.motor
        if self.motor is None or order is None:
            return None
        axes = (self.energy_axes, self.speed_axes, self.work_axes)
        feet = Boundaries(*self.inertia.feet)
        run = Run(self.energy_at, self.speed, self.work_at, feet, axes, self.inertia.mu)
        at_rest = not (order.step or self.order.start or self.order.steady)
        return draw_step(self.draft, self.base, self.motor, run, order.step, at_rest=at_rest)

    def run_up(self) -> Mark | None:
        """Count the turns of the run-up, where a motor drives."""
        own = self.inertia
        if self.motor is None or self.order.steady:
            return None
        self.draft.open(RUN)
        used = self.by_motor(self.motor, own.read, own.mu, own.start)
        a_turn = self.row // self.machine.turns
        stride = max(
            s for s in range(1, a_turn + 1) if (a_turn % s == 0 and a_turn // s >= ENOUGH) or s == 1
        )
        # a four-stroke cycle is no turn: its speed never comes back before
        long = 1 if self.order.indicator is None else self.machine.turns
        each = self.machine.turns // long
        cycles = self.draft.draw(
            op.turns_to_run_up, "n", *used, row=self.row, stride=stride, cycles=each
        )
        turns = self.draft.take(Number, "n_t", float(long))
        return self.draft.draw(op.turns_of_cycles, "n_r", cycles, turns)

    def unevenness(self, omega: Both) -> Mark | None:
        """Calculate δ of a steady cycle."""
        if not self.order.steady:
            return None
        self.draft.open(SPEED)
        return self.draft.draw(op.unevenness, "δ", *omega, row=self.row)

    def error(self, energies: Mark) -> Mark | None:
        """Calculate by how much ω is off for the number of positions; None where they cannot be halved."""
        row, own = self.row, self.inertia
        stride = next((s for s in range(2, row // 4 + 1) if row % s == 0), None)
        if stride is None:
            return None
        draft = self.draft
        draft.open(RUN)
        points = self.moment_points.points, self.base.length
        rough = draft.draw(rough_graph, "(k–k)′", *points, row=row, stride=stride)
        works = self.moment_curve, rough, energies, self.moment_axes.mu, self.base.mu
        error = draft.draw(error_of_works, "ξ_A", *works, unit="%", row=row, stride=stride)
        if self.motor is None:
            return error
        run = (*self.by_motor(self.motor, own.read, own.mu, own.start), energies)
        steps = draft.draw(error_of_steps, "ξ_M", *run, unit="%", row=row, stride=stride)
        return draft.draw(added, "ξ", error, steps, unit="%")
