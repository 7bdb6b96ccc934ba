"""The columns of the plans: segments in mm, times μ, in SI; the rates of links; the views of each plan."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    BY_DRIVE,
    EXTREMES,
    PLANS,
    POSITIONS,
    SPECIAL_POINTS,
    VELOCITIES,
)
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.equations import components, quantity
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import Holder

UNITS = {POSITIONS: "m", VELOCITIES: "m/s", ACCELERATIONS: "m/s²"}
"""Of what the segments of a plan stand for."""
RATE_LETTERS = {VELOCITIES: "ω", ACCELERATIONS: "ε"}
RATE_NAMES = {VELOCITIES: "omega", ACCELERATIONS: "epsilon"}
"""What the rates of links are called where machines read them."""


def plan_columns(drawn: Drawn, plan: str, *, read: bool = False) -> tuple[Column, ...]:
    """Return the columns of one plan at its positions: segments, magnitudes; rates with their sign.

    ``read``: only the segments that are measured, not those that were calculated before they were laid off.
    """
    motion, reading, log = (
        KINEMATICS_PLAN.on(drawn).motion(plan),
        drawn.of(plan),
        drawn.construction,
    )
    view = log.view(plan)
    if reading is None or view is None or view.scale is None:
        return ()
    if motion is None and plan != POSITIONS:
        return ()
    count, places, found = len(drawn.names), drawn.row(plan), []
    parts = components(log)
    for step in log.steps:
        # a length that is laid off is a segment of its plan; of the links' lengths only what is read is told
        if (
            step.it.view == plan
            and step.it.kind is Length
            and (step.op.reads or (motion is not None and not read))
        ):
            mm, value = (np.abs(reading.figure(step.it, by)) for by in (None, view.scale))
            rows = row_of(mm, places, count), row_of(value, places, count)
            relative = "a" if plan == ACCELERATIONS else "v"
            sought = quantity(step.it, parts, relative) if motion is not None else ""
            segment = segment_name(step.it.letter)
            found.append(Column(plan, segment, step.it.name, UNITS[plan], *rows, quantity=sought))
    for link, mark in sorted(motion.rates.items()) if motion is not None and not read else ():
        letter = f"{RATE_LETTERS[plan]}_{link}"
        row = row_of(reading.figure(mark), places, count)
        found.append(Column(plan, segment_name(letter), letter, mark.unit, empty(count), row))
    for one in KINEMATICS_PLAN.on(drawn).rows if not read else ():
        if one.plan == plan:
            row = row_of(reading.figure(one.mark), places, count)
            found.append(Column(plan, one.name, one.letter, one.unit, empty(count), row))
    return tuple(found)


def kinematic_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of all plans."""
    for plan in PLANS:
        yield from plan_columns(drawn, plan)


def measured_vectors(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of the vectors that are measured on the plans of velocities and of accelerations."""
    for plan in (VELOCITIES, ACCELERATIONS):
        yield from plan_columns(drawn, plan, read=True)


def rate_marks(project: Project) -> dict[tuple[str, str], Mark]:
    """Return the rates of links, and further rows, by plan and the name that machines read."""
    plans, found = KINEMATICS_PLAN.on(project), {}
    for plan, sign in RATE_NAMES.items():
        motion = plans.motion(plan)
        for link, mark in motion.rates.items() if motion is not None else ():
            found[plan, f"{sign}{link}"] = mark
    return {**found, **{(one.plan, one.name): one.mark for one in plans.rows}}


TABLE = Tabled(columns=kinematic_columns)


def _title(held: Holder, view: str, language: str) -> str:
    """Return what the plan of velocities is called where a mechanism stands."""
    rests = view == VELOCITIES and KINEMATICS_PLAN.on(held).mechanism.at_rest
    return captions(language)[f"{view} at rest"] if rests else ""


def _views(project: Project) -> dict[str, tuple[str, ...]]:
    """Return the views of the plans; those of single drives stand with the plan of velocities."""
    shown = EXTREMES, POSITIONS, SPECIAL_POINTS, VELOCITIES, ACCELERATIONS
    plans, found = KINEMATICS_PLAN.on(project), {plan: (plan,) for plan in shown}
    more = [*(one.mu.view for one in plans.apart), *[BY_DRIVE] * bool(plans.summed)]
    return {**found, VELOCITIES: (VELOCITIES, *more)}


PROTOCOL = Protocols(views=_views, titles=_title)
