"""What is asked of the law of motion of a machine (SI; drawn lengths in mm)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import Bound
from graphic_tmm.chapters.indicator.task import IndicatorTask
from graphic_tmm.chapters.motor.task import MOTOR, MotorTask
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

MOTION_LAW = "motion_law"
MOMENT, WORK, MASS = "motion-moment", "motion-work", "motion-mass"
ENERGY, SPEED, ACCELERATION = "motion-energy", "motion-speed", "motion-acceleration"
SLOWNESS, TIME = "motion-slowness", "motion-time"
"""The views of the chapter, one below the other."""


@dataclass(frozen=True)
class MotionLawTask:
    """The motion of a machine from given forces: its crank starts at ``start`` (1/s) in the first position.

    ``indicator``: the gas forces of which diagram; None: by the loads of the links. ``M``: a constant moment on
    the crank (N·m), positive where it drives. ``J``: what turns with the crank besides the links (kg·m²).
    ``turns``: of the crank that are drawn. ``motor``: what drives besides; ``steady``: its steady cycle;
    ``delta``: which a flywheel keeps that is sought.
    """

    indicator: IndicatorTask | None
    motor: MotorTask | None
    start: float = key(
        v.quantity("angular speed", Bound(0)),
        "angular velocity of the crank in the first position; left out: the machine starts from rest",
        "30 rpm",
        0.0,
    )
    M: float = key(
        v.quantity("moment"),
        "constant moment on the crank, positive where it drives",
        "120 N*m",
        0.0,
    )
    J: float = key(
        v.INERTIA, "moment of inertia that turns with the crank: a flywheel", "1.8 kg*m^2", 0.0
    )
    turns: int = key(v.number(Bound(1, 12, whole=True)), "turns of the crank that are drawn", 2, 1)
    steady: bool = key(
        v.SWITCH, "with a motor: the cycle to which the run-up comes is drawn", True, False
    )
    delta: float | None = key(
        v.number(Bound(0, 2, above=True, below=True), "ratio"),
        "coefficient of irregularity of the steady cycle: J of a flywheel is sought that keeps it",
        0.05,
        None,
    )
    base: float = key(
        v.DRAWN, "length of the base for all turns; if none is given, 180 mm on an A1", "120 mm", 180.0,
        fixes="size",
    )  # fmt: skip


ASKED: SectionKey[MotionLawTask] = SectionKey(MOTION_LAW)


def _check(order: Said, parts: Parts) -> Iterator[Flaw]:
    """What a law of motion needs besides its own section."""
    yield from parts.intervals(MOTION_LAW)
    if (
        "indicator" not in parts.doc
        and "forces" not in parts.doc
        and not (order.M or MOTOR in parts.doc)
    ):
        says = said(
            "nothing drives or resists; write M, a section [indicator], or loads and [forces]"
        )
        yield Flaw((MOTION_LAW,), says)
    yield from _by_speed(parts)
    if order.steady and MOTOR not in parts.doc:
        says = said("no motor keeps the cycle steady: write [motor], or leave steady out")
        yield Flaw((MOTION_LAW, "steady"), says)
    if order.delta is not None and not order.steady:
        says = said(
            "a steady cycle has a coefficient of irregularity: write steady = true, or leave delta out"
        )
        yield Flaw((MOTION_LAW, "delta"), says)
    if order.steady and order.start:
        says = said("the steady cycle begins with a speed of its own: leave start out, or steady")
        yield Flaw((MOTION_LAW, "start"), says)
    cylinders = parts.said.get("indicator")
    if cylinders and order.turns not in (1, cylinders[0].strokes // 2):
        says = said(
            "an indicator diagram is drawn over one cycle: leave turns out, or write the gas as a load"
        )
        yield Flaw((MOTION_LAW, "turns"), says)
    if order.turns > 1 and "flywheel" in parts.doc:
        says = said(
            "a flywheel is drawn over one cycle, the motion over {turns} turns: leave [flywheel] out, or turns",
            turns=order.turns,
        )
        yield Flaw((MOTION_LAW, "turns"), says)


def _by_speed(parts: Parts) -> Iterator[Flaw]:
    """What depends on the speed that is sought, or on the time."""
    for k, spring in enumerate(parts.said.get("spring") or ()):
        if spring is not None and spring.damping is not None:
            says = said(
                "the force of a damper depends on the speed that [motion_law] seeks: leave damping out"
            )
            yield Flaw(("spring", k, "damping"), says)
    for k, load in enumerate(parts.said.get("load") or ()):
        if load is not None and load.by_time:
            says = said(
                "[motion_law] seeks the times of the positions: give the load by_angle, or by its travel"
            )
            yield Flaw(("load", k, "by_time"), says)


SECTIONS = (
    Section(
        MOTION_LAW, MotionLawTask, "the law of motion of the machine under given forces",
        begin='M = "120 N*m"', weighs=True, check=_check,
        joined=lambda others: {"indicator": others["indicator"], "motor": others[MOTOR]},
        shows=lambda order: () if order.indicator else ("forces",),
    ),
)  # fmt: skip
