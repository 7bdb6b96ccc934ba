"""The columns of the plans: segments in mm, times μ, in SI; the rates of links."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.plan import (
    ACCELERATIONS,
    KINEMATICS,
    PLANS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, columns

RATE_NAMES = {VELOCITIES: "omega", ACCELERATIONS: "epsilon"}
"""What the rates of links are called where machines read them."""


def plan_columns(drawn: Drawn, plan: str) -> tuple[Column, ...]:
    """Return the columns of one plan at its positions."""
    motion, reading = KINEMATICS.on(drawn).motion(plan), drawn.of(plan)
    if reading is None or (motion is None and plan != POSITIONS):
        return ()
    rates = motion.rates if motion is not None else None
    places = list(drawn.row(plan))
    return columns(drawn.construction, reading, plan, places, len(drawn.names), rates)


def kinematic_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of all plans."""
    for plan in PLANS:
        yield from plan_columns(drawn, plan)


def rate_marks(project: Project) -> dict[tuple[str, str], Mark]:
    """Return the rates of links by plan and the name that machines read."""
    plans, found = KINEMATICS.on(project), {}
    for plan, sign in RATE_NAMES.items():
        motion = plans.motion(plan)
        for link, mark in motion.rates.items() if motion is not None else ():
            found[plan, f"{sign}{link}"] = mark
    return found


def speed_marks(project: Project) -> list[Mark]:
    """Return the marks that tell how fast the mechanism runs."""
    velocities = KINEMATICS.on(project).velocities
    if velocities is None:
        return []
    speed = [velocities.speed] if velocities.speed is not None else []
    return [*speed, *velocities.rates.values()]
