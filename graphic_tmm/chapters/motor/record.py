"""What is recorded of a motor: its characteristic, where the law of motion needs it."""

from __future__ import annotations

from graphic_tmm.chapters.motor.plan import DrawnMotor, draw_motor
from graphic_tmm.chapters.motor.task import MOTOR, MotorTask
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded

MOTOR_PLAN: Recorded[DrawnMotor] = Recorded(MOTOR)


def record(bench: Bench) -> DrawnMotor | None:
    """Draw the characteristic that another chapter needs."""
    order: MotorTask | None = bench.needed.get(MOTOR)
    return None if order is None else draw_motor(bench.draft, order)


PLAN = Plan(record=record, charts=lambda made: made.charts)
