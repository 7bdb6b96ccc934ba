"""What people are told of a law of motion besides: a machine that does not start, or comes to rest."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.kinematics.findings import assumed
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN
from graphic_tmm.chapters.motion_law.task import (
    ACCELERATION,
    ENERGY,
    MASS,
    SLOWNESS,
    SPEED,
    TIME,
)
from graphic_tmm.chapters.motor.task import MOTOR, RUN, STEP
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.readers.findings import Warned

NEAR = 1e-6
"""A motion that ends nearer to its beginning than this share of the base does not begin."""

COARSE = 2.0
"""An error of ω, %, up to which the number of positions is large enough: about that of an honest hand."""


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    law = LAW_PLAN.of(drawn)
    if law is None:
        return
    _ = speaking(language)
    far, whole = drawn.value(law.angle), math.tau * law.turns
    if far <= NEAR * whole:
        yield _(
            "motion_law: the machine does not start: at rest the forces do not drive the crank; change M, the "
            "loads or the zero position"
        )
    elif not math.isfinite(drawn.value(law.energy.end)):
        yield _(
            "motion_law: the machine comes to rest at φ = {angle}° after {time} s, and does not reach the "
            "positions behind",
            angle=number(math.degrees(far), language, 4), time=number(drawn.value(law.time), language, 3),
        )  # fmt: skip
    elif law.step is not None and not math.isfinite(drawn.value(law.step.omega)):
        yield _(
            "motor: the interval whose crossing would be drawn goes on above the end of the characteristic: it "
            "is left out; write another step"
        )
    error = drawn.value(law.error) if law.error is not None else 0.0
    if law.error is None:
        yield _(
            "motion_law: of {count} positions a turn nothing can be left out evenly, so it is not known by how "
            "much ω may be off: take an even number, 8 or more",
            count=drawn.project.count // law.turns,
        )
    if error > COARSE:
        count = drawn.project.count // law.turns
        yield _(
            "motion_law: with {count} positions a turn ω may be off by {error} %: take {due} or more",
            count=count, error=number(error, language, 2),
            due=math.ceil(count * math.sqrt(error / COARSE)),
        )  # fmt: skip
    yield from assumed(drawn)


def _covers(drawn: Drawn) -> Iterator[str]:
    """Yield the views that lack positions because the machine rests, or a crossing that cannot be drawn."""
    law = LAW_PLAN.of(drawn)
    if law is None:
        return
    if not math.isfinite(drawn.value(law.energy.end)):
        yield from (ENERGY, MASS, SPEED, ACCELERATION, SLOWNESS, TIME, RUN)
    if law.step is not None and not math.isfinite(drawn.value(law.step.omega)):
        yield from (MOTOR, RUN, STEP)


WARNINGS = Warned(_warnings, _covers)
