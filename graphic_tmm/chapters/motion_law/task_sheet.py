"""What a task gives of a law of motion, and what it asks, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.indicator.given import GasOf, given_of
from graphic_tmm.chapters.motion_law.task import ASKED, MOTION_LAW
from graphic_tmm.chapters.motor.task_sheet import given_of as motor_given
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import Given, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield the speed at the beginning, the constant moment, what turns with the crank."""
    order = ASKED.of(scene)
    if order is None:
        return
    if order.indicator is not None:
        yield from given_of(order.indicator)
    if not order.steady:
        yield Given("ω_0", order.start, "1/s")
    if order.M:
        yield Given("M_c", order.M, "N·m")
    if order.J:
        yield Given("J_c", order.J, "kg·m²")
    if order.delta is not None:
        yield Given("δ", order.delta)
    if order.motor is not None:
        yield from motor_given(order.motor)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the motion from its beginning on."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    if order.steady:
        yield _(_STEADY if order.delta is None else _FLYWHEEL)
    else:
        yield _(_RUNS if order.start else _STARTS, n=order.turns)
    yield _(_GRAPHS)


_STARTS = said(
    "The machine starts from rest; its motion over {n} turn of the crank is sought.",
    "The machine starts from rest; its motion over {n} turns of the crank is sought.",
)
_RUNS = said(
    "In the first position the crank turns at ω_0; the motion over {n} turn of it is sought.",
    "In the first position the crank turns at ω_0; the motion over {n} turns of it is sought.",
)
_STEADY = said("The steady cycle of the machine with its motor is sought, and the δ of it.")
_FLYWHEEL = said(
    "The flywheel is sought with which the steady cycle of the machine keeps the given δ."
)
_GRAPHS = said(
    "Over the angle of the crank are drawn the reduced moment of all forces, their work, the kinetic energy, "
    "by the energy–mass diagram ω, by subnormals ε, by integrating 1/ω the time."
)


_GAS = GasOf(ASKED)
TASK_SHEET = TaskSheet(
    given=given,
    stated=_GAS.stated,
    listed=_GAS.listed,
    acting=_GAS.acting,
    wanted={MOTION_LAW: asks},
)
