"""What a task gives of a motor."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.motor.task import MotorTask
from graphic_tmm.readers.task_sheet import Given, given_speed


def given_of(motor: MotorTask) -> Iterator[Given]:
    """Yield power, speeds, moments and ratio, as far as they are given."""
    if motor.power is not None:
        yield Given("P_n", motor.power, "W")
    if motor.nominal is not None:
        yield given_speed("n", motor.nominal)
    if motor.synchronous is not None:
        yield given_speed("s", motor.synchronous)
        yield Given("λ", motor.overload)
    if motor.no_load is not None:
        yield given_speed("x", motor.no_load)
    if motor.starting is not None:
        yield Given("M_p", motor.starting, "N·m")
    for k, (speed, moment) in enumerate(motor.points or (), 1):
        yield Given(f"ω_{k}", speed, "1/s")
        yield Given(f"M_{k}", moment, "N·m")
    yield Given("i", motor.ratio)
    if motor.J:
        yield Given("J_m", motor.J, "kg·m²")
