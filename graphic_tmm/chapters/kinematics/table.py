"""The columns of the plans: segments in mm, times μ, in SI; the rates of links."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.kinematics.plan import KINEMATICS, PLANS, POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column, columns


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
